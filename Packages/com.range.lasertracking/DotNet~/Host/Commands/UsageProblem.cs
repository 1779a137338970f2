using System;
using System.CommandLine;
using System.CommandLine.Parsing;

namespace LaserTracking.Host.Commands
{
    /// <summary>Says in one line what is wrong with a command line: the word, what is wrong with it, what to do.</summary>
    internal static class UsageProblem
    {
        /// <param name="parsed">Has errors.</param>
        public static string Describe(ParseResult parsed)
        {
            string command = Path(parsed.CommandResult);
            string remedy = command.Length == 0 ? "'./range help' lists the commands" : $"'./range help {command}' shows the usage";
            return What(parsed, command) + "; " + remedy;
        }

        private static string What(ParseResult parsed, string command)
        {
            if (parsed.UnmatchedTokens.Count > 0)
            {
                string word = parsed.UnmatchedTokens[0];
                return word + ": " + (word.StartsWith('-') ? "there is no such option" : command is "" or "calibrate" ? "there is no such command" : "one word too many");
            }

            ParseError error = parsed.Errors[^1];
            if (error.SymbolResult is OptionResult option)
            {
                if (option.Tokens.Count == 0)
                    return option.Option.Name + (option.IdentifierToken == null ? ": must be given" : ": its value is missing");
                string? kind = KindOf(option.Option.ValueType);
                if (kind != null)
                    return $"{option.Option.Name}: \"{option.Tokens[^1].Value}\" is not {kind}";
            }

            if (error.SymbolResult is ArgumentResult { Tokens.Count: 0 } argument)
                return $"{command}: {argument.Argument.Name} is missing";
            return (command.Length == 0 ? string.Empty : command + ": ") + error.Message.TrimEnd('.');
        }

        private static string? KindOf(Type type)
        {
            Type number = Nullable.GetUnderlyingType(type) ?? type;
            return number == typeof(int) ? "a whole number up to 2147483647" : number == typeof(long) ? "a whole number" : number == typeof(double) ? "a number" : null;
        }

        /// <summary>"calibrate screen"; empty for the program itself.</summary>
        private static string Path(CommandResult result)
        {
            string path = string.Empty;
            for (SymbolResult? at = result; at is CommandResult { Command: not RootCommand } command; at = at.Parent)
                path = command.Command.Name + (path.Length == 0 ? string.Empty : " " + path);
            return path;
        }
    }
}
