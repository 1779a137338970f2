using System;
using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.Live
{
    public sealed class VendorLibraryTests
    {
        [Test]
        public void Check_LibraryMissing_SaysWhichAndWhatToDo()
        {
            Exception[] problems =
            {
                new DllNotFoundException("k4a"), new TypeLoadException("k4a"), new BadImageFormatException("k4a"), new FileNotFoundException("k4a"), new MissingMethodException("k4a"),
                new EntryPointNotFoundException("k4a"), new TypeInitializationException("X", new TypeInitializationException("Y", new DllNotFoundException("k4a"))),
            };
            foreach (Exception problem in problems)
            {
                InputException? said = Assert.Throws<InputException>(() => VendorLibrary.Check("the library", () => throw problem, "install it"));
                Assert.That(said!.Message, Is.EqualTo("the library: its library cannot be loaded (k4a); install it"));
            }
        }

        [Test]
        public void Check_LibraryThatIsThereButFails_IsLeftToTheSession()
        {
            Assert.That(() => VendorLibrary.Check("the library", () => throw new InvalidOperationException("busy"), "install it"), Throws.Nothing);
        }

        [Test]
        public void Describe_MessageOfSeveralLines_IsOne()
        {
            Assert.That(VendorLibrary.Describe(new InvalidOperationException("a\r\nb.\n")), Is.EqualTo("a b"));
            Assert.That(VendorLibrary.Describe(new InvalidOperationException("")), Is.EqualTo("InvalidOperationException"));
        }
    }
}
