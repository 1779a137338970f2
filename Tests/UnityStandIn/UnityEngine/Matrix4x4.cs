// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace UnityEngine
{
    public struct Matrix4x4 : IEquatable<Matrix4x4>
    {
        public float m00;
        public float m10;
        public float m20;
        public float m30;
        public float m01;
        public float m11;
        public float m21;
        public float m31;
        public float m02;
        public float m12;
        public float m22;
        public float m32;
        public float m03;
        public float m13;
        public float m23;
        public float m33;

        public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
        {
            m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
            m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
            m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
            m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
        }

        public static Matrix4x4 identity => Scale(Vector3.one);

        /// <summary>General 4×4 inverse; zero for a singular matrix, as in Unity.</summary>
        public Matrix4x4 inverse => MatrixInverse.Of(this);

        /// <summary>Of the upper 3×3 when its columns are perpendicular; their lengths are the scale and do not matter.</summary>
        public Quaternion rotation
        {
            get
            {
                Vector3 x = new Vector3(m00, m10, m20).normalized, y = new Vector3(m01, m11, m21).normalized, z = new Vector3(m02, m12, m22).normalized;
                float trace = x.x + y.y + z.z;
                if (trace > 0)
                {
                    float s = (float)Math.Sqrt(trace + 1) * 2;
                    return new Quaternion((y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s, s / 4);
                }

                if (x.x > y.y && x.x > z.z)
                {
                    float s = (float)Math.Sqrt(1 + x.x - y.y - z.z) * 2;
                    return new Quaternion(s / 4, (y.x + x.y) / s, (z.x + x.z) / s, (y.z - z.y) / s);
                }

                if (y.y > z.z)
                {
                    float s = (float)Math.Sqrt(1 + y.y - x.x - z.z) * 2;
                    return new Quaternion((y.x + x.y) / s, s / 4, (z.y + y.z) / s, (z.x - x.z) / s);
                }

                float r = (float)Math.Sqrt(1 + z.z - x.x - y.y) * 2;
                return new Quaternion((z.x + x.z) / r, (z.y + y.z) / r, r / 4, (x.y - y.x) / r);
            }
        }

        public float this[int row, int column]
        {
            get => this[row + column * 4];
            set => this[row + column * 4] = value;
        }

        /// <summary>Column by column.</summary>
        public float this[int index]
        {
            get => index switch
            {
                0 => m00, 1 => m10, 2 => m20, 3 => m30, 4 => m01, 5 => m11, 6 => m21, 7 => m31,
                8 => m02, 9 => m12, 10 => m22, 11 => m32, 12 => m03, 13 => m13, 14 => m23, 15 => m33,
                _ => throw new IndexOutOfRangeException("Invalid matrix index!"),
            };
            set
            {
                switch (index)
                {
                    case 0: m00 = value; break;
                    case 1: m10 = value; break;
                    case 2: m20 = value; break;
                    case 3: m30 = value; break;
                    case 4: m01 = value; break;
                    case 5: m11 = value; break;
                    case 6: m21 = value; break;
                    case 7: m31 = value; break;
                    case 8: m02 = value; break;
                    case 9: m12 = value; break;
                    case 10: m22 = value; break;
                    case 11: m32 = value; break;
                    case 12: m03 = value; break;
                    case 13: m13 = value; break;
                    case 14: m23 = value; break;
                    case 15: m33 = value; break;
                    default: throw new IndexOutOfRangeException("Invalid matrix index!");
                }
            }
        }

        public static Matrix4x4 Translate(Vector3 vector) => FromAxes(Vector3.right, Vector3.up, Vector3.forward, vector);

        public static Matrix4x4 Rotate(Quaternion q) => FromAxes(q * Vector3.right, q * Vector3.up, q * Vector3.forward);

        public static Matrix4x4 Scale(Vector3 vector) =>
            FromAxes(Vector3.right * vector.x, Vector3.up * vector.y, Vector3.forward * vector.z);

        public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s) => Translate(pos) * Rotate(q) * Scale(s);

        public Vector3 MultiplyPoint3x4(Vector3 point) => MultiplyVector(point) + new Vector3(m03, m13, m23);

        public Vector3 MultiplyVector(Vector3 vector) => new Vector3(
            m00 * vector.x + m01 * vector.y + m02 * vector.z,
            m10 * vector.x + m11 * vector.y + m12 * vector.z,
            m20 * vector.x + m21 * vector.y + m22 * vector.z);

        public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs)
        {
            var product = default(Matrix4x4);
            for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
            {
                product[row, column] = lhs[row, 0] * rhs[0, column] + lhs[row, 1] * rhs[1, column]
                    + lhs[row, 2] * rhs[2, column] + lhs[row, 3] * rhs[3, column];
            }

            return product;
        }

        public bool Equals(Matrix4x4 other)
        {
            for (int i = 0; i < 16; i++)
            {
                if (this[i] != other[i])
                    return false;
            }

            return true;
        }

        public override bool Equals(object other) => other is Matrix4x4 m && Equals(m);

        public override int GetHashCode()
        {
            int hash = 0;
            for (int i = 0; i < 16; i++)
                hash = hash * 31 + this[i].GetHashCode();
            return hash;
        }

        internal static Matrix4x4 FromAxes(Vector3 x, Vector3 y, Vector3 z, Vector3 origin = default) => new Matrix4x4(
            new Vector4(x.x, x.y, x.z, 0), new Vector4(y.x, y.y, y.z, 0), new Vector4(z.x, z.y, z.z, 0),
            new Vector4(origin.x, origin.y, origin.z, 1));
    }
}
