using System;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using LaserTracking.Pipeline;

namespace LaserTracking.Host.Sessions
{
    /// <summary>A recording of what the projector showed, brought on the camera's clock by what both show.</summary>
    internal sealed class RenderedVideo : IDisposable
    {
        /// <summary>Where the delay is put, µs: the fine measurement has room to both sides.</summary>
        private const long NominalDelayUs = 100_000;

        private const double MinCorrelation = 0.4;
        private readonly IFrameSource _pictures;
        private readonly RenderedFeed _feed;

        private RenderedVideo(IFrameSource pictures, RangeCalibration calibration, long offsetUs)
        {
            var history = new RenderedFrameHistory();
            _pictures = pictures;
            _feed = new RenderedFeed(pictures, history, offsetUs - NominalDelayUs, 0);
            Expected = new ExpectedView(history, calibration);
        }

        /// <summary>For the detector.</summary>
        public ExpectedView Expected { get; }

        /// <summary>
        /// Reads the video once and the camera's recording as far as it takes to find their clocks' difference. Null when nothing
        /// fits; the problem then says so.
        /// </summary>
        /// <exception cref="InputException">The video cannot be read.</exception>
        public static RenderedVideo? Open(string path, string cameraPath, RangeCalibration calibration, CancellationToken interrupted, out string problem)
        {
            problem = "";
            var clock = new RenderedClock(calibration);
            using (var progress = new ProgressLine())
            {
                Read(FrameSources.OpenPictures(path), progress, "rendered video", interrupted, frame =>
                {
                    clock.AddPicture(frame.Color, frame.TimeUs);
                    return true;
                });
                Read(FrameSources.OpenScreenCamera(cameraPath), progress, "clock of the rendered video", interrupted, frame =>
                {
                    if (frame.Color.Width == calibration.ImageWidth && frame.Color.Height == calibration.ImageHeight)
                        clock.AddCameraFrame(frame.Color, frame.TimeUs);
                    return clock.MovingFrames < RenderedClock.EnoughMovingFrames;
                });
            }

            if (clock.TryFind(MinCorrelation, out long offsetUs, out double correlation))
                return new RenderedVideo(new PrefetchingFrameSource(FrameSources.OpenPictures(path)), calibration, offsetUs);
            problem = clock.MovingFrames == 0
                ? FormattableString.Invariant($"nothing moves in the camera's picture: when it saw the pictures of {path} cannot be told; they are not used")
                : FormattableString.Invariant($"what the camera saw does not fit the pictures of {path} (best correlation {correlation:F2}, {MinCorrelation} is needed): they are not used; check video and calibration");
            return null;
        }

        /// <summary>Before each frame of the camera.</summary>
        public void AdvanceTo(long cameraTimeUs) => _feed.AdvanceTo(cameraTimeUs);

        public void Dispose()
        {
            _feed.Dispose();
            _pictures.Dispose();
        }

        private static void Read(IFrameSource source, ProgressLine progress, string what, CancellationToken interrupted, Func<Frame, bool> take)
        {
            using (source)
            {
                using var frame = new Frame();
                while (source.TryRead(frame) && !interrupted.IsCancellationRequested)
                {
                    progress.Show(FormattableString.Invariant($"{what}, frame {frame.Index + 1}"));
                    if (frame.Color.IsPresent && !take(frame))
                        break;
                }
            }

            interrupted.ThrowIfCancellationRequested();
        }
    }
}
