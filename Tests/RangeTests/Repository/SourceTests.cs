using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    /// <summary>Rules of the code base that a compiler does not check.</summary>
    public sealed class SourceTests
    {
        private const int MaxLines = 400;

        // Top-level types stand at the namespace's first indentation, or at none in file-scoped namespaces.
        private static readonly Regex PublicType =
            new Regex(@"^(?:    )?public (?:(?:static|sealed|abstract|readonly|unsafe|partial|ref) )*(?:class|struct|interface|enum|record|delegate \S+) (\w+)", RegexOptions.Multiline);

        private static readonly Regex MutableStatic =
            new Regex(@"^\s+(?:(?:public|internal|private|protected|volatile|unsafe) )*static (?!readonly |class |extern |unsafe static )(?:(?:volatile|unsafe) )*[\w.<>\[\],?* ]+? \w+(?: = [^>;][^;]*)?;$", RegexOptions.Multiline);

        private static IEnumerable<string> Product => RepositoryFiles.UnitySources.Where(path => path.StartsWith(RepositoryFiles.Package + "/Runtime/", StringComparison.Ordinal));

        [Test]
        public void Source_EveryFile_HasAtMost400Lines()
        {
            Assert.That(RepositoryFiles.Sources, Has.Count.GreaterThan(100));
            Assert.That(RepositoryFiles.Sources.Where(path => Lines(path).Length > MaxLines), Is.Empty);
        }

        [Test]
        public void Source_PublicType_IsAloneInAFileOfItsName()
        {
            var wrong = new List<string>();
            foreach (string path in Product)
            {
                string[] types = PublicType.Matches(RepositoryFiles.Read(path)).Select(match => match.Groups[1].Value).Distinct().ToArray();
                string name = Path.GetFileName(path).Split('.')[0];
                if (types.Length > 1 || (types.Length == 1 && types[0] != name))
                    wrong.Add(path + ": " + string.Join(", ", types));
            }

            Assert.That(wrong, Is.Empty);
        }

        [Test]
        public void Source_OfCore_UsesOneSymbolOnly()
        {
            var wrong = new List<string>();
            foreach (string path in Product.Where(IsCore))
            {
                foreach (string line in Lines(path).Select(line => line.Trim()))
                {
                    Match condition = Regex.Match(line, @"^#(?:if|elif)\s+(.*)$");
                    if (condition.Success && condition.Groups[1].Value != "NET8_0_OR_GREATER" && condition.Groups[1].Value != "!NET8_0_OR_GREATER")
                        wrong.Add(path + ": " + line);
                    if (line.StartsWith("#define", StringComparison.Ordinal))
                        wrong.Add(path + ": " + line);
                }
            }

            Assert.That(wrong, Is.Empty);
        }

        [Test]
        public void Source_OfCore_KnowsNeitherUnityNorWhatIl2CppCannotDo()
        {
            var banned = new Regex(@"UnityEngine|UnityEditor|Reflection\.Emit|\bdynamic\b [a-z]|AppDomain|Expression\.Compile|DateTime\.(?:Utc)?Now|Environment\.TickCount|Stopwatch|new Random\(\)");
            Assert.That(Product.Where(path => IsCore(path) || IsCalibration(path)).SelectMany(path => Code(path).Where(line => banned.IsMatch(line)).Select(line => path + ": " + line.Trim())), Is.Empty);
        }

        [Test]
        public void Source_OfTheProduct_HasNoMutableStatics()
        {
            // Unity 6.6 no longer reloads the domain when play begins: a static keeps what the last run left in it.
            Assert.That(Product.SelectMany(path => MutableStatic.Matches(RepositoryFiles.Read(path)).Select(match => path + ": " + match.Value.Trim())), Is.Empty);
        }

        [TestCase("        private static int _count;", true)]
        [TestCase("        internal static readonly int[] Table = { 1 };", false)]
        [TestCase("        public static int Twice(int x) => 2 * x;", false)]
        [TestCase("        private static List<int> _all = new List<int>();", true)]
        [TestCase("        public static Homography Identity => new Homography(1);", false)]
        public void MutableStatic_Pattern_FindsFieldsThatCanChange(string line, bool isOne)
        {
            Assert.That(MutableStatic.IsMatch(line), Is.EqualTo(isOne));
        }

        [Test]
        public void Source_Namespace_IsThatOfItsFolder()
        {
            var wrong = new List<string>();
            foreach (string path in Product)
            {
                Match declared = Regex.Match(RepositoryFiles.Read(path), @"^namespace ([\w.]+)", RegexOptions.Multiline);
                if (!declared.Success)
                    continue;
                string[] folders = path.Substring((RepositoryFiles.Package + "/Runtime/").Length).Split('/');
                string root = folders[0] == "Core" ? (folders.Length > 2 ? "LaserTracking." + folders[1] : "LaserTracking") : "LaserTracking." + folders[0];
                if (declared.Groups[1].Value != root && !declared.Groups[1].Value.StartsWith(root + ".", StringComparison.Ordinal))
                    wrong.Add(path + ": " + declared.Groups[1].Value + " instead of " + root);
            }

            Assert.That(wrong, Is.Empty);
        }

        [Test]
        public void Source_MonoBehaviour_HasItsNameAsFileName()
        {
            var behaviour = new Regex(@"class (\w+)[^{\n]*:\s*(?:MonoBehaviour|ScriptableObject|EditorWindow|\w+SourceAsset)\b");
            IEnumerable<string> scripts = Product.Where(path => behaviour.IsMatch(RepositoryFiles.Read(path)));
            Assert.That(scripts, Is.Not.Empty);
            Assert.That(scripts.Where(path => behaviour.Matches(RepositoryFiles.Read(path)).Any(match => match.Groups[1].Value != Path.GetFileNameWithoutExtension(path))), Is.Empty);
        }

        [Test]
        public void Text_EveryFile_IsUtf8WithLineFeedsAndALastOne()
        {
            var wrong = new List<string>();
            foreach (string path in RepositoryFiles.TextFiles())
            {
                byte[] bytes = File.ReadAllBytes(RepositoryFiles.Absolute(path));
                if (bytes.Contains((byte)'\r'))
                    wrong.Add(path + ": carriage return");
                if (bytes.Length > 2 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf)
                    wrong.Add(path + ": byte order mark");
                if (bytes.Length > 0 && bytes[bytes.Length - 1] != (byte)'\n')
                    wrong.Add(path + ": no line feed at the end");
                if (!IsUtf8(bytes))
                    wrong.Add(path + ": not UTF-8");
            }

            Assert.That(wrong, Is.Empty);
        }

        private static bool IsCore(string path) => path.StartsWith(RepositoryFiles.Core + "/", StringComparison.Ordinal);

        private static bool IsCalibration(string path) => path.StartsWith(RepositoryFiles.Package + "/Runtime/Calibration/", StringComparison.Ordinal);

        private static string[] Lines(string path) => RepositoryFiles.Read(path).TrimEnd('\n').Split('\n');

        private static IEnumerable<string> Code(string path) => Lines(path).Where(line => !line.TrimStart().StartsWith("//", StringComparison.Ordinal));

        private static bool IsUtf8(byte[] bytes)
        {
            try
            {
                new UTF8Encoding(false, throwOnInvalidBytes: true).GetCharCount(bytes);
                return true;
            }
            catch (DecoderFallbackException)
            {
                return false;
            }
        }
    }
}
