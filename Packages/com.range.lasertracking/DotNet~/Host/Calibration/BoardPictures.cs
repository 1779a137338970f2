using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Geometry;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Sources;
using LaserTracking.Imaging;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Draws what a calibration rests on: each view's corners in their order, and arrows that show how far each is off.</summary>
    internal static class BoardPictures
    {
        private const int WidthWished = 1280;
        private const double ArrowMagnification = 50;
        private const int TitleHeight = 30;
        private const uint Background = 0x202428;
        private const uint Arrow = 0xFFFF00;
        private const uint LeftOut = 0xFF5050;

        private static readonly uint[] RowColors = { 0xFF4040, 0xFFA030, 0x60E060, 0x40D0E0, 0x6080FF, 0xE060E0 };

        public static void Write(string folder, CameraCalibration found, SeenBoards seen, BoardSize? size) =>
            WriteSide(folder, string.Empty, seen, size, i => IndexOf(found.Views, seen.Views[i]), found.ResidualsPx, found.PerViewRmsPx, i => ReasonOf(seen.Names[i], found.LeftOut));

        public static void Write(string folder, StereoSession session, SeenBoards left, SeenBoards right, BoardSize? size)
        {
            StereoCalibration found = session.Both;
            for (int side = 0; side < 2; side++)
            {
                bool isRight = side == 1;
                SeenBoards seen = isRight ? right : left;
                BoardView[] views = found.Pairs.Select(pair => isRight ? pair.Right : pair.Left).ToArray();
                WriteSide(folder, isRight ? "right-" : "left-", seen, size, i => IndexOf(views, seen.Views[i]), i => found.ResidualsPx(i, isRight), found.PerPairRmsPx,
                    i => ReasonOf(seen.Names[i], (isRight ? session.Right : session.Left).LeftOut) ?? ReasonOf(left.Names[i] + " + " + right.Names[i], found.LeftOut) ?? "its partner was left out");
            }
        }

        /// <summary>Every picture of one camera, those that were not used with the reason.</summary>
        private static void WriteSide(string folder, string prefix, SeenBoards seen, BoardSize? size, Func<int, int> usedAs, Func<int, IEnumerable<Vector2D>> residualsPx, double[] rmsPx, Func<int, string?> whyNot)
        {
            using var reader = new PictureFile();
            string[] files = UniqueNames.OfPictures(seen.Names);
            for (int i = 0; i < seen.Views.Length; i++)
            {
                int used = usedAs(i);
                string title = used >= 0
                    ? FormattableString.Invariant($"{seen.Names[i]}: {seen.Views[i]!.ImagePx.Length} corners, rms {rmsPx[used]:F3} px; arrows x{ArrowMagnification:F0}, large square: first corner")
                    : "LEFT OUT " + seen.Names[i] + ": " + (seen.Views[i] == null ? seen.Reasons[i] : whyNot(i));
                Write(reader, Path.Combine(folder, prefix + files[i]), i, used >= 0 ? residualsPx(used).ToArray() : null, title, seen, size);
            }
        }

        private static int IndexOf(IReadOnlyList<BoardView> views, BoardView? view) => view == null ? -1 : Enumerable.Range(0, views.Count).FirstOrDefault(i => ReferenceEquals(views[i], view), -1);

        private static string? ReasonOf(string name, IEnumerable<LeftOutView> leftOut) => leftOut.Where(view => view.Name == name).Select(view => view.Reason).FirstOrDefault();

        /// <summary>Without residuals the view was left out: a red frame, and its corners where they were found.</summary>
        private static void Write(PictureFile reader, string file, int index, Vector2D[]? residuals, string title, SeenBoards seen, BoardSize? size)
        {
            int reduction = Math.Max(1, (seen.Width + WidthWished - 1) / WidthWished);
            int magnification = reduction > 1 ? 1 : Math.Max(1, WidthWished / seen.Width);
            double scale = magnification / (double)reduction;
            using var canvas = new Canvas(seen.Width / reduction * magnification, seen.Height / reduction * magnification + TitleHeight, Background);
            if (seen.Paths[index] is string path)
            {
                using var bgra = new Image();
                ColorConversion.ToBgra(reader.Read(path), bgra);
                if (bgra.Width == seen.Width && bgra.Height == seen.Height)
                    canvas.Draw(bgra, 0, TitleHeight, magnification, reduction);
            }

            Vector2D At(Vector2D px) => new((px.X + 0.5) * scale, (px.Y + 0.5) * scale + TitleHeight);
            Vector2D[] corners = seen.Views[index]?.ImagePx ?? [];
            bool isGrid = size is BoardSize whole && whole.Count == corners.Length;
            int columns = isGrid ? size!.Value.Columns : 1;
            for (int i = 0; i < corners.Length; i++)
            {
                Vector2D at = At(corners[i]), end = at + (residuals?[i] ?? default) * (ArrowMagnification * scale);
                uint color = RowColors[i / columns % RowColors.Length];
                if (isGrid && i > 0)
                {
                    Vector2D before = At(corners[i - 1]);
                    canvas.Line(before.X, before.Y, at.X, at.Y, color);
                }

                int mark = i == 0 ? 7 : 4;
                canvas.Outline((int)at.X - mark, (int)at.Y - mark, 2 * mark + 1, 2 * mark + 1, color);
                canvas.Line(at.X, at.Y, end.X, end.Y, Arrow, 2);
            }

            if (residuals == null)
                canvas.Outline(0, TitleHeight, canvas.Width, canvas.Height - TitleHeight, LeftOut, 6);
            canvas.Text(8, 7, title, residuals == null ? LeftOut : 0xFFFFFF);
            Sessions.ResultFile.CheckNotRead(file, seen.Paths.ToArray());
            Save(file, canvas);
        }

        private static void Save(string path, Canvas canvas)
        {
            using var file = new Sessions.ResultFile(path);
            file.Stream.Write(PngEncoder.Encode(canvas.Image));
            file.Commit();
        }
    }
}
