using System;
using System.IO;
using System.Text;
using System.Text.Json;

namespace LaserTracking.Host.Scoring
{
    /// <summary>CLEAR MOT (Bernardin and Stiefelhagen 2008) and identity metrics (Ristani et al. 2016) of one sequence. Ratios of nothing are NaN.</summary>
    internal sealed record TrackMetrics
    {
        public int Frames { get; init; }

        /// <summary>True boxes.</summary>
        public int Objects { get; init; }

        /// <summary>Tracked boxes.</summary>
        public int Predictions { get; init; }

        /// <summary>True boxes found under the number they had before.</summary>
        public int Matches { get; init; }

        /// <summary>True boxes found under another number than before.</summary>
        public int Switches { get; init; }

        /// <summary>How often a true track is lost and found again.</summary>
        public int Fragmentations { get; init; }

        /// <summary>Over matches and switches: px, or 1 less the intersection over union.</summary>
        public double DistanceSum { get; init; }

        /// <summary>Boxes found under the number that is the track's in the best assignment of numbers over the whole sequence.</summary>
        public int IdentityTruePositives { get; init; }

        /// <summary>True tracks found in at least 80 % of their frames.</summary>
        public int MostlyTracked { get; init; }

        /// <summary>True tracks found in less than 20 % of their frames.</summary>
        public int MostlyLost { get; init; }

        public int PartiallyTracked { get; init; }

        public int Found => Matches + Switches;

        public int Misses => Objects - Found;

        public int FalsePositives => Predictions - Found;

        public double Mota => 1 - (double)(Misses + FalsePositives + Switches) / Objects;

        /// <summary>Mean distance, not the 2008 paper's percentage.</summary>
        public double Motp => DistanceSum / Found;

        public double Precision => (double)Found / Predictions;

        public double Recall => (double)Found / Objects;

        public double IdentityPrecision => (double)IdentityTruePositives / Predictions;

        public double IdentityRecall => (double)IdentityTruePositives / Objects;

        public double IdentityF1 => 2.0 * IdentityTruePositives / (Objects + Predictions);

        /// <summary>With the names of py-motmetrics, 10 decimals, null for what is undefined; ended by a line feed.</summary>
        public string ToJson()
        {
            using var stream = new MemoryStream();
            using (var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true, NewLine = "\n" }))
            {
                json.WriteStartObject();
                json.WriteNumber("num_frames", Frames);
                json.WriteNumber("num_objects", Objects);
                json.WriteNumber("num_predictions", Predictions);
                json.WriteNumber("num_matches", Matches);
                json.WriteNumber("num_switches", Switches);
                json.WriteNumber("num_false_positives", FalsePositives);
                json.WriteNumber("num_misses", Misses);
                json.WriteNumber("num_fragmentations", Fragmentations);
                Ratio(json, "mota", Mota);
                Ratio(json, "motp", Motp);
                Ratio(json, "precision", Precision);
                Ratio(json, "recall", Recall);
                json.WriteNumber("idtp", IdentityTruePositives);
                json.WriteNumber("idfp", Predictions - IdentityTruePositives);
                json.WriteNumber("idfn", Objects - IdentityTruePositives);
                Ratio(json, "idp", IdentityPrecision);
                Ratio(json, "idr", IdentityRecall);
                Ratio(json, "idf1", IdentityF1);
                json.WriteNumber("mostly_tracked", MostlyTracked);
                json.WriteNumber("partially_tracked", PartiallyTracked);
                json.WriteNumber("mostly_lost", MostlyLost);
                json.WriteEndObject();
            }

            return Encoding.UTF8.GetString(stream.ToArray()) + "\n";
        }

        private static void Ratio(Utf8JsonWriter json, string name, double value)
        {
            if (double.IsFinite(value))
                json.WriteNumber(name, Math.Round(value, 10));
            else
                json.WriteNull(name);
        }
    }
}
