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

        private static readonly uint[] RowColors = { 0xFF4040, 0xFFA030, 0x60E060, 0x40D0E0, 0x6080FF, 0xE060E0 };

        public static void Write(string folder, CameraCalibration found, SeenBoards seen, BoardSize? size)
        {
            using var reader = new PictureFile();
            for (int i = 0; i < found.Views.Count; i++)
                Write(reader, folder, string.Empty, found.Views[i], found.ResidualsPx(i), found.PerViewRmsPx[i], seen, size);
        }

        public static void Write(string folder, StereoCalibration found, SeenBoards left, SeenBoards right, BoardSize? size)
        {
            using var reader = new PictureFile();
            for (int i = 0; i < found.Pairs.Count; i++)
            {
                Write(reader, folder, "left-", found.Pairs[i].Left, found.ResidualsPx(i, false), found.PerPairRmsPx[i], left, size);
                Write(reader, folder, "right-", found.Pairs[i].Right, found.ResidualsPx(i, true), found.PerPairRmsPx[i], right, size);
            }
        }

        private static void Write(PictureFile reader, string folder, string prefix, BoardView view, IEnumerable<Vector2D> residualsPx, double rmsPx, SeenBoards seen, BoardSize? size)
        {
            int reduction = Math.Max(1, (seen.Width + WidthWished - 1) / WidthWished);
            int magnification = reduction > 1 ? 1 : Math.Max(1, WidthWished / seen.Width);
            double scale = magnification / (double)reduction;
            using var canvas = new Canvas(seen.Width / reduction * magnification, seen.Height / reduction * magnification + TitleHeight, Background);
            if (seen.PathOf(view) is string path)
            {
                using var bgra = new Image();
                ColorConversion.ToBgra(reader.Read(path), bgra);
                if (bgra.Width == seen.Width && bgra.Height == seen.Height)
                    canvas.Draw(bgra, 0, TitleHeight, magnification, reduction);
            }

            Vector2D At(Vector2D px) => new((px.X + 0.5) * scale, (px.Y + 0.5) * scale + TitleHeight);
            Vector2D[] residuals = residualsPx.ToArray();
            bool isGrid = size is BoardSize whole && whole.Count == view.ImagePx.Length;
            int columns = isGrid ? size!.Value.Columns : 1;
            for (int i = 0; i < view.ImagePx.Length; i++)
            {
                Vector2D at = At(view.ImagePx[i]), end = at + residuals[i] * (ArrowMagnification * scale);
                uint color = RowColors[i / columns % RowColors.Length];
                if (isGrid && i > 0)
                {
                    Vector2D before = At(view.ImagePx[i - 1]);
                    canvas.Line(before.X, before.Y, at.X, at.Y, color);
                }

                int mark = i == 0 ? 7 : 4;
                canvas.Outline((int)at.X - mark, (int)at.Y - mark, 2 * mark + 1, 2 * mark + 1, color);
                canvas.Line(at.X, at.Y, end.X, end.Y, Arrow, 2);
            }

            canvas.Text(8, 7, FormattableString.Invariant($"{view.Name}: {view.ImagePx.Length} corners, rms {rmsPx:F3} px; arrows x{ArrowMagnification:F0}, large square: first corner"), 0xFFFFFF);
            string drawn = Path.Combine(folder, prefix + Path.GetFileNameWithoutExtension(view.Name) + ".png");
            Sessions.ResultFile.CheckNotRead(drawn, seen.Paths.ToArray());
            Save(drawn, canvas);
        }

        private static void Save(string path, Canvas canvas)
        {
            using var file = new Sessions.ResultFile(path);
            file.Stream.Write(PngEncoder.Encode(canvas.Image));
            file.Commit();
        }
    }
}
