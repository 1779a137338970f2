using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Imaging;
using LaserTracking.Session;
using LaserTracking.Simulation;

namespace LaserTracking.Health
{
    /// <summary>What a monitor says of drawn or simulated frames.</summary>
    internal sealed class MonitorRun
    {
        private readonly SessionRecorder _recorder = new SessionRecorder();
        private readonly Frame _frame = new Frame();
        private readonly PixelFormat _format;

        public MonitorRun(PictureMonitorSettings? settings = null, int framesPerSecond = 30, PixelFormat format = PixelFormat.Bgra32)
        {
            _format = format;
            Monitor = new PictureMonitor(_recorder, settings);
            IntervalUs = 1_000_000 / framesPerSecond;
        }

        public PictureMonitor Monitor { get; }

        public FrameBuilder Builder { get; } = new FrameBuilder(320, 240);

        public long IntervalUs { get; }

        public IReadOnlyList<HealthEvent> Said => _recorder.Health;

        public HealthKind[] Kinds => _recorder.Health.Select(h => h.Kind).ToArray();

        /// <summary>Draws and shows frames first … first + count - 1.</summary>
        public MonitorRun Play(int first, int count, Action<FrameBuilder, int> draw)
        {
            for (int i = first; i < first + count; i++)
            {
                draw(Builder, i);
                Builder.Write(_frame, i, i * IntervalUs, _format);
                Monitor.Process(_frame);
            }

            return this;
        }

        /// <summary>Shows the same frame again and again.</summary>
        public MonitorRun Repeat(int first, int count)
        {
            for (int i = first; i < first + count; i++)
            {
                _frame.Index = i;
                _frame.TimeUs = _frame.Color.TimeUs = i * IntervalUs;
                Monitor.Process(_frame);
            }

            return this;
        }

        public MonitorRun Play(SimulationScenario scenario)
        {
            using IFrameSource source = new SimulatedRange(scenario, SimulationScenes.Default()).CreateColorSource();
            return Play(source);
        }

        public MonitorRun Play(IFrameSource source)
        {
            while (source.TryRead(_frame))
                Monitor.Process(_frame);
            return this;
        }

        /// <summary>A room with things in it: shapes all over, so that a displacement shows.</summary>
        public static void Room(FrameBuilder builder, int offsetX = 0, int offsetY = 0, float light = 1)
        {
            builder.Wall(50 * light, 60 * light, 55 * light);
            for (int i = 0; i < 24; i++)
            {
                int x = i * 137 % 330, y = i * 71 % 250;
                builder.Box(x - 10 + offsetX, y - 10 + offsetY, 14 + i % 5 * 6, 12 + i % 4 * 7, (30 + 60 * (i % 3)) * light, (40 + 50 * (i % 4)) * light, (60 + 40 * (i % 2)) * light);
            }
        }
    }
}
