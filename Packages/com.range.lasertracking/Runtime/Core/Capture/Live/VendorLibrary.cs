using System;
using System.IO;

namespace LaserTracking.Capture.Live
{
    /// <summary>Tells a vendor's library that is not installed from one that fails.</summary>
    public static class VendorLibrary
    {
        /// <summary>Calls into a vendor's library for the first time, so that a missing file is said before a session begins and not in it.</summary>
        /// <param name="library">Its name, for the message.</param>
        /// <param name="call">The call; in a method of its own, so that it can be compiled without the library.</param>
        /// <param name="remedy">How to install it, without a full stop.</param>
        /// <exception cref="InputException">It, or a library it needs, is missing or of another kind of machine.</exception>
        public static void Check(string library, Action call, string remedy)
        {
            try
            {
                call();
            }
            catch (Exception problem) when (IsMissing(problem))
            {
                throw new InputException(library, Describe(problem), remedy);
            }
            catch (Exception)
            {
                // It is there. What it complains of is for the session to see, which tries again.
            }
        }

        /// <summary>Whether the exception says that a managed or native library cannot be loaded, or is another version.</summary>
        public static bool IsMissing(Exception problem)
        {
            switch (Cause(problem))
            {
                case TypeLoadException _: // DllNotFound and EntryPointNotFound too.
                case BadImageFormatException _:
                case FileNotFoundException _:
                case FileLoadException _:
                case MissingMemberException _:
                    return true;
                default:
                    return false;
            }
        }

        /// <summary>One line: what an exception of a vendor's library says.</summary>
        public static string Describe(Exception problem)
        {
            Exception cause = Cause(problem);
            string text = cause.Message.Replace("\r", "").Replace('\n', ' ').Trim().TrimEnd('.');
            return IsMissing(cause) ? "its library cannot be loaded (" + text + ")" : text.Length == 0 ? cause.GetType().Name : text;
        }

        /// <summary>A static constructor that fails hides the reason within.</summary>
        private static Exception Cause(Exception problem)
        {
            while (problem is TypeInitializationException && problem.InnerException != null)
                problem = problem.InnerException;
            return problem;
        }
    }
}
