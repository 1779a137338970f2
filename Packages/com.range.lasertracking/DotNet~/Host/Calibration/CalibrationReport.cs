using System.Collections.Generic;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Calibrations of cameras as JSON, field by field as the contract has it.</summary>
    internal static class CalibrationReport
    {
        public static JObject OfCamera(CameraCalibration found, SeenBoards seen, string model, Board? board, double? heldOutPx, IEnumerable<string> notes)
        {
            JObject root = Head("camera", found.RmsPx, found.PerViewRmsPx);
            root.Merge(LensCameraJson.Format(found.Camera));
            root["model"] = model;
            root["std"] = Deviations(found);
            AddBoard(root, board);
            root["views"] = new JArray(found.Views.Select(view => view.Name));
            AddJudgement(root, heldOutPx, seen.Missing().Concat(found.LeftOut), notes.Concat(found.Notes));
            return root;
        }

        /// <param name="left">Camera 0 alone.</param>
        /// <param name="right">Camera 1 alone.</param>
        /// <param name="found">Both.</param>
        /// <param name="missing">Pairs without a board in one picture.</param>
        /// <param name="model">As the user named it.</param>
        /// <param name="board">Null when the points are no grid.</param>
        /// <param name="heldOutPx">Null when there are too few pairs.</param>
        /// <param name="notes">What else the user should know.</param>
        public static JObject OfStereo(CameraCalibration left, CameraCalibration right, StereoCalibration found, IEnumerable<LeftOutView> missing, string model, Board? board, double? heldOutPx, IEnumerable<string> notes)
        {
            StereoRig rig = found.Rig;
            JObject root = Head("stereo", found.RmsPx, found.PerPairRmsPx);
            root.Merge(StereoRigJson.Format(rig));
            AddMono((JObject)root["left"]!, left);
            AddMono((JObject)root["right"]!, right);
            root["model"] = model;
            double[] deviations = found.RigDeviations;
            root["std"] = new JObject { ["R_rad"] = new JArray(deviations.Take(3)), ["T"] = new JArray(deviations.Skip(3)) };
            root["baseline"] = rig.LeftToRight.Position.Length;
            var epipolar = new EpipolarGeometry(rig);
            root["E"] = CalibrationJson.Rows(epipolar.Essential, 3);
            root["F"] = CalibrationJson.Rows(epipolar.Fundamental, 3);
            (double meanSum, double rms) = epipolar.Errors(found.Pairs.SelectMany(TriangulationCheck.Common).Select(point => (point.Left, point.Right)));
            root["epipolar"] = new JObject { ["mean_sum_px"] = meanSum, ["rms_px"] = rms };
            TriangulationCheck check = TriangulationCheck.Of(found);
            root["triangulation"] = new JObject { ["edges"] = check.Edges, ["edge_ratio_mean"] = check.EdgeRatioMean, ["edge_ratio_std"] = check.EdgeRatioDeviation, ["behind"] = check.Behind };
            root["rectification"] = Rectification(rig);
            AddBoard(root, board);
            root["views"] = new JArray(found.Pairs.Select(pair => new JArray(pair.Left.Name, pair.Right.Name)));
            AddJudgement(root, heldOutPx, missing.Concat(found.LeftOut), notes.Concat(left.Notes.Select(note => "left: " + note)).Concat(right.Notes.Select(note => "right: " + note)).Concat(found.Notes).Distinct());
            return root;
        }

        private static JObject Head(string kind, double rmsPx, double[] perViewRmsPx) => new()
        {
            ["v"] = CalibrationJson.Version, ["kind"] = kind, ["rms_px"] = rmsPx, ["per_view_rms_px"] = new JArray(perViewRmsPx),
        };

        private static void AddMono(JObject camera, CameraCalibration alone)
        {
            camera["rms_px"] = alone.RmsPx;
            camera["per_view_rms_px"] = new JArray(alone.PerViewRmsPx);
            camera["std"] = Deviations(alone);
        }

        private static JObject Deviations(CameraCalibration found)
        {
            var deviations = new JObject();
            for (int i = 0; i < CameraParameters.Count; i++)
            {
                if (found.StandardDeviations[i] > 0)
                    deviations[CameraParameters.NameOf(i)] = found.StandardDeviations[i];
            }

            return deviations;
        }

        private static JObject Rectification(StereoRig rig)
        {
            StereoRectification rectified = StereoRectification.Of(rig);
            return new JObject
            {
                ["R1"] = CalibrationJson.Rows(rectified.Left.ToMatrix(), 3),
                ["R2"] = CalibrationJson.Rows(rectified.Right.ToMatrix(), 3),
                ["P1"] = Rows(rectified.Projection(ofRight: false)),
                ["P2"] = Rows(rectified.Projection(ofRight: true)),
                ["Q"] = Rows(rectified.DisparityToDepth()),
            };
        }

        private static JArray Rows(double[] fourColumns) => new(fourColumns.Chunk(4).Select(row => new JArray(row)));

        private static void AddBoard(JObject root, Board? board)
        {
            if (board is { } known)
                root["board"] = new JObject { ["inner_corners"] = new JArray(known.Size.Columns, known.Size.Rows), ["square_mm"] = known.SquareMm };
        }

        private static void AddJudgement(JObject root, double? heldOutPx, IEnumerable<LeftOutView> leftOut, IEnumerable<string> notes)
        {
            if (heldOutPx is double px)
                root["held_out"] = new JObject { ["rms_px"] = px };
            root["left_out"] = new JArray(leftOut.Select(view => new JObject { ["view"] = view.Name, ["why"] = view.Reason }));
            root["notes"] = new JArray(notes);
        }
    }
}
