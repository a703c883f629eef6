import type { Plugin } from 'vite';

export function mathml(latex: string, displayMode?: boolean): string;
export function html(text: string): string;
export function readyWords(words: unknown): Record<string, unknown>;
export function figureWords(): Plugin;
