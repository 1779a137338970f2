using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Studies
{
    /// <summary>A study's result: rows of texts, numbers and <see cref="Proportion"/>s, and notes below them.</summary>
    internal sealed class StudyTable
    {
        private readonly string _title;
        private readonly string[] _columns;
        private readonly List<object[]> _rows = new();

        public StudyTable(string title, params string[] columns)
        {
            _title = title;
            _columns = columns;
        }

        /// <summary>Sentences printed below the table.</summary>
        public List<string> Notes { get; } = new();

        /// <param name="cells">As many as columns: string, int, double (NaN: nothing to measure) or Proportion.</param>
        public void Add(params object[] cells)
        {
            if (cells.Length != _columns.Length)
                throw new ArgumentException("A row needs " + _columns.Length + " cells, not " + cells.Length, nameof(cells));
            _rows.Add(cells);
        }

        public void Print(TextWriter to)
        {
            string[][] texts = _rows.Select(row => row.Select(Text).ToArray()).Prepend(_columns).ToArray();
            int[] widths = Enumerable.Range(0, _columns.Length).Select(c => texts.Max(row => row[c].Length)).ToArray();
            to.WriteLine(_title);
            foreach (string[] row in texts)
                to.WriteLine(string.Join("  ", row.Select((cell, c) => c == 0 ? cell.PadRight(widths[c]) : cell.PadLeft(widths[c]))).TrimEnd());
            foreach (string note in Notes)
                to.WriteLine(note);
        }

        /// <summary>{"title", "rows": [{column: value, …}], "notes"}; a proportion is {"count", "of", "share", "low", "high"}.</summary>
        public string ToJson()
        {
            var rows = new JArray(_rows.Select(row => new JObject(row.Select((cell, c) => new JProperty(_columns[c], Token(cell))))));
            return new JObject { ["title"] = _title, ["rows"] = rows, ["notes"] = new JArray(Notes) }.ToString(Formatting.Indented);
        }

        private static string Text(object cell) => cell switch
        {
            double.NaN => "-",
            double number => number.ToString("0.###", CultureInfo.InvariantCulture),
            IFormattable other => other.ToString(null, CultureInfo.InvariantCulture),
            _ => cell.ToString() ?? string.Empty,
        };

        private static JToken Token(object cell) => cell switch
        {
            Proportion p => new JObject { ["count"] = p.Count, ["of"] = p.Of, ["share"] = p.Of == 0 ? null : p.Share, ["low"] = p.Low, ["high"] = p.High },
            double.NaN => JValue.CreateNull(),
            _ => JToken.FromObject(cell),
        };
    }
}
