// The command line. Results go to files or standard output, one line about what went wrong to standard error.
#include <exception>
#include <iostream>

#include "arguments.hpp"

namespace {

using namespace polylap;

constexpr int failed = 1, wrong_usage = 2;

int complain(std::string message, int exit_code) {
    for (char& c : message)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    std::cerr << "polylap: " << message << '\n';
    return exit_code;
}

/// CLI11 says neither which word it took for a command nor which there are.
std::string no_command(const CLI::App& app) {
    const auto words = app.remaining();
    std::string text = words.empty() ? "expected a command" : "there is no command '" + words.front() + "'";
    const char* separator = "; the commands are ";
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        text += separator + command->get_name();
        separator = ", ";
    }
    return text;
}

int run(int argc, char** argv) {
    tool::Arguments arguments;
    tool::Command command;
    CLI::App app("Discrete Laplace operators on general polygon meshes. Vertices and faces count from 0.", "polylap");
    tool::declare(app, arguments, command);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {  // --help, --version
            app.exit(error);
            return std::cout.flush() ? 0 : complain("cannot write standard output", failed);
        }
        const std::string what = app.get_subcommands().empty() ? no_command(app) : error.what();
        return complain(what + " (see polylap --help)", wrong_usage);
    }
    const auto outputs = command();
    if (!outputs) return complain(outputs.error().message, failed);
    if (auto status = tool::write_outputs(*outputs); !status) return complain(status.error().message, failed);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory", failed);
    } catch (const std::exception& error) {
        return complain(error.what(), failed);
    }
}
