from IPython.display import IFrame

IFrame("{{site}}figures/two-cuts.html?embed", width="100%", height=760)
