; sha256 c11821562ebeef0563a49b55156ff06099b318e1310ca0547e682f3b9472954e

@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.20 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.21 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.19 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.20, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.21, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.54 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.55 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.54, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.55, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.71 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.72 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.71, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.72, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17.115 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18.116 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.114 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17.115, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18.116, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.149 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.150 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.127 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.149, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.150, ptr null, i32 0 }
@switch.table.advance_of_many.3 = private unnamed_addr constant [9 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table.advance_of_many.8 = private unnamed_addr constant [17 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8
@switch.table.advance_of_many.17 = private unnamed_addr constant [8 x double] [double 1.800000e-01, double 4.600000e-01, double 7.500000e-01, double 9.300000e-01, double 1.800000e-01, double 4.600000e-01, double 7.500000e-01, double 9.300000e-01], align 8
@switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.23 = private unnamed_addr constant [8 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, i64 %arg.shape.7, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, i64 %arg.linear.3.0, i64 %arg.linear.3.1, i64 %arg.linear.3.2, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.110.i.i = alloca double, align 8
  %.833.i9945 = alloca double, align 8
  %.1589.i = alloca [3 x double], align 8
  %.1648.i = alloca [3 x double], align 8
  %.1853.i = alloca [3 x double], align 8
  %.2538.i = alloca [3 x double], align 8
  %.4216 = alloca i8, align 1
  store i8 0, ptr %.4216, align 1
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.4798 = alloca i8, align 1
  store i8 0, ptr %.4798, align 1
  %excinfo.12 = alloca ptr, align 8
  store ptr null, ptr %excinfo.12, align 8
  %.469 = mul i64 %arg.shape.1, %arg.shape.0
  %.577.idx = shl i64 %arg.batch.4.0.5.1, 6
  %.577 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.577.idx
  %.616 = icmp eq i64 %arg.shape.2, 9
  %.618 = icmp sgt i64 %arg.shape.2, 4
  %.620 = icmp eq i64 %arg.shape.2, 12
  %.631 = icmp ne i64 %arg.shape.2, 7
  %. = select i1 %.631, i64 1, i64 7
  %.661 = mul nsw i64 %.469, 17
  %.691 = load i64, ptr %arg.code.4, align 8
  %.726 = getelementptr i8, ptr %arg.code.4, i64 56
  %.727 = load i64, ptr %.726, align 8
  %.728.not = icmp eq i64 %.727, 0
  %"$phi516.0.2.0" = select i1 %.728.not, i64 %.691, i64 %.727
  %.815 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.815, i64 0, i64 %arg.shape.0
  br i1 %.815, label %B712, label %B552.if.lr.ph

B552.if.lr.ph:                                    ; preds = %entry
  %.idx.i = mul i64 %arg.batch.4.0.5.1, 24
  %0 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i
  %.321.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %.416.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %1 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1123.i = shl i64 %arg.batch.4.1.5.1, 4
  %2 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1123.i
  %.idx1124.i = mul i64 %arg.batch.4.1.5.1, 24
  %3 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i
  %.7871131.not.i = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.10951137.not.i = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %gep.5.idx.i = mul i64 %arg.batch.4.0.5.1, 40
  %gep.6.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i = mul i64 %arg.batch.4.0.5.1, 232
  %gep.30.idx.i = mul i64 %arg.batch.4.0.5.1, 240
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.30.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 248
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B552.if

B604:                                             ; preds = %B552.if
  %.238.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.291.i9804 = getelementptr double, ptr %0, i64 %.801.010262
  store double 0.000000e+00, ptr %.291.i9804, align 8, !noalias !0
  %.322.i = load i64, ptr %.321.i, align 8, !noalias !0
  %.324.i = icmp eq i64 %.238.i, %.322.i
  br i1 %.324.i, label %B648, label %B142.i

B142.i:                                           ; preds = %B604
  %.357.i = add nsw i64 %.238.i, 1
  store i64 %.357.i, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 2, ptr %.416.i, align 8, !noalias !0
  %.436.i = icmp slt i64 %.238.i, 0
  %.437.i = select i1 %.436.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.238.i
  %.451.i = getelementptr i64, ptr %8, i64 %.437.i
  %.452.i9805 = load i64, ptr %.451.i, align 8, !noalias !0
  %.467.i = icmp slt i64 %.452.i9805, 0
  %.468.i = select i1 %.467.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.452.i9805
  %.482.i = getelementptr i64, ptr %9, i64 %.468.i
  %.483.i = load i64, ptr %.482.i, align 8, !noalias !0
  %.534.i9806 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.801.010262
  store i64 %.238.i, ptr %.534.i9806, align 8, !noalias !0
  %.585.i = getelementptr i64, ptr %1, i64 %.801.010262
  store i64 %.483.i, ptr %.585.i, align 8, !noalias !0
  %.640.i = getelementptr i64, ptr %2, i64 %.801.010262
  store i64 1, ptr %.640.i, align 8, !noalias !0
  %.691.i = getelementptr i64, ptr %3, i64 %.801.010262
  store i64 0, ptr %.691.i, align 8, !noalias !0
  br i1 %.7871131.not.i, label %B462.i, label %B418.if.lr.ph.i

B418.if.lr.ph.i:                                  ; preds = %B142.i
  %.849.i = select i1 %.436.i, i64 %arg.batch.0.1.5.0, i64 0
  %.850.i = add i64 %.849.i, %.238.i
  %.870.i = mul i64 %.850.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.870.i
  %invariant.gep10610 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.801.010262
  br label %B418.if.i

B462.i:                                           ; preds = %B418.if.i, %B142.i
  br i1 %.175.i1134.not.i, label %B462.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B462.i
  %.968.i = load i64, ptr %.585.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.968.i, 0
  %.237.i.i = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i, %.968.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i9807

B76.if.i.i9807:                                   ; preds = %B76.if.i.i9807, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i9807 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i, %.801.010262
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i9808 = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i9808
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B462.endif.i, label %B76.if.i.i9807

B1038.i:                                          ; preds = %B660.if.i
  store double 0.000000e+00, ptr %.1827.i, align 8, !noalias !0
  br label %B648

B418.if.i:                                        ; preds = %B418.if.i, %B418.if.lr.ph.i
  %.729.01132.i = phi i64 [ 0, %B418.if.lr.ph.i ], [ %.800.i, %B418.if.i ]
  %.800.i = add nsw i64 %.729.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.729.01132.i
  %.875.i = load double, ptr %15, align 8, !noalias !0
  %.877.i = mul nsw i64 %.729.01132.i, %arg.shape.0
  %gep10611 = getelementptr double, ptr %invariant.gep10610, i64 %.877.i
  store double %.875.i, ptr %gep10611, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.800.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B462.i, label %B418.if.i

B462.endif.i:                                     ; preds = %B76.if.i.i9807, %B462.i
  br i1 %.10951137.not.i, label %B660.if.i, label %B566.if.lr.ph.i

B566.if.lr.ph.i:                                  ; preds = %B462.endif.i
  %.1157.i = select i1 %.436.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1158.i = add i64 %.1157.i, %.238.i
  %.1178.i = mul i64 %.1158.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1178.i
  %invariant.gep10612 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.801.010262
  br label %B566.if.i

B566.if.i:                                        ; preds = %B566.if.i, %B566.if.lr.ph.i
  %.1039.01138.i = phi i64 [ 0, %B566.if.lr.ph.i ], [ %.1108.i, %B566.if.i ]
  %.1108.i = add nsw i64 %.1039.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1039.01138.i
  %.1183.i = load double, ptr %17, align 8, !noalias !0
  %.1185.i9809 = mul nsw i64 %.1039.01138.i, %arg.shape.0
  %gep10613 = getelementptr double, ptr %invariant.gep10612, i64 %.1185.i9809
  store double %.1183.i, ptr %gep10613, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1108.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B660.if.i, label %B566.if.i

B660.if.i:                                        ; preds = %B566.if.i, %B462.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.801.010262
  store double 0.000000e+00, ptr %invariant.gep.i, align 8, !noalias !0
  %gep.1.i = getelementptr double, ptr %invariant.gep.i, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i, align 8, !noalias !0
  %gep.2.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.2.idx.i
  store double 0.000000e+00, ptr %gep.2.i, align 8, !noalias !0
  %gep.3.i = getelementptr i8, ptr %invariant.gep.i, i64 %.idx.i
  store double 0.000000e+00, ptr %gep.3.i, align 8, !noalias !0
  %gep.4.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.4.idx.i
  store double 0.000000e+00, ptr %gep.4.i, align 8, !noalias !0
  %gep.5.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.5.idx.i
  store double 0.000000e+00, ptr %gep.5.i, align 8, !noalias !0
  %gep.6.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.6.idx.i
  store double 0.000000e+00, ptr %gep.6.i, align 8, !noalias !0
  %gep.7.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.7.idx.i
  store double 0.000000e+00, ptr %gep.7.i, align 8, !noalias !0
  %gep.8.i = getelementptr i8, ptr %invariant.gep.i, i64 %.577.idx
  store double 0.000000e+00, ptr %gep.8.i, align 8, !noalias !0
  %gep.9.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.9.idx.i
  store double 0.000000e+00, ptr %gep.9.i, align 8, !noalias !0
  %gep.10.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.10.idx.i
  store double 0.000000e+00, ptr %gep.10.i, align 8, !noalias !0
  %gep.11.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.11.idx.i
  store double 0.000000e+00, ptr %gep.11.i, align 8, !noalias !0
  %gep.12.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.12.idx.i
  store double 0.000000e+00, ptr %gep.12.i, align 8, !noalias !0
  %gep.13.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.13.idx.i
  store double 0.000000e+00, ptr %gep.13.i, align 8, !noalias !0
  %gep.14.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.14.idx.i
  store double 0.000000e+00, ptr %gep.14.i, align 8, !noalias !0
  %gep.15.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.15.idx.i
  store double 0.000000e+00, ptr %gep.15.i, align 8, !noalias !0
  %gep.16.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.16.idx.i
  store double 0.000000e+00, ptr %gep.16.i, align 8, !noalias !0
  %gep.17.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.17.idx.i
  store double 0.000000e+00, ptr %gep.17.i, align 8, !noalias !0
  %gep.18.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.18.idx.i
  store double 0.000000e+00, ptr %gep.18.i, align 8, !noalias !0
  %gep.19.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.19.idx.i
  store double 0.000000e+00, ptr %gep.19.i, align 8, !noalias !0
  %gep.20.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.20.idx.i
  store double 0.000000e+00, ptr %gep.20.i, align 8, !noalias !0
  %gep.21.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.21.idx.i
  store double 0.000000e+00, ptr %gep.21.i, align 8, !noalias !0
  %gep.22.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.22.idx.i
  store double 0.000000e+00, ptr %gep.22.i, align 8, !noalias !0
  %gep.23.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.23.idx.i
  store double 0.000000e+00, ptr %gep.23.i, align 8, !noalias !0
  %gep.24.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.24.idx.i
  store double 0.000000e+00, ptr %gep.24.i, align 8, !noalias !0
  %gep.25.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.25.idx.i
  store double 0.000000e+00, ptr %gep.25.i, align 8, !noalias !0
  %gep.26.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.26.idx.i
  store double 0.000000e+00, ptr %gep.26.i, align 8, !noalias !0
  %gep.27.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.27.idx.i
  store double 0.000000e+00, ptr %gep.27.i, align 8, !noalias !0
  %gep.28.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.28.idx.i
  store double 0.000000e+00, ptr %gep.28.i, align 8, !noalias !0
  %gep.29.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.29.idx.i
  store double 0.000000e+00, ptr %gep.29.i, align 8, !noalias !0
  %gep.30.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.30.idx.i
  store double 0.000000e+00, ptr %gep.30.i, align 8, !noalias !0
  %.1433.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1490.i = load i64, ptr %.585.i, align 8, !noalias !0
  %.1505.i = icmp slt i64 %.1490.i, 0
  %.1506.i = select i1 %.1505.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1490.i
  %.1520.i = getelementptr double, ptr %18, i64 %.1506.i
  %.1521.i = load double, ptr %.1520.i, align 8, !noalias !0
  store double %.1433.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1622.i = getelementptr double, ptr %4, i64 %.801.010262
  store double %.1521.i, ptr %.1622.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.291.i9804, align 8, !noalias !0
  %.1725.i = getelementptr double, ptr %5, i64 %.801.010262
  store double 0xFFF0000000000000, ptr %.1725.i, align 8, !noalias !0
  %.1776.i = getelementptr double, ptr %6, i64 %.801.010262
  store double 0x7FF0000000000000, ptr %.1776.i, align 8, !noalias !0
  %.1827.i = getelementptr double, ptr %7, i64 %.801.010262
  %.1828.i = load double, ptr %.1827.i, align 8, !noalias !0
  %.1830.i = fcmp ueq double %.1828.i, 0xFFF0000000000000
  br i1 %.1830.i, label %B648, label %B1038.i

B648:                                             ; preds = %B1038.i, %B604, %B660.if.i, %B552.if
  %.1085 = load i64, ptr %449, align 8
  %.1086 = icmp sgt i64 %.1085, -1
  %.9773 = zext i1 %.1086 to i64
  %.1103 = add nsw i64 %active.4.010264, %.9773
  %.859 = icmp sgt i64 %.804.010263, 1
  br i1 %.859, label %B552.if, label %B712

B712:                                             ; preds = %B648, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.1103, %B648 ]
  %.1120.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1136 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1120.not, i1 %.1136, i1 false
  br i1 %or.cond, label %B740.preheader, label %B5580

B740.preheader:                                   ; preds = %B712
  %.1180 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.6, 3
  %factor.op.mul10451 = mul i64 %arg.shape.1, 14
  %factor.op.mul10452 = mul i64 %arg.shape.1, 15
  %factor.op.mul10453 = mul i64 %arg.shape.6, 27
  %.1283 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1332 = icmp sgt i64 %arg.shape.6, 0
  %.155.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx9772 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9772
  %.589.i10265 = icmp sgt i64 %arg.shape.6, 0
  %.1426 = icmp sgt i64 %arg.shape.6, 0
  %.164.i136 = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx9771 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9771
  %.535.i10275 = icmp slt i64 %arg.shape.6, 1
  %.689.i227 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1488.not = icmp eq i64 %arg.shape.3, 0
  %.1518 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1616.idx = shl i64 %.469, 4
  %.1616 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1616.idx
  %.1617 = inttoptr i64 %.691 to ptr
  %.1647 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1723 = getelementptr i8, ptr %arg.code.4, i64 88
  %.1794 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.661
  %.1819.idx = mul i64 %.469, 24
  %.1819 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1819.idx
  %.1850 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx9763 = mul i64 %arg.batch.4.0.5.1, 24
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9763
  %.idx9764 = shl i64 %arg.batch.4.0.5.1, 5
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9764
  %.idx9765 = mul i64 %arg.batch.4.0.5.1, 264
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9765
  %.9774 = select i1 %.618, i64 2, i64 0
  %.754.i875 = icmp ne i64 %arg.shape.2, 1
  %"$phi466.4.2.i.2" = zext i1 %.754.i875 to i64
  %.idx9766 = mul i64 %arg.batch.4.0.5.1, 96
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9766
  %.idx9767 = shl i64 %arg.batch.4.0.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9767
  %.idx9768 = shl i64 %arg.batch.4.1.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9768
  %.idx9769 = shl i64 %arg.batch.4.0.5.1, 4
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9769
  %.idx9770 = mul i64 %arg.batch.4.0.5.1, 184
  %28 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9770
  %.2012.idx = shl i64 %arg.batch.4.0.5.1, 5
  %.2012 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.2012.idx
  %.2046 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2142 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469
  %.2143 = inttoptr i64 %.691 to ptr
  %.317.i2117.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2159.i = mul i64 %arg.shape.1, 136
  %.idx2160.i = mul i64 %arg.shape.1, 88
  %.547.i2141.i = icmp sgt i64 %arg.linear.6.5.0, 1
  %.493.i.12144.i = add nsw i64 %arg.linear.6.5.0, -2
  %.589.i.i = icmp sgt i64 %arg.linear.3.2, 0
  %29 = tail call i64 @llvm.smax.i64(i64 %arg.shape.1, i64 -1)
  %storemerge2107.i = add nsw i64 %29, 1
  %.682.i2120.i = icmp sgt i64 %arg.shape.1, -1
  %.842.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.915.i.i = mul nsw i64 %arg.shape.1, 12
  %.933.i.idx.i = mul i64 %arg.shape.1, 136
  %.933.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.933.i.idx.i
  %.958.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.915.i.i
  %.150.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.510.i.i.i = icmp slt i64 %arg.shape.1, 0
  %.511.i.i.i = select i1 %.510.i.i.i, i64 %arg.linear.5.5.0, i64 0
  %30 = getelementptr i64, ptr %arg.linear.5.4, i64 %arg.shape.1
  %.525.i.i.i = getelementptr i64, ptr %30, i64 %.511.i.i.i
  %.586.i.i.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %.586.i.i.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.586.i.i.idx.i
  %.597.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.615.i.i.i = select i1 %.510.i.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %.idx.i9817 = mul i64 %arg.shape.1, 152
  %31 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i9817
  %.629.i.i.i = getelementptr double, ptr %31, i64 %.615.i.i.i
  %.944.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1748.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2161.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx2161.i
  %.idx2162.i = mul i64 %arg.shape.1, 144
  %.1276.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1276.i.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.idx.i
  %.1276.i.i.idx.c.i = mul i64 %arg.shape.1, 96
  %.1276.i.i.c.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.idx.c.i
  %.1276.i.i.1.idx.i = mul i64 %arg.shape.1, 104
  %.1276.i.i.1.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.1.idx.i
  %.idx2164.i = mul i64 %arg.shape.1, 96
  %.402.i = icmp sgt i64 %arg.shape.1, 0
  %.520.i9811 = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 176
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2261 = add i64 %arg.shape.2, -1
  %storemerge9715 = tail call i64 @llvm.smax.i64(i64 %.2261, i64 0)
  %.230410288.not = icmp slt i64 %.2261, 1
  %.2448 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.661
  %.2474 = inttoptr i64 %"$phi516.0.2.0" to ptr
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond10240.not = select i1 %.616, i1 %.218614.not.i, i1 false
  %.326.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i9818 = mul i64 %arg.shape.1, 80
  %invariant.gep10284 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i9818
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep10286 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %33 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2568 = getelementptr i8, ptr %arg.code.4, i64 72
  %.2645 = icmp sgt i64 %arg.shape.3, 0
  %.2650 = icmp sgt i64 %arg.shape.6, 0
  %.2655 = icmp sgt i64 %arg.shape.7, 0
  %.idx9761 = mul i64 %arg.batch.4.0.5.1, 40
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9761
  %.idx9762 = mul i64 %arg.batch.4.0.5.1, 200
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9762
  %.idx9758 = mul i64 %arg.batch.4.0.5.1, 208
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9758
  %.idx9759 = mul i64 %arg.batch.4.0.5.1, 216
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9759
  %.idx9760 = mul i64 %arg.batch.4.0.5.1, 192
  %38 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9760
  %.idx9752 = shl i64 %arg.batch.4.1.5.1, 4
  %39 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9752
  %.idx9753 = mul i64 %arg.batch.4.0.5.1, 224
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9753
  %.idx9754 = mul i64 %arg.batch.4.0.5.1, 80
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9754
  %.idx9755 = mul i64 %arg.batch.4.0.5.1, 40
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9755
  %.idx9756 = mul i64 %arg.batch.4.0.5.1, 248
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9756
  %.idx9757 = mul i64 %arg.batch.4.0.5.1, 56
  %44 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9757
  %not.brmerge9777 = select i1 %.2655, i1 %.620, i1 false
  %.not10236 = and i1 %.618, %.631
  %.4001 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.661
  %.4026.idx = mul i64 %.469, 104
  %.4026 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4026.idx
  %.4027 = inttoptr i64 %.691 to ptr
  %.4066 = getelementptr i8, ptr %arg.code.4, i64 128
  %.4160 = getelementptr i8, ptr %arg.code.4, i64 120
  %.4674.c = getelementptr i8, ptr %arg.code.4, i64 112
  %.4534 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.661
  %.4560 = inttoptr i64 %.691 to ptr
  %.4597 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4674 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx9745 = shl i64 %arg.batch.4.1.5.1, 4
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9745
  %.idx9746 = mul i64 %arg.batch.4.0.5.1, 40
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9746
  %.idx9747 = mul i64 %arg.batch.4.0.5.1, 56
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9747
  %.idx9748 = mul i64 %arg.batch.4.0.5.1, 232
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9748
  %.idx9749 = mul i64 %arg.batch.4.0.5.1, 48
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9749
  %50 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx9751 = mul i64 %arg.batch.4.0.5.1, 240
  %51 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9751
  %52 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.232.i = getelementptr i8, ptr %52, i64 -8
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx8010.i = mul i64 %arg.batch.4.0.5.1, 152
  %53 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8010.i
  %.idx8007.i = mul i64 %arg.batch.4.0.5.1, 48
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8007.i
  %.287.i2218184.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i355.i = shl i64 %arg.shape.1, 4
  %.idx8000.i = shl i64 %arg.batch.4.1.5.1, 5
  %55 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8000.i
  %.idx8001.i = mul i64 %arg.batch.4.0.5.1, 152
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8001.i
  %.idx8002.i = mul i64 %arg.batch.4.0.5.1, 112
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8002.i
  %.idx8003.i = mul i64 %arg.batch.4.0.5.1, 120
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8003.i
  %storemerge8004.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.194.i.i738.i = mul i64 %arg.shape.6, %arg.shape.0
  %.idx8006.i = mul i64 %arg.batch.4.0.5.1, 160
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8006.i
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %factor.op.mul8210.i.reass = mul i64 %factor.op.mul10451, %arg.shape.0
  %.875.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul8210.i.reass
  %.881.i.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.114.i40.i8194.not.i = icmp slt i64 %.194.i.i738.i, 1
  %.940.i.i = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul8211.i.reass = mul i64 %factor.op.mul10452, %arg.shape.0
  %.1199.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul8211.i.reass
  %.1889.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.155.i.i392.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i392.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i392.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i392.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i392.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i392.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i392.6.i = mul nsw i64 %arg.shape.1, 18
  %.192.i9518228.i = icmp sgt i64 %arg.shape.0, 0
  %.205.i16328229.i = zext i1 %.192.i9518228.i to i64
  %.201.i16298230.i = sext i1 %.192.i9518228.i to i64
  %.136.i821.18231.i = add nsw i64 %storemerge.i, %.201.i16298230.i
  %.430.i8215.not.i = icmp slt i64 %arg.shape.6, 1
  %.580.i1547.i = mul nsw i64 %arg.shape.6, 30
  %.idx7901.i = mul i64 %arg.batch.4.0.5.1, 136
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7901.i
  %.idx7902.i = mul i64 %arg.batch.4.0.5.1, 144
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7902.i
  %.648.i1956.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.739.i2013.idx.i = shl i64 %.469, 7
  %.739.i2013.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.739.i2013.idx.i
  %.764.i.idx.i = mul i64 %.194.i.i738.i, 216
  %.764.i.i = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.764.i.idx.i
  %.155.i571.i.i = mul nsw i64 %arg.shape.6, 28
  %factor.op.mul8305.i.reass = mul i64 %factor.op.mul10453, %arg.shape.0
  %.1450.reass.i = mul i64 %.358.i355.i, %arg.shape.0
  %.1470.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1450.reass.i
  %.1495.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %factor.op.mul8305.i.reass
  %.155.i.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.136.i7232.18329.i = add nsw i64 %storemerge.i, -1
  %.155.i.i.i5004.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i5004.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i5004.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i5004.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i5004.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i5004.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i5004.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx7936.i = mul i64 %arg.batch.4.0.5.1, 56
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7936.i
  %.183.1450.i.i = add nsw i64 %arg.shape.6, -1
  %.454.i.i.i = shl i64 %factor.op.mul.i.reass, 1
  %.320.i.i9840 = shl nsw i64 %arg.shape.6, 1
  %.456.i.2.i.i = shl i64 %factor.op.mul.i.reass, 2
  %.456.i.3.i.i = mul i64 %factor.op.mul.i.reass, 6
  %.456.i.4.i.i = shl i64 %factor.op.mul.i.reass, 3
  %.190.i.1.i.i = mul nsw i64 %factor.op.mul.i.reass, 3
  %.190.i.2.i.i = mul nsw i64 %factor.op.mul.i.reass, 5
  %.190.i.3.i.i = mul nsw i64 %factor.op.mul.i.reass, 7
  %.155.i9394.i = mul nsw i64 %arg.shape.6, 25
  %.idx7944.i = mul i64 %arg.batch.4.0.5.1, 104
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7944.i
  %.idx7945.i = mul i64 %arg.batch.4.0.5.1, 40
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7945.i
  %65 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4976.not = icmp eq i64 %arg.shape.3, 0
  %.idx631.i = shl i64 %arg.shape.0, 4
  %invariant.gep10393 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx631.i
  %.idx632.i = mul i64 %arg.shape.0, 40
  %invariant.gep10395 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx632.i
  %.idx633.i = shl i64 %arg.shape.0, 6
  %invariant.gep10397 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx633.i
  %.idx634.i = mul i64 %arg.shape.0, 88
  %invariant.gep10399 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx634.i
  %.idx635.i = mul i64 %arg.shape.0, 112
  %invariant.gep10401 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx635.i
  %.idx636.i = mul i64 %arg.shape.0, 136
  %invariant.gep10403 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx636.i
  %.idx637.i = mul i64 %arg.shape.0, 160
  %invariant.gep10405 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx637.i
  %.idx638.i = mul i64 %arg.shape.0, 184
  %invariant.gep10407 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx638.i
  %.idx639.i = mul i64 %arg.shape.0, 208
  %invariant.gep10409 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx639.i
  %66 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.228.i.i = getelementptr i8, ptr %66, i64 -8
  %.298.i.i = icmp sgt i64 %arg.shape.2, 4
  %..i.i = select i1 %.298.i.i, i64 0, i64 8
  %.356.i.i9866 = sub nsw i64 9, %..i.i
  %.5221298.not.i.i = icmp slt i64 %arg.shape.0, 1
  %.idx1284.i.i = mul i64 %arg.batch.4.0.5.1, 48
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1284.i.i
  %.287.i1295.not.i.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i9867 = shl nsw i64 %arg.shape.1, 4
  %.709.i.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.155.i.i.i.i9868 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i.i = mul nsw i64 %arg.shape.1, 18
  %.883.11306.i.i = add nsw i64 %arg.shape.0, -1
  %.idx.i.i = mul i64 %arg.batch.4.0.5.1, 56
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i.i
  %.idx1274.i.i = shl i64 %arg.batch.4.1.5.1, 5
  %69 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1274.i.i
  %.idx1276.i.i = mul i64 %arg.batch.4.0.5.1, 40
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1276.i.i
  %.1288.i.i9884 = select i1 %.298.i.i, i64 0, i64 7
  %.idx1277.i.i = mul i64 %arg.batch.4.0.5.1, 112
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1277.i.i
  %.idx1278.i.i = mul i64 %arg.batch.4.0.5.1, 120
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1278.i.i
  %.43.i.i.i = mul nsw i64 %arg.shape.0, 3
  %.454.i.i.i.i = mul i64 %arg.shape.0, 6
  %.456.i.2.i.i.i = mul i64 %arg.shape.0, 12
  %.456.i.3.i.i.i = mul i64 %arg.shape.0, 18
  %.456.i.4.i.i.i = mul i64 %arg.shape.0, 24
  %.190.i.1.i.i.i = mul nsw i64 %arg.shape.0, 9
  %.190.i.2.i.i.i = mul nsw i64 %arg.shape.0, 15
  %.190.i.3.i.i.i = mul nsw i64 %arg.shape.0, 21
  %.323.i.i.i = shl nsw i64 %arg.shape.0, 1
  %73 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx.i9874 = shl i64 %arg.batch.4.1.5.1, 5
  %74 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i9874
  %.idx603.i = mul i64 %arg.batch.4.0.5.1, 40
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx603.i
  %.fca.1.gep282.i = getelementptr inbounds i8, ptr %.1589.i, i64 8
  %.fca.2.gep283.i = getelementptr inbounds i8, ptr %.1589.i, i64 16
  %.fca.1.gep276.i = getelementptr inbounds i8, ptr %.1648.i, i64 8
  %.fca.2.gep277.i = getelementptr inbounds i8, ptr %.1648.i, i64 16
  %.fca.1.gep238.i = getelementptr inbounds i8, ptr %.1853.i, i64 8
  %.fca.2.gep239.i = getelementptr inbounds i8, ptr %.1853.i, i64 16
  %.fca.1.gep131.i = getelementptr inbounds i8, ptr %.2538.i, i64 8
  %.263.idx.i = mul i64 %arg.batch.4.1.5.1, 24
  %.263.i9946 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.263.idx.i
  %.395.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %.395.i9949 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.395.idx.i
  %.512.idx.i = mul i64 %arg.batch.4.0.5.1, 280
  %.512.i9950 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.512.idx.i
  %.600.idx.i = shl i64 %arg.batch.4.1.5.1, 4
  %.600.i = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.600.idx.i
  %.210.i.i = icmp sgt i64 %arg.shape.7, 1
  %.287.i531.not.i.i = icmp slt i64 %arg.shape.1, 1
  %.idx.i.i9964 = mul i64 %arg.shape.1, 192
  %76 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i.i9964
  %.idx544.i.i = mul i64 %arg.shape.1, 184
  %77 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx544.i.i
  %.idx545.i.i = mul i64 %arg.shape.1, 176
  %78 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx545.i.i
  %.idx546.i.i = mul i64 %arg.shape.1, 168
  %79 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx546.i.i
  %.idx547.i.i = mul i64 %arg.shape.1, 160
  %80 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx547.i.i
  %.idx548.i.i = mul i64 %arg.shape.1, 152
  %81 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx548.i.i
  %.idx549.i.i = mul i64 %arg.shape.1, 144
  %82 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx549.i.i
  %.idx550.i.i = shl i64 %arg.shape.1, 7
  %.296.i.i = shl i64 %arg.shape.1, 4
  %.298.i.i9988 = mul nsw i64 %arg.shape.1, 15
  %.313.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.296.i.i
  %.338.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.298.i.i9988
  %.487.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx.i3359.i = mul i64 %arg.shape.1, 192
  %83 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i3359.i
  %.idx544.i3363.i = mul i64 %arg.shape.1, 184
  %84 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx544.i3363.i
  %.idx545.i3367.i = mul i64 %arg.shape.1, 176
  %85 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx545.i3367.i
  %.idx546.i3371.i = mul i64 %arg.shape.1, 168
  %86 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx546.i3371.i
  %.idx547.i3375.i = mul i64 %arg.shape.1, 160
  %87 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx547.i3375.i
  %.idx548.i3379.i = mul i64 %arg.shape.1, 152
  %88 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx548.i3379.i
  %.idx549.i3383.i = mul i64 %arg.shape.1, 144
  %89 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx549.i3383.i
  %.idx550.i3390.i = shl i64 %arg.shape.1, 7
  %.487.i3401.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx551.i3419.i = mul i64 %arg.shape.1, 48
  %.2237.idx.i = mul i64 %arg.batch.4.0.5.1, 40
  %.2237.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.2237.idx.i
  %.214.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.2373.idx.i = mul i64 %arg.batch.4.0.5.1, 56
  %.2373.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.2373.idx.i
  %.idx.i3342.i = mul i64 %arg.shape.1, 56
  %.2992.idx.i = mul i64 %arg.batch.4.0.5.1, 272
  %.2992.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.2992.idx.i
  %.3067.idx.i = shl i64 %arg.batch.4.0.5.1, 4
  %.3067.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.3067.idx.i
  %.3143.idx.i = mul i64 %arg.batch.4.0.5.1, 40
  %.3143.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.3143.idx.i
  %.214.i516.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.3268.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.409.i947.idx.i = shl i64 %arg.batch.4.0.5.1, 7
  %.409.i947.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.409.i947.idx.i
  %90 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.440.i.i = getelementptr i8, ptr %90, i64 -8
  %.813.i.idx.i = mul i64 %arg.batch.4.0.5.1, 24
  %.813.i.i10016 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.813.i.idx.i
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i10029 = shl i64 %arg.batch.4.1.5.1, 4
  %91 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i10029
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.894649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 240
  %95 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.970.i = mul nsw i64 %arg.shape.1, 17
  %96 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5280 = icmp sgt i64 %arg.shape.0, 1
  %.5334.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5334 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5334.idx
  %.5366 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx9738 = mul i64 %arg.batch.4.0.5.1, 104
  %97 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9738
  %.idx9739 = mul i64 %arg.batch.4.0.5.1, 40
  %98 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9739
  %.idx9740 = shl i64 %arg.batch.4.0.5.1, 7
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9740
  %.538.i416410429.not = icmp slt i64 %arg.shape.1, 1
  %.659.i4653 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %100 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.797.i4202 = getelementptr i8, ptr %100, i64 -8
  %.idx9742 = mul i64 %arg.batch.4.1.5.1, 24
  %101 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9742
  %.idx9743 = mul i64 %arg.batch.4.1.5.1, 24
  %102 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9743
  %.idx9744 = mul i64 %arg.batch.4.0.5.1, 24
  %103 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9744
  %.5537.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5537 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5537.idx
  %.114.i4857.idx = mul i64 %arg.batch.4.0.5.1, 272
  %.114.i4857 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.114.i4857.idx
  %.228.i4987.idx = mul i64 %arg.batch.4.0.5.1, 48
  %.228.i4987 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.228.i4987.idx
  %.409.i5114.idx = shl i64 %arg.batch.4.0.5.1, 7
  %.409.i5114 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.409.i5114.idx
  %104 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.440.i5140 = getelementptr i8, ptr %104, i64 -8
  %.530.i5432.idx = mul i64 %arg.batch.4.1.5.1, 24
  %.530.i5432 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.530.i5432.idx
  %.593.i5211.idx = mul i64 %arg.batch.4.1.5.1, 24
  %.593.i5211 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.593.i5211.idx
  %.813.i5369.idx = mul i64 %arg.batch.4.0.5.1, 24
  %.813.i5369 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.813.i5369.idx
  %.5582.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i10043 = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1639.i = mul i64 %arg.batch.4.0.5.1, 40
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1639.i
  %.idx1640.i = shl i64 %arg.batch.4.0.5.1, 4
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1640.i
  %107 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i1642.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.634.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.777.i10048 = getelementptr i8, ptr %arg.code.4, i64 32
  %.848.i = mul nsw i64 %arg.shape.1, 17
  %.850.i10050 = mul nsw i64 %.848.i, %arg.shape.0
  %.893.i10051 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.850.i10050
  %.898.not.i = icmp eq i64 %arg.shape.3, 0
  %.928.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1637.i = shl i64 %arg.batch.4.1.5.1, 4
  %108 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1637.i
  %.15311649.not.i = icmp slt i64 %arg.shape.1, 1
  %.1726.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx9725 = mul i64 %arg.batch.4.0.5.1, 40
  %109 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9725
  %.idx9726 = shl i64 %arg.batch.4.0.5.1, 4
  %110 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9726
  %111 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx9727 = mul i64 %arg.batch.4.0.5.1, 24
  %112 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9727
  %.idx9729 = mul i64 %arg.batch.4.0.5.1, 24
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9729
  %.175.i.i620110441.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx9732 = shl i64 %arg.batch.4.1.5.1, 4
  %114 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9732
  %.idx.i10078 = mul i64 %arg.batch.4.0.5.1, 24
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10078
  %.321.i10080 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %116 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i10100 = mul i64 %arg.batch.4.1.5.1, 24
  %117 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i10100
  %.7871131.not.i10102 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i10118 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.10951137.not.i10137 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i10155 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.6.idx.i10163 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i10165 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i10169 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i10171 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i10173 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i10175 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i10177 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i10179 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i10181 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i10183 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i10185 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i10187 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i10189 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i10191 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i10193 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i10195 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i10197 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i10199 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i10201 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i10203 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i10205 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i10207 = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i10209 = mul i64 %arg.batch.4.0.5.1, 232
  %gep.30.idx.i10211 = mul i64 %arg.batch.4.0.5.1, 240
  %118 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i10155
  %119 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i10183
  %120 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.30.idx.i10211
  %.idx1130.i10226 = mul i64 %arg.batch.4.0.5.1, 248
  %121 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i10226
  %.idx9731 = mul i64 %arg.batch.4.0.5.1, 248
  %122 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9731
  %.6616 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %123 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %124 = getelementptr i8, ptr %123, i64 -8
  %.6630 = getelementptr double, ptr %124, i64 %.6616
  %125 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx9733 = mul i64 %arg.batch.4.0.5.1, 248
  %126 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9733
  %.idx9734 = mul i64 %arg.batch.4.0.5.1, 192
  %127 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9734
  %.idx9735 = shl i64 %arg.batch.4.1.5.1, 4
  %128 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx9735
  %.idx9736 = shl i64 %arg.batch.4.0.5.1, 4
  %129 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9736
  %.idx9737 = mul i64 %arg.batch.4.0.5.1, 184
  %130 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9737
  %131 = shl i64 %arg.shape.0, 3
  %132 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4559.idx = mul i64 %.469, 112
  %.4559 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4559.idx
  %133 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4559.1.idx = mul i64 %.469, 120
  %.4559.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4559.1.idx
  %134 = getelementptr i8, ptr %arg.code.4, i64 248
  %.4559.2.idx = shl i64 %.469, 7
  %.4559.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4559.2.idx
  br label %B740

B740:                                             ; preds = %B740.preheader, %B5554
  %excinfo.13.0 = phi ptr [ %excinfo.13.1, %B5554 ], [ null, %B740.preheader ]
  %excinfo.14.0 = phi ptr [ %excinfo.14.1, %B5554 ], [ null, %B740.preheader ]
  %excinfo.15.0 = phi ptr [ %excinfo.15.1, %B5554 ], [ null, %B740.preheader ]
  %budget.3.1 = phi i64 [ %budget.4.2, %B5554 ], [ %arg.budget, %B740.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B5554 ], [ %active.4.0.lcssa, %B740.preheader ]
  %.1146 = add nsw i64 %budget.3.1, -1
  %.1181 = load i64, ptr %.1180, align 8
  %.1182 = icmp eq i64 %.1181, 2
  %.1220 = icmp sgt i64 %.1181, 0
  br i1 %.1220, label %B818, label %B958

B818:                                             ; preds = %B740
  store i64 0, ptr %.1180, align 8
  %.1284 = load i64, ptr %.1283, align 8
  %.1329 = inttoptr i64 %.1284 to ptr
  tail call void %.1329(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.1332, label %B918, label %B958

B918:                                             ; preds = %B818
  %.156.i = load i64, ptr %.155.i, align 8, !noalias !7
  %.265.i = inttoptr i64 %.156.i to ptr
  tail call void %.265.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.815, label %B918.endif.endif, label %B218.if.i

B290.i:                                           ; preds = %B218.if.i
  store double 0.000000e+00, ptr %135, align 8, !noalias !7
  br i1 %.589.i10265, label %B354.if.i.preheader, label %B466.i

B354.if.i.preheader:                              ; preds = %B290.i
  %invariant.gep10614 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.291.i.010271
  br label %B354.if.i

B424.i:                                           ; preds = %B354.if.i
  store double 1.000000e+00, ptr %135, align 8, !noalias !7
  br label %B464.i

B464.i:                                           ; preds = %B424.i, %B354.if.i
  %some.5.i.3 = phi i1 [ true, %B424.i ], [ %some.4.i.210268, %B354.if.i ]
  %exitcond.not = icmp eq i64 %.602.i, %arg.shape.6
  br i1 %exitcond.not, label %B466.i, label %B354.if.i

B466.i:                                           ; preds = %B464.i, %B290.i, %B218.if.i
  %some.3.i.1 = phi i1 [ %some.2.i.010273, %B218.if.i ], [ %some.2.i.010273, %B290.i ], [ %some.5.i.3, %B464.i ]
  %.349.i = icmp sgt i64 %.294.i.010272, 1
  br i1 %.349.i, label %B218.if.i, label %B918.endif.endif

B218.if.i:                                        ; preds = %B918, %B466.i
  %some.2.i.010273 = phi i1 [ %some.3.i.1, %B466.i ], [ false, %B918 ]
  %.294.i.010272 = phi i64 [ %.358.i, %B466.i ], [ %storemerge, %B918 ]
  %.291.i.010271 = phi i64 [ %.362.i, %B466.i ], [ 0, %B918 ]
  %.358.i = add nsw i64 %.294.i.010272, -1
  %.362.i = add nsw i64 %.291.i.010271, 1
  %135 = getelementptr double, ptr %19, i64 %.291.i.010271
  %.444.i = load double, ptr %135, align 8, !noalias !7
  %.445.i = fcmp oeq double %.444.i, 2.500000e-01
  br i1 %.445.i, label %B290.i, label %B466.i

B354.if.i:                                        ; preds = %B354.if.i.preheader, %B464.i
  %some.4.i.210268 = phi i1 [ %some.5.i.3, %B464.i ], [ %some.2.i.010273, %B354.if.i.preheader ]
  %.530.i.010266 = phi i64 [ %.602.i, %B464.i ], [ 0, %B354.if.i.preheader ]
  %.602.i = add nsw i64 %.530.i.010266, 1
  %.636.i = mul nsw i64 %.530.i.010266, %arg.shape.0
  %gep10615 = getelementptr double, ptr %invariant.gep10614, i64 %.636.i
  %.668.i = load double, ptr %gep10615, align 8, !noalias !7
  %.670.i = add nsw i64 %.530.i.010266, %arg.shape.5
  %.672.i = mul nsw i64 %.670.i, %arg.shape.0
  %.674.i = add nsw i64 %.672.i, %.291.i.010271
  %.688.i = icmp slt i64 %.674.i, 0
  %.689.i = select i1 %.688.i, i64 %arg.batch.5.1.5.0, i64 0
  %136 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.674.i
  %.703.i = getelementptr double, ptr %136, i64 %.689.i
  %.704.i = load double, ptr %.703.i, align 8, !noalias !7
  %.705.i = fcmp une double %.668.i, %.704.i
  br i1 %.705.i, label %B424.i, label %B464.i

B958:                                             ; preds = %B918.endif.endif, %B818, %B740
  %anew.2.1 = phi i1 [ %"$phi956.0.2.2", %B918.endif.endif ], [ %.1182, %B818 ], [ %.1182, %B740 ]
  br i1 %anew.2.1, label %B964, label %B1530

B964:                                             ; preds = %B958
  br i1 %.1426, label %B976, label %B1012

B976:                                             ; preds = %B964
  %.165.i137 = load i64, ptr %.164.i136, align 8, !noalias !11
  %.277.i179 = inttoptr i64 %.165.i137 to ptr
  tail call void %.277.i179(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !11
  br i1 %.815, label %B356.i205, label %B214.if.i

B354.i310:                                        ; preds = %B296.if.i, %B214.if.i
  %.361.i200 = icmp sgt i64 %.306.i94.010280, 1
  br i1 %.361.i200, label %B214.if.i, label %B356.i205

B356.i205:                                        ; preds = %B354.i310, %B976
  %.690.i228 = load i64, ptr %.689.i227, align 8, !noalias !11
  %.806.i = inttoptr i64 %.690.i228 to ptr
  tail call void %.806.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !11
  br label %B1012

B214.if.i:                                        ; preds = %B976, %B354.i310
  %.306.i94.010280 = phi i64 [ %.370.i, %B354.i310 ], [ %storemerge, %B976 ]
  %.303.i.010279 = phi i64 [ %.374.i384, %B354.i310 ], [ 0, %B976 ]
  %.370.i = add nsw i64 %.306.i94.010280, -1
  %.374.i384 = add nsw i64 %.303.i.010279, 1
  %137 = getelementptr double, ptr %20, i64 %.303.i.010279
  %.452.i = load double, ptr %137, align 8, !noalias !11
  %.453.i309 = fcmp ule double %.452.i, 5.000000e-01
  %brmerge10457 = select i1 %.453.i309, i1 true, i1 %.535.i10275
  br i1 %brmerge10457, label %B354.i310, label %B296.if.i.preheader

B296.if.i.preheader:                              ; preds = %B214.if.i
  %invariant.gep10616 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.303.i.010279
  br label %B296.if.i

B296.if.i:                                        ; preds = %B296.if.i.preheader, %B296.if.i
  %.479.i101.010276 = phi i64 [ %.548.i, %B296.if.i ], [ 0, %B296.if.i.preheader ]
  %.548.i = add nsw i64 %.479.i101.010276, 1
  %.574.i = mul nsw i64 %.479.i101.010276, %arg.shape.0
  %gep10617 = getelementptr double, ptr %invariant.gep10616, i64 %.574.i
  %.606.i = load double, ptr %gep10617, align 8, !noalias !11
  %.608.i356 = add nsw i64 %.479.i101.010276, %arg.shape.5
  %.610.i = mul nsw i64 %.608.i356, %arg.shape.0
  %.612.i = add nsw i64 %.610.i, %.303.i.010279
  %.626.i362 = icmp slt i64 %.612.i, 0
  %.627.i = select i1 %.626.i362, i64 %arg.batch.5.1.5.0, i64 0
  %138 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.612.i
  %.641.i = getelementptr double, ptr %138, i64 %.627.i
  store double %.606.i, ptr %.641.i, align 8, !noalias !11
  %exitcond10489.not = icmp eq i64 %.548.i, %arg.shape.6
  br i1 %exitcond10489.not, label %B354.i310, label %B296.if.i

B1012:                                            ; preds = %B356.i205, %B964
  br i1 %.1488.not, label %B1094, label %B1016

B1016:                                            ; preds = %B1012
  %.1519 = load i64, ptr %.1518, align 8
  %.1564 = inttoptr i64 %.1519 to ptr
  tail call void %.1564(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1094

B1094:                                            ; preds = %B1016, %B1012
  br i1 %.618, label %B1098, label %B1488

B1098:                                            ; preds = %B1094
  tail call void %.1617(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1616)
  %.1648 = load i64, ptr %.1647, align 8
  %.1693 = inttoptr i64 %.1648 to ptr
  tail call void %.1693(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1724 = load i64, ptr %.1723, align 8
  %.1769 = inttoptr i64 %.1724 to ptr
  tail call void %.1769(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.1617(ptr %.577, ptr %.1794, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1819)
  %.1851 = load i64, ptr %.1850, align 8
  %.1896 = inttoptr i64 %.1851 to ptr
  tail call void %.1896(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1488

B1488:                                            ; preds = %B1098, %B1094
  br i1 %.815, label %B1530, label %B64.if.i

B118.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.310.i556, align 8, !noalias !15
  %.418.i626 = getelementptr double, ptr %22, i64 %.161.i465.010282
  store double 0.000000e+00, ptr %.418.i626, align 8, !noalias !15
  %.469.i664 = getelementptr double, ptr %23, i64 %.161.i465.010282
  store double 0.000000e+00, ptr %.469.i664, align 8, !noalias !15
  %.520.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i465.010282
  %.521.i704 = load i64, ptr %.520.i, align 8, !noalias !15
  %.544.i718 = icmp slt i64 %.521.i704, 0
  %.545.i719 = select i1 %.544.i718, i64 %arg.batch.3.3.5.0, i64 0
  %.546.i720 = add i64 %.545.i719, %.521.i704
  %.566.i737 = mul i64 %.546.i720, %arg.batch.3.3.5.1
  %139 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.566.i737
  %.570.i739 = getelementptr i8, ptr %139, i64 8
  %.571.i740 = load i64, ptr %.570.i739, align 8, !noalias !15
  %.594.i750 = add nsw i64 %.571.i740, %.9774
  store i64 %.594.i750, ptr %.570.i739, align 8, !noalias !15
  %.702.i831 = load i64, ptr %.520.i, align 8, !noalias !15
  %.725.i848 = icmp slt i64 %.702.i831, 0
  %.726.i849 = select i1 %.725.i848, i64 %arg.batch.3.3.5.0, i64 0
  %.727.i850 = add i64 %.726.i849, %.702.i831
  %.747.i = mul i64 %.727.i850, %arg.batch.3.3.5.1
  %140 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.747.i
  %.751.i872 = getelementptr i8, ptr %140, i64 16
  %.752.i873 = load i64, ptr %.751.i872, align 8, !noalias !15
  %.775.i884 = add nsw i64 %.752.i873, %"$phi466.4.2.i.2"
  store i64 %.775.i884, ptr %.751.i872, align 8, !noalias !15
  %.882.i = getelementptr double, ptr %24, i64 %.161.i465.010282
  %.883.i = load double, ptr %.882.i, align 8, !noalias !15
  %.884.i = fcmp une double %.883.i, 0.000000e+00
  br i1 %.884.i, label %B526.i, label %B582.i

B526.i:                                           ; preds = %B118.i
  %141 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i465.010282
  %.84.i.i = load i64, ptr %141, align 8, !noalias !19
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B582.i

B46.i.i:                                          ; preds = %B526.i
  %.120.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !19
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B582.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !19
  br label %B582.i

B582.i:                                           ; preds = %B80.i.i, %B526.i, %B46.i.i, %B118.i
  br i1 %.1488.not, label %B758.i, label %B586.i

B586.i:                                           ; preds = %B582.i
  %142 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i465.010282
  %.954.i = load double, ptr %142, align 8, !noalias !15
  %.956.i = fcmp olt double %.954.i, -1.000000e-09
  br i1 %.956.i, label %B632.i, label %B758.i

B632.i:                                           ; preds = %B586.i
  %143 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i465.010282
  %.84.i63.i = load i64, ptr %143, align 8, !noalias !22
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i

B46.i71.i:                                        ; preds = %B632.i
  %.120.i91.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !22
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !22
  br label %_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i

_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i: ; preds = %B46.i71.i, %B632.i, %B80.i98.i
  %.1041.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i465.010282
  %.1042.i = load double, ptr %.1041.i, align 8, !noalias !15
  %.1092.i = getelementptr double, ptr %25, i64 %.161.i465.010282
  store double %.1042.i, ptr %.1092.i, align 8, !noalias !15
  br label %B758.i

B758.i:                                           ; preds = %_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i, %B586.i, %B582.i
  %.107.i182.i = getelementptr i64, ptr %26, i64 %.161.i465.010282
  %.108.i183.i = load i64, ptr %.107.i182.i, align 8, !noalias !25
  %.161.i.i = getelementptr double, ptr %27, i64 %.161.i465.010282
  %.162.i.i = load double, ptr %.161.i.i, align 8, !noalias !25
  %.212.i.i = getelementptr double, ptr %28, i64 %.161.i465.010282
  store double %.162.i.i, ptr %.212.i.i, align 8, !noalias !25
  %.225.i.i = icmp slt i64 %.108.i183.i, %arg.batch.2.5.0
  br i1 %.225.i.i, label %B164.i.i, label %B792.i

B164.i.i:                                         ; preds = %B758.i
  %.241.i.i = icmp slt i64 %.108.i183.i, 0
  %.242.i.i = select i1 %.241.i.i, i64 %arg.batch.2.5.0, i64 0
  %144 = getelementptr double, ptr %arg.batch.2.4, i64 %.108.i183.i
  %.256.i.i = getelementptr double, ptr %144, i64 %.242.i.i
  %.257.i.i = load double, ptr %.256.i.i, align 8, !noalias !25
  %.312.i.i = load double, ptr %.161.i.i, align 8, !noalias !25
  %.10.i.i.i = fcmp olt double %.312.i.i, %.257.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.312.i.i, double %.257.i.i
  store double %.11.i.i.i, ptr %.212.i.i, align 8, !noalias !25
  br label %B792.i

B792.i:                                           ; preds = %B164.i.i, %B758.i, %B64.if.i
  %.220.i516 = icmp sgt i64 %.164.i466.010283, 1
  br i1 %.220.i516, label %B64.if.i, label %B1530

B64.if.i:                                         ; preds = %B1488, %B792.i
  %.164.i466.010283 = phi i64 [ %.229.i913, %B792.i ], [ %storemerge, %B1488 ]
  %.161.i465.010282 = phi i64 [ %.233.i916, %B792.i ], [ 0, %B1488 ]
  %.229.i913 = add nsw i64 %.164.i466.010283, -1
  %.233.i916 = add nsw i64 %.161.i465.010282, 1
  %.310.i556 = getelementptr double, ptr %21, i64 %.161.i465.010282
  %.311.i = load double, ptr %.310.i556, align 8, !noalias !15
  %.312.i557 = fcmp ogt double %.311.i, 5.000000e-01
  br i1 %.312.i557, label %B118.i, label %B792.i

B1530:                                            ; preds = %B792.i, %B1488, %B958
  %.2013 = load double, ptr %.2012, align 8
  %.2014 = fcmp ogt double %.2013, 5.000000e-01
  %.2047 = load i64, ptr %.2046, align 8
  %.2092 = inttoptr i64 %.2047 to ptr
  tail call void %.2092(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.618, label %B1732, label %B1660

B1660:                                            ; preds = %B1530
  tail call void %.2143(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2142)
  br label %B1732

B1732:                                            ; preds = %B1660, %B1530
  br i1 %.616, label %B1736, label %B1776

B1736:                                            ; preds = %B1732
  %.267.i = load double, ptr %.2012, align 8, !noalias !29
  %.268.i9810 = fcmp olt double %.267.i, 5.000000e-01
  br i1 %.268.i9810, label %B86.i, label %B126.i

B86.i:                                            ; preds = %B1736
  br i1 %.317.i2117.not.i, label %B186.i.i, label %B84.if.i.i

B186.i.i:                                         ; preds = %B84.if.i.i, %B86.i
  br i1 %.547.i2141.i, label %B252.i.i, label %B126.i

B248.i.loopexit.i:                                ; preds = %B1115.i.i, %B792.i.i
  %.547.i.i = icmp sgt i64 %.493.i.12146.i, 0
  %.560.i.i = zext i1 %.547.i.i to i64
  %.490.i.1.i = add i64 %.490.i.12145.i, %.560.i.i
  %.556.i.i = sext i1 %.547.i.i to i64
  %.493.i.1.i = add nsw i64 %.493.i.12146.i, %.556.i.i
  %.537.i.sroa.0.0.i = select i1 %.547.i.i, i64 %.490.i.12145.i, i64 0
  br i1 %.547.i.i, label %B252.i.i, label %B126.i

B252.i.i:                                         ; preds = %B186.i.i, %B248.i.loopexit.i
  %.537.i.sroa.0.02147.i = phi i64 [ %.537.i.sroa.0.0.i, %B248.i.loopexit.i ], [ 0, %B186.i.i ]
  %.493.i.12146.i = phi i64 [ %.493.i.1.i, %B248.i.loopexit.i ], [ %.493.i.12144.i, %B186.i.i ]
  %.490.i.12145.i = phi i64 [ %.490.i.1.i, %B248.i.loopexit.i ], [ 1, %B186.i.i ]
  br i1 %.589.i.i, label %B270.i.i, label %B750.i.i

B270.i.i:                                         ; preds = %B252.i.i
  br i1 %.682.i2120.i, label %B306.if.i.i, label %B382.i.i

B382.i.i:                                         ; preds = %B306.if.i.i, %B270.i.i
  %.843.i.i = load i64, ptr %.842.i.i, align 8, !noalias !32
  %.959.i.i = inttoptr i64 %.843.i.i to ptr
  tail call void %.959.i.i(ptr %arg.batch.4.0.4, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.958.i.i), !noalias !32
  %.975.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.976.i.i = select i1 %.975.i.i, i64 %arg.linear.6.5.0, i64 0
  %145 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.990.i.i = getelementptr i64, ptr %145, i64 %.976.i.i
  %.991.i.i = load i64, ptr %.990.i.i, align 8, !noalias !32
  %.1007.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1008.i.i = select i1 %.1007.i.i, i64 %arg.linear.6.5.0, i64 0
  %146 = getelementptr i8, ptr %145, i64 8
  %.1022.i.i = getelementptr i64, ptr %146, i64 %.1008.i.i
  %.1023.i.i = load i64, ptr %.1022.i.i, align 8, !noalias !32
  %.1060.i.i = sub i64 %.1023.i.i, %.991.i.i
  %.1106.i2123.not.i = icmp slt i64 %.1060.i.i, 1
  br i1 %.1106.i2123.not.i, label %B792.i.i, label %B606.if.i.i

B614.i.i:                                         ; preds = %B606.if.i.i
  %.1173.i.i = icmp slt i64 %.1047.i.02124.i, 0
  %.1174.i.i = select i1 %.1173.i.i, i64 %arg.linear.7.5.0, i64 0
  %147 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1047.i.02124.i
  %.1188.i.i = getelementptr i64, ptr %147, i64 %.1174.i.i
  %.1189.i.i = load i64, ptr %.1188.i.i, align 8, !noalias !32
  %.1190.i.i = add nsw i64 %.1189.i.i, %.915.i.i
  %.1204.i.i = icmp slt i64 %.1190.i.i, 0
  %.1205.i.i = select i1 %.1204.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %148 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1190.i.i
  %.1219.i.i = getelementptr double, ptr %148, i64 %.1205.i.i
  %.1220.i.i = load double, ptr %.1219.i.i, align 8, !noalias !32
  %.1287.i.i = fsub double %.1220.i.i, %.1220.i.i
  %.1288.i.i = fcmp oeq double %.1287.i.i, 0.000000e+00
  br label %B742.i.i

B742.i.i:                                         ; preds = %B606.if.i.i, %B614.i.i
  %"$phi742.2.2.i.3.i" = phi i1 [ %.1288.i.i, %B614.i.i ], [ false, %B606.if.i.i ]
  %.1106.i.i = icmp sgt i64 %.1050.i.02125.i, 1
  br i1 %.1106.i.i, label %B606.if.i.i, label %B746.i.i

B746.i.i:                                         ; preds = %B742.i.i
  br i1 %"$phi742.2.2.i.3.i", label %B792.i.i, label %B750.i.i

B750.i.i:                                         ; preds = %B746.i.i, %B252.i.i
  %.151.i.i.i = load double, ptr %.150.i.i.i, align 8, !noalias !36
  %.180.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !36
  %.184.i.i.i = fdiv double %.151.i.i.i, %.180.i.i.i
  br i1 %.317.i2117.not.i, label %B272.i.i.i, label %B84.if.i.i.i

B272.i.i.i:                                       ; preds = %B84.if.i.i.i, %B750.i.i
  %.526.i.i.i = load i64, ptr %.525.i.i.i, align 8, !noalias !36
  %.530.i.i.i = icmp eq i64 %.526.i.i.i, %.537.i.sroa.0.02147.i
  br i1 %.530.i.i.i, label %B296.i.i.i, label %B344.i.i.i

B296.i.i.i:                                       ; preds = %B272.i.i.i
  %.587.i.i.i = load double, ptr %.586.i.i.i, align 8, !noalias !36
  %.588.i.i.i = fmul double %.587.i.i.i, 1.000000e-03
  br label %B344.i.i.i

B344.i.i.i:                                       ; preds = %B296.i.i.i, %B272.i.i.i
  %"$phi344.0.2.i.i.0.i" = phi double [ %.588.i.i.i, %B296.i.i.i ], [ 0.000000e+00, %B272.i.i.i ]
  store double %"$phi344.0.2.i.i.0.i", ptr %.629.i.i.i, align 8, !noalias !36
  br i1 %.317.i2117.not.i, label %B574.i.i.1.critedge.i, label %B458.if.i.i.i

B574.i.i.i:                                       ; preds = %B458.if.i.i.i
  %.1034.i.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !36
  %.1068.i.i.i = load double, ptr %.629.i.i.i, align 8, !noalias !36
  %.1070.i.i.i = fmul double %.1068.i.i.i, 5.000000e-01
  %.1073.i.i.i = fadd double %.1034.i.i.i, %.1070.i.i.i
  store double %.1073.i.i.i, ptr %.577, align 8, !noalias !36
  %.1163.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !36
  %.1277.i.i.i = inttoptr i64 %.1163.i.i.i to ptr
  tail call void %.1277.i.i.i(ptr nonnull %.577, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.i), !noalias !36
  br label %B458.if.i.i.1.i

B458.if.i.i.1.i:                                  ; preds = %B458.if.i.i.1.i, %B574.i.i.i
  %.783.i.i.02131.1.i = phi i64 [ %.852.i.i.1.i, %B458.if.i.i.1.i ], [ 0, %B574.i.i.i ]
  %.852.i.i.1.i = add nsw i64 %.783.i.i.02131.1.i, 1
  %149 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.1.i
  %.906.i.i.1.i = load double, ptr %149, align 8, !noalias !36
  %150 = getelementptr double, ptr %149, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %150, align 8, !noalias !36
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %151 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %152 = getelementptr double, ptr %149, i64 %.944.i.i.i
  store double %151, ptr %152, align 8, !noalias !36
  %exitcond2155.1.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.1.i
  br i1 %exitcond2155.1.not.i, label %B574.i.i.1.i, label %B458.if.i.i.1.i

B574.i.i.1.critedge.i:                            ; preds = %B344.i.i.i
  %.1034.i.i.c.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !36
  %.1070.i.i.c.i = fmul double %"$phi344.0.2.i.i.0.i", 5.000000e-01
  %.1073.i.i.c.i = fadd double %.1070.i.i.c.i, %.1034.i.i.c.i
  store double %.1073.i.i.c.i, ptr %.577, align 8, !noalias !36
  %.1163.i.i.c.i = load i64, ptr %arg.code.4, align 8, !noalias !36
  %.1277.i.i.c.i = inttoptr i64 %.1163.i.i.c.i to ptr
  tail call void %.1277.i.i.c.i(ptr nonnull %.577, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.c.i), !noalias !36
  br label %B574.i.i.1.i

B574.i.i.1.i:                                     ; preds = %B458.if.i.i.1.i, %B574.i.i.1.critedge.i
  %.1034.i.i.1.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !36
  %.1068.i.i.1.i = load double, ptr %.629.i.i.i, align 8, !noalias !36
  %.1070.i.i.1.i = fmul double %.1068.i.i.1.i, 5.000000e-01
  %153 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %153, ptr %.577, align 8, !noalias !36
  %.1163.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !36
  %.1277.i.i.1.i = inttoptr i64 %.1163.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.577, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !36
  br i1 %.317.i2117.not.i, label %B792.i.i, label %B904.if.i.i.i

B1130.i.i.i:                                      ; preds = %B904.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1237.i.i.i

B1180.i.i.i:                                      ; preds = %B904.if.i.i.i
  %154 = getelementptr double, ptr %162, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %154, align 8, !noalias !36
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1237.i.i.i

B1237.i.i.i:                                      ; preds = %B1180.i.i.i, %B1130.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1180.i.i.i ], [ %.1601.i.i.i, %B1130.i.i.i ]
  store double %storemerge2111.i, ptr %164, align 8, !noalias !36
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B792.i.i, label %B904.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B750.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B750.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02129.i, 1
  %155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02129.i
  %.341.i.i.i = load double, ptr %155, align 8, !noalias !36
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %156 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %156, double 1.200000e-05
  %157 = getelementptr i64, ptr %arg.linear.5.4, i64 %.212.i.i.02129.i
  %.434.i.i.i = load i64, ptr %157, align 8, !noalias !36
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.537.i.sroa.0.02147.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %158 = getelementptr i8, ptr %155, i64 %.idx2162.i
  store double %"$phi230.1.2.i.i.1.i", ptr %158, align 8, !noalias !36
  %exitcond2154.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2154.not.i, label %B272.i.i.i, label %B84.if.i.i.i

B458.if.i.i.i:                                    ; preds = %B344.i.i.i, %B458.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B458.if.i.i.i ], [ 0, %B344.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02131.i, 1
  %159 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.i
  %.906.i.i.i = load double, ptr %159, align 8, !noalias !36
  %160 = getelementptr double, ptr %159, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %160, align 8, !noalias !36
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %161 = getelementptr double, ptr %159, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %161, align 8, !noalias !36
  %exitcond2155.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2155.not.i, label %B574.i.i.i, label %B458.if.i.i.i

B904.if.i.i.i:                                    ; preds = %B574.i.i.1.i, %B1237.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1237.i.i.i ], [ 0, %B574.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02136.i, 1
  %162 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02136.i
  %.1445.i.i.i = load double, ptr %162, align 8, !noalias !36
  %163 = getelementptr i8, ptr %162, i64 %.933.i.idx.i
  store double %.1445.i.i.i, ptr %163, align 8, !noalias !36
  %164 = getelementptr i8, ptr %162, i64 %.idx2164.i
  %.1513.i.i.i = load double, ptr %164, align 8, !noalias !36
  %165 = getelementptr i8, ptr %162, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %165, align 8, !noalias !36
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B1130.i.i.i, label %B1180.i.i.i

B792.i.i:                                         ; preds = %B1237.i.i.i, %B574.i.i.1.i, %B746.i.i, %B382.i.i
  %.1384.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.1385.i.i = select i1 %.1384.i.i, i64 %arg.linear.6.5.0, i64 0
  %166 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.1399.i.i = getelementptr i64, ptr %166, i64 %.1385.i.i
  %.1400.i.i = load i64, ptr %.1399.i.i, align 8, !noalias !32
  %.1418.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1419.i.i = select i1 %.1418.i.i, i64 %arg.linear.6.5.0, i64 0
  %167 = getelementptr i8, ptr %166, i64 8
  %.1433.i.i = getelementptr i64, ptr %167, i64 %.1419.i.i
  %.1434.i.i = load i64, ptr %.1433.i.i, align 8, !noalias !32
  %.1471.i.i = sub i64 %.1434.i.i, %.1400.i.i
  %.1514.i2138.not.i = icmp slt i64 %.1471.i.i, 1
  br i1 %.1514.i2138.not.i, label %B248.i.loopexit.i, label %B854.if.i.i

B1030.i.i:                                        ; preds = %B854.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %168 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %168, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !32
  br label %B1115.i.i

B1086.i.i:                                        ; preds = %B854.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %169 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %169, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !32
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %170 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %170, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !32
  br label %B1115.i.i

B1115.i.i:                                        ; preds = %B1086.i.i, %B1030.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B854.if.i.i, label %B248.i.loopexit.i

B84.if.i.i:                                       ; preds = %B86.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B86.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %171 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %171, align 8, !noalias !32
  %172 = getelementptr i8, ptr %171, i64 %.idx2159.i
  store double %.384.i.i, ptr %172, align 8, !noalias !32
  %173 = getelementptr i8, ptr %171, i64 %.idx2160.i
  store double 0.000000e+00, ptr %173, align 8, !noalias !32
  %exitcond.not.i9816 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i9816, label %B186.i.i, label %B84.if.i.i

B306.if.i.i:                                      ; preds = %B270.i.i, %B306.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B306.if.i.i ], [ %storemerge2107.i, %B270.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B306.if.i.i ], [ 0, %B270.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %174 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %174, align 8, !noalias !32
  %.755.i.i = icmp eq i64 %.753.i.i, %.537.i.sroa.0.02147.i
  %..i = select i1 %.755.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.626.i.02121.i
  store double %..i, ptr %gep, align 8, !noalias !32
  %.682.i.i = icmp sgt i64 %.629.i.02122.i, 1
  br i1 %.682.i.i, label %B306.if.i.i, label %B382.i.i

B606.if.i.i:                                      ; preds = %B382.i.i, %B742.i.i
  %known.2.i.22126.i = phi i1 [ %"$phi742.2.2.i.3.i", %B742.i.i ], [ true, %B382.i.i ]
  %.1050.i.02125.i = phi i64 [ %.1115.i.i, %B742.i.i ], [ %.1060.i.i, %B382.i.i ]
  %.1047.i.02124.i = phi i64 [ %.1119.i.i, %B742.i.i ], [ %.991.i.i, %B382.i.i ]
  %.1115.i.i = add nsw i64 %.1050.i.02125.i, -1
  %.1119.i.i = add i64 %.1047.i.02124.i, 1
  br i1 %known.2.i.22126.i, label %B614.i.i, label %B742.i.i

B854.if.i.i:                                      ; preds = %B792.i.i, %B1115.i.i
  %.1461.i.02140.i = phi i64 [ %.1523.i.i, %B1115.i.i ], [ %.1471.i.i, %B792.i.i ]
  %.1458.i.02139.i = phi i64 [ %.1527.i.i, %B1115.i.i ], [ %.1400.i.i, %B792.i.i ]
  %.1523.i.i = add nsw i64 %.1461.i.02140.i, -1
  %.1527.i.i = add i64 %.1458.i.02139.i, 1
  %.1571.i.i = icmp slt i64 %.1458.i.02139.i, 0
  %.1572.i.i = select i1 %.1571.i.i, i64 %arg.linear.7.5.0, i64 0
  %175 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1458.i.02139.i
  %.1586.i.i = getelementptr i64, ptr %175, i64 %.1572.i.i
  %.1587.i.i = load i64, ptr %.1586.i.i, align 8, !noalias !32
  %.1588.i.i = add nsw i64 %.1587.i.i, %.915.i.i
  %.1602.i.i = icmp slt i64 %.1588.i.i, 0
  %.1603.i.i = select i1 %.1602.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %176 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1588.i.i
  %.1617.i.i = getelementptr double, ptr %176, i64 %.1603.i.i
  %.1618.i.i = load double, ptr %.1617.i.i, align 8, !noalias !32
  %.1636.i.i = select i1 %.1571.i.i, i64 %arg.linear.8.5.0, i64 0
  %177 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1458.i.02139.i
  %.1650.i.i = getelementptr i64, ptr %177, i64 %.1636.i.i
  %.1651.i.i = load i64, ptr %.1650.i.i, align 8, !noalias !32
  %.1652.i.i = add nsw i64 %.1651.i.i, %.597.i.i.i
  %.1666.i.i = icmp slt i64 %.1652.i.i, 0
  %.1667.i.i = select i1 %.1666.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %178 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1652.i.i
  %.1681.i.i = getelementptr double, ptr %178, i64 %.1667.i.i
  %.1682.i.i = load double, ptr %.1681.i.i, align 8, !noalias !32
  %.1686.i.i = fdiv double %.1618.i.i, %.1682.i.i
  %.1692.i.i = fsub double %.1686.i.i, %.1686.i.i
  %.1693.i.i = fcmp oeq double %.1692.i.i, 0.000000e+00
  %.1686.i..i = select i1 %.1693.i.i, double %.1686.i.i, double 0.000000e+00
  %.1745.i.i = icmp eq i64 %.1651.i.i, %arg.shape.1
  br i1 %.1745.i.i, label %B1030.i.i, label %B1086.i.i

B126.i:                                           ; preds = %B248.i.loopexit.i, %B186.i.i, %B1736
  br i1 %.402.i, label %B156.if.i, label %B1776

B326.i:                                           ; preds = %B272.if.i, %B156.if.i
  %.746.i = mul i64 %.388.02152.i, %.434.sroa.0.02106.i
  %.762.i = icmp slt i64 %.746.i, 0
  %.763.i = select i1 %.762.i, i64 %arg.linear.1.5.0, i64 0
  %179 = getelementptr double, ptr %arg.linear.1.4, i64 %.746.i
  %.777.i = getelementptr double, ptr %179, i64 %.763.i
  %.778.i = load double, ptr %.777.i, align 8, !noalias !29
  %.832.i = load double, ptr %.831.i, align 8, !noalias !29
  %.833.i = fadd double %.778.i, %.832.i
  store double %.833.i, ptr %.777.i, align 8, !noalias !29
  %exitcond2158.not.i = icmp eq i64 %.457.i, %arg.shape.1
  br i1 %exitcond2158.not.i, label %B36.if.i.i, label %B156.if.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1776, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %180 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %180, align 8, !noalias !40
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i9814
  %.561.i.i = icmp slt i64 %.547.i2114.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %181 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i2114.i
  %.576.i.i = getelementptr double, ptr %181, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !40
  %.610.i.i = load double, ptr %183, align 8, !noalias !40
  store double %.577.i.i, ptr %183, align 8, !noalias !40
  store double %.610.i.i, ptr %.576.i.i, align 8, !noalias !40
  br i1 %.362493.not.i.i, label %B528.i.i, label %B466.if.i.i

B528.i.i:                                         ; preds = %B466.if.i.i, %B348.i.i
  %.942.i.i = sub i64 %.11.i492.i.i, %.131.i.i
  %.985504.not.i.i = icmp slt i64 %.942.i.i, 1
  br i1 %.985504.not.i.i, label %B34.loopexit.i.i, label %B566.if.i.i

B790.i.i:                                         ; preds = %B716.if.i.i, %B566.if.i.i
  %.985.i.i = icmp sgt i64 %.932.0506.i.i, 1
  br i1 %.985.i.i, label %B566.if.i.i, label %B34.loopexit.i.i

B36.if.i.i:                                       ; preds = %B326.i, %B34.loopexit.i.i
  %.59.0509.i.i = phi i64 [ %.131.i.i, %B34.loopexit.i.i ], [ 0, %B326.i ]
  %.131.i.i = add nsw i64 %.59.0509.i.i, 1
  %.161.i.i9814 = mul nsw i64 %.59.0509.i.i, %arg.shape.1
  %.164.i.i = add nsw i64 %.59.0509.i.i, %arg.linear.3.0
  %.165.i.i = add nsw i64 %.164.i.i, 1
  %.11.i.i.i9815 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %182 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i9814
  %183 = getelementptr double, ptr %182, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i9815, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %183, align 8, !noalias !40
  %.272.i.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.preheader.i.i
  %p.2.1497.i.i = phi i64 [ %p.3.2.i.i, %B234.if.i.i ], [ %.59.0509.i.i, %B234.if.preheader.i.i ]
  %largest.2.1496.i.i = phi double [ %largest.3.2.i.i, %B234.if.i.i ], [ %.272.i.i, %B234.if.preheader.i.i ]
  %.309.0495.i.i = phi i64 [ %.371.i.i, %B234.if.i.i ], [ %storemerge488.i.i, %B234.if.preheader.i.i ]
  %.306.0494.i.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.preheader.i.i ]
  %.371.i.i = add nsw i64 %.309.0495.i.i, -1
  %.375.i.i = add i64 %.306.0494.i.i, 1
  %.415.i.i = add nsw i64 %.306.0494.i.i, %.161.i.i9814
  %.429.i.i = icmp slt i64 %.415.i.i, 0
  %.430.i.i = select i1 %.429.i.i, i64 %arg.linear.1.5.0, i64 0
  %184 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %184, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !40
  %.446.i.i = tail call double @llvm.fabs.f64(double %.445.i.i)
  %.448.i.i = fcmp ogt double %.446.i.i, %largest.2.1496.i.i
  %largest.3.2.i.i = select i1 %.448.i.i, double %.446.i.i, double %largest.2.1496.i.i
  %p.3.2.i.i = select i1 %.448.i.i, i64 %.306.0494.i.i, i64 %p.2.1497.i.i
  %.362.i.i = icmp sgt i64 %.309.0495.i.i, 1
  br i1 %.362.i.i, label %B234.if.i.i, label %B348.i.i

B466.if.i.i:                                      ; preds = %B348.i.i, %B466.if.i.i
  %.706.0500.i.i = phi i64 [ %.768.i.i, %B466.if.i.i ], [ %storemerge488.i.i, %B348.i.i ]
  %.703.0499.i.i = phi i64 [ %.772.i.i, %B466.if.i.i ], [ %.131.i.i, %B348.i.i ]
  %.768.i.i = add nsw i64 %.706.0500.i.i, -1
  %.772.i.i = add i64 %.703.0499.i.i, 1
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i9814
  %.812.i.i = icmp slt i64 %.798.i.i, 0
  %.813.i.i = select i1 %.812.i.i, i64 %arg.linear.1.5.0, i64 0
  %185 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %185, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i.i, align 8, !noalias !40
  %.861.i.i = load double, ptr %183, align 8, !noalias !40
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i.i, align 8, !noalias !40
  %.759.i.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %186 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i.i = add nsw i64 %186, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %arg.linear.1.5.0, i64 0
  %187 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i.i
  %.1059.i.i = getelementptr double, ptr %187, i64 %.1045.i.i
  %.1060.i2115.i = load double, ptr %.1059.i.i, align 8, !noalias !40
  %.1068.i.i = add nsw i64 %186, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %188 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %188, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !40
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !40
  store double %.1060.i2115.i, ptr %.1097.i.i, align 8, !noalias !40
  %.1171.i.i = fcmp oeq double %.1060.i2115.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %186
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i.i = select i1 %.1310.i.i, i64 %arg.linear.1.5.0, i64 0
  %189 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %189, i64 %.1311.i.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !40
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i9814
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %arg.linear.1.5.0, i64 0
  %190 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %190, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !40
  %.1360.i.i = fmul double %.1060.i2115.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !40
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B156.if.i:                                        ; preds = %B126.i, %B326.i
  %.388.02152.i = phi i64 [ %.457.i, %B326.i ], [ 0, %B126.i ]
  %.457.i = add nsw i64 %.388.02152.i, 1
  %.489.i = sub i64 %.388.02152.i, %32
  %.11.i.i9812 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i = add i64 %.520.i9811, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i9812
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B326.i, label %B272.if.lr.ph.i

B272.if.lr.ph.i:                                  ; preds = %B156.if.i
  %.670.i9813 = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B272.if.i

B272.if.i:                                        ; preds = %B272.if.i, %B272.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B272.if.lr.ph.i ], [ %.639.i, %B272.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i9812, %B272.if.lr.ph.i ], [ %.643.i, %B272.if.i ]
  %.639.i = add nsw i64 %.577.02150.i, -1
  %.643.i = add i64 %.574.02149.i, 1
  %.671.i = add nsw i64 %.574.02149.i, %.670.i9813
  %.685.i = icmp slt i64 %.671.i, 0
  %.686.i = select i1 %.685.i, i64 %arg.linear.0.5.0, i64 0
  %191 = getelementptr double, ptr %arg.linear.0.4, i64 %.671.i
  %.700.i = getelementptr double, ptr %191, i64 %.686.i
  %.701.i = load double, ptr %.700.i, align 8, !noalias !29
  %.702.i = fneg double %.701.i
  %.721.i = select i1 %.685.i, i64 %arg.linear.1.5.0, i64 0
  %192 = getelementptr double, ptr %arg.linear.1.4, i64 %.671.i
  %.735.i = getelementptr double, ptr %192, i64 %.721.i
  store double %.702.i, ptr %.735.i, align 8, !noalias !29
  %.630.i = icmp sgt i64 %.577.02150.i, 1
  br i1 %.630.i, label %B272.if.i, label %B326.i

B1776:                                            ; preds = %B34.loopexit.i.i, %B126.i, %B1732
  br i1 %.230410288.not, label %B1996, label %B1808.if

B68.if.lr.ph.i:                                   ; preds = %B1808.if
  %.259.i = mul nsw i64 %.2317, %arg.shape.1
  br label %B68.if.i

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i
  %exitcond633.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond633.not.i, label %B314.if.i.i, label %B34.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0629.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B326.if.lr.ph.i

B326.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.624.i = mul nsw i64 %.2317, %arg.shape.1
  br label %B326.if.i

B34.if.i.i:                                       ; preds = %B68.if.i, %B34.i.loopexit.i
  %.73.i.0621.i = phi i64 [ %.144.i.i, %B34.i.loopexit.i ], [ 0, %B68.if.i ]
  %.144.i.i = add nsw i64 %.73.i.0621.i, 1
  %193 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0621.i
  %.202.i.i = load i64, ptr %193, align 8, !noalias !43
  %.204.i.i = add nsw i64 %.202.i.i, %.395.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %194 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %194, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !43
  %gep10287 = getelementptr double, ptr %invariant.gep10286, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep10287, align 8, !noalias !43
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !43
  store double %.234.i.i, ptr %gep10287, align 8, !noalias !43
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i9822 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i9822, %.144.i.i
  %.449.i617.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i617.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i
  %.521.i.i = mul nsw i64 %.73.i.0621.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0619.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0618.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0619.i, -1
  %.462.i.i = add i64 %.393.i.0618.i, 1
  %.488.i.i = add nsw i64 %.393.i.0618.i, %.395.i
  %.502.i.i = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %195 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %195, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !43
  %.522.i.i = add nsw i64 %.393.i.0618.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %196 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %196, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !43
  %.554.i.i = fmul double %.234.i.i, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !43
  %.449.i.i = icmp sgt i64 %.396.i.0619.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i

B314.if.i.i:                                      ; preds = %B34.i.loopexit.i, %B314.i.loopexit.i
  %.627.i.0629.in.i = phi i64 [ %.627.i.0629.i, %B314.i.loopexit.i ], [ %arg.shape.1, %B34.i.loopexit.i ]
  %.627.i.0629.i = add nsw i64 %.627.i.0629.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0629.i, %.395.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %197 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i9823 = getelementptr double, ptr %197, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i9823, align 8, !noalias !43
  %.759.i.i9824 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i9824, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %198 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %198, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !43
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i9823, align 8, !noalias !43
  %.866.i.i = sub i64 %.627.i.0629.i, %33
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0629.i, %.11.i4.i.i
  %.975.i623.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i623.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0625.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0624.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0625.i, -1
  %.988.i.i = add i64 %.919.i.0624.i, 1
  %.1014.i.i = add nsw i64 %.919.i.0624.i, %.395.i
  %.1028.i.i = icmp slt i64 %.1014.i.i, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %199 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %199, i64 %.1029.i.i
  %.1044.i.i9825 = load double, ptr %.1043.i.i, align 8, !noalias !43
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i9824
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %200 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %200, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !43
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i9825, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !43
  %.975.i.i9826 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i9826, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %201 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %201, i64 %.275.i
  %.290.i = load double, ptr %.289.i, align 8, !noalias !49
  %gep10285 = getelementptr double, ptr %invariant.gep10284, i64 %.160.0615.i
  %.323.i = load double, ptr %gep10285, align 8, !noalias !49
  %.324.i9819 = fadd double %.290.i, %.323.i
  %202 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %202, align 8, !noalias !49
  %.357.i9820 = add nsw i64 %.356.i, %.326.i
  %.371.i = icmp slt i64 %.357.i9820, 0
  %.372.i = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %203 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i9820
  %.386.i = getelementptr double, ptr %203, i64 %.372.i
  store double %.324.i9819, ptr %.386.i, align 8, !noalias !49
  %exitcond.not.i9821 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i9821, label %B34.if.i.i, label %B68.if.i

B326.if.i:                                        ; preds = %B326.if.i, %B326.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B326.if.lr.ph.i ], [ %.533.i9827, %B326.if.i ]
  %.533.i9827 = add nsw i64 %.464.0631.i, 1
  %204 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i9828 = load i64, ptr %204, align 8, !noalias !49
  %.590.i = add nsw i64 %.589.i9828, %.395.i
  %.604.i = icmp slt i64 %.590.i, 0
  %.605.i9829 = select i1 %.604.i, i64 %arg.batch.5.0.5.0, i64 0
  %205 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %205, i64 %.605.i9829
  %.620.i = load double, ptr %.619.i, align 8, !noalias !49
  %.625.i = add nsw i64 %.464.0631.i, %.624.i
  %.639.i9830 = icmp slt i64 %.625.i, 0
  %.640.i9831 = select i1 %.639.i9830, i64 %arg.batch.5.0.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i = getelementptr double, ptr %206, i64 %.640.i9831
  store double %.620.i, ptr %.654.i, align 8, !noalias !49
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i9827
  br i1 %exitcond634.not.i, label %B1994, label %B326.if.i

B1994:                                            ; preds = %B326.if.i, %B1808.if
  %exitcond10490.not = icmp eq i64 %.2248.010289, %storemerge9715
  br i1 %exitcond10490.not, label %B1996, label %B1808.if

B1996:                                            ; preds = %B1994, %B1776
  %.2569 = load i64, ptr %.2568, align 8
  %.2614 = inttoptr i64 %.2569 to ptr
  tail call void %.2614(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %anew.2.1, i1 true, i1 %.616
  %or.cond9775 = select i1 %brmerge, i1 true, i1 %.2645
  %or.cond9776 = select i1 %or.cond9775, i1 true, i1 %.2650
  %spec.select9802 = select i1 %or.cond9776, i1 true, i1 %.2655
  br i1 %.815, label %B2270, label %B2160.if

B2168:                                            ; preds = %B2160.if
  %207 = getelementptr double, ptr %34, i64 %.2695.010292
  %.2850 = load double, ptr %207, align 8
  %.2851 = fcmp ogt double %.2850, 5.000000e-01
  br label %B2214

B2214:                                            ; preds = %B2168, %B2160.if
  %"$phi2214.1.2.2" = phi i1 [ true, %B2160.if ], [ %.2851, %B2168 ]
  br i1 %looked.2.110295, label %B2266, label %B2220

B2220:                                            ; preds = %B2214
  %208 = getelementptr double, ptr %35, i64 %.2695.010292
  %.2921 = load double, ptr %208, align 8
  %.2922 = fcmp ogt double %.2921, 5.000000e-01
  br label %B2266

B2266:                                            ; preds = %B2220, %B2214
  %"$phi2266.1.2.2" = phi i1 [ true, %B2214 ], [ %.2922, %B2220 ]
  %.2751 = icmp sgt i64 %.2698.010293, 1
  br i1 %.2751, label %B2160.if, label %B2270

B2270:                                            ; preds = %B2266, %B1996
  %good.2.1.lcssa = phi i1 [ false, %B1996 ], [ %"$phi2214.1.2.2", %B2266 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select9802, %B1996 ], [ %"$phi2266.1.2.2", %B2266 ]
  %looked.2.1.lcssa.not10496 = xor i1 %looked.2.1.lcssa, true
  %brmerge10497 = or i1 %.815, %looked.2.1.lcssa.not10496
  br i1 %brmerge10497, label %B2952, label %B82.if.i

B2340.preheader:                                  ; preds = %B682.i
  br i1 %.815, label %B2952, label %B2342.if

B140.i:                                           ; preds = %B82.if.i
  %.313.i1128 = getelementptr double, ptr %36, i64 %.107.i969.010299
  %.314.i1129 = load double, ptr %.313.i1128, align 8, !noalias !50
  %.5.i.i = fptosi double %.314.i1129 to i64
  %.388.i1174 = getelementptr double, ptr %37, i64 %.107.i969.010299
  %.389.i1175 = load double, ptr %.388.i1174, align 8, !noalias !50
  %.5.i1.i = fptosi double %.389.i1175 to i64
  %.465.i1220 = mul i64 %.257.i1082, %arg.batch.3.3.5.1
  %.469.i1224 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.465.i1220
  %.470.i1225 = load i64, ptr %.469.i1224, align 8, !noalias !50
  %.472.i = add nsw i64 %.470.i1225, %.5.i.i
  store i64 %.472.i, ptr %.469.i1224, align 8, !noalias !50
  %.570.i1309 = getelementptr i8, ptr %.469.i1224, i64 24
  %.571.i1310 = load i64, ptr %.570.i1309, align 8, !noalias !50
  %.573.i1312 = add nsw i64 %.571.i1310, %.5.i1.i
  store i64 %.573.i1312, ptr %.570.i1309, align 8, !noalias !50
  %.671.i1397 = getelementptr i8, ptr %.469.i1224, i64 8
  %.672.i1398 = load i64, ptr %.671.i1397, align 8, !noalias !50
  %.677.i1403 = add nsw i64 %.5.i1.i, %.5.i.i
  %.678.i1404 = mul nsw i64 %.677.i1403, %.2261
  %..5.i.i = select i1 %.631, i64 %.5.i.i, i64 0
  %.679.i1405 = add i64 %.678.i1404, %..5.i.i
  %.804.i1504 = add i64 %.679.i1405, %.672.i1398
  store i64 %.804.i1504, ptr %.671.i1397, align 8, !noalias !50
  store double 0.000000e+00, ptr %.313.i1128, align 8, !noalias !50
  store double 0.000000e+00, ptr %.388.i1174, align 8, !noalias !50
  %.1019.i1613 = getelementptr double, ptr %38, i64 %.107.i969.010299
  %.1020.i1614 = load double, ptr %.1019.i1613, align 8, !noalias !50
  %.1028.i = sitofp i64 %.677.i1403 to double
  %.1029.i = fsub double %.1020.i1614, %.1028.i
  store double %.1029.i, ptr %.1019.i1613, align 8, !noalias !50
  br label %B682.i

B682.i:                                           ; preds = %B140.i, %B82.if.i
  %.166.i1030 = icmp sgt i64 %.110.i.010300, 1
  br i1 %.166.i1030, label %B82.if.i, label %B2340.preheader

B82.if.i:                                         ; preds = %B2270, %B682.i
  %.110.i.010300 = phi i64 [ %.175.i1656, %B682.i ], [ %storemerge, %B2270 ]
  %.107.i969.010299 = phi i64 [ %.179.i, %B682.i ], [ 0, %B2270 ]
  %.175.i1656 = add nsw i64 %.110.i.010300, -1
  %.179.i = add nsw i64 %.107.i969.010299, 1
  %209 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.107.i969.010299
  %.257.i1082 = load i64, ptr %209, align 8, !noalias !50
  %.262.i1085 = icmp sgt i64 %.257.i1082, -1
  br i1 %.262.i1085, label %B140.i, label %B682.i

B2472:                                            ; preds = %B2342.if
  %.3362 = getelementptr double, ptr %41, i64 %.3043.010302
  %.3363 = load double, ptr %.3362, align 8
  %.3364 = fcmp ogt double %.3363, 5.000000e-01
  br i1 %.3364, label %B2520, label %B2630

B2520:                                            ; preds = %B2472
  %.5.i = fptosi double %.3363 to i64
  %210 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.3043.010302
  %.84.i2743 = load i64, ptr %210, align 8, !noalias !54
  %.89.i2746 = icmp sgt i64 %.84.i2743, -1
  br i1 %.89.i2746, label %B46.i2751, label %B2630

B2630:                                            ; preds = %B2472, %B46.i2751, %B2520, %B80.i2783
  %.3542 = getelementptr double, ptr %42, i64 %.3043.010302
  %.3543 = load double, ptr %.3542, align 8
  %.3544 = fcmp ogt double %.3543, 5.000000e-01
  br i1 %.3544, label %B2678, label %B2948

B2678:                                            ; preds = %B2630
  %spec.select = select i1 %within.3.210304, i1 true, i1 %.2645
  %.3616 = mul i64 %.3201, %arg.batch.3.3.5.1
  %.3620 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3616
  %.3621 = load i64, ptr %.3620, align 8
  %.3632.0 = and i64 %.3621, 127
  %.3662 = icmp eq i64 %.3632.0, 0
  br i1 %.3662, label %B2806, label %B2758

B2758:                                            ; preds = %B2678
  %.3719 = getelementptr double, ptr %43, i64 %.3043.010302
  %.3720 = load double, ptr %.3719, align 8
  %.3722 = fcmp ogt double %.3720, 0.000000e+00
  br i1 %.3722, label %B2806, label %B2846

B2806:                                            ; preds = %B2678, %B2758
  store double 1.000000e+00, ptr %.3308, align 8
  br label %B2846

B2846:                                            ; preds = %B2806, %B2758
  %checked.5.5 = phi i1 [ true, %B2806 ], [ %checked.3.210305, %B2758 ]
  %.3801 = icmp slt i64 %.3252, %arg.batch.2.5.0
  br i1 %.3801, label %B2884, label %B2948

B2884:                                            ; preds = %B2846
  %.3825 = icmp slt i64 %.3252, 0
  %.3826 = select i1 %.3825, i64 %arg.batch.2.5.0, i64 0
  %211 = getelementptr double, ptr %arg.batch.2.4, i64 %.3252
  %.3840 = getelementptr double, ptr %211, i64 %.3826
  %.3841 = load double, ptr %.3840, align 8
  %.3895 = getelementptr double, ptr %44, i64 %.3043.010302
  %.3896 = load double, ptr %.3895, align 8
  %.3897 = fcmp olt double %.3841, %.3896
  br i1 %.3897, label %B2944, label %B2948

B2944:                                            ; preds = %B2884
  br label %B2948

B2948:                                            ; preds = %B2342.if, %B2944, %B2884, %B2846, %B2630
  %within.4.3 = phi i1 [ true, %B2944 ], [ %spec.select, %B2884 ], [ %spec.select, %B2846 ], [ %within.3.210304, %B2630 ], [ %within.3.210304, %B2342.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2944 ], [ %checked.5.5, %B2884 ], [ %checked.5.5, %B2846 ], [ %checked.3.210305, %B2630 ], [ %checked.3.210305, %B2342.if ]
  %.3106 = icmp sgt i64 %.3046.010303, 1
  br i1 %.3106, label %B2342.if, label %B2952

B2952:                                            ; preds = %B2948, %B2270, %B2340.preheader
  %within.5.1 = phi i1 [ false, %B2270 ], [ false, %B2340.preheader ], [ %within.4.3, %B2948 ]
  %checked.2.1 = phi i1 [ false, %B2270 ], [ false, %B2340.preheader ], [ %checked.4.3, %B2948 ]
  %spec.select9778 = select i1 %good.2.1.lcssa, i1 true, i1 %.2014
  %spec.select9803 = select i1 %not.brmerge9777, i1 %spec.select9778, i1 false
  %brmerge9780.not = select i1 %good.2.1.lcssa, i1 %.not10236, i1 false
  %brmerge9781 = select i1 %brmerge9780.not, i1 true, i1 %spec.select9803
  br i1 %brmerge9781, label %B2992, label %B3090

B2992:                                            ; preds = %B2952
  tail call void %.4027(ptr %.577, ptr %.4001, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4026)
  br label %B3090

B3090:                                            ; preds = %B2952, %B2992
  br i1 %checked.2.1, label %B3094, label %B3180

B3094:                                            ; preds = %B3090
  switch i64 %arg.shape.2, label %B3180 [
    i64 12, label %B3102
    i64 7, label %B3102
  ]

B3102:                                            ; preds = %B3094, %B3094
  %.4067 = load i64, ptr %.4066, align 8
  %.4112 = inttoptr i64 %.4067 to ptr
  tail call void %.4112(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3180

B3180:                                            ; preds = %B3094, %B3102, %B3090
  %212 = select i1 %.2650, i1 %good.2.1.lcssa, i1 false
  br i1 %212, label %B3200, label %B3342

B3200:                                            ; preds = %B3180
  %.4161 = load i64, ptr %.4160, align 8
  %.4206 = inttoptr i64 %.4161 to ptr
  tail call void %.4206(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  store i8 0, ptr %.4216, align 1
  %.4271 = call fastcc i32 @_ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4216, ptr %excinfo.10, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4273.not = icmp eq i32 %.4271, 0
  %.4281 = load i8, ptr %.4216, align 1
  %.4284 = icmp ne i8 %.4281, 0
  br i1 %.4273.not, label %B3342, label %B3200.endif.if, !prof !57

B3342:                                            ; preds = %B3200, %B3180
  %beyond.3.1 = phi i1 [ false, %B3180 ], [ %.4284, %B3200 ]
  %brmerge9785 = select i1 %within.5.1, i1 true, i1 %beyond.3.1
  %brmerge9786 = select i1 %brmerge9785, i1 true, i1 %spec.select9803
  br i1 %brmerge9786, label %B3356, label %B3982

B3356:                                            ; preds = %B3342
  br i1 %.620, label %B3404.if, label %B3778.critedge

B160.i:                                           ; preds = %B64.if.i3739
  %.397.i3140 = getelementptr double, ptr %46, i64 %.138.i2916.010312
  %.398.i3141 = load double, ptr %.397.i3140, align 8, !noalias !58
  %.399.i = fcmp uge double %.398.i3141, 5.000000e-01
  %.412.i3149.not = icmp slt i64 %.338.i3091, %arg.batch.2.5.0
  %or.cond9790 = select i1 %.399.i, i1 %.412.i3149.not, i1 false
  br i1 %or.cond9790, label %B248.i, label %B533.i

B248.i:                                           ; preds = %B160.i
  %.435.i3160 = icmp slt i64 %.338.i3091, 0
  %.436.i3161 = select i1 %.435.i3160, i64 %arg.batch.2.5.0, i64 0
  %213 = getelementptr double, ptr %arg.batch.2.4, i64 %.338.i3091
  %.450.i3174 = getelementptr double, ptr %213, i64 %.436.i3161
  %.451.i3175 = load double, ptr %.450.i3174, align 8, !noalias !58
  %.501.i3219 = getelementptr double, ptr %47, i64 %.138.i2916.010312
  %.502.i3220 = load double, ptr %.501.i3219, align 8, !noalias !58
  %.503.i3221 = fcmp olt double %.451.i3175, %.502.i3220
  br i1 %.503.i3221, label %B308.i, label %B533.i

B308.i:                                           ; preds = %B248.i
  %.554.i3265 = getelementptr double, ptr %48, i64 %.138.i2916.010312
  %.555.i3266 = load double, ptr %.554.i3265, align 8, !noalias !58
  %.556.i3267 = fcmp ogt double %.555.i3266, 1.000000e+00
  br i1 %.556.i3267, label %B356.i3268, label %B533.i

B356.i3268:                                       ; preds = %B308.i
  %.608.i3311 = getelementptr double, ptr %49, i64 %.138.i2916.010312
  %.609.i3312 = load double, ptr %.608.i3311, align 8, !noalias !58
  store double 0.000000e+00, ptr %.397.i3140, align 8, !noalias !62
  %.161.i.i3472 = getelementptr double, ptr %.2012, i64 %.138.i2916.010312
  store double 0.000000e+00, ptr %.161.i.i3472, align 8, !noalias !62
  %.214.i.i3499 = getelementptr double, ptr %50, i64 %.138.i2916.010312
  store double %.609.i3312, ptr %.214.i.i3499, align 8, !noalias !62
  %.268.i.i = load i64, ptr %.286.i3044, align 8, !noalias !62
  %.294.i.i3533 = icmp slt i64 %.268.i.i, 0
  %.295.i.i3534 = select i1 %.294.i.i3533, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i3535 = add i64 %.295.i.i3534, %.268.i.i
  %.316.i.i = mul i64 %.296.i.i3535, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i
  %.321.i.i = load i64, ptr %.320.i.i, align 8, !noalias !62
  %.322.i.i3546 = add nsw i64 %.321.i.i, -1
  store i64 %.322.i.i3546, ptr %.320.i.i, align 8, !noalias !62
  %.426.i.i = load i64, ptr %.286.i3044, align 8, !noalias !62
  %.452.i.i = icmp slt i64 %.426.i.i, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %214 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %214, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !62
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !62
  %.681.i3599 = load double, ptr %.450.i3174, align 8, !noalias !58
  %.735.i3646 = getelementptr double, ptr %51, i64 %.138.i2916.010312
  store double %.681.i3599, ptr %.735.i3646, align 8, !noalias !58
  %.784.i3689 = mul i64 %.287.i3045, %arg.batch.3.3.5.1
  %215 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.784.i3689
  %.788.i3693 = getelementptr i8, ptr %215, i64 8
  %.789.i3694 = load i64, ptr %.788.i3693, align 8, !noalias !58
  %.790.i3695 = add nsw i64 %.789.i3694, 3
  store i64 %.790.i3695, ptr %.788.i3693, align 8, !noalias !58
  br label %B533.i

B533.i:                                           ; preds = %B248.i, %B308.i, %B356.i3268, %B64.if.i3739, %B160.i
  %.196.i2983 = icmp sgt i64 %.141.i2917.010311, 1
  br i1 %.196.i2983, label %B64.if.i3739, label %B3778

B64.if.i3739:                                     ; preds = %B3404.if, %B533.i
  %.138.i2916.010312 = phi i64 [ %.209.i3745, %B533.i ], [ 0, %B3404.if ]
  %.141.i2917.010311 = phi i64 [ %.205.i3743, %B533.i ], [ %storemerge, %B3404.if ]
  %.205.i3743 = add nsw i64 %.141.i2917.010311, -1
  %.209.i3745 = add nsw i64 %.138.i2916.010312, 1
  %.286.i3044 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2916.010312
  %.287.i3045 = load i64, ptr %.286.i3044, align 8, !noalias !58
  %.337.i3090 = getelementptr i64, ptr %45, i64 %.138.i2916.010312
  %.338.i3091 = load i64, ptr %.337.i3090, align 8, !noalias !58
  %.346.i3095 = icmp slt i64 %.287.i3045, 0
  br i1 %.346.i3095, label %B533.i, label %B160.i

B3778.critedge:                                   ; preds = %B3356
  %.4675.c = load i64, ptr %.4674.c, align 8
  %.4720.c = inttoptr i64 %.4675.c to ptr
  tail call void %.4720.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3778

B3778:                                            ; preds = %B533.i, %B3404.if, %B3778.critedge
  br i1 %beyond.3.1, label %B3782, label %B3892

B3782:                                            ; preds = %B3778
  store i8 0, ptr %.4798, align 1
  %.4853 = call fastcc i32 @_ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4798, ptr %excinfo.12, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4855.not = icmp eq i32 %.4853, 0
  br i1 %.4855.not, label %B3782.endif.endif, label %B3782.endif.if, !prof !57

B3850:                                            ; preds = %B3782.endif.endif
  %.233.i = load double, ptr %.232.i, align 8, !noalias !65
  %.262.i = load double, ptr %arg.batch.2.4, align 8, !noalias !65
  %.263.i = fsub double %.233.i, %.262.i
  %.264.i = fmul double %.263.i, 1.000000e-13
  br i1 %.815, label %B296.preheader.i.preheader, label %B178.if.i.preheader

B178.if.i.preheader:                              ; preds = %B3850
  tail call void @llvm.memset.p0.i64(ptr align 8 %53, i8 0, i64 %131, i1 false), !noalias !65
  br label %B296.preheader.i.preheader

B296.preheader.i.preheader:                       ; preds = %B178.if.i.preheader, %B3850
  br label %B296.preheader.i

B296.preheader.i:                                 ; preds = %B296.preheader.i.preheader, %B364.endif.i
  %.547.sroa.0.08214.i = phi i64 [ %.504.18213.i, %B364.endif.i ], [ 8, %B296.preheader.i.preheader ]
  %.504.18213.i = phi i64 [ %.504.1.i, %B364.endif.i ], [ 7, %B296.preheader.i.preheader ]
  br i1 %.815, label %B364.endif.i, label %B296.if.i9834.preheader

B296.if.i9834.preheader:                          ; preds = %B296.preheader.i
  %switch.tableidx10541 = add i64 %.547.sroa.0.08214.i, 9
  %216 = icmp ult i64 %switch.tableidx10541, 17
  %switch.gep10543 = getelementptr inbounds double, ptr @switch.table.advance_of_many.8, i64 %switch.tableidx10541
  br label %B296.if.i9834

B296.loopexit.i:                                  ; preds = %B122.if.i467.i, %switch.end.i
  %exitcond8398.not.i = icmp eq i64 %arg.shape.0, %.691.i9835
  br i1 %exitcond8398.not.i, label %B90.if.i.lr.ph.i, label %B296.if.i9834

B90.if.i.lr.ph.i:                                 ; preds = %B296.loopexit.i
  %.151.i.i.i9836 = mul nsw i64 %.547.sroa.0.08214.i, 3
  %.153.i.i7078005.i = add nsw i64 %.151.i.i.i9836, 1
  %.155.i.i709.i = mul i64 %.153.i.i7078005.i, %arg.shape.6
  br label %B90.if.i.i

B142.i.i:                                         ; preds = %B90.if.i.i
  %217 = getelementptr double, ptr %56, i64 %.206.i540.08191.i
  %.411.i.i = load double, ptr %217, align 8, !noalias !69
  %.412.i.i = fcmp ugt double %.411.i.i, 1.000000e-01
  br i1 %.412.i.i, label %B336.i.i, label %B204.i.i

B204.i.i:                                         ; preds = %B142.i.i
  %.472.i.i = getelementptr double, ptr %57, i64 %.206.i540.08191.i
  %.473.i.i = load double, ptr %.472.i.i, align 8, !noalias !69
  %.523.i.i = getelementptr double, ptr %58, i64 %.206.i540.08191.i
  %.524.i.i = load double, ptr %.523.i.i, align 8, !noalias !69
  %.525.i.i = fcmp olt double %.473.i.i, %.524.i.i
  br i1 %.525.i.i, label %B34.i.i.i, label %B336.i.i

B34.i.i.i:                                        ; preds = %B204.i.i, %B34.if.i.i.i
  %.51.i.i492.0.i = phi i64 [ %.122.i.i.i, %B34.if.i.i.i ], [ 0, %B204.i.i ]
  %exitcond8399.not.i = icmp eq i64 %.51.i.i492.0.i, %storemerge8004.i
  br i1 %exitcond8399.not.i, label %B336.i.i, label %B34.if.i.i.i

B128.i.i.i:                                       ; preds = %B34.if.i.i.i
  %218 = icmp sgt i64 %.51.i.i492.0.i, -1
  br label %B336.i.i

B34.if.i.i.i:                                     ; preds = %B34.i.i.i
  %.122.i.i.i = add i64 %.51.i.i492.0.i, 1
  %.157.i.i711.i = add nsw i64 %.51.i.i492.0.i, %.155.i.i709.i
  %.159.i.i713.i = mul nsw i64 %.157.i.i711.i, %arg.shape.0
  %.161.i.i715.i = add nsw i64 %.159.i.i713.i, %.206.i540.08191.i
  %.175.i.i723.i = icmp slt i64 %.161.i.i715.i, 0
  %.176.i.i724.i = select i1 %.175.i.i723.i, i64 %arg.batch.5.4.5.0, i64 0
  %219 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i715.i
  %.190.i.i734.i = getelementptr double, ptr %219, i64 %.176.i.i724.i
  %.191.i.i735.i = load double, ptr %.190.i.i734.i, align 8, !noalias !73
  %.195.i.i.i = add nsw i64 %.161.i.i715.i, %.194.i.i738.i
  %.209.i.i741.i = icmp slt i64 %.195.i.i.i, 0
  %.210.i.i.i = select i1 %.209.i.i741.i, i64 %arg.batch.5.4.5.0, i64 0
  %220 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i.i.i
  %.224.i.i746.i = getelementptr double, ptr %220, i64 %.210.i.i.i
  %.225.i.i.i = load double, ptr %.224.i.i746.i, align 8, !noalias !73
  %.226.i.i747.i = fneg double %.225.i.i.i
  %.227.i.i.i = fcmp olt double %.191.i.i735.i, %.226.i.i747.i
  br i1 %.227.i.i.i, label %B128.i.i.i, label %B34.i.i.i

B336.i.i:                                         ; preds = %B34.i.i.i, %B90.if.i.i, %B128.i.i.i, %B204.i.i, %B142.i.i
  %"$phi336.1.2.i.1.i" = phi i1 [ false, %B142.i.i ], [ false, %B204.i.i ], [ false, %B90.if.i.i ], [ %218, %B128.i.i.i ], [ false, %B34.i.i.i ]
  %spec.select.i = or i1 %some.2.i.08193.i, %"$phi336.1.2.i.1.i"
  %"$phi354.2.2.i.1.i" = select i1 %"$phi336.1.2.i.1.i", double 1.000000e+00, double 0.000000e+00
  %221 = getelementptr double, ptr %59, i64 %.206.i540.08191.i
  store double %"$phi354.2.2.i.1.i", ptr %221, align 8, !noalias !69
  %exitcond8400.not.i = icmp eq i64 %arg.shape.0, %.277.i792.i
  br i1 %exitcond8400.not.i, label %B392.i.i, label %B90.if.i.i

B392.i.i:                                         ; preds = %B336.i.i
  br i1 %spec.select.i, label %B400.i.i, label %B364.endif.i

B400.i.i:                                         ; preds = %B392.i.i
  %.702.i.not.i = icmp eq i64 %.547.sroa.0.08214.i, 8
  %..i9861 = select i1 %.702.i.not.i, i64 17, i64 16
  %.717.i.i = mul i64 %..i9861, %.469
  %.725.i.i = mul i64 %.547.sroa.0.08214.i, %factor.op.mul.i.reass
  %.760.i.i = load i64, ptr %arg.code.4, align 8, !noalias !69
  %.850.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.717.i.i
  %.876.i.i = inttoptr i64 %.760.i.i to ptr
  tail call void %.876.i.i(ptr %.577, ptr %.850.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.875.i.i), !noalias !69
  br i1 %.114.i40.i8194.not.i, label %B468.endif.endif.i.i.critedge, label %B34.if.i111.i.i

B34.if.i111.i.i:                                  ; preds = %B400.i.i, %B34.if.i111.i.i
  %.56.i.i485.08195.i = phi i64 [ %.127.i115.i.i, %B34.if.i111.i.i ], [ 0, %B400.i.i ]
  %.127.i115.i.i = add nsw i64 %.56.i.i485.08195.i, 1
  %.153.i49.i.i = add nsw i64 %.56.i.i485.08195.i, %.725.i.i
  %.167.i56.i.i = icmp slt i64 %.153.i49.i.i, 0
  %.168.i.i.i = select i1 %.167.i56.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %222 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i49.i.i
  %.182.i.i.i = getelementptr double, ptr %222, i64 %.168.i.i.i
  %.183.i68.i.i = load double, ptr %.182.i.i.i, align 8, !noalias !77
  %.185.i70.i.i = add nsw i64 %.56.i.i485.08195.i, %.881.i.i
  %.199.i.i.i = icmp slt i64 %.185.i70.i.i, 0
  %.200.i.i.i = select i1 %.199.i.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %223 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i70.i.i
  %.214.i89.i.i = getelementptr double, ptr %223, i64 %.200.i.i.i
  %.215.i90.i.i = load double, ptr %.214.i89.i.i, align 8, !noalias !77
  store double %.183.i68.i.i, ptr %.214.i89.i.i, align 8, !noalias !77
  store double %.215.i90.i.i, ptr %.182.i.i.i, align 8, !noalias !77
  %exitcond8401.not.i = icmp eq i64 %.194.i.i738.i, %.127.i115.i.i
  br i1 %exitcond8401.not.i, label %B468.endif.i.i, label %B34.if.i111.i.i

B1136.i.loopexit.i:                               ; preds = %B1224.if.i.i, %B1138.if.i.i
  %exitcond8404.not.i = icmp eq i64 %arg.shape.0, %.1485.i.i
  br i1 %exitcond8404.not.i, label %B364.endif.i, label %B1138.if.i.i

B90.if.i.i:                                       ; preds = %B336.i.i, %B90.if.i.lr.ph.i
  %some.2.i.08193.i = phi i1 [ false, %B90.if.i.lr.ph.i ], [ %spec.select.i, %B336.i.i ]
  %.206.i540.08191.i = phi i64 [ 0, %B90.if.i.lr.ph.i ], [ %.277.i792.i, %B336.i.i ]
  %.277.i792.i = add nsw i64 %.206.i540.08191.i, 1
  %224 = getelementptr i64, ptr %55, i64 %.206.i540.08191.i
  %.355.i.i = load i64, ptr %224, align 8, !noalias !69
  %.356.i.i = icmp sgt i64 %.355.i.i, -1
  br i1 %.356.i.i, label %B142.i.i, label %B336.i.i

B468.endif.i.i:                                   ; preds = %B34.if.i111.i.i
  %.941.i.i = load i64, ptr %.940.i.i, align 8, !noalias !69
  %.1053.i.i = inttoptr i64 %.941.i.i to ptr
  tail call void %.1053.i.i(ptr %.577, ptr %.850.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !69
  %.1084.i.i = load i64, ptr %arg.code.4, align 8, !noalias !69
  %.1200.i.i = inttoptr i64 %.1084.i.i to ptr
  tail call void %.1200.i.i(ptr %.577, ptr %.850.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1199.i.i), !noalias !69
  br label %B34.if.i316.i.i

B34.if.i316.i.i:                                  ; preds = %B468.endif.i.i, %B34.if.i316.i.i
  %.56.i149.i.08198.i = phi i64 [ %.127.i324.i.i, %B34.if.i316.i.i ], [ 0, %B468.endif.i.i ]
  %.127.i324.i.i = add nsw i64 %.56.i149.i.08198.i, 1
  %.153.i217.i.i = add nsw i64 %.56.i149.i.08198.i, %.725.i.i
  %.167.i227.i.i = icmp slt i64 %.153.i217.i.i, 0
  %.168.i228.i.i = select i1 %.167.i227.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i217.i.i
  %.182.i241.i.i = getelementptr double, ptr %225, i64 %.168.i228.i.i
  %.183.i242.i.i = load double, ptr %.182.i241.i.i, align 8, !noalias !81
  %.185.i244.i.i = add nsw i64 %.56.i149.i.08198.i, %.881.i.i
  %.199.i254.i.i = icmp slt i64 %.185.i244.i.i, 0
  %.200.i255.i.i = select i1 %.199.i254.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %226 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i244.i.i
  %.214.i268.i.i = getelementptr double, ptr %226, i64 %.200.i255.i.i
  %.215.i269.i.i = load double, ptr %.214.i268.i.i, align 8, !noalias !81
  store double %.183.i242.i.i, ptr %.214.i268.i.i, align 8, !noalias !81
  store double %.215.i269.i.i, ptr %.182.i241.i.i, align 8, !noalias !81
  %exitcond8402.not.i = icmp eq i64 %.194.i.i738.i, %.127.i324.i.i
  br i1 %exitcond8402.not.i, label %B468.endif.endif.i.i, label %B34.if.i316.i.i

B468.endif.endif.i.i.critedge:                    ; preds = %B400.i.i
  %.941.i.i.c = load i64, ptr %.940.i.i, align 8, !noalias !69
  %.1053.i.i.c = inttoptr i64 %.941.i.i.c to ptr
  tail call void %.1053.i.i.c(ptr %.577, ptr %.850.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !69
  %.1084.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !69
  %.1200.i.i.c = inttoptr i64 %.1084.i.i.c to ptr
  tail call void %.1200.i.i.c(ptr %.577, ptr %.850.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1199.i.i), !noalias !69
  br label %B468.endif.endif.i.i

B468.endif.endif.i.i:                             ; preds = %B34.if.i316.i.i, %B468.endif.endif.i.i.critedge
  %.1267.i.i = load i64, ptr %.940.i.i, align 8, !noalias !69
  %.1381.i.i = inttoptr i64 %.1267.i.i to ptr
  tail call void %.1381.i.i(ptr %.577, ptr %.850.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !69
  br label %B1138.if.i.i

B1138.if.i.i:                                     ; preds = %B468.endif.endif.i.i, %B1136.i.loopexit.i
  %.1415.i.08206.i = phi i64 [ %.1485.i.i, %B1136.i.loopexit.i ], [ 0, %B468.endif.endif.i.i ]
  %.1485.i.i = add nsw i64 %.1415.i.08206.i, 1
  %.1562.i.i = getelementptr double, ptr %59, i64 %.1415.i.08206.i
  %.1563.i.i = load double, ptr %.1562.i.i, align 8, !noalias !69
  %.1564.i.i = fcmp ule double %.1563.i.i, 5.000000e-01
  %.1661.i8202.not.i = select i1 %.1564.i.i, i1 true, i1 %.287.i2218184.not.i
  br i1 %.1661.i8202.not.i, label %B1136.i.loopexit.i, label %B1224.if.i.lr.ph.i

B1224.if.i.lr.ph.i:                               ; preds = %B1138.if.i.i
  %gep8209.i = getelementptr double, ptr %54, i64 %.1415.i.08206.i
  %gep.i = getelementptr double, ptr %56, i64 %.1415.i.08206.i
  br label %B1224.if.i.i

B1224.if.i.i:                                     ; preds = %B1224.if.i.i, %B1224.if.i.lr.ph.i
  %.1605.i.08203.i = phi i64 [ 0, %B1224.if.i.lr.ph.i ], [ %.1674.i.i, %B1224.if.i.i ]
  %.1674.i.i = add nsw i64 %.1605.i.08203.i, 1
  %227 = mul nsw i64 %.1605.i.08203.i, %arg.shape.0
  %.1702.i.i = add nsw i64 %227, %.1415.i.08206.i
  %228 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1702.i.i
  %.1732.i.i = load double, ptr %228, align 8, !noalias !69
  %.1741.i.i = add nsw i64 %.1702.i.i, %factor.op.mul8211.i.reass
  %.1755.i.i = icmp slt i64 %.1741.i.i, 0
  %.1756.i.i = select i1 %.1755.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %229 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1741.i.i
  %.1770.i.i = getelementptr double, ptr %229, i64 %.1756.i.i
  %.1771.i.i = load double, ptr %.1770.i.i, align 8, !noalias !69
  %.1776.i.i = add nsw i64 %.1702.i.i, %factor.op.mul8210.i.reass
  %.1790.i.i = icmp slt i64 %.1776.i.i, 0
  %.1791.i.i = select i1 %.1790.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %230 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1776.i.i
  %.1805.i.i = getelementptr double, ptr %230, i64 %.1791.i.i
  %.1806.i.i = load double, ptr %.1805.i.i, align 8, !noalias !69
  %.1807.i.i = fsub double %.1771.i.i, %.1806.i.i
  %.1808.i.i = tail call double @llvm.fabs.f64(double %.1807.i.i)
  %.1859.i.i = load double, ptr %gep8209.i, align 8, !noalias !69
  %.1860.i.i = fmul double %.1859.i.i, %.1808.i.i
  %.1890.i.i = load double, ptr %.1889.i.i, align 8, !noalias !69
  %.1920.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !69
  %.1921.i.i = tail call double @llvm.fabs.f64(double %.1732.i.i)
  %.1922.i.i = fmul double %.1921.i.i, %.1920.i.i
  %.1923.i.i = fadd double %.1890.i.i, %.1922.i.i
  %.1927.i.i = fdiv double %.1860.i.i, %.1923.i.i
  %.1933.i.i = fsub double %.1927.i.i, %.1927.i.i
  %.1934.i.i = fcmp oeq double %.1933.i.i, 0.000000e+00
  %.1927.i..i = select i1 %.1934.i.i, double %.1927.i.i, double 0x7FF0000000000000
  %.2001.i.i = load double, ptr %gep.i, align 8, !noalias !69
  %.10.i.i.i9862 = fcmp ogt double %.1927.i..i, %.2001.i.i
  %.11.i.i.i9863 = select i1 %.10.i.i.i9862, double %.1927.i..i, double %.2001.i.i
  store double %.11.i.i.i9863, ptr %gep.i, align 8, !noalias !69
  %exitcond8403.not.i = icmp eq i64 %arg.shape.1, %.1674.i.i
  br i1 %exitcond8403.not.i, label %B1136.i.loopexit.i, label %B1224.if.i.i

B448.i:                                           ; preds = %B364.endif.i, %B678.endif.i
  %.935.sroa.0.08312.i = phi i1 [ true, %B678.endif.i ], [ false, %B364.endif.i ]
  %.892.18311.i = phi i64 [ %.892.1.i, %B678.endif.i ], [ 31, %B364.endif.i ]
  br i1 %.192.i9518228.i, label %B92.i966.lr.ph.i, label %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B92.i966.lr.ph.i:                                 ; preds = %B448.i
  %.474.i15357990.i = select i1 %.935.sroa.0.08312.i, i64 28, i64 1
  %.476.i1536.i = mul i64 %.474.i15357990.i, %arg.shape.6
  br label %B92.i966.i

B92.i966.i:                                       ; preds = %B925.i.i, %B92.i966.lr.ph.i
  %.182.i824.sroa.0.08236.i = phi i64 [ 0, %B92.i966.lr.ph.i ], [ %.182.i824.sroa.0.0.i, %B925.i.i ]
  %.136.i821.18235.i = phi i64 [ %.136.i821.18231.i, %B92.i966.lr.ph.i ], [ %.136.i821.1.i, %B925.i.i ]
  %.133.i.18234.i = phi i64 [ %.205.i16328229.i, %B92.i966.lr.ph.i ], [ %.133.i.1.i, %B925.i.i ]
  %some.2.i815.08232.i = phi i1 [ false, %B92.i966.lr.ph.i ], [ %some.3.i.1.i, %B925.i.i ]
  %.259.i.i = icmp slt i64 %.182.i824.sroa.0.08236.i, 0
  %.260.i985.i = select i1 %.259.i.i, i64 %arg.batch.4.1.5.1, i64 0
  %231 = getelementptr i64, ptr %55, i64 %.182.i824.sroa.0.08236.i
  %.282.i1003.i = getelementptr i64, ptr %231, i64 %.260.i985.i
  %.283.i1004.i = load i64, ptr %.282.i1003.i, align 8, !noalias !85
  %.284.i1005.i = icmp slt i64 %.283.i1004.i, 0
  br i1 %.284.i1005.i, label %B925.i.i, label %B142.i1006.i

B142.i1006.i:                                     ; preds = %B92.i966.i
  %.313.i1025.i = select i1 %.259.i.i, i64 %arg.batch.4.0.5.1, i64 0
  %.314.i.i = add i64 %.313.i1025.i, %.182.i824.sroa.0.08236.i
  %.335.i1046.i = getelementptr double, ptr %56, i64 %.314.i.i
  %.336.i1047.i = load double, ptr %.335.i1046.i, align 8, !noalias !85
  %.337.i1048.i = fcmp ogt double %.336.i1047.i, 1.000000e-01
  br i1 %.337.i1048.i, label %B925.i.i, label %B210.i.i

B210.i.i:                                         ; preds = %B142.i1006.i
  br i1 %.430.i8215.not.i, label %B416.i.i, label %B240.if.i.i

B306.i.i:                                         ; preds = %B240.if.i.i
  %.478.i1538.i = add nsw i64 %.374.i834.08216.i, %.476.i1536.i
  %.480.i.i9859 = mul nsw i64 %.478.i1538.i, %arg.shape.0
  %.482.i1539.i = add nsw i64 %.480.i.i9859, %.182.i824.sroa.0.08236.i
  %.506.i1573.i = icmp slt i64 %.482.i1539.i, 0
  %.507.i1574.i = select i1 %.506.i1573.i, i64 %arg.batch.5.4.5.0, i64 0
  %232 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.482.i1539.i
  %.521.i.i9860 = getelementptr double, ptr %232, i64 %.507.i1574.i
  %.522.i1584.i = load double, ptr %.521.i.i9860, align 8, !noalias !85
  %.527.i.i = add nsw i64 %.482.i1539.i, %.194.i.i738.i
  %.543.i.i = icmp slt i64 %.527.i.i, 0
  %.544.i.i = select i1 %.543.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %233 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.527.i.i
  %.558.i1604.i = getelementptr double, ptr %233, i64 %.544.i.i
  %.559.i.i = load double, ptr %.558.i1604.i, align 8, !noalias !85
  %.560.i1605.i = fneg double %.559.i.i
  %.561.i1606.i = fcmp olt double %.522.i1584.i, %.560.i1605.i
  %234 = select i1 %.561.i1606.i, double -1.000000e+00, double 1.000000e+00
  br label %B354.i1544.i

B354.i1544.i:                                     ; preds = %B240.if.i.i, %B306.i.i
  %"$phi354.2.2.i840.3.i" = phi double [ %234, %B306.i.i ], [ 1.000000e+00, %B240.if.i.i ]
  %.582.i.i = add nsw i64 %.374.i834.08216.i, %.580.i1547.i
  %.586.i1549.i = mul nsw i64 %.582.i.i, %arg.shape.0
  %.588.i.i = add nsw i64 %.586.i1549.i, %.182.i824.sroa.0.08236.i
  %.603.i.i = icmp slt i64 %.588.i.i, 0
  %.604.i1556.i = select i1 %.603.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %235 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.588.i.i
  %.618.i.i = getelementptr double, ptr %235, i64 %.604.i1556.i
  store double %"$phi354.2.2.i840.3.i", ptr %.618.i.i, align 8, !noalias !85
  %exitcond8405.not.i = icmp eq i64 %arg.shape.6, %.443.i1613.i
  br i1 %exitcond8405.not.i, label %B416.i.i, label %B240.if.i.i

B416.i.i:                                         ; preds = %B354.i1544.i, %B210.i.i
  br i1 %.935.sroa.0.08312.i, label %B438.i.i, label %B480.i.i

B438.i.i:                                         ; preds = %B416.i.i
  %.679.i1530.i = getelementptr double, ptr %58, i64 %.314.i.i
  %.680.i.i = load double, ptr %.679.i1530.i, align 8, !noalias !85
  br label %B480.i.i

B480.i.i:                                         ; preds = %B438.i.i, %B416.i.i
  %"$phi480.1.2.i.2.i" = phi double [ %.680.i.i, %B438.i.i ], [ 0.000000e+00, %B416.i.i ]
  br i1 %.430.i8215.not.i, label %B562.i.i.preheader, label %B58.if.i.i.i

B58.if.i.i.i:                                     ; preds = %B480.i.i, %B58.if.i.i.i
  %least.2.i.i.08221.i = phi double [ %.11.i.i.i.i9857, %B58.if.i.i.i ], [ 0x7FF0000000000000, %B480.i.i ]
  %.54.i.i804.08219.i = phi i64 [ %.125.i.i1497.i, %B58.if.i.i.i ], [ 0, %B480.i.i ]
  %.125.i.i1497.i = add nsw i64 %.54.i.i804.08219.i, 1
  %.156.i.i1415.i = add nsw i64 %.54.i.i804.08219.i, %.476.i1536.i
  %.158.i.i1417.i = mul nsw i64 %.156.i.i1415.i, %arg.shape.0
  %.160.i.i1419.i = add nsw i64 %.158.i.i1417.i, %.182.i824.sroa.0.08236.i
  %.164.i.i1422.i = add nsw i64 %.54.i.i804.08219.i, %.580.i1547.i
  %.166.i.i1424.i = mul nsw i64 %.164.i.i1422.i, %arg.shape.0
  %.168.i.i1426.i = add nsw i64 %.166.i.i1424.i, %.182.i824.sroa.0.08236.i
  %.182.i.i1434.i = icmp slt i64 %.168.i.i1426.i, 0
  %.183.i.i1435.i = select i1 %.182.i.i1434.i, i64 %arg.batch.5.4.5.0, i64 0
  %236 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i.i1426.i
  %.197.i.i1444.i = getelementptr double, ptr %236, i64 %.183.i.i1435.i
  %.198.i.i1445.i = load double, ptr %.197.i.i1444.i, align 8, !noalias !89
  %.212.i.i1453.i = icmp slt i64 %.160.i.i1419.i, 0
  %.213.i.i.i = select i1 %.212.i.i1453.i, i64 %arg.batch.5.4.5.0, i64 0
  %237 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i1419.i
  %.227.i.i1462.i = getelementptr double, ptr %237, i64 %.213.i.i.i
  %.228.i.i1463.i = load double, ptr %.227.i.i1462.i, align 8, !noalias !89
  %.229.i.i1464.i = fmul double %.198.i.i1445.i, %.228.i.i1463.i
  %.233.i.i1468.i = add nsw i64 %.160.i.i1419.i, %.194.i.i738.i
  %.247.i.i1474.i = icmp slt i64 %.233.i.i1468.i, 0
  %.248.i.i1475.i = select i1 %.247.i.i1474.i, i64 %arg.batch.5.4.5.0, i64 0
  %238 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i.i1468.i
  %.262.i.i1485.i = getelementptr double, ptr %238, i64 %.248.i.i1475.i
  %.263.i.i1486.i = load double, ptr %.262.i.i1485.i, align 8, !noalias !89
  %.264.i.i1487.i = fadd double %.229.i.i1464.i, %.263.i.i1486.i
  %.10.i.i.i.i9856 = fcmp olt double %.264.i.i1487.i, %least.2.i.i.08221.i
  %.11.i.i.i.i9857 = select i1 %.10.i.i.i.i9856, double %.264.i.i1487.i, double %least.2.i.i.08221.i
  %exitcond8406.not.i = icmp eq i64 %arg.shape.6, %.125.i.i1497.i
  br i1 %exitcond8406.not.i, label %B562.i.i.preheader, label %B58.if.i.i.i

B562.i.i.preheader:                               ; preds = %B58.if.i.i.i, %B480.i.i
  %here.4.i.2.i.ph = phi double [ 0x7FF0000000000000, %B480.i.i ], [ %.11.i.i.i.i9857, %B58.if.i.i.i ]
  br label %B562.i.i

B562.i.i:                                         ; preds = %B562.i.i.preheader, %B676.i.i
  %look.2.i.2.i = phi i64 [ %.981.i1205.i, %B676.i.i ], [ 1, %B562.i.i.preheader ]
  %low.2.i.2.i = phi double [ %low.3.i.3.i, %B676.i.i ], [ %"$phi480.1.2.i.2.i", %B562.i.i.preheader ]
  %ahead.3.i.2.i = phi double [ %ahead.2.i.3.i, %B676.i.i ], [ 0.000000e+00, %B562.i.i.preheader ]
  %here.4.i.2.i = phi double [ %here.3.i.3.i, %B676.i.i ], [ %here.4.i.2.i.ph, %B562.i.i.preheader ]
  %239 = icmp ult i64 %look.2.i.2.i, 9
  br i1 %239, label %switch.lookup, label %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B58.if.i186.i.i:                                  ; preds = %B58.if.i186.i.lr.ph.i, %B58.if.i186.i.i
  %least.2.i16.i.08226.i = phi double [ 0x7FF0000000000000, %B58.if.i186.i.lr.ph.i ], [ %.11.i.i182.i.i, %B58.if.i186.i.i ]
  %.54.i20.i.08224.i = phi i64 [ 0, %B58.if.i186.i.lr.ph.i ], [ %.125.i192.i.i, %B58.if.i186.i.i ]
  %.125.i192.i.i = add nsw i64 %.54.i20.i.08224.i, 1
  %.156.i98.i.i = add nsw i64 %.54.i20.i.08224.i, %.155.i97.i.i
  %.158.i100.i.i = mul nsw i64 %.156.i98.i.i, %arg.shape.0
  %.160.i102.i.i = add nsw i64 %.158.i100.i.i, %.182.i824.sroa.0.08236.i
  %.164.i105.i.i = add nsw i64 %.54.i20.i.08224.i, %.580.i1547.i
  %.166.i107.i.i = mul nsw i64 %.164.i105.i.i, %arg.shape.0
  %.168.i109.i.i = add nsw i64 %.166.i107.i.i, %.182.i824.sroa.0.08236.i
  %.182.i117.i.i = icmp slt i64 %.168.i109.i.i, 0
  %.183.i118.i.i = select i1 %.182.i117.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %240 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i109.i.i
  %.197.i128.i.i = getelementptr double, ptr %240, i64 %.183.i118.i.i
  %.198.i129.i.i = load double, ptr %.197.i128.i.i, align 8, !noalias !93
  %.212.i137.i.i = icmp slt i64 %.160.i102.i.i, 0
  %.213.i138.i.i = select i1 %.212.i137.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %241 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i102.i.i
  %.227.i148.i.i = getelementptr double, ptr %241, i64 %.213.i138.i.i
  %.228.i149.i.i = load double, ptr %.227.i148.i.i, align 8, !noalias !93
  %.229.i150.i.i = fmul double %.198.i129.i.i, %.228.i149.i.i
  %.233.i154.i.i = add nsw i64 %.160.i102.i.i, %.194.i.i738.i
  %.247.i162.i.i = icmp slt i64 %.233.i154.i.i, 0
  %.248.i163.i.i = select i1 %.247.i162.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %242 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i154.i.i
  %.262.i173.i.i = getelementptr double, ptr %242, i64 %.248.i163.i.i
  %.263.i174.i.i = load double, ptr %.262.i173.i.i, align 8, !noalias !93
  %.264.i175.i.i = fadd double %.229.i150.i.i, %.263.i174.i.i
  %.10.i.i181.i.i = fcmp olt double %.264.i175.i.i, %least.2.i16.i.08226.i
  %.11.i.i182.i.i = select i1 %.10.i.i181.i.i, double %.264.i175.i.i, double %least.2.i16.i.08226.i
  %exitcond8407.not.i = icmp eq i64 %arg.shape.6, %.125.i192.i.i
  br i1 %exitcond8407.not.i, label %B596.endif.i.i, label %B58.if.i186.i.i

B646.i.i:                                         ; preds = %B596.endif.i.i
  switch i64 %look.2.i.2.i, label %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i [
    i64 0, label %B676.i.i
    i64 6, label %switch.6.1.i.i
    i64 1, label %switch.1.1.i.i
    i64 8, label %switch.8.1.i.i
    i64 2, label %switch.2.1.i.i
    i64 5, label %switch.5.1.i.i
    i64 3, label %switch.3.1.i.i
    i64 7, label %switch.7.1.i.i
    i64 4, label %switch.4.1.i.i
  ]

B676.i.i:                                         ; preds = %switch.8.1.i.i, %switch.7.1.i.i, %switch.6.1.i.i, %switch.5.1.i.i, %switch.4.1.i.i, %switch.3.1.i.i, %switch.2.1.i.i, %switch.1.1.i.i, %B596.endif.i.i, %switch.lookup, %B646.i.i
  %low.3.i.3.i = phi double [ %low.2.i.2.i, %switch.lookup ], [ %low.2.i.2.i, %B596.endif.i.i ], [ 1.000000e+00, %switch.8.1.i.i ], [ 0x3FB48E8A71DE69AD, %switch.1.1.i.i ], [ 2.500000e-01, %switch.2.1.i.i ], [ 3.333000e-01, %switch.3.1.i.i ], [ 5.000000e-01, %switch.4.1.i.i ], [ 0x3FE50A3D70A3D70A, %switch.5.1.i.i ], [ 7.500000e-01, %switch.6.1.i.i ], [ 8.889000e-01, %switch.7.1.i.i ], [ 0.000000e+00, %B646.i.i ]
  %ahead.2.i.3.i = phi double [ %ahead.3.i.2.i, %switch.lookup ], [ %least.2.i16.i.0.lcssa.i, %B596.endif.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.8.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.1.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.2.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.3.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.4.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.5.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.6.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.7.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %B646.i.i ]
  %here.3.i.3.i = phi double [ %here.4.i.2.i, %switch.lookup ], [ %here.4.i.2.i, %B596.endif.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.8.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.1.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.2.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.3.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.4.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.5.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.6.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.7.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %B646.i.i ]
  %.991.i1210.i = icmp eq i64 %look.2.i.2.i, 8
  %.981.i1205.i = add nsw i64 %look.2.i.2.i, 1
  %.1024.i.i = fcmp ult double %ahead.2.i.3.i, 0.000000e+00
  %or.cond.i = select i1 %.991.i1210.i, i1 true, i1 %.1024.i.i
  br i1 %or.cond.i, label %B720.i.i, label %B562.i.i

B720.i.i:                                         ; preds = %B676.i.i
  br i1 %.1024.i.i, label %switch.lookup10517, label %B768.i.i

switch.lookup10517:                               ; preds = %B720.i.i
  %switch.gep10518 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i.2.i
  %switch.load10519 = load double, ptr %switch.gep10518, align 8
  br label %B768.i.i

B768.i.i:                                         ; preds = %switch.lookup10517, %B720.i.i
  %"$phi768.2.2.i.2.i" = phi double [ %low.3.i.3.i, %B720.i.i ], [ %switch.load10519, %switch.lookup10517 ]
  %.1158.i1250.i = getelementptr double, ptr %57, i64 %.314.i.i
  store double %low.3.i.3.i, ptr %.1158.i1250.i, align 8, !noalias !85
  %.1212.i.i = getelementptr double, ptr %58, i64 %.314.i.i
  store double %"$phi768.2.2.i.2.i", ptr %.1212.i.i, align 8, !noalias !85
  %.1266.i1307.i = getelementptr double, ptr %60, i64 %.314.i.i
  store double %here.3.i.3.i, ptr %.1266.i1307.i, align 8, !noalias !85
  %.1322.i.i = getelementptr double, ptr %61, i64 %.314.i.i
  store double %ahead.2.i.3.i, ptr %.1322.i.i, align 8, !noalias !85
  %.1333.i1342.i = fcmp olt double %ahead.2.i.3.i, 0.000000e+00
  %spec.select8013.i = select i1 %some.2.i815.08232.i, i1 true, i1 %.1333.i1342.i
  br label %B925.i.i

B924.i.loopexit.i:                                ; preds = %B925.i.i
  %243 = xor i1 %some.3.i.1.i, true
  br label %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B925.i.i:                                         ; preds = %B768.i.i, %B142.i1006.i, %B92.i966.i
  %some.3.i.1.i = phi i1 [ %spec.select8013.i, %B768.i.i ], [ %some.2.i815.08232.i, %B142.i1006.i ], [ %some.2.i815.08232.i, %B92.i966.i ]
  %.192.i951.i = icmp sgt i64 %.136.i821.18235.i, 0
  %.205.i1632.i = zext i1 %.192.i951.i to i64
  %.133.i.1.i = add i64 %.133.i.18234.i, %.205.i1632.i
  %.201.i1629.i = sext i1 %.192.i951.i to i64
  %.136.i821.1.i = add nsw i64 %.136.i821.18235.i, %.201.i1629.i
  %.182.i824.sroa.0.0.i = select i1 %.192.i951.i, i64 %.133.i.18234.i, i64 0
  br i1 %.192.i951.i, label %B92.i966.i, label %B924.i.loopexit.i

B240.if.i.i:                                      ; preds = %B210.i.i, %B354.i1544.i
  %.374.i834.08216.i = phi i64 [ %.443.i1613.i, %B354.i1544.i ], [ 0, %B210.i.i ]
  %.443.i1613.i = add nsw i64 %.374.i834.08216.i, 1
  br i1 %.935.sroa.0.08312.i, label %B306.i.i, label %B354.i1544.i

switch.lookup:                                    ; preds = %B562.i.i
  %switch.gep = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i.2.i
  %switch.load = load double, ptr %switch.gep, align 8
  %.866.i.i9858 = fcmp ogt double %switch.load, %low.2.i.2.i
  br i1 %.866.i.i9858, label %B58.i66.i.preheader.i, label %B676.i.i

B58.i66.i.preheader.i:                            ; preds = %switch.lookup
  br i1 %.430.i8215.not.i, label %B596.endif.i.i, label %B58.if.i186.i.lr.ph.i

B58.if.i186.i.lr.ph.i:                            ; preds = %B58.i66.i.preheader.i
  %.151.i93.i.i = mul nsw i64 %look.2.i.2.i, 3
  %.153.i95.i7903.i = add nsw i64 %.151.i93.i.i, 1
  %.155.i97.i.i = mul i64 %.153.i95.i7903.i, %arg.shape.6
  br label %B58.if.i186.i.i

B596.endif.i.i:                                   ; preds = %B58.if.i186.i.i, %B58.i66.i.preheader.i
  %least.2.i16.i.0.lcssa.i = phi double [ 0x7FF0000000000000, %B58.i66.i.preheader.i ], [ %.11.i.i182.i.i, %B58.if.i186.i.i ]
  %.917.i1393.i = fcmp ult double %least.2.i16.i.0.lcssa.i, 0.000000e+00
  br i1 %.917.i1393.i, label %B676.i.i, label %B646.i.i

switch.1.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.2.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.3.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.4.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.5.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.6.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.7.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

switch.8.1.i.i:                                   ; preds = %B646.i.i
  br label %B676.i.i

_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B646.i.i, %B562.i.i, %B924.i.loopexit.i, %B448.i
  %.192.i9518169.i = phi i1 [ false, %B924.i.loopexit.i ], [ false, %B448.i ], [ true, %B562.i.i ], [ true, %B646.i.i ]
  %.1004.0.i = phi i1 [ %243, %B924.i.loopexit.i ], [ true, %B448.i ], [ true, %B562.i.i ], [ true, %B646.i.i ]
  %.10291638.i = phi i32 [ 0, %B924.i.loopexit.i ], [ 0, %B448.i ], [ 1, %B562.i.i ], [ 1, %B646.i.i ]
  br i1 %.192.i9518169.i, label %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B492.endif.endif.i, !prof !97

B114.i.loopexit.i:                                ; preds = %B879.i.i
  %.221.i1854.i = icmp ne i64 %.165.i1752.18267.i, 0
  %244 = sub nsw i64 45, %.162.i.18266.i
  %.234.i2818.i = zext i1 %.221.i1854.i to i64
  %.162.i.1.i = add i64 %.162.i.18266.i, %.234.i2818.i
  %.230.i2815.i = sext i1 %.221.i1854.i to i64
  %.165.i1752.1.i = add nsw i64 %.165.i1752.18267.i, %.230.i2815.i
  %.211.i1754.sroa.0.0.i = select i1 %.221.i1854.i, i64 %244, i64 45
  br i1 %.221.i1854.i, label %B154.i.preheader.i, label %B596.if.i.preheader

B596.if.i.preheader:                              ; preds = %B326.i.i, %B114.i.loopexit.i
  br label %B596.if.i

B154.i.preheader.i:                               ; preds = %B154.i.preheader.i.preheader, %B114.i.loopexit.i
  %.211.i1754.sroa.0.08268.i = phi i64 [ %.211.i1754.sroa.0.0.i, %B114.i.loopexit.i ], [ 45, %B154.i.preheader.i.preheader ]
  %.165.i1752.18267.i = phi i64 [ %.165.i1752.1.i, %B114.i.loopexit.i ], [ 44, %B154.i.preheader.i.preheader ]
  %.162.i.18266.i = phi i64 [ %.162.i.1.i, %B114.i.loopexit.i ], [ 1, %B154.i.preheader.i.preheader ]
  %.108.not.i.i = icmp eq i64 %.211.i1754.sroa.0.08268.i, 0
  br label %B154.if.i.i

B154.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %B250.endif.i.i
  %exitcond8410.not.i = icmp eq i64 %arg.shape.0, %.358.i2803.i
  br i1 %exitcond8410.not.i, label %B326.i.i, label %B154.if.i.i

B162.i.i:                                         ; preds = %B154.if.i.i
  %.443.i2424.i = getelementptr double, ptr %58, i64 %.289.i1760.08246.i
  %.444.i2425.i = load double, ptr %.443.i2424.i, align 8, !noalias !98
  %.494.i2465.i = getelementptr double, ptr %57, i64 %.289.i1760.08246.i
  %.495.i2466.i = load double, ptr %.494.i2465.i, align 8, !noalias !98
  %.496.i2467.i = fsub double %.444.i2425.i, %.495.i2466.i
  %.498.i2469.i = fcmp ogt double %.496.i2467.i, 1.000000e-05
  br label %B250.i.i

B250.i.i:                                         ; preds = %B154.if.i.i, %B162.i.i
  %"$phi250.2.2.i.2.i" = phi i1 [ true, %B154.if.i.i ], [ %.498.i2469.i, %B162.i.i ]
  %.67.i.i2525.i = getelementptr double, ptr %57, i64 %.289.i1760.08246.i
  %.68.i.i2526.i = load double, ptr %.67.i.i2525.i, align 8, !noalias !102
  %.116.i.i.i = getelementptr double, ptr %58, i64 %.289.i1760.08246.i
  %.117.i.i2559.i = load double, ptr %.116.i.i.i, align 8, !noalias !102
  %.171.i.i.i = getelementptr double, ptr %60, i64 %.289.i1760.08246.i
  %.172.i.i2592.i = load double, ptr %.171.i.i.i, align 8, !noalias !102
  %.220.i.i2625.i = getelementptr double, ptr %61, i64 %.289.i1760.08246.i
  %.221.i.i2626.i = load double, ptr %.220.i.i2625.i, align 8, !noalias !102
  %.224.i.i2629.i = fadd double %.68.i.i2526.i, %.117.i.i2559.i
  %.225.i.i2630.i = fmul double %.224.i.i2629.i, 5.000000e-01
  br i1 %.108.not.i.i, label %B0.endif.i.i2644.i, label %B282.i.i

B282.i.i:                                         ; preds = %B250.i.i, %B282.i.i
  %r.2.0.i.i = phi double [ %r.3.1.i.i, %B282.i.i ], [ 1.000000e+00, %B250.i.i ]
  %a.1.2.0.i.i = phi double [ %.147.i8022.i, %B282.i.i ], [ 2.000000e+00, %B250.i.i ]
  %exp.4.0.i.i = phi i64 [ %.142.i.i, %B282.i.i ], [ %.211.i1754.sroa.0.08268.i, %B250.i.i ]
  %.122.i.i9838 = and i64 %exp.4.0.i.i, 1
  %.123.not.i.i = icmp eq i64 %.122.i.i9838, 0
  %.127.i.i = fmul double %r.2.0.i.i, %a.1.2.0.i.i
  %r.3.1.i.i = select i1 %.123.not.i.i, double %r.2.0.i.i, double %.127.i.i
  %.142.i.i = lshr i64 %exp.4.0.i.i, 1
  %.147.i8022.i = fmul double %a.1.2.0.i.i, %a.1.2.0.i.i
  %.150.not.i.i = icmp eq i64 %.142.i.i, 0
  br i1 %.150.not.i.i, label %B334.i.loopexit.i, label %B282.i.i

B334.i.loopexit.i:                                ; preds = %B282.i.i
  %245 = fmul double %r.3.1.i.i, 1.000000e-05
  br label %B0.endif.i.i2644.i

B494.i.i.i:                                       ; preds = %B0.endif.i.i2644.i
  %.10.i3.i.i.i = fcmp olt double %.261.i.i2650.i, 0.000000e+00
  %.11.i4.i.i.i = select i1 %.10.i3.i.i.i, double 0.000000e+00, double %.261.i.i2650.i
  %.420.i.i.i = fmul double %.316.i.i.i, %.11.i4.i.i.i
  %.424.i.i.i = fsub double %.225.i.i2630.i, %.420.i.i.i
  br label %B250.endif.i.i

B0.endif.i.i2644.i:                               ; preds = %B334.i.loopexit.i, %B250.i.i
  %r.4.1.i.i = phi double [ 1.000000e-05, %B250.i.i ], [ %245, %B334.i.loopexit.i ]
  %.259.i.i2648.i = fsub double %.117.i.i2559.i, %.68.i.i2526.i
  %.260.i.i2649.i = fsub double %r.4.1.i.i, %.259.i.i2648.i
  %.261.i.i2650.i = fmul double %.260.i.i2649.i, 5.000000e-01
  %.266.i.i2653.i = fmul double %.68.i.i2526.i, %.221.i.i2626.i
  %.268.i.i2655.i = fmul double %.117.i.i2559.i, %.172.i.i2592.i
  %.269.i.i2656.i = fsub double %.266.i.i2653.i, %.268.i.i2655.i
  %.270.i.i2657.i = fsub double %.221.i.i2626.i, %.172.i.i2592.i
  %.274.i.i2660.i = fdiv double %.269.i.i2656.i, %.270.i.i2657.i
  %.280.i.i2663.i = fcmp olt double %.68.i.i2526.i, %.274.i.i2660.i
  %.288.i.i2786.i = fcmp olt double %.274.i.i2660.i, %.117.i.i2559.i
  %or.cond8018.i = select i1 %.280.i.i2663.i, i1 %.288.i.i2786.i, i1 false
  %"$phi302.0.2.i.i.0.i" = select i1 %or.cond8018.i, double %.274.i.i2660.i, double %.225.i.i2630.i
  %.315.i.i.i = fsub double %.225.i.i2630.i, %"$phi302.0.2.i.i.0.i"
  %.316.i.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i.i.i)
  %.330.i.i.i = fmul double %.259.i.i2648.i, %.259.i.i2648.i
  %.333.i.i.i = tail call double @llvm.fabs.f64(double %.315.i.i.i)
  %.10.i.i.i2676.i = fcmp olt double %.333.i.i.i, %.330.i.i.i
  %.11.i.i.i2677.i = select i1 %.10.i.i.i2676.i, double %.333.i.i.i, double %.330.i.i.i
  %.363.i.i.i = fmul double %.316.i.i.i, %.11.i.i.i2677.i
  %.364.i.i.i = fadd double %"$phi302.0.2.i.i.0.i", %.363.i.i.i
  %.370.i.i.i = fsub double %.364.i.i.i, %.225.i.i2630.i
  %.371.i.i.i = tail call double @llvm.fabs.f64(double %.370.i.i.i)
  %.373.i.i.i = fcmp ugt double %.371.i.i.i, %.261.i.i2650.i
  br i1 %.373.i.i.i, label %B494.i.i.i, label %B250.endif.i.i

B326.i.i:                                         ; preds = %B154.i.loopexit.i
  br i1 %"$phi250.2.2.i.2.i", label %B336.i1932.i, label %B596.if.i.preheader

B336.i1932.i:                                     ; preds = %B326.i.i
  %.649.i1957.i = load i64, ptr %.648.i1956.i, align 8, !noalias !98
  %.765.i2021.i = inttoptr i64 %.649.i1957.i to ptr
  tail call void %.765.i2021.i(ptr %.577, ptr %.739.i2013.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.764.i.i), !noalias !98
  br label %B540.if.i.i

B634.i.i:                                         ; preds = %B540.if.i.i
  %.171.i135.i.i = getelementptr double, ptr %60, i64 %.791.i1781.08258.i
  %.172.i136.i.i = load double, ptr %.171.i135.i.i, align 8, !noalias !106
  %.220.i169.i.i = getelementptr double, ptr %61, i64 %.791.i1781.08258.i
  %.221.i170.i.i = load double, ptr %.220.i169.i.i, align 8, !noalias !106
  %.224.i173.i.i = fadd double %.938.i2093.i, %.989.i2131.i
  %.225.i174.i.i = fmul double %.224.i173.i.i, 5.000000e-01
  br i1 %.108.not.i.i, label %B0.endif.i188.i.i, label %B282.i8028.i

B282.i8028.i:                                     ; preds = %B634.i.i, %B282.i8028.i
  %r.2.0.i8029.i = phi double [ %r.3.1.i8035.i, %B282.i8028.i ], [ 1.000000e+00, %B634.i.i ]
  %a.1.2.0.i8030.i = phi double [ %.147.i8037.i, %B282.i8028.i ], [ 2.000000e+00, %B634.i.i ]
  %exp.4.0.i8031.i = phi i64 [ %.142.i8036.i, %B282.i8028.i ], [ %.211.i1754.sroa.0.08268.i, %B634.i.i ]
  %.122.i8032.i = and i64 %exp.4.0.i8031.i, 1
  %.123.not.i8033.i = icmp eq i64 %.122.i8032.i, 0
  %.127.i8034.i = fmul double %r.2.0.i8029.i, %a.1.2.0.i8030.i
  %r.3.1.i8035.i = select i1 %.123.not.i8033.i, double %r.2.0.i8029.i, double %.127.i8034.i
  %.142.i8036.i = lshr i64 %exp.4.0.i8031.i, 1
  %.147.i8037.i = fmul double %a.1.2.0.i8030.i, %a.1.2.0.i8030.i
  %.150.not.i8038.i = icmp eq i64 %.142.i8036.i, 0
  br i1 %.150.not.i8038.i, label %B334.i8039.loopexit.i, label %B282.i8028.i

B334.i8039.loopexit.i:                            ; preds = %B282.i8028.i
  %246 = fmul double %r.3.1.i8035.i, 1.000000e-05
  br label %B0.endif.i188.i.i

B494.i255.i.i:                                    ; preds = %B0.endif.i188.i.i
  %.10.i3.i262.i.i = fcmp olt double %.261.i194.i.i, 0.000000e+00
  %.11.i4.i263.i.i = select i1 %.10.i3.i262.i.i, double 0.000000e+00, double %.261.i194.i.i
  %.420.i268.i.i = fmul double %.316.i223.i.i, %.11.i4.i263.i.i
  %.424.i271.i.i = fsub double %.225.i174.i.i, %.420.i268.i.i
  br label %B634.endif.i.i

B0.endif.i188.i.i:                                ; preds = %B334.i8039.loopexit.i, %B634.i.i
  %r.4.1.i8040.i = phi double [ 1.000000e-05, %B634.i.i ], [ %246, %B334.i8039.loopexit.i ]
  %.260.i193.i.i = fsub double %r.4.1.i8040.i, %.990.i2132.i
  %.261.i194.i.i = fmul double %.260.i193.i.i, 5.000000e-01
  %.266.i197.i.i = fmul double %.989.i2131.i, %.221.i170.i.i
  %.268.i199.i.i = fmul double %.938.i2093.i, %.172.i136.i.i
  %.269.i200.i.i = fsub double %.266.i197.i.i, %.268.i199.i.i
  %.270.i201.i.i = fsub double %.221.i170.i.i, %.172.i136.i.i
  %.274.i204.i.i = fdiv double %.269.i200.i.i, %.270.i201.i.i
  %.280.i208.i.i = fcmp olt double %.989.i2131.i, %.274.i204.i.i
  %.288.i282.i.i = fcmp olt double %.274.i204.i.i, %.938.i2093.i
  %or.cond8019.i = and i1 %.280.i208.i.i, %.288.i282.i.i
  %"$phi302.0.2.i26.i.0.i" = select i1 %or.cond8019.i, double %.274.i204.i.i, double %.225.i174.i.i
  %.315.i222.i.i = fsub double %.225.i174.i.i, %"$phi302.0.2.i26.i.0.i"
  %.316.i223.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i222.i.i)
  %.330.i233.i.i = fmul double %.990.i2132.i, %.990.i2132.i
  %.333.i236.i.i = tail call double @llvm.fabs.f64(double %.315.i222.i.i)
  %.10.i.i241.i.i = fcmp olt double %.333.i236.i.i, %.330.i233.i.i
  %.11.i.i242.i.i = select i1 %.10.i.i241.i.i, double %.333.i236.i.i, double %.330.i233.i.i
  %.363.i246.i.i = fmul double %.316.i223.i.i, %.11.i.i242.i.i
  %.364.i247.i.i = fadd double %"$phi302.0.2.i26.i.0.i", %.363.i246.i.i
  %.370.i251.i.i = fsub double %.364.i247.i.i, %.225.i174.i.i
  %.371.i252.i.i = tail call double @llvm.fabs.f64(double %.370.i251.i.i)
  %.373.i254.i.i = fcmp ugt double %.371.i252.i.i, %.261.i194.i.i
  br i1 %.373.i254.i.i, label %B494.i255.i.i, label %B634.endif.i.i

B730.i.i:                                         ; preds = %B634.endif.endif.i.i
  store double %.999.i1788.0.i, ptr %.937.i2092.i, align 8, !noalias !98
  store double %least.2.i.i1642.0.lcssa.i, ptr %.220.i169.i.i, align 8, !noalias !98
  br label %B879.i.i

B802.i.i:                                         ; preds = %B634.endif.endif.i.i
  store double %.999.i1788.0.i, ptr %.988.i2130.i, align 8, !noalias !98
  store double %least.2.i.i1642.0.lcssa.i, ptr %.171.i135.i.i, align 8, !noalias !98
  br label %B879.i.i

B879.i.i:                                         ; preds = %B540.if.i.i, %B802.i.i, %B730.i.i
  %exitcond8412.not.i = icmp eq i64 %arg.shape.0, %.860.i.i
  br i1 %exitcond8412.not.i, label %B114.i.loopexit.i, label %B540.if.i.i

B154.if.i.i:                                      ; preds = %B154.i.loopexit.i, %B154.i.preheader.i
  %wide.2.i.18248.i = phi i1 [ false, %B154.i.preheader.i ], [ %"$phi250.2.2.i.2.i", %B154.i.loopexit.i ]
  %.289.i1760.08246.i = phi i64 [ 0, %B154.i.preheader.i ], [ %.358.i2803.i, %B154.i.loopexit.i ]
  %.358.i2803.i = add nsw i64 %.289.i1760.08246.i, 1
  br i1 %wide.2.i.18248.i, label %B250.i.i, label %B162.i.i

B250.endif.i.i:                                   ; preds = %B0.endif.i.i2644.i, %B494.i.i.i
  %.513.i1768.0.i = phi double [ %.364.i.i.i, %B0.endif.i.i2644.i ], [ %.424.i.i.i, %B494.i.i.i ]
  %.92.i352.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.289.i1760.08246.i
  %.93.i353.i.i = load double, ptr %.92.i352.i.i, align 8, !noalias !110
  %.146.i384.i.i = getelementptr double, ptr %54, i64 %.289.i1760.08246.i
  %.147.i385.i.i = load double, ptr %.146.i384.i.i, align 8, !noalias !110
  %.149.i387.i.i = fmul double %.513.i1768.0.i, %.147.i385.i.i
  %.150.i388.i.i = fadd double %.93.i353.i.i, %.149.i387.i.i
  %.203.i421.i.i = getelementptr double, ptr %.577, i64 %.289.i1760.08246.i
  store double %.150.i388.i.i, ptr %.203.i421.i.i, align 8, !noalias !110
  br i1 %.287.i2218184.not.i, label %B154.i.loopexit.i, label %B122.if.i.i.lr.ph.i

B122.if.i.i.lr.ph.i:                              ; preds = %B250.endif.i.i
  %.247.i.i.i.i = fsub double 1.000000e+00, %.513.i1768.0.i
  %invariant.gep10331 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10333 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10335 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10337 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10339 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10341 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10343 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10345 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  %invariant.gep10347 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i1760.08246.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.lr.ph.i
  %.229.i313.i.08243.i = phi i64 [ 0, %B122.if.i.i.lr.ph.i ], [ %.300.i.i.i, %B122.if.i.i.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep10332 = getelementptr double, ptr %invariant.gep10331, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep10332, align 8, !noalias !114
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.513.i1768.0.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep10334 = getelementptr double, ptr %invariant.gep10333, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep10334, align 8, !noalias !114
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep10336 = getelementptr double, ptr %invariant.gep10335, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep10336, align 8, !noalias !114
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.513.i1768.0.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep10338 = getelementptr double, ptr %invariant.gep10337, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep10338, align 8, !noalias !114
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep10340 = getelementptr double, ptr %invariant.gep10339, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep10340, align 8, !noalias !114
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.513.i1768.0.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep10342 = getelementptr double, ptr %invariant.gep10341, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep10342, align 8, !noalias !114
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i313.i.08243.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep10344 = getelementptr double, ptr %invariant.gep10343, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep10344, align 8, !noalias !114
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.513.i1768.0.i, %.193.i.i.i.6.i
  %.300.i.i.i = add nsw i64 %.229.i313.i.08243.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i313.i.08243.i, %arg.shape.0
  %gep10346 = getelementptr double, ptr %invariant.gep10345, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep10346, align 8, !noalias !114
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i.i.i = add nsw i64 %.229.i313.i.08243.i, %.358.i355.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep10348 = getelementptr double, ptr %invariant.gep10347, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep10348, align 8, !noalias !110
  %exitcond8409.not.i = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond8409.not.i, label %B154.i.loopexit.i, label %B122.if.i.i.i

B540.if.i.i:                                      ; preds = %B879.i.i, %B336.i1932.i
  %.791.i1781.08258.i = phi i64 [ 0, %B336.i1932.i ], [ %.860.i.i, %B879.i.i ]
  %.860.i.i = add nsw i64 %.791.i1781.08258.i, 1
  %.937.i2092.i = getelementptr double, ptr %58, i64 %.791.i1781.08258.i
  %.938.i2093.i = load double, ptr %.937.i2092.i, align 8, !noalias !98
  %.988.i2130.i = getelementptr double, ptr %57, i64 %.791.i1781.08258.i
  %.989.i2131.i = load double, ptr %.988.i2130.i, align 8, !noalias !98
  %.990.i2132.i = fsub double %.938.i2093.i, %.989.i2131.i
  %.992.i2134.i = fcmp ogt double %.990.i2132.i, 1.000000e-05
  br i1 %.992.i2134.i, label %B634.i.i, label %B879.i.i

B634.endif.i.i:                                   ; preds = %B0.endif.i188.i.i, %B494.i255.i.i
  %.999.i1788.0.i = phi double [ %.364.i247.i.i, %B0.endif.i188.i.i ], [ %.424.i271.i.i, %B494.i255.i.i ]
  br i1 %.430.i8215.not.i, label %B634.endif.endif.i.i, label %B58.if.i.i2369.i.preheader

B58.if.i.i2369.i.preheader:                       ; preds = %B634.endif.i.i
  %invariant.gep10349 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.791.i1781.08258.i
  %invariant.gep10351 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.791.i1781.08258.i
  br label %B58.if.i.i2369.i

B58.if.i.i2369.i:                                 ; preds = %B58.if.i.i2369.i.preheader, %B58.if.i.i2369.i
  %least.2.i.i1642.08255.i = phi double [ %.11.i.i665.i.i, %B58.if.i.i2369.i ], [ 0x7FF0000000000000, %B58.if.i.i2369.i.preheader ]
  %.54.i.i1643.08253.i = phi i64 [ %.125.i675.i.i, %B58.if.i.i2369.i ], [ 0, %B58.if.i.i2369.i.preheader ]
  %.125.i675.i.i = add nsw i64 %.54.i.i1643.08253.i, 1
  %.156.i572.i.i = add nsw i64 %.54.i.i1643.08253.i, %.155.i571.i.i
  %.158.i574.i.i = mul nsw i64 %.156.i572.i.i, %arg.shape.0
  %.164.i578.i.i = add nsw i64 %.54.i.i1643.08253.i, %.580.i1547.i
  %.166.i580.i.i = mul nsw i64 %.164.i578.i.i, %arg.shape.0
  %gep10350 = getelementptr double, ptr %invariant.gep10349, i64 %.166.i580.i.i
  %.198.i608.i.i = load double, ptr %gep10350, align 8, !noalias !118
  %gep10352 = getelementptr double, ptr %invariant.gep10351, i64 %.158.i574.i.i
  %.228.i630.i.i = load double, ptr %gep10352, align 8, !noalias !118
  %.229.i631.i.i = fmul double %.198.i608.i.i, %.228.i630.i.i
  %247 = getelementptr double, ptr %gep10352, i64 %.194.i.i738.i
  %.263.i656.i.i = load double, ptr %247, align 8, !noalias !118
  %.264.i657.i.i = fadd double %.229.i631.i.i, %.263.i656.i.i
  %.10.i.i664.i.i = fcmp olt double %.264.i657.i.i, %least.2.i.i1642.08255.i
  %.11.i.i665.i.i = select i1 %.10.i.i664.i.i, double %.264.i657.i.i, double %least.2.i.i1642.08255.i
  %exitcond8411.not.i = icmp eq i64 %arg.shape.6, %.125.i675.i.i
  br i1 %exitcond8411.not.i, label %B634.endif.endif.i.i, label %B58.if.i.i2369.i

B634.endif.endif.i.i:                             ; preds = %B58.if.i.i2369.i, %B634.endif.i.i
  %least.2.i.i1642.0.lcssa.i = phi double [ 0x7FF0000000000000, %B634.endif.i.i ], [ %.11.i.i665.i.i, %B58.if.i.i2369.i ]
  %.1065.i2196.i = fcmp olt double %least.2.i.i1642.0.lcssa.i, 0.000000e+00
  br i1 %.1065.i2196.i, label %B730.i.i, label %B802.i.i

B596.loopexit.i:                                  ; preds = %B122.if.i.i, %B596.if.i
  %exitcond8415.not.i = icmp eq i64 %arg.shape.0, %.1231.i
  br i1 %exitcond8415.not.i, label %B678.i, label %B596.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.08273.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.08273.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep10354 = getelementptr double, ptr %invariant.gep10353, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep10354, align 8, !noalias !122
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.1306.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.08273.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep10356 = getelementptr double, ptr %invariant.gep10355, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep10356, align 8, !noalias !122
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.08273.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep10358 = getelementptr double, ptr %invariant.gep10357, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep10358, align 8, !noalias !122
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.1306.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.08273.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep10360 = getelementptr double, ptr %invariant.gep10359, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep10360, align 8, !noalias !122
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.08273.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep10362 = getelementptr double, ptr %invariant.gep10361, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep10362, align 8, !noalias !122
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.1306.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.08273.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep10364 = getelementptr double, ptr %invariant.gep10363, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep10364, align 8, !noalias !122
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.08273.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep10366 = getelementptr double, ptr %invariant.gep10365, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep10366, align 8, !noalias !122
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.1306.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.08273.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.08273.i, %arg.shape.0
  %gep10368 = getelementptr double, ptr %invariant.gep10367, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep10368, align 8, !noalias !122
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.359.i.i = add nsw i64 %.229.i.08273.i, %.358.i355.i
  %.361.i.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep10370 = getelementptr double, ptr %invariant.gep10369, i64 %.361.i.i
  store double %.313.i.i.i, ptr %gep10370, align 8, !noalias !129
  %exitcond8414.not.i = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond8414.not.i, label %B596.loopexit.i, label %B122.if.i.i

B678.i:                                           ; preds = %B596.loopexit.i
  %.1380.i = load i64, ptr %.648.i1956.i, align 8, !noalias !65
  %.1496.i = inttoptr i64 %.1380.i to ptr
  tail call void %.1496.i(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1495.i), !noalias !65
  br label %B90.if.i7153.i

B142.i7104.i:                                     ; preds = %B90.if.i7153.i
  %248 = getelementptr double, ptr %56, i64 %.206.i5349.08279.i
  %.411.i7150.i = load double, ptr %248, align 8, !noalias !130
  %.412.i7151.i = fcmp ugt double %.411.i7150.i, 1.000000e-01
  br i1 %.412.i7151.i, label %B336.i6757.i, label %B204.i7011.i

B204.i7011.i:                                     ; preds = %B142.i7104.i
  %.472.i7055.i = getelementptr double, ptr %57, i64 %.206.i5349.08279.i
  %.473.i7056.i = load double, ptr %.472.i7055.i, align 8, !noalias !130
  %.523.i7100.i = getelementptr double, ptr %58, i64 %.206.i5349.08279.i
  %.524.i7101.i = load double, ptr %.523.i7100.i, align 8, !noalias !130
  %.525.i7102.i = fcmp olt double %.473.i7056.i, %.524.i7101.i
  br i1 %.525.i7102.i, label %B34.i.i6882.i, label %B336.i6757.i

B34.i.i6882.i:                                    ; preds = %B204.i7011.i, %B34.if.i.i6996.i
  %.51.i.i5209.0.i = phi i64 [ %.122.i.i7002.i, %B34.if.i.i6996.i ], [ 0, %B204.i7011.i ]
  %exitcond8416.not.i = icmp eq i64 %.51.i.i5209.0.i, %storemerge8004.i
  br i1 %exitcond8416.not.i, label %B336.i6757.i, label %B34.if.i.i6996.i

B128.i.i6987.i:                                   ; preds = %B34.if.i.i6996.i
  %249 = icmp sgt i64 %.51.i.i5209.0.i, -1
  br label %B336.i6757.i

B34.if.i.i6996.i:                                 ; preds = %B34.i.i6882.i
  %.122.i.i7002.i = add i64 %.51.i.i5209.0.i, 1
  %.157.i.i6934.i = add nsw i64 %.51.i.i5209.0.i, %.155.i571.i.i
  %.159.i.i6936.i = mul nsw i64 %.157.i.i6934.i, %arg.shape.0
  %.161.i.i6938.i = add nsw i64 %.159.i.i6936.i, %.206.i5349.08279.i
  %.175.i.i6946.i = icmp slt i64 %.161.i.i6938.i, 0
  %.176.i.i6947.i = select i1 %.175.i.i6946.i, i64 %arg.batch.5.4.5.0, i64 0
  %250 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i6938.i
  %.190.i.i6957.i = getelementptr double, ptr %250, i64 %.176.i.i6947.i
  %.191.i.i6958.i = load double, ptr %.190.i.i6957.i, align 8, !noalias !134
  %.195.i.i6962.i = add nsw i64 %.161.i.i6938.i, %.194.i.i738.i
  %.209.i.i6970.i = icmp slt i64 %.195.i.i6962.i, 0
  %.210.i.i6971.i = select i1 %.209.i.i6970.i, i64 %arg.batch.5.4.5.0, i64 0
  %251 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i.i6962.i
  %.224.i.i6981.i = getelementptr double, ptr %251, i64 %.210.i.i6971.i
  %.225.i.i6982.i = load double, ptr %.224.i.i6981.i, align 8, !noalias !134
  %.226.i.i6983.i = fneg double %.225.i.i6982.i
  %.227.i.i6984.i = fcmp olt double %.191.i.i6958.i, %.226.i.i6983.i
  br i1 %.227.i.i6984.i, label %B128.i.i6987.i, label %B34.i.i6882.i

B336.i6757.i:                                     ; preds = %B34.i.i6882.i, %B90.if.i7153.i, %B128.i.i6987.i, %B204.i7011.i, %B142.i7104.i
  %"$phi336.1.2.i5365.1.i" = phi i1 [ false, %B142.i7104.i ], [ false, %B204.i7011.i ], [ false, %B90.if.i7153.i ], [ %249, %B128.i.i6987.i ], [ false, %B34.i.i6882.i ]
  %spec.select8014.i = or i1 %some.2.i5345.08281.i, %"$phi336.1.2.i5365.1.i"
  %"$phi354.2.2.i5370.1.i" = select i1 %"$phi336.1.2.i5365.1.i", double 1.000000e+00, double 0.000000e+00
  %252 = getelementptr double, ptr %59, i64 %.206.i5349.08279.i
  store double %"$phi354.2.2.i5370.1.i", ptr %252, align 8, !noalias !130
  %exitcond8417.not.i = icmp eq i64 %arg.shape.0, %.277.i7161.i
  br i1 %exitcond8417.not.i, label %B392.i5517.i, label %B90.if.i7153.i

B392.i5517.i:                                     ; preds = %B336.i6757.i
  br i1 %spec.select8014.i, label %B400.i5537.i, label %B678.endif.i

B400.i5537.i:                                     ; preds = %B392.i5517.i
  %.759.i.i9855 = load i64, ptr %arg.code.4, align 8, !noalias !130
  %.875.i5646.i = inttoptr i64 %.759.i.i9855 to ptr
  tail call void %.875.i5646.i(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.875.i.i), !noalias !130
  br i1 %.114.i40.i8194.not.i, label %B468.endif.endif.i6041.i.critedge, label %B34.if.i111.i6683.i

B34.if.i111.i6683.i:                              ; preds = %B400.i5537.i, %B34.if.i111.i6683.i
  %.56.i.i5188.08284.i = phi i64 [ %.127.i115.i6689.i, %B34.if.i111.i6683.i ], [ 0, %B400.i5537.i ]
  %.127.i115.i6689.i = add nsw i64 %.56.i.i5188.08284.i, 1
  %.153.i49.i6598.i = add nsw i64 %.56.i.i5188.08284.i, %factor.op.mul8305.i.reass
  %.167.i56.i6606.i = icmp slt i64 %.153.i49.i6598.i, 0
  %.168.i.i6607.i = select i1 %.167.i56.i6606.i, i64 %arg.batch.5.4.5.0, i64 0
  %253 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i49.i6598.i
  %.182.i.i6617.i = getelementptr double, ptr %253, i64 %.168.i.i6607.i
  %.183.i68.i6618.i = load double, ptr %.182.i.i6617.i, align 8, !noalias !138
  %.185.i70.i6620.i = add nsw i64 %.56.i.i5188.08284.i, %.881.i.i
  %.199.i.i6628.i = icmp slt i64 %.185.i70.i6620.i, 0
  %.200.i.i6629.i = select i1 %.199.i.i6628.i, i64 %arg.batch.5.1.5.0, i64 0
  %254 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i70.i6620.i
  %.214.i89.i6639.i = getelementptr double, ptr %254, i64 %.200.i.i6629.i
  %.215.i90.i6640.i = load double, ptr %.214.i89.i6639.i, align 8, !noalias !138
  store double %.183.i68.i6618.i, ptr %.214.i89.i6639.i, align 8, !noalias !138
  store double %.215.i90.i6640.i, ptr %.182.i.i6617.i, align 8, !noalias !138
  %exitcond8418.not.i = icmp eq i64 %.194.i.i738.i, %.127.i115.i6689.i
  br i1 %exitcond8418.not.i, label %B468.endif.i5748.i, label %B34.if.i111.i6683.i

B1136.i6151.loopexit.i:                           ; preds = %B1224.if.i6453.i, %B1138.if.i6465.i
  %exitcond8421.not.i = icmp eq i64 %arg.shape.0, %.1484.i6469.i
  br i1 %exitcond8421.not.i, label %B678.endif.i, label %B1138.if.i6465.i

B90.if.i7153.i:                                   ; preds = %B678.i, %B336.i6757.i
  %some.2.i5345.08281.i = phi i1 [ %spec.select8014.i, %B336.i6757.i ], [ false, %B678.i ]
  %.206.i5349.08279.i = phi i64 [ %.277.i7161.i, %B336.i6757.i ], [ 0, %B678.i ]
  %.277.i7161.i = add nsw i64 %.206.i5349.08279.i, 1
  %255 = getelementptr i64, ptr %55, i64 %.206.i5349.08279.i
  %.355.i6746.i = load i64, ptr %255, align 8, !noalias !130
  %.356.i6747.i = icmp sgt i64 %.355.i6746.i, -1
  br i1 %.356.i6747.i, label %B142.i7104.i, label %B336.i6757.i

B468.endif.i5748.i:                               ; preds = %B34.if.i111.i6683.i
  %.940.i5770.i = load i64, ptr %.940.i.i, align 8, !noalias !130
  %.1052.i.i = inttoptr i64 %.940.i5770.i to ptr
  tail call void %.1052.i.i(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !130
  %.1083.i5862.i = load i64, ptr %arg.code.4, align 8, !noalias !130
  %.1199.i5936.i = inttoptr i64 %.1083.i5862.i to ptr
  tail call void %.1199.i5936.i(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1199.i.i), !noalias !130
  br label %B34.if.i316.i6572.i

B34.if.i316.i6572.i:                              ; preds = %B468.endif.i5748.i, %B34.if.i316.i6572.i
  %.56.i149.i5168.08287.i = phi i64 [ %.127.i324.i6578.i, %B34.if.i316.i6572.i ], [ 0, %B468.endif.i5748.i ]
  %.127.i324.i6578.i = add nsw i64 %.56.i149.i5168.08287.i, 1
  %.153.i217.i6487.i = add nsw i64 %.56.i149.i5168.08287.i, %factor.op.mul8305.i.reass
  %.167.i227.i6495.i = icmp slt i64 %.153.i217.i6487.i, 0
  %.168.i228.i6496.i = select i1 %.167.i227.i6495.i, i64 %arg.batch.5.4.5.0, i64 0
  %256 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i217.i6487.i
  %.182.i241.i6506.i = getelementptr double, ptr %256, i64 %.168.i228.i6496.i
  %.183.i242.i6507.i = load double, ptr %.182.i241.i6506.i, align 8, !noalias !142
  %.185.i244.i6509.i = add nsw i64 %.56.i149.i5168.08287.i, %.881.i.i
  %.199.i254.i6517.i = icmp slt i64 %.185.i244.i6509.i, 0
  %.200.i255.i6518.i = select i1 %.199.i254.i6517.i, i64 %arg.batch.5.1.5.0, i64 0
  %257 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i244.i6509.i
  %.214.i268.i6528.i = getelementptr double, ptr %257, i64 %.200.i255.i6518.i
  %.215.i269.i6529.i = load double, ptr %.214.i268.i6528.i, align 8, !noalias !142
  store double %.183.i242.i6507.i, ptr %.214.i268.i6528.i, align 8, !noalias !142
  store double %.215.i269.i6529.i, ptr %.182.i241.i6506.i, align 8, !noalias !142
  %exitcond8419.not.i = icmp eq i64 %.194.i.i738.i, %.127.i324.i6578.i
  br i1 %exitcond8419.not.i, label %B468.endif.endif.i6041.i, label %B34.if.i316.i6572.i

B468.endif.endif.i6041.i.critedge:                ; preds = %B400.i5537.i
  %.940.i5770.i.c = load i64, ptr %.940.i.i, align 8, !noalias !130
  %.1052.i.i.c = inttoptr i64 %.940.i5770.i.c to ptr
  tail call void %.1052.i.i.c(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !130
  %.1083.i5862.i.c = load i64, ptr %arg.code.4, align 8, !noalias !130
  %.1199.i5936.i.c = inttoptr i64 %.1083.i5862.i.c to ptr
  tail call void %.1199.i5936.i.c(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1199.i.i), !noalias !130
  br label %B468.endif.endif.i6041.i

B468.endif.endif.i6041.i:                         ; preds = %B34.if.i316.i6572.i, %B468.endif.endif.i6041.i.critedge
  %.1266.i6065.i = load i64, ptr %.940.i.i, align 8, !noalias !130
  %.1380.i.i = inttoptr i64 %.1266.i6065.i to ptr
  tail call void %.1380.i.i(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !130
  br label %B1138.if.i6465.i

B1138.if.i6465.i:                                 ; preds = %B468.endif.endif.i6041.i, %B1136.i6151.loopexit.i
  %.1414.i5415.08297.i = phi i64 [ %.1484.i6469.i, %B1136.i6151.loopexit.i ], [ 0, %B468.endif.endif.i6041.i ]
  %.1484.i6469.i = add nsw i64 %.1414.i5415.08297.i, 1
  %.1561.i6191.i = getelementptr double, ptr %59, i64 %.1414.i5415.08297.i
  %.1562.i6192.i = load double, ptr %.1561.i6191.i, align 8, !noalias !130
  %.1563.i6193.i = fcmp ule double %.1562.i6192.i, 5.000000e-01
  %.1660.i62198293.not.i = select i1 %.1563.i6193.i, i1 true, i1 %.287.i2218184.not.i
  br i1 %.1660.i62198293.not.i, label %B1136.i6151.loopexit.i, label %B1224.if.i6453.lr.ph.i

B1224.if.i6453.lr.ph.i:                           ; preds = %B1138.if.i6465.i
  %gep8300.i = getelementptr double, ptr %54, i64 %.1414.i5415.08297.i
  %gep8302.i = getelementptr double, ptr %56, i64 %.1414.i5415.08297.i
  br label %B1224.if.i6453.i

B1224.if.i6453.i:                                 ; preds = %B1224.if.i6453.i, %B1224.if.i6453.lr.ph.i
  %.1604.i5426.08294.i = phi i64 [ 0, %B1224.if.i6453.lr.ph.i ], [ %.1673.i6457.i, %B1224.if.i6453.i ]
  %.1673.i6457.i = add nsw i64 %.1604.i5426.08294.i, 1
  %258 = mul nsw i64 %.1604.i5426.08294.i, %arg.shape.0
  %.1701.i6228.i = add nsw i64 %258, %.1414.i5415.08297.i
  %259 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1701.i6228.i
  %.1731.i6247.i = load double, ptr %259, align 8, !noalias !130
  %.1740.i6256.i = add nsw i64 %.1701.i6228.i, %factor.op.mul8211.i.reass
  %.1754.i6263.i = icmp slt i64 %.1740.i6256.i, 0
  %.1755.i6264.i = select i1 %.1754.i6263.i, i64 %arg.batch.5.0.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1740.i6256.i
  %.1769.i.i = getelementptr double, ptr %260, i64 %.1755.i6264.i
  %.1770.i6275.i = load double, ptr %.1769.i.i, align 8, !noalias !130
  %.1775.i6280.i = add nsw i64 %.1701.i6228.i, %factor.op.mul8210.i.reass
  %.1789.i6287.i = icmp slt i64 %.1775.i6280.i, 0
  %.1790.i6288.i = select i1 %.1789.i6287.i, i64 %arg.batch.5.0.5.0, i64 0
  %261 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1775.i6280.i
  %.1804.i.i = getelementptr double, ptr %261, i64 %.1790.i6288.i
  %.1805.i6299.i = load double, ptr %.1804.i.i, align 8, !noalias !130
  %.1806.i6300.i = fsub double %.1770.i6275.i, %.1805.i6299.i
  %.1807.i6301.i = tail call double @llvm.fabs.f64(double %.1806.i6300.i)
  %.1858.i6335.i = load double, ptr %gep8300.i, align 8, !noalias !130
  %.1859.i6336.i = fmul double %.1858.i6335.i, %.1807.i6301.i
  %.1889.i6352.i = load double, ptr %.1889.i.i, align 8, !noalias !130
  %.1919.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !130
  %.1920.i6367.i = tail call double @llvm.fabs.f64(double %.1731.i6247.i)
  %.1921.i6368.i = fmul double %.1920.i6367.i, %.1919.i.i
  %.1922.i6369.i = fadd double %.1889.i6352.i, %.1921.i6368.i
  %.1926.i.i = fdiv double %.1859.i6336.i, %.1922.i6369.i
  %.1932.i6373.i = fsub double %.1926.i.i, %.1926.i.i
  %.1933.i6374.i = fcmp oeq double %.1932.i6373.i, 0.000000e+00
  %.1926.i..i = select i1 %.1933.i6374.i, double %.1926.i.i, double 0x7FF0000000000000
  %.2000.i6410.i = load double, ptr %gep8302.i, align 8, !noalias !130
  %.10.i.i6415.i = fcmp ogt double %.1926.i..i, %.2000.i6410.i
  %.11.i.i6416.i = select i1 %.10.i.i6415.i, double %.1926.i..i, double %.2000.i6410.i
  store double %.11.i.i6416.i, ptr %gep8302.i, align 8, !noalias !130
  %exitcond8420.not.i = icmp eq i64 %arg.shape.1, %.1673.i6457.i
  br i1 %exitcond8420.not.i, label %B1136.i6151.loopexit.i, label %B1224.if.i6453.i

B904.i:                                           ; preds = %B678.endif.i, %B492.endif.endif.i
  br i1 %.192.i9518228.i, label %B92.i7424.i, label %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B92.i7424.i:                                      ; preds = %B904.i, %B925.i7967.i
  %.182.i7235.sroa.0.08334.i = phi i64 [ %.182.i7235.sroa.0.0.i, %B925.i7967.i ], [ 0, %B904.i ]
  %.136.i7232.18333.i = phi i64 [ %.136.i7232.1.i, %B925.i7967.i ], [ %.136.i7232.18329.i, %B904.i ]
  %.133.i7231.18332.i = phi i64 [ %.133.i7231.1.i, %B925.i7967.i ], [ 1, %B904.i ]
  %some.2.i7225.08330.i = phi i1 [ %some.3.i7243.1.i, %B925.i7967.i ], [ false, %B904.i ]
  %.259.i7449.i = icmp slt i64 %.182.i7235.sroa.0.08334.i, 0
  %.260.i7450.i = select i1 %.259.i7449.i, i64 %arg.batch.4.1.5.1, i64 0
  %262 = getelementptr i64, ptr %55, i64 %.182.i7235.sroa.0.08334.i
  %.282.i7472.i = getelementptr i64, ptr %262, i64 %.260.i7450.i
  %.283.i7473.i = load i64, ptr %.282.i7472.i, align 8, !noalias !146
  %.284.i7474.i = icmp slt i64 %.283.i7473.i, 0
  br i1 %.284.i7474.i, label %B925.i7967.i, label %B142.i7475.i

B142.i7475.i:                                     ; preds = %B92.i7424.i
  %.313.i7496.i = select i1 %.259.i7449.i, i64 %arg.batch.4.0.5.1, i64 0
  %.314.i7497.i = add i64 %.313.i7496.i, %.182.i7235.sroa.0.08334.i
  %.335.i7518.i = getelementptr double, ptr %56, i64 %.314.i7497.i
  %.336.i7519.i = load double, ptr %.335.i7518.i, align 8, !noalias !146
  %.337.i7520.i = fcmp ule double %.336.i7519.i, 1.000000e-01
  br i1 %.337.i7520.i, label %B925.i7967.i, label %B210.i7523.i

B210.i7523.i:                                     ; preds = %B142.i7475.i
  br i1 %.430.i8215.not.i, label %B562.i7709.i.preheader, label %B240.if.i8336.i

B58.if.i.i8262.i:                                 ; preds = %B240.if.i8336.i, %B58.if.i.i8262.i
  %least.2.i.i7200.08319.i = phi double [ %.11.i.i.i8258.i, %B58.if.i.i8262.i ], [ 0x7FF0000000000000, %B240.if.i8336.i ]
  %.54.i.i7204.08317.i = phi i64 [ %.125.i.i8268.i, %B58.if.i.i8262.i ], [ 0, %B240.if.i8336.i ]
  %.125.i.i8268.i = add nsw i64 %.54.i.i7204.08317.i, 1
  %.156.i.i8174.i = add nsw i64 %.54.i.i7204.08317.i, %arg.shape.6
  %.158.i.i8176.i = mul nsw i64 %.156.i.i8174.i, %arg.shape.0
  %.160.i.i8178.i = add nsw i64 %.158.i.i8176.i, %.182.i7235.sroa.0.08334.i
  %.164.i.i8181.i = add nsw i64 %.54.i.i7204.08317.i, %.580.i1547.i
  %.166.i.i8183.i = mul nsw i64 %.164.i.i8181.i, %arg.shape.0
  %.168.i.i8185.i = add nsw i64 %.166.i.i8183.i, %.182.i7235.sroa.0.08334.i
  %.182.i.i8193.i = icmp slt i64 %.168.i.i8185.i, 0
  %.183.i.i8194.i = select i1 %.182.i.i8193.i, i64 %arg.batch.5.4.5.0, i64 0
  %263 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i.i8185.i
  %.197.i.i8204.i = getelementptr double, ptr %263, i64 %.183.i.i8194.i
  %.198.i.i8205.i = load double, ptr %.197.i.i8204.i, align 8, !noalias !150
  %.212.i.i8213.i = icmp slt i64 %.160.i.i8178.i, 0
  %.213.i.i8214.i = select i1 %.212.i.i8213.i, i64 %arg.batch.5.4.5.0, i64 0
  %264 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i8178.i
  %.227.i.i8224.i = getelementptr double, ptr %264, i64 %.213.i.i8214.i
  %.228.i.i8225.i = load double, ptr %.227.i.i8224.i, align 8, !noalias !150
  %.229.i.i8226.i = fmul double %.198.i.i8205.i, %.228.i.i8225.i
  %.233.i.i8230.i = add nsw i64 %.160.i.i8178.i, %.194.i.i738.i
  %.247.i.i8238.i = icmp slt i64 %.233.i.i8230.i, 0
  %.248.i.i8239.i = select i1 %.247.i.i8238.i, i64 %arg.batch.5.4.5.0, i64 0
  %265 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i.i8230.i
  %.262.i.i8249.i = getelementptr double, ptr %265, i64 %.248.i.i8239.i
  %.263.i.i8250.i = load double, ptr %.262.i.i8249.i, align 8, !noalias !150
  %.264.i.i8251.i = fadd double %.229.i.i8226.i, %.263.i.i8250.i
  %.10.i.i.i8257.i = fcmp olt double %.264.i.i8251.i, %least.2.i.i7200.08319.i
  %.11.i.i.i8258.i = select i1 %.10.i.i.i8257.i, double %.264.i.i8251.i, double %least.2.i.i7200.08319.i
  %exitcond8423.not.i = icmp eq i64 %arg.shape.6, %.125.i.i8268.i
  br i1 %exitcond8423.not.i, label %B562.i7709.i.preheader, label %B58.if.i.i8262.i

B562.i7709.i.preheader:                           ; preds = %B58.if.i.i8262.i, %B210.i7523.i
  %here.4.i7277.2.i.ph = phi double [ 0x7FF0000000000000, %B210.i7523.i ], [ %.11.i.i.i8258.i, %B58.if.i.i8262.i ]
  br label %B562.i7709.i

B562.i7709.i:                                     ; preds = %B562.i7709.i.preheader, %B676.i7727.i
  %here.4.i7277.2.i = phi double [ %here.3.i7281.3.i, %B676.i7727.i ], [ %here.4.i7277.2.i.ph, %B562.i7709.i.preheader ]
  %ahead.3.i7276.2.i = phi double [ %ahead.2.i7280.3.i, %B676.i7727.i ], [ 0.000000e+00, %B562.i7709.i.preheader ]
  %low.2.i7275.2.i = phi double [ %low.3.i7279.3.i, %B676.i7727.i ], [ 0.000000e+00, %B562.i7709.i.preheader ]
  %look.2.i7274.2.i = phi i64 [ %.979.i7738.i, %B676.i7727.i ], [ 1, %B562.i7709.i.preheader ]
  %266 = icmp ult i64 %look.2.i7274.2.i, 9
  br i1 %266, label %switch.lookup10520, label %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B58.if.i183.i.i:                                  ; preds = %B58.if.i183.i.lr.ph.i, %B58.if.i183.i.i
  %least.2.i16.i7177.08324.i = phi double [ 0x7FF0000000000000, %B58.if.i183.i.lr.ph.i ], [ %.11.i.i179.i.i, %B58.if.i183.i.i ]
  %.54.i20.i7181.08322.i = phi i64 [ 0, %B58.if.i183.i.lr.ph.i ], [ %.125.i189.i.i, %B58.if.i183.i.i ]
  %.125.i189.i.i = add nsw i64 %.54.i20.i7181.08322.i, 1
  %.156.i95.i.i = add nsw i64 %.54.i20.i7181.08322.i, %.155.i.i8148.i
  %.158.i97.i.i = mul nsw i64 %.156.i95.i.i, %arg.shape.0
  %.160.i99.i.i = add nsw i64 %.158.i97.i.i, %.182.i7235.sroa.0.08334.i
  %.164.i102.i.i = add nsw i64 %.54.i20.i7181.08322.i, %.580.i1547.i
  %.166.i104.i.i = mul nsw i64 %.164.i102.i.i, %arg.shape.0
  %.168.i106.i.i = add nsw i64 %.166.i104.i.i, %.182.i7235.sroa.0.08334.i
  %.182.i114.i.i = icmp slt i64 %.168.i106.i.i, 0
  %.183.i115.i.i = select i1 %.182.i114.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %267 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i106.i.i
  %.197.i125.i.i = getelementptr double, ptr %267, i64 %.183.i115.i.i
  %.198.i126.i.i = load double, ptr %.197.i125.i.i, align 8, !noalias !154
  %.212.i134.i.i = icmp slt i64 %.160.i99.i.i, 0
  %.213.i135.i.i = select i1 %.212.i134.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %268 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i99.i.i
  %.227.i145.i.i = getelementptr double, ptr %268, i64 %.213.i135.i.i
  %.228.i146.i.i = load double, ptr %.227.i145.i.i, align 8, !noalias !154
  %.229.i147.i.i = fmul double %.198.i126.i.i, %.228.i146.i.i
  %.233.i151.i.i = add nsw i64 %.160.i99.i.i, %.194.i.i738.i
  %.247.i159.i.i = icmp slt i64 %.233.i151.i.i, 0
  %.248.i160.i.i = select i1 %.247.i159.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %269 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i151.i.i
  %.262.i170.i.i = getelementptr double, ptr %269, i64 %.248.i160.i.i
  %.263.i171.i.i = load double, ptr %.262.i170.i.i, align 8, !noalias !154
  %.264.i172.i.i = fadd double %.229.i147.i.i, %.263.i171.i.i
  %.10.i.i178.i.i = fcmp olt double %.264.i172.i.i, %least.2.i16.i7177.08324.i
  %.11.i.i179.i.i = select i1 %.10.i.i178.i.i, double %.264.i172.i.i, double %least.2.i16.i7177.08324.i
  %exitcond8424.not.i = icmp eq i64 %arg.shape.6, %.125.i189.i.i
  br i1 %exitcond8424.not.i, label %B596.endif.i8106.i, label %B58.if.i183.i.i

B646.i8112.i:                                     ; preds = %B596.endif.i8106.i
  switch i64 %look.2.i7274.2.i, label %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i [
    i64 0, label %B676.i7727.i
    i64 6, label %switch.6.1.i8124.i
    i64 1, label %switch.1.1.i8129.i
    i64 8, label %switch.8.1.i8116.i
    i64 2, label %switch.2.1.i8128.i
    i64 5, label %switch.5.1.i8125.i
    i64 3, label %switch.3.1.i8127.i
    i64 7, label %switch.7.1.i8123.i
    i64 4, label %switch.4.1.i8126.i
  ]

B676.i7727.i:                                     ; preds = %switch.8.1.i8116.i, %switch.7.1.i8123.i, %switch.6.1.i8124.i, %switch.5.1.i8125.i, %switch.4.1.i8126.i, %switch.3.1.i8127.i, %switch.2.1.i8128.i, %switch.1.1.i8129.i, %B596.endif.i8106.i, %switch.lookup10520, %B646.i8112.i
  %here.3.i7281.3.i = phi double [ %here.4.i7277.2.i, %switch.lookup10520 ], [ %here.4.i7277.2.i, %B596.endif.i8106.i ], [ %least.2.i16.i7177.0.lcssa.i, %B646.i8112.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.8.1.i8116.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.7.1.i8123.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.6.1.i8124.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.5.1.i8125.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.4.1.i8126.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.3.1.i8127.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.2.1.i8128.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.1.1.i8129.i ]
  %ahead.2.i7280.3.i = phi double [ %ahead.3.i7276.2.i, %switch.lookup10520 ], [ %least.2.i16.i7177.0.lcssa.i, %B596.endif.i8106.i ], [ %least.2.i16.i7177.0.lcssa.i, %B646.i8112.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.8.1.i8116.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.7.1.i8123.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.6.1.i8124.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.5.1.i8125.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.4.1.i8126.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.3.1.i8127.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.2.1.i8128.i ], [ %least.2.i16.i7177.0.lcssa.i, %switch.1.1.i8129.i ]
  %low.3.i7279.3.i = phi double [ %low.2.i7275.2.i, %switch.lookup10520 ], [ %low.2.i7275.2.i, %B596.endif.i8106.i ], [ 0.000000e+00, %B646.i8112.i ], [ 1.000000e+00, %switch.8.1.i8116.i ], [ 8.889000e-01, %switch.7.1.i8123.i ], [ 7.500000e-01, %switch.6.1.i8124.i ], [ 0x3FE50A3D70A3D70A, %switch.5.1.i8125.i ], [ 5.000000e-01, %switch.4.1.i8126.i ], [ 3.333000e-01, %switch.3.1.i8127.i ], [ 2.500000e-01, %switch.2.1.i8128.i ], [ 0x3FB48E8A71DE69AD, %switch.1.1.i8129.i ]
  %.989.i7743.i = icmp eq i64 %look.2.i7274.2.i, 8
  %.979.i7738.i = add nsw i64 %look.2.i7274.2.i, 1
  %.1022.i.i9854 = fcmp ult double %ahead.2.i7280.3.i, 0.000000e+00
  %or.cond8016.i = select i1 %.989.i7743.i, i1 true, i1 %.1022.i.i9854
  br i1 %or.cond8016.i, label %B720.i7744.i, label %B562.i7709.i

B720.i7744.i:                                     ; preds = %B676.i7727.i
  br i1 %.1022.i.i9854, label %switch.lookup10523, label %B768.i7767.i

switch.lookup10523:                               ; preds = %B720.i7744.i
  %switch.gep10524 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i7274.2.i
  %switch.load10525 = load double, ptr %switch.gep10524, align 8
  br label %B768.i7767.i

B768.i7767.i:                                     ; preds = %switch.lookup10523, %B720.i7744.i
  %"$phi768.2.2.i7287.2.i" = phi double [ %low.3.i7279.3.i, %B720.i7744.i ], [ %switch.load10525, %switch.lookup10523 ]
  %.1156.i7813.i = getelementptr double, ptr %57, i64 %.314.i7497.i
  store double %low.3.i7279.3.i, ptr %.1156.i7813.i, align 8, !noalias !146
  %.1210.i7860.i = getelementptr double, ptr %58, i64 %.314.i7497.i
  store double %"$phi768.2.2.i7287.2.i", ptr %.1210.i7860.i, align 8, !noalias !146
  %.1264.i7907.i = getelementptr double, ptr %60, i64 %.314.i7497.i
  store double %here.3.i7281.3.i, ptr %.1264.i7907.i, align 8, !noalias !146
  %.1320.i7954.i = getelementptr double, ptr %61, i64 %.314.i7497.i
  store double %ahead.2.i7280.3.i, ptr %.1320.i7954.i, align 8, !noalias !146
  %.1331.i.i = fcmp olt double %ahead.2.i7280.3.i, 0.000000e+00
  %spec.select8017.i = select i1 %some.2.i7225.08330.i, i1 true, i1 %.1331.i.i
  br label %B925.i7967.i

B924.i7413.loopexit.i:                            ; preds = %B925.i7967.i
  %270 = xor i1 %some.3.i7243.1.i, true
  br label %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B925.i7967.i:                                     ; preds = %B768.i7767.i, %B142.i7475.i, %B92.i7424.i
  %some.3.i7243.1.i = phi i1 [ %spec.select8017.i, %B768.i7767.i ], [ %some.2.i7225.08330.i, %B142.i7475.i ], [ %some.2.i7225.08330.i, %B92.i7424.i ]
  %.192.i7404.i = icmp sgt i64 %.136.i7232.18333.i, 0
  %.205.i8367.i = zext i1 %.192.i7404.i to i64
  %.133.i7231.1.i = add i64 %.133.i7231.18332.i, %.205.i8367.i
  %.201.i8364.i = sext i1 %.192.i7404.i to i64
  %.136.i7232.1.i = add nsw i64 %.136.i7232.18333.i, %.201.i8364.i
  %.182.i7235.sroa.0.0.i = select i1 %.192.i7404.i, i64 %.133.i7231.18332.i, i64 0
  br i1 %.192.i7404.i, label %B92.i7424.i, label %B924.i7413.loopexit.i

B240.if.i8336.i:                                  ; preds = %B210.i7523.i, %B240.if.i8336.i
  %.374.i7247.08314.i = phi i64 [ %.443.i8344.i, %B240.if.i8336.i ], [ 0, %B210.i7523.i ]
  %.443.i8344.i = add nsw i64 %.374.i7247.08314.i, 1
  %.581.i8305.i = add nsw i64 %.374.i7247.08314.i, %.580.i1547.i
  %.585.i8308.i = mul nsw i64 %.581.i8305.i, %arg.shape.0
  %.587.i8310.i = add nsw i64 %.585.i8308.i, %.182.i7235.sroa.0.08334.i
  %.602.i8319.i = icmp slt i64 %.587.i8310.i, 0
  %.603.i8320.i = select i1 %.602.i8319.i, i64 %arg.batch.5.4.5.0, i64 0
  %271 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.587.i8310.i
  %.617.i8333.i = getelementptr double, ptr %271, i64 %.603.i8320.i
  store double 1.000000e+00, ptr %.617.i8333.i, align 8, !noalias !146
  %exitcond8422.not.i = icmp eq i64 %arg.shape.6, %.443.i8344.i
  br i1 %exitcond8422.not.i, label %B58.if.i.i8262.i, label %B240.if.i8336.i

switch.lookup10520:                               ; preds = %B562.i7709.i
  %switch.gep10521 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i7274.2.i
  %switch.load10522 = load double, ptr %switch.gep10521, align 8
  %.864.i.i = fcmp ogt double %switch.load10522, %low.2.i7275.2.i
  br i1 %.864.i.i, label %B58.i66.i8073.preheader.i, label %B676.i7727.i

B58.i66.i8073.preheader.i:                        ; preds = %switch.lookup10520
  br i1 %.430.i8215.not.i, label %B596.endif.i8106.i, label %B58.if.i183.i.lr.ph.i

B58.if.i183.i.lr.ph.i:                            ; preds = %B58.i66.i8073.preheader.i
  %.151.i.i8146.i = mul nsw i64 %look.2.i7274.2.i, 3
  %.153.i.i81477914.i = add nsw i64 %.151.i.i8146.i, 1
  %.155.i.i8148.i = mul i64 %.153.i.i81477914.i, %arg.shape.6
  br label %B58.if.i183.i.i

B596.endif.i8106.i:                               ; preds = %B58.if.i183.i.i, %B58.i66.i8073.preheader.i
  %least.2.i16.i7177.0.lcssa.i = phi double [ 0x7FF0000000000000, %B58.i66.i8073.preheader.i ], [ %.11.i.i179.i.i, %B58.if.i183.i.i ]
  %.915.i8111.i = fcmp ult double %least.2.i16.i7177.0.lcssa.i, 0.000000e+00
  br i1 %.915.i8111.i, label %B676.i7727.i, label %B646.i8112.i

switch.1.1.i8129.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.2.1.i8128.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.3.1.i8127.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.4.1.i8126.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.5.1.i8125.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.6.1.i8124.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.7.1.i8123.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

switch.8.1.i8116.i:                               ; preds = %B646.i8112.i
  br label %B676.i7727.i

_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B646.i8112.i, %B562.i7709.i, %B924.i7413.loopexit.i, %B904.i
  %.192.i74048163.i = phi i1 [ false, %B924.i7413.loopexit.i ], [ false, %B904.i ], [ true, %B562.i7709.i ], [ true, %B646.i8112.i ]
  %.1586.0.i = phi i1 [ %270, %B924.i7413.loopexit.i ], [ true, %B904.i ], [ true, %B562.i7709.i ], [ true, %B646.i8112.i ]
  %excinfo.7.6.i = phi ptr [ null, %B924.i7413.loopexit.i ], [ null, %B904.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53, %B562.i7709.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53, %B646.i8112.i ]
  %.16118378.i = phi i32 [ 0, %B924.i7413.loopexit.i ], [ 0, %B904.i ], [ 1, %B562.i7709.i ], [ 1, %B646.i8112.i ]
  br i1 %.192.i74048163.i, label %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B904.endif.endif.i, !prof !97

B114.i3153.loopexit.i:                            ; preds = %B879.i3503.i
  %.221.i3158.i = icmp ne i64 %.165.i3034.18365.i, 0
  %272 = sub nsw i64 45, %.162.i3033.18364.i
  %.234.i5149.i = zext i1 %.221.i3158.i to i64
  %.162.i3033.1.i = add i64 %.162.i3033.18364.i, %.234.i5149.i
  %.230.i5146.i = sext i1 %.221.i3158.i to i64
  %.165.i3034.1.i = add nsw i64 %.165.i3034.18365.i, %.230.i5146.i
  %.211.i3037.sroa.0.0.i = select i1 %.221.i3158.i, i64 %272, i64 45
  br i1 %.221.i3158.i, label %B154.i3220.preheader.i, label %B996.i

B154.i3220.preheader.i:                           ; preds = %B154.i3220.preheader.i.preheader, %B114.i3153.loopexit.i
  %.211.i3037.sroa.0.08366.i = phi i64 [ %.211.i3037.sroa.0.0.i, %B114.i3153.loopexit.i ], [ 45, %B154.i3220.preheader.i.preheader ]
  %.165.i3034.18365.i = phi i64 [ %.165.i3034.1.i, %B114.i3153.loopexit.i ], [ 44, %B154.i3220.preheader.i.preheader ]
  %.162.i3033.18364.i = phi i64 [ %.162.i3033.1.i, %B114.i3153.loopexit.i ], [ 1, %B154.i3220.preheader.i.preheader ]
  %.108.not.i8056.i = icmp eq i64 %.211.i3037.sroa.0.08366.i, 0
  br label %B154.if.i5124.i

B154.i3220.loopexit.i:                            ; preds = %B122.if.i.i5079.i, %B250.endif.i4617.i
  %exitcond8427.not.i = icmp eq i64 %arg.shape.0, %.358.i5131.i
  br i1 %exitcond8427.not.i, label %B326.i3233.i, label %B154.if.i5124.i

B162.i4239.i:                                     ; preds = %B154.if.i5124.i
  %.443.i4282.i = getelementptr double, ptr %58, i64 %.289.i3047.08344.i
  %.444.i4283.i = load double, ptr %.443.i4282.i, align 8, !noalias !158
  %.494.i4327.i = getelementptr double, ptr %57, i64 %.289.i3047.08344.i
  %.495.i4328.i = load double, ptr %.494.i4327.i, align 8, !noalias !158
  %.496.i4329.i = fsub double %.444.i4283.i, %.495.i4328.i
  %.498.i4331.i = fcmp ogt double %.496.i4329.i, 1.000000e-13
  br label %B250.i4333.i

B250.i4333.i:                                     ; preds = %B154.if.i5124.i, %B162.i4239.i
  %"$phi250.2.2.i3056.2.i" = phi i1 [ true, %B154.if.i5124.i ], [ %.498.i4331.i, %B162.i4239.i ]
  %.67.i.i4397.i = getelementptr double, ptr %57, i64 %.289.i3047.08344.i
  %.68.i.i4398.i = load double, ptr %.67.i.i4397.i, align 8, !noalias !162
  %.116.i.i4431.i = getelementptr double, ptr %58, i64 %.289.i3047.08344.i
  %.117.i.i4432.i = load double, ptr %.116.i.i4431.i, align 8, !noalias !162
  %.171.i.i4467.i = getelementptr double, ptr %60, i64 %.289.i3047.08344.i
  %.172.i.i4468.i = load double, ptr %.171.i.i4467.i, align 8, !noalias !162
  %.220.i.i4501.i = getelementptr double, ptr %61, i64 %.289.i3047.08344.i
  %.221.i.i4502.i = load double, ptr %.220.i.i4501.i, align 8, !noalias !162
  %.224.i.i4505.i = fadd double %.68.i.i4398.i, %.117.i.i4432.i
  %.225.i.i4506.i = fmul double %.224.i.i4505.i, 5.000000e-01
  br i1 %.108.not.i8056.i, label %B0.endif.i.i4520.i, label %B282.i8057.i

B282.i8057.i:                                     ; preds = %B250.i4333.i, %B282.i8057.i
  %r.2.0.i8058.i = phi double [ %r.3.1.i8064.i, %B282.i8057.i ], [ 1.000000e+00, %B250.i4333.i ]
  %a.1.2.0.i8059.i = phi double [ %.147.i8066.i, %B282.i8057.i ], [ 2.000000e+00, %B250.i4333.i ]
  %exp.4.0.i8060.i = phi i64 [ %.142.i8065.i, %B282.i8057.i ], [ %.211.i3037.sroa.0.08366.i, %B250.i4333.i ]
  %.122.i8061.i = and i64 %exp.4.0.i8060.i, 1
  %.123.not.i8062.i = icmp eq i64 %.122.i8061.i, 0
  %.127.i8063.i = fmul double %r.2.0.i8058.i, %a.1.2.0.i8059.i
  %r.3.1.i8064.i = select i1 %.123.not.i8062.i, double %r.2.0.i8058.i, double %.127.i8063.i
  %.142.i8065.i = lshr i64 %exp.4.0.i8060.i, 1
  %.147.i8066.i = fmul double %a.1.2.0.i8059.i, %a.1.2.0.i8059.i
  %.150.not.i8067.i = icmp eq i64 %.142.i8065.i, 0
  br i1 %.150.not.i8067.i, label %B334.i8068.loopexit.i, label %B282.i8057.i

B334.i8068.loopexit.i:                            ; preds = %B282.i8057.i
  %273 = fmul double %r.3.1.i8064.i, 1.000000e-13
  br label %B0.endif.i.i4520.i

B494.i.i4587.i:                                   ; preds = %B0.endif.i.i4520.i
  %.10.i3.i.i4594.i = fcmp olt double %.261.i.i4526.i, 0.000000e+00
  %.11.i4.i.i4595.i = select i1 %.10.i3.i.i4594.i, double 0.000000e+00, double %.261.i.i4526.i
  %.420.i.i4600.i = fmul double %.316.i.i4555.i, %.11.i4.i.i4595.i
  %.424.i.i4603.i = fsub double %.225.i.i4506.i, %.420.i.i4600.i
  br label %B250.endif.i4617.i

B0.endif.i.i4520.i:                               ; preds = %B334.i8068.loopexit.i, %B250.i4333.i
  %r.4.1.i8069.i = phi double [ 1.000000e-13, %B250.i4333.i ], [ %273, %B334.i8068.loopexit.i ]
  %.259.i.i4524.i = fsub double %.117.i.i4432.i, %.68.i.i4398.i
  %.260.i.i4525.i = fsub double %r.4.1.i8069.i, %.259.i.i4524.i
  %.261.i.i4526.i = fmul double %.260.i.i4525.i, 5.000000e-01
  %.266.i.i4529.i = fmul double %.68.i.i4398.i, %.221.i.i4502.i
  %.268.i.i4531.i = fmul double %.117.i.i4432.i, %.172.i.i4468.i
  %.269.i.i4532.i = fsub double %.266.i.i4529.i, %.268.i.i4531.i
  %.270.i.i4533.i = fsub double %.221.i.i4502.i, %.172.i.i4468.i
  %.274.i.i4536.i = fdiv double %.269.i.i4532.i, %.270.i.i4533.i
  %.280.i.i4540.i = fcmp olt double %.68.i.i4398.i, %.274.i.i4536.i
  %.288.i.i5110.i = fcmp olt double %.274.i.i4536.i, %.117.i.i4432.i
  %or.cond8020.i = select i1 %.280.i.i4540.i, i1 %.288.i.i5110.i, i1 false
  %"$phi302.0.2.i.i2934.0.i" = select i1 %or.cond8020.i, double %.274.i.i4536.i, double %.225.i.i4506.i
  %.315.i.i4554.i = fsub double %.225.i.i4506.i, %"$phi302.0.2.i.i2934.0.i"
  %.316.i.i4555.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i.i4554.i)
  %.330.i.i4565.i = fmul double %.259.i.i4524.i, %.259.i.i4524.i
  %.333.i.i4568.i = tail call double @llvm.fabs.f64(double %.315.i.i4554.i)
  %.10.i.i.i4573.i = fcmp olt double %.333.i.i4568.i, %.330.i.i4565.i
  %.11.i.i.i4574.i = select i1 %.10.i.i.i4573.i, double %.333.i.i4568.i, double %.330.i.i4565.i
  %.363.i.i4578.i = fmul double %.316.i.i4555.i, %.11.i.i.i4574.i
  %.364.i.i4579.i = fadd double %"$phi302.0.2.i.i2934.0.i", %.363.i.i4578.i
  %.370.i.i4583.i = fsub double %.364.i.i4579.i, %.225.i.i4506.i
  %.371.i.i4584.i = tail call double @llvm.fabs.f64(double %.370.i.i4583.i)
  %.373.i.i4586.i = fcmp ugt double %.371.i.i4584.i, %.261.i.i4526.i
  br i1 %.373.i.i4586.i, label %B494.i.i4587.i, label %B250.endif.i4617.i

B326.i3233.i:                                     ; preds = %B154.i3220.loopexit.i
  br i1 %"$phi250.2.2.i3056.2.i", label %B336.i3252.i, label %B996.i

B336.i3252.i:                                     ; preds = %B326.i3233.i
  %.649.i3280.i = load i64, ptr %.648.i1956.i, align 8, !noalias !158
  %.765.i3355.i = inttoptr i64 %.649.i3280.i to ptr
  tail call void %.765.i3355.i(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1495.i), !noalias !158
  br label %B540.if.i4214.i

B634.i3504.i:                                     ; preds = %B540.if.i4214.i
  %.171.i135.i3634.i = getelementptr double, ptr %60, i64 %.791.i3075.08356.i
  %.172.i136.i3635.i = load double, ptr %.171.i135.i3634.i, align 8, !noalias !166
  %.220.i169.i3668.i = getelementptr double, ptr %61, i64 %.791.i3075.08356.i
  %.221.i170.i3669.i = load double, ptr %.220.i169.i3668.i, align 8, !noalias !166
  %.224.i173.i3672.i = fadd double %.938.i3453.i, %.989.i3497.i
  %.225.i174.i3673.i = fmul double %.224.i173.i3672.i, 5.000000e-01
  br i1 %.108.not.i8056.i, label %B0.endif.i188.i3687.i, label %B282.i8086.i

B282.i8086.i:                                     ; preds = %B634.i3504.i, %B282.i8086.i
  %r.2.0.i8087.i = phi double [ %r.3.1.i8093.i, %B282.i8086.i ], [ 1.000000e+00, %B634.i3504.i ]
  %a.1.2.0.i8088.i = phi double [ %.147.i8095.i, %B282.i8086.i ], [ 2.000000e+00, %B634.i3504.i ]
  %exp.4.0.i8089.i = phi i64 [ %.142.i8094.i, %B282.i8086.i ], [ %.211.i3037.sroa.0.08366.i, %B634.i3504.i ]
  %.122.i8090.i = and i64 %exp.4.0.i8089.i, 1
  %.123.not.i8091.i = icmp eq i64 %.122.i8090.i, 0
  %.127.i8092.i = fmul double %r.2.0.i8087.i, %a.1.2.0.i8088.i
  %r.3.1.i8093.i = select i1 %.123.not.i8091.i, double %r.2.0.i8087.i, double %.127.i8092.i
  %.142.i8094.i = lshr i64 %exp.4.0.i8089.i, 1
  %.147.i8095.i = fmul double %a.1.2.0.i8088.i, %a.1.2.0.i8088.i
  %.150.not.i8096.i = icmp eq i64 %.142.i8094.i, 0
  br i1 %.150.not.i8096.i, label %B334.i8097.loopexit.i, label %B282.i8086.i

B334.i8097.loopexit.i:                            ; preds = %B282.i8086.i
  %274 = fmul double %r.3.1.i8093.i, 1.000000e-13
  br label %B0.endif.i188.i3687.i

B494.i255.i3754.i:                                ; preds = %B0.endif.i188.i3687.i
  %.10.i3.i262.i3761.i = fcmp olt double %.261.i194.i3693.i, 0.000000e+00
  %.11.i4.i263.i3762.i = select i1 %.10.i3.i262.i3761.i, double 0.000000e+00, double %.261.i194.i3693.i
  %.420.i268.i3767.i = fmul double %.316.i223.i3722.i, %.11.i4.i263.i3762.i
  %.424.i271.i3770.i = fsub double %.225.i174.i3673.i, %.420.i268.i3767.i
  br label %B634.endif.i3784.i

B0.endif.i188.i3687.i:                            ; preds = %B334.i8097.loopexit.i, %B634.i3504.i
  %r.4.1.i8098.i = phi double [ 1.000000e-13, %B634.i3504.i ], [ %274, %B334.i8097.loopexit.i ]
  %.260.i193.i3692.i = fsub double %r.4.1.i8098.i, %.990.i3498.i
  %.261.i194.i3693.i = fmul double %.260.i193.i3692.i, 5.000000e-01
  %.266.i197.i3696.i = fmul double %.989.i3497.i, %.221.i170.i3669.i
  %.268.i199.i3698.i = fmul double %.938.i3453.i, %.172.i136.i3635.i
  %.269.i200.i3699.i = fsub double %.266.i197.i3696.i, %.268.i199.i3698.i
  %.270.i201.i3700.i = fsub double %.221.i170.i3669.i, %.172.i136.i3635.i
  %.274.i204.i3703.i = fdiv double %.269.i200.i3699.i, %.270.i201.i3700.i
  %.280.i208.i3707.i = fcmp olt double %.989.i3497.i, %.274.i204.i3703.i
  %.288.i282.i4200.i = fcmp olt double %.274.i204.i3703.i, %.938.i3453.i
  %or.cond8021.i = and i1 %.280.i208.i3707.i, %.288.i282.i4200.i
  %"$phi302.0.2.i26.i2914.0.i" = select i1 %or.cond8021.i, double %.274.i204.i3703.i, double %.225.i174.i3673.i
  %.315.i222.i3721.i = fsub double %.225.i174.i3673.i, %"$phi302.0.2.i26.i2914.0.i"
  %.316.i223.i3722.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i222.i3721.i)
  %.330.i233.i3732.i = fmul double %.990.i3498.i, %.990.i3498.i
  %.333.i236.i3735.i = tail call double @llvm.fabs.f64(double %.315.i222.i3721.i)
  %.10.i.i241.i3740.i = fcmp olt double %.333.i236.i3735.i, %.330.i233.i3732.i
  %.11.i.i242.i3741.i = select i1 %.10.i.i241.i3740.i, double %.333.i236.i3735.i, double %.330.i233.i3732.i
  %.363.i246.i3745.i = fmul double %.316.i223.i3722.i, %.11.i.i242.i3741.i
  %.364.i247.i3746.i = fadd double %"$phi302.0.2.i26.i2914.0.i", %.363.i246.i3745.i
  %.370.i251.i3750.i = fsub double %.364.i247.i3746.i, %.225.i174.i3673.i
  %.371.i252.i3751.i = tail call double @llvm.fabs.f64(double %.370.i251.i3750.i)
  %.373.i254.i3753.i = fcmp ugt double %.371.i252.i3751.i, %.261.i194.i3693.i
  br i1 %.373.i254.i3753.i, label %B494.i255.i3754.i, label %B634.endif.i3784.i

B730.i3974.i:                                     ; preds = %B634.endif.endif.i3876.i
  store double %.999.i3086.0.i, ptr %.937.i3452.i, align 8, !noalias !158
  store double %least.2.i.i2833.0.lcssa.i, ptr %.220.i169.i3668.i, align 8, !noalias !158
  br label %B879.i3503.i

B802.i3880.i:                                     ; preds = %B634.endif.endif.i3876.i
  store double %.999.i3086.0.i, ptr %.988.i3496.i, align 8, !noalias !158
  store double %least.2.i.i2833.0.lcssa.i, ptr %.171.i135.i3634.i, align 8, !noalias !158
  br label %B879.i3503.i

B879.i3503.i:                                     ; preds = %B540.if.i4214.i, %B802.i3880.i, %B730.i3974.i
  %exitcond8429.not.i = icmp eq i64 %arg.shape.0, %.860.i4221.i
  br i1 %exitcond8429.not.i, label %B114.i3153.loopexit.i, label %B540.if.i4214.i

B154.if.i5124.i:                                  ; preds = %B154.i3220.loopexit.i, %B154.i3220.preheader.i
  %wide.2.i3043.18346.i = phi i1 [ false, %B154.i3220.preheader.i ], [ %"$phi250.2.2.i3056.2.i", %B154.i3220.loopexit.i ]
  %.289.i3047.08344.i = phi i64 [ 0, %B154.i3220.preheader.i ], [ %.358.i5131.i, %B154.i3220.loopexit.i ]
  %.358.i5131.i = add nsw i64 %.289.i3047.08344.i, 1
  br i1 %wide.2.i3043.18346.i, label %B250.i4333.i, label %B162.i4239.i

B250.endif.i4617.i:                               ; preds = %B0.endif.i.i4520.i, %B494.i.i4587.i
  %.513.i3059.0.i = phi double [ %.364.i.i4579.i, %B0.endif.i.i4520.i ], [ %.424.i.i4603.i, %B494.i.i4587.i ]
  %.92.i352.i4698.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.289.i3047.08344.i
  %.93.i353.i4699.i = load double, ptr %.92.i352.i4698.i, align 8, !noalias !170
  %.146.i384.i4735.i = getelementptr double, ptr %54, i64 %.289.i3047.08344.i
  %.147.i385.i4736.i = load double, ptr %.146.i384.i4735.i, align 8, !noalias !170
  %.149.i387.i4738.i = fmul double %.513.i3059.0.i, %.147.i385.i4736.i
  %.150.i388.i4739.i = fadd double %.93.i353.i4699.i, %.149.i387.i4738.i
  %.203.i421.i4775.i = getelementptr double, ptr %.577, i64 %.289.i3047.08344.i
  store double %.150.i388.i4739.i, ptr %.203.i421.i4775.i, align 8, !noalias !170
  br i1 %.287.i2218184.not.i, label %B154.i3220.loopexit.i, label %B122.if.i.i5079.lr.ph.i

B122.if.i.i5079.lr.ph.i:                          ; preds = %B250.endif.i4617.i
  %.247.i.i.i5049.i = fsub double 1.000000e+00, %.513.i3059.0.i
  %invariant.gep10371 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10373 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10375 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10377 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10379 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10381 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10383 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10385 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  %invariant.gep10387 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.289.i3047.08344.i
  br label %B122.if.i.i5079.i

B122.if.i.i5079.i:                                ; preds = %B122.if.i.i5079.i, %B122.if.i.i5079.lr.ph.i
  %.229.i313.i2889.08341.i = phi i64 [ 0, %B122.if.i.i5079.lr.ph.i ], [ %.300.i.i5085.i, %B122.if.i.i5079.i ]
  %.157.i.i.i5006.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.i
  %.159.i.i.i5008.i = mul nsw i64 %.157.i.i.i5006.i, %arg.shape.0
  %gep10372 = getelementptr double, ptr %invariant.gep10371, i64 %.159.i.i.i5008.i
  %.191.i.i.i5030.i = load double, ptr %gep10372, align 8, !noalias !174
  %.193.i.i.i5032.i = fadd double %.191.i.i.i5030.i, 0.000000e+00
  %.253.i.i.i5054.i = fmul double %.513.i3059.0.i, %.193.i.i.i5032.i
  %.157.i.i.i5006.1.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.1.i
  %.159.i.i.i5008.1.i = mul nsw i64 %.157.i.i.i5006.1.i, %arg.shape.0
  %gep10374 = getelementptr double, ptr %invariant.gep10373, i64 %.159.i.i.i5008.1.i
  %.191.i.i.i5030.1.i = load double, ptr %gep10374, align 8, !noalias !174
  %.193.i.i.i5032.1.i = fadd double %.191.i.i.i5030.1.i, %.253.i.i.i5054.i
  %.253.i.i.i5054.1.i = fmul double %.247.i.i.i5049.i, %.193.i.i.i5032.1.i
  %.157.i.i.i5006.2.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.2.i
  %.159.i.i.i5008.2.i = mul nsw i64 %.157.i.i.i5006.2.i, %arg.shape.0
  %gep10376 = getelementptr double, ptr %invariant.gep10375, i64 %.159.i.i.i5008.2.i
  %.191.i.i.i5030.2.i = load double, ptr %gep10376, align 8, !noalias !174
  %.193.i.i.i5032.2.i = fadd double %.191.i.i.i5030.2.i, %.253.i.i.i5054.1.i
  %.253.i.i.i5054.2.i = fmul double %.513.i3059.0.i, %.193.i.i.i5032.2.i
  %.157.i.i.i5006.3.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.3.i
  %.159.i.i.i5008.3.i = mul nsw i64 %.157.i.i.i5006.3.i, %arg.shape.0
  %gep10378 = getelementptr double, ptr %invariant.gep10377, i64 %.159.i.i.i5008.3.i
  %.191.i.i.i5030.3.i = load double, ptr %gep10378, align 8, !noalias !174
  %.193.i.i.i5032.3.i = fadd double %.191.i.i.i5030.3.i, %.253.i.i.i5054.2.i
  %.253.i.i.i5054.3.i = fmul double %.247.i.i.i5049.i, %.193.i.i.i5032.3.i
  %.157.i.i.i5006.4.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.4.i
  %.159.i.i.i5008.4.i = mul nsw i64 %.157.i.i.i5006.4.i, %arg.shape.0
  %gep10380 = getelementptr double, ptr %invariant.gep10379, i64 %.159.i.i.i5008.4.i
  %.191.i.i.i5030.4.i = load double, ptr %gep10380, align 8, !noalias !174
  %.193.i.i.i5032.4.i = fadd double %.191.i.i.i5030.4.i, %.253.i.i.i5054.3.i
  %.253.i.i.i5054.4.i = fmul double %.513.i3059.0.i, %.193.i.i.i5032.4.i
  %.157.i.i.i5006.5.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.5.i
  %.159.i.i.i5008.5.i = mul nsw i64 %.157.i.i.i5006.5.i, %arg.shape.0
  %gep10382 = getelementptr double, ptr %invariant.gep10381, i64 %.159.i.i.i5008.5.i
  %.191.i.i.i5030.5.i = load double, ptr %gep10382, align 8, !noalias !174
  %.193.i.i.i5032.5.i = fadd double %.191.i.i.i5030.5.i, %.253.i.i.i5054.4.i
  %.253.i.i.i5054.5.i = fmul double %.247.i.i.i5049.i, %.193.i.i.i5032.5.i
  %.157.i.i.i5006.6.i = add nsw i64 %.229.i313.i2889.08341.i, %.155.i.i.i5004.6.i
  %.159.i.i.i5008.6.i = mul nsw i64 %.157.i.i.i5006.6.i, %arg.shape.0
  %gep10384 = getelementptr double, ptr %invariant.gep10383, i64 %.159.i.i.i5008.6.i
  %.191.i.i.i5030.6.i = load double, ptr %gep10384, align 8, !noalias !174
  %.193.i.i.i5032.6.i = fadd double %.191.i.i.i5030.6.i, %.253.i.i.i5054.5.i
  %.253.i.i.i5054.6.i = fmul double %.513.i3059.0.i, %.193.i.i.i5032.6.i
  %.300.i.i5085.i = add nsw i64 %.229.i313.i2889.08341.i, 1
  %.271.i.i.i4927.i = mul nsw i64 %.229.i313.i2889.08341.i, %arg.shape.0
  %gep10386 = getelementptr double, ptr %invariant.gep10385, i64 %.271.i.i.i4927.i
  %.309.i.i.i4952.i = load double, ptr %gep10386, align 8, !noalias !174
  %.313.i.i.i4955.i = fadd double %.309.i.i.i4952.i, %.253.i.i.i5054.6.i
  %.359.i.i4968.i = add nsw i64 %.229.i313.i2889.08341.i, %.358.i355.i
  %.361.i.i4970.i = mul nsw i64 %.359.i.i4968.i, %arg.shape.0
  %gep10388 = getelementptr double, ptr %invariant.gep10387, i64 %.361.i.i4970.i
  store double %.313.i.i.i4955.i, ptr %gep10388, align 8, !noalias !170
  %exitcond8426.not.i = icmp eq i64 %arg.shape.1, %.300.i.i5085.i
  br i1 %exitcond8426.not.i, label %B154.i3220.loopexit.i, label %B122.if.i.i5079.i

B540.if.i4214.i:                                  ; preds = %B879.i3503.i, %B336.i3252.i
  %.791.i3075.08356.i = phi i64 [ 0, %B336.i3252.i ], [ %.860.i4221.i, %B879.i3503.i ]
  %.860.i4221.i = add nsw i64 %.791.i3075.08356.i, 1
  %.937.i3452.i = getelementptr double, ptr %58, i64 %.791.i3075.08356.i
  %.938.i3453.i = load double, ptr %.937.i3452.i, align 8, !noalias !158
  %.988.i3496.i = getelementptr double, ptr %57, i64 %.791.i3075.08356.i
  %.989.i3497.i = load double, ptr %.988.i3496.i, align 8, !noalias !158
  %.990.i3498.i = fsub double %.938.i3453.i, %.989.i3497.i
  %.992.i3500.i = fcmp ogt double %.990.i3498.i, 1.000000e-13
  br i1 %.992.i3500.i, label %B634.i3504.i, label %B879.i3503.i

B634.endif.i3784.i:                               ; preds = %B0.endif.i188.i3687.i, %B494.i255.i3754.i
  %.999.i3086.0.i = phi double [ %.364.i247.i3746.i, %B0.endif.i188.i3687.i ], [ %.424.i271.i3770.i, %B494.i255.i3754.i ]
  br i1 %.430.i8215.not.i, label %B634.endif.endif.i3876.i, label %B58.if.i.i4169.i.preheader

B58.if.i.i4169.i.preheader:                       ; preds = %B634.endif.i3784.i
  %invariant.gep10389 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.791.i3075.08356.i
  %invariant.gep10391 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.791.i3075.08356.i
  br label %B58.if.i.i4169.i

B58.if.i.i4169.i:                                 ; preds = %B58.if.i.i4169.i.preheader, %B58.if.i.i4169.i
  %least.2.i.i2833.08353.i = phi double [ %.11.i.i665.i4165.i, %B58.if.i.i4169.i ], [ 0x7FF0000000000000, %B58.if.i.i4169.i.preheader ]
  %.54.i.i2837.08351.i = phi i64 [ %.125.i675.i4175.i, %B58.if.i.i4169.i ], [ 0, %B58.if.i.i4169.i.preheader ]
  %.125.i675.i4175.i = add nsw i64 %.54.i.i2837.08351.i, 1
  %.156.i572.i4081.i = add nsw i64 %.54.i.i2837.08351.i, %.155.i571.i.i
  %.158.i574.i4083.i = mul nsw i64 %.156.i572.i4081.i, %arg.shape.0
  %.164.i578.i4088.i = add nsw i64 %.54.i.i2837.08351.i, %.580.i1547.i
  %.166.i580.i4090.i = mul nsw i64 %.164.i578.i4088.i, %arg.shape.0
  %gep10390 = getelementptr double, ptr %invariant.gep10389, i64 %.166.i580.i4090.i
  %.198.i608.i4112.i = load double, ptr %gep10390, align 8, !noalias !178
  %gep10392 = getelementptr double, ptr %invariant.gep10391, i64 %.158.i574.i4083.i
  %.228.i630.i4132.i = load double, ptr %gep10392, align 8, !noalias !178
  %.229.i631.i4133.i = fmul double %.198.i608.i4112.i, %.228.i630.i4132.i
  %275 = getelementptr double, ptr %gep10392, i64 %.194.i.i738.i
  %.263.i656.i4157.i = load double, ptr %275, align 8, !noalias !178
  %.264.i657.i4158.i = fadd double %.229.i631.i4133.i, %.263.i656.i4157.i
  %.10.i.i664.i4164.i = fcmp olt double %.264.i657.i4158.i, %least.2.i.i2833.08353.i
  %.11.i.i665.i4165.i = select i1 %.10.i.i664.i4164.i, double %.264.i657.i4158.i, double %least.2.i.i2833.08353.i
  %exitcond8428.not.i = icmp eq i64 %arg.shape.6, %.125.i675.i4175.i
  br i1 %exitcond8428.not.i, label %B634.endif.endif.i3876.i, label %B58.if.i.i4169.i

B634.endif.endif.i3876.i:                         ; preds = %B58.if.i.i4169.i, %B634.endif.i3784.i
  %least.2.i.i2833.0.lcssa.i = phi double [ 0x7FF0000000000000, %B634.endif.i3784.i ], [ %.11.i.i665.i4165.i, %B58.if.i.i4169.i ]
  %.1065.i3879.i = fcmp olt double %least.2.i.i2833.0.lcssa.i, 0.000000e+00
  br i1 %.1065.i3879.i, label %B730.i3974.i, label %B802.i3880.i

B996.i:                                           ; preds = %B326.i3233.i, %B114.i3153.loopexit.i, %B904.endif.endif.i
  br i1 %.815, label %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B1028.if.lr.ph.i

B1028.if.lr.ph.i:                                 ; preds = %B996.i
  %.2105.i = fmul double %.264.i, 2.000000e+00
  br label %B1028.if.i

B1152.i:                                          ; preds = %B1028.if.i
  %.2042.i = getelementptr double, ptr %54, i64 %.1737.08369.i
  %.2043.i = load double, ptr %.2042.i, align 8, !noalias !65
  %.2107.i = fcmp ogt double %.2043.i, %.2105.i
  %.2157.i = getelementptr double, ptr %57, i64 %.1737.08369.i
  %.2158.i = load double, ptr %.2157.i, align 8, !noalias !65
  %.2208.i = getelementptr double, ptr %58, i64 %.1737.08369.i
  %.2209.i = load double, ptr %.2208.i, align 8, !noalias !65
  %.2210.i = fcmp olt double %.2158.i, %.2209.i
  %.2266.i = getelementptr double, ptr %56, i64 %.1737.08369.i
  %.2267.i = load double, ptr %.2266.i, align 8, !noalias !65
  %.2268.i = fcmp ogt double %.2267.i, 1.000000e-01
  br i1 %.2268.i, label %B1440.i, label %B1710.i

B1440.i:                                          ; preds = %B1152.i
  br i1 %.2107.i, label %B1548.i, label %B1662.i

B1548.i:                                          ; preds = %B1440.i
  %.2095.i = load double, ptr %.1884.i, align 8, !noalias !65
  %.2096.i = tail call double @llvm.fabs.f64(double %.2095.i)
  %.2097.i = fmul double %.2096.i, 4.000000e-15
  %.2327.i = fmul double %.2043.i, 0x3D719799812DEA11
  %.10.i.i9852 = fcmp ogt double %.2097.i, %.2327.i
  %.11.i.i9853 = select i1 %.10.i.i9852, double %.2097.i, double %.2327.i
  %.2323.i = fsub double 1.000000e+00, %.2158.i
  %.2325.i = fmul double %.2043.i, %.2323.i
  %.2359.i = fcmp ugt double %.2325.i, %.11.i.i9853
  br i1 %.2359.i, label %B1552.i, label %B1662.i

B1552.i:                                          ; preds = %B1548.i
  %.2424.i = fmul double %.2043.i, %.2209.i
  %.10.i8110.i = fcmp ogt double %.264.i, %.2424.i
  %.11.i8111.i = select i1 %.10.i8110.i, double %.264.i, double %.2424.i
  %.108.i8940.i = getelementptr double, ptr %64, i64 %.1737.08369.i
  store double 0.000000e+00, ptr %.108.i8940.i, align 8, !noalias !182
  %.161.i8986.i = getelementptr double, ptr %.2012, i64 %.1737.08369.i
  store double 0.000000e+00, ptr %.161.i8986.i, align 8, !noalias !182
  %.214.i9031.i = getelementptr double, ptr %65, i64 %.1737.08369.i
  store double %.11.i8111.i, ptr %.214.i9031.i, align 8, !noalias !182
  %.267.i9077.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1737.08369.i
  %.268.i9078.i = load i64, ptr %.267.i9077.i, align 8, !noalias !182
  %.294.i9100.i = icmp slt i64 %.268.i9078.i, 0
  %.295.i9101.i = select i1 %.294.i9100.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i9102.i = add i64 %.295.i9101.i, %.268.i9078.i
  %.316.i9121.i = mul i64 %.296.i9102.i, %arg.batch.3.3.5.1
  %.320.i9125.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i9121.i
  %.321.i9126.i = load i64, ptr %.320.i9125.i, align 8, !noalias !182
  %.322.i9127.i = add nsw i64 %.321.i9126.i, -1
  store i64 %.322.i9127.i, ptr %.320.i9125.i, align 8, !noalias !182
  %.426.i9219.i = load i64, ptr %.267.i9077.i, align 8, !noalias !182
  %.452.i9240.i = icmp slt i64 %.426.i9219.i, 0
  %.453.i9241.i = select i1 %.452.i9240.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i9242.i = add i64 %.453.i9241.i, %.426.i9219.i
  %.474.i9262.i = mul i64 %.454.i9242.i, %arg.batch.3.3.5.1
  %276 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i9262.i
  %.478.i9266.i = getelementptr i8, ptr %276, i64 24
  %.479.i9267.i = load i64, ptr %.478.i9266.i, align 8, !noalias !182
  %.480.i9268.i = add nsw i64 %.479.i9267.i, 1
  store i64 %.480.i9268.i, ptr %.478.i9266.i, align 8, !noalias !182
  br label %B1919.i

B1662.i:                                          ; preds = %B1548.i, %B1440.i
  %.2555.i = getelementptr double, ptr %63, i64 %.1737.08369.i
  store double 1.000000e+00, ptr %.2555.i, align 8, !noalias !65
  br label %B1919.i

B1710.i:                                          ; preds = %B1152.i
  br i1 %.2107.i, label %B1714.i, label %B1814.i

B1714.i:                                          ; preds = %B1710.i
  br i1 %.2210.i, label %B1768.i, label %B1718.i

B1718.i:                                          ; preds = %B1714.i
  %.96.i.i = load double, ptr %.1884.i, align 8, !noalias !185
  %.97.i.i = tail call double @llvm.fabs.f64(double %.96.i.i)
  %.98.i.i = fmul double %.97.i.i, 1.000000e-15
  %.152.i.i = fdiv double %.98.i.i, %.2043.i
  br i1 %.2650, label %B178.i.i, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B178.i.i:                                         ; preds = %B1718.i, %B1225.i.i
  %.229.sroa.0.0454.i.i = phi i64 [ %.229.sroa.0.0.i.i, %B1225.i.i ], [ 0, %B1718.i ]
  %.183.1453.i.i = phi i64 [ %.183.1.i.i, %B1225.i.i ], [ %.183.1450.i.i, %B1718.i ]
  %.180.1452.i.i = phi i64 [ %.180.1.i.i, %B1225.i.i ], [ 1, %B1718.i ]
  %.278.i.i = add nsw i64 %.229.sroa.0.0454.i.i, %arg.shape.6
  %.280.i.i = mul nsw i64 %.278.i.i, %arg.shape.0
  %.282.i.i = add nsw i64 %.280.i.i, %.1737.08369.i
  %.192.i.i.i = add nsw i64 %.282.i.i, %factor.op.mul.i.reass
  %.206.i.i.i = icmp slt i64 %.192.i.i.i, 0
  %.207.i.i.i = select i1 %.206.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %277 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i
  %.221.i.i.i = getelementptr double, ptr %277, i64 %.207.i.i.i
  %.222.i.i.i = load double, ptr %.221.i.i.i, align 8, !noalias !189
  %.472.i.i.i = icmp slt i64 %.282.i.i, 0
  %.473.i.i.i = select i1 %.472.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %278 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.282.i.i
  %.487.i.i.i = getelementptr double, ptr %278, i64 %.473.i.i.i
  %.488.i.i.i = load double, ptr %.487.i.i.i, align 8, !noalias !189
  %.489.i.i.i = fmul double %.488.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i = fsub double %.222.i.i.i, %.489.i.i.i
  %.458.i.1.i.i = add nsw i64 %.282.i.i, %.454.i.i.i
  %.472.i.1.i.i = icmp slt i64 %.458.i.1.i.i, 0
  %.473.i.1.i.i = select i1 %.472.i.1.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %279 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i
  %.487.i.1.i.i = getelementptr double, ptr %279, i64 %.473.i.1.i.i
  %.488.i.1.i.i = load double, ptr %.487.i.1.i.i, align 8, !noalias !189
  %.489.i.1.i.i = fmul double %.488.i.1.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i = fsub double %.491.i.i.i, %.489.i.1.i.i
  %.458.i.2.i.i = add nsw i64 %.282.i.i, %.456.i.2.i.i
  %.472.i.2.i.i = icmp slt i64 %.458.i.2.i.i, 0
  %.473.i.2.i.i = select i1 %.472.i.2.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %280 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i
  %.487.i.2.i.i = getelementptr double, ptr %280, i64 %.473.i.2.i.i
  %.488.i.2.i.i = load double, ptr %.487.i.2.i.i, align 8, !noalias !189
  %.489.i.2.i.i = fmul double %.488.i.2.i.i, 0x3FE1306AA3D795F4
  %281 = fadd double %.491.i.1.i.i, %.489.i.2.i.i
  %.458.i.3.i.i = add nsw i64 %.282.i.i, %.456.i.3.i.i
  %.472.i.3.i.i = icmp slt i64 %.458.i.3.i.i, 0
  %.473.i.3.i.i = select i1 %.472.i.3.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %282 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i
  %.487.i.3.i.i = getelementptr double, ptr %282, i64 %.473.i.3.i.i
  %.488.i.3.i.i = load double, ptr %.487.i.3.i.i, align 8, !noalias !189
  %.489.i.3.i.i = fmul double %.488.i.3.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i = fsub double %281, %.489.i.3.i.i
  %.458.i.4.i.i = add nsw i64 %.282.i.i, %.456.i.4.i.i
  %.472.i.4.i.i = icmp slt i64 %.458.i.4.i.i, 0
  %.473.i.4.i.i = select i1 %.472.i.4.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %283 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i
  %.487.i.4.i.i = getelementptr double, ptr %283, i64 %.473.i.4.i.i
  %.488.i.4.i.i = load double, ptr %.487.i.4.i.i, align 8, !noalias !189
  %.489.i.4.i.i = fmul double %.488.i.4.i.i, 0x3FA4EAF2D6B11E79
  %284 = fadd double %.491.i.3.i.i, %.489.i.4.i.i
  %.502.i.i.i = tail call double @llvm.fabs.f64(double %284)
  %.10.i.i.i8115.i = fcmp ogt double %.502.i.i.i, 0.000000e+00
  %.11.i.i.i8116.i = select i1 %.10.i.i.i8115.i, double %.502.i.i.i, double 0.000000e+00
  %.192.i.1.i.i = add nsw i64 %.282.i.i, %.190.i.1.i.i
  %.206.i.1.i.i = icmp slt i64 %.192.i.1.i.i, 0
  %.207.i.1.i.i = select i1 %.206.i.1.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %285 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i
  %.221.i.1.i.i = getelementptr double, ptr %285, i64 %.207.i.1.i.i
  %.222.i.1.i.i = load double, ptr %.221.i.1.i.i, align 8, !noalias !189
  %.489.i.1492.i.i = fmul double %.488.i.i.i, 0x3FA5118805F8B876
  %286 = fadd double %.489.i.1492.i.i, %.222.i.1.i.i
  %.489.i.1.1.i.i = fmul double %.488.i.1.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i = fsub double %286, %.489.i.1.1.i.i
  %.489.i.2.1.i.i = fmul double %.488.i.2.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i = fsub double %.491.i.1.1.i.i, %.489.i.2.1.i.i
  %.489.i.3.1.i.i = fmul double %.488.i.3.i.i, 0x3FC0DA0C684D1D67
  %287 = fadd double %.489.i.3.1.i.i, %.491.i.2.1.i.i
  %.489.i.4.1.i.i = fmul double %.488.i.4.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i = fsub double %287, %.489.i.4.1.i.i
  %.502.i.1.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i)
  %.10.i.i.1.i.i = fcmp ogt double %.502.i.1.i.i, %.11.i.i.i8116.i
  %.11.i.i.1.i.i = select i1 %.10.i.i.1.i.i, double %.502.i.1.i.i, double %.11.i.i.i8116.i
  %.192.i.2.i.i = add nsw i64 %.282.i.i, %.190.i.2.i.i
  %.206.i.2.i.i = icmp slt i64 %.192.i.2.i.i, 0
  %.207.i.2.i.i = select i1 %.206.i.2.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %288 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i
  %.221.i.2.i.i = getelementptr double, ptr %288, i64 %.207.i.2.i.i
  %.222.i.2.i.i = load double, ptr %.221.i.2.i.i, align 8, !noalias !189
  %.489.i.2519.i.i = fmul double %.488.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2520.i.i = fsub double %.222.i.2.i.i, %.489.i.2519.i.i
  %.489.i.1.2.i.i = fmul double %.488.i.1.i.i, 0x3FC1EAE0FF33D241
  %289 = fadd double %.489.i.1.2.i.i, %.491.i.2520.i.i
  %.489.i.2.2.i.i = fmul double %.488.i.2.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i = fsub double %289, %.489.i.2.2.i.i
  %.489.i.3.2.i.i = fmul double %.488.i.3.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i = fsub double %.491.i.2.2.i.i, %.489.i.3.2.i.i
  %.489.i.4.2.i.i = fmul double %.488.i.4.i.i, 0x3FA55161A739EB34
  %290 = fadd double %.489.i.4.2.i.i, %.491.i.3.2.i.i
  %.502.i.2.i.i = tail call double @llvm.fabs.f64(double %290)
  %.10.i.i.2.i.i = fcmp ogt double %.502.i.2.i.i, %.11.i.i.1.i.i
  %.11.i.i.2.i.i = select i1 %.10.i.i.2.i.i, double %.502.i.2.i.i, double %.11.i.i.1.i.i
  %.192.i.3.i.i = add nsw i64 %.282.i.i, %.190.i.3.i.i
  %.206.i.3.i.i = icmp slt i64 %.192.i.3.i.i, 0
  %.207.i.3.i.i = select i1 %.206.i.3.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %291 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i
  %.221.i.3.i.i = getelementptr double, ptr %291, i64 %.207.i.3.i.i
  %.222.i.3.i.i = load double, ptr %.221.i.3.i.i, align 8, !noalias !189
  %.489.i.3546.i.i = fmul double %.488.i.i.i, 0x3FA4F0C0BB579409
  %292 = fadd double %.489.i.3546.i.i, %.222.i.3.i.i
  %.489.i.1.3.i.i = fmul double %.488.i.1.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i = fsub double %292, %.489.i.1.3.i.i
  %.489.i.2.3.i.i = fmul double %.488.i.2.i.i, 0x3FE1F2DB6FEE3151
  %293 = fadd double %.489.i.2.3.i.i, %.491.i.1.3.i.i
  %.489.i.3.3.i.i = fmul double %.488.i.3.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i = fsub double %293, %.489.i.3.3.i.i
  %.489.i.4.3.i.i = fmul double %.488.i.4.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i = fsub double %.491.i.3.3.i.i, %.489.i.4.3.i.i
  %.502.i.3.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i)
  %.10.i.i.3.i.i = fcmp ogt double %.502.i.3.i.i, %.11.i.i.2.i.i
  %.11.i.i.3.i.i = select i1 %.10.i.i.3.i.i, double %.502.i.3.i.i, double %.11.i.i.2.i.i
  %.321.i.i9843 = add nsw i64 %.229.sroa.0.0454.i.i, %.320.i.i9840
  %.323.i.i = mul nsw i64 %.321.i.i9843, %arg.shape.0
  %.325.i.i = add nsw i64 %.323.i.i, %.1737.08369.i
  %294 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.325.i.i
  %.339.i.i9844 = icmp slt i64 %.325.i.i, 0
  %.340.i.i9845 = select i1 %.339.i.i9844, i64 %arg.batch.5.4.5.0, i64 0
  %.354.i8117.i = getelementptr double, ptr %294, i64 %.340.i.i9845
  %.355.i8118.i = load double, ptr %.354.i8117.i, align 8, !noalias !185
  %.548.i.i = fsub double %.222.i.i.i, %.488.i.i.i
  %.549.i.i = tail call double @llvm.fabs.f64(double %.548.i.i)
  %.551.i.i9846 = fmul double %.152.i.i, %.549.i.i
  %.553.i.i = fadd double %.551.i.i9846, %.355.i8118.i
  %.548.1.i.i = fsub double %.488.i.1.i.i, %.222.i.i.i
  %.549.1.i.i = tail call double @llvm.fabs.f64(double %.548.1.i.i)
  %.551.1.i.i = fmul double %.152.i.i, %.549.1.i.i
  %.553.1.i.i = fadd double %.551.1.i.i, %.553.i.i
  %.548.2.i.i = fsub double %.222.i.1.i.i, %.488.i.1.i.i
  %.549.2.i.i = tail call double @llvm.fabs.f64(double %.548.2.i.i)
  %.551.2.i.i = fmul double %.152.i.i, %.549.2.i.i
  %.553.2.i.i = fadd double %.551.2.i.i, %.553.1.i.i
  %.548.3.i.i = fsub double %.488.i.2.i.i, %.222.i.1.i.i
  %.549.3.i.i = tail call double @llvm.fabs.f64(double %.548.3.i.i)
  %.551.3.i.i = fmul double %.152.i.i, %.549.3.i.i
  %.553.3.i.i = fadd double %.551.3.i.i, %.553.2.i.i
  %.548.4.i.i = fsub double %.222.i.2.i.i, %.488.i.2.i.i
  %.549.4.i.i = tail call double @llvm.fabs.f64(double %.548.4.i.i)
  %.551.4.i.i = fmul double %.152.i.i, %.549.4.i.i
  %.553.4.i.i = fadd double %.551.4.i.i, %.553.3.i.i
  %.548.5.i.i = fsub double %.488.i.3.i.i, %.222.i.2.i.i
  %.549.5.i.i = tail call double @llvm.fabs.f64(double %.548.5.i.i)
  %.551.5.i.i = fmul double %.152.i.i, %.549.5.i.i
  %.553.5.i.i = fadd double %.551.5.i.i, %.553.4.i.i
  %.548.6.i.i = fsub double %.222.i.3.i.i, %.488.i.3.i.i
  %.549.6.i.i = tail call double @llvm.fabs.f64(double %.548.6.i.i)
  %.551.6.i.i = fmul double %.152.i.i, %.549.6.i.i
  %.553.6.i.i = fadd double %.551.6.i.i, %.553.5.i.i
  %.548.7.i.i = fsub double %.488.i.4.i.i, %.222.i.3.i.i
  %.549.7.i.i = tail call double @llvm.fabs.f64(double %.548.7.i.i)
  %.551.7.i.i = fmul double %.152.i.i, %.549.7.i.i
  %.553.7.i.i = fadd double %.551.7.i.i, %.553.6.i.i
  %.563.i.i = fcmp ugt double %.11.i.i.3.i.i, %.553.7.i.i
  br i1 %.563.i.i, label %B538.preheader.i.i, label %B1225.i.i

B538.preheader.i.i:                               ; preds = %B178.i.i
  %.958.i.i9847 = fmul double %.11.i.i.3.i.i, 1.000000e+01
  br label %B542.i.i

B542.i.i:                                         ; preds = %B1226.i.i, %B538.preheader.i.i
  %.680.sroa.0.0446.i.i = phi i64 [ 1, %B538.preheader.i.i ], [ %.680.sroa.0.0.i.i, %B1226.i.i ]
  %.636.1445.i.i = phi i64 [ 6, %B538.preheader.i.i ], [ %.636.1.i.i, %B1226.i.i ]
  %.633.1444.i.i = phi i64 [ 2, %B538.preheader.i.i ], [ %.633.1.i.i, %B1226.i.i ]
  %nearest.3.2443.i.i = phi double [ 0x7FF0000000000000, %B538.preheader.i.i ], [ %nearest.4.3.i.i, %B1226.i.i ]
  %.732.i.i = add nsw i64 %.680.sroa.0.0446.i.i, -1
  %.734.i.i = mul nsw i64 %.732.i.i, %factor.op.mul.i.reass
  %.736.i.i = add nsw i64 %.734.i.i, %.282.i.i
  %.750.i.i = icmp slt i64 %.736.i.i, 0
  %.751.i.i = select i1 %.750.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %295 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.736.i.i
  %.765.i.i = getelementptr double, ptr %295, i64 %.751.i.i
  %.766.i.i = load double, ptr %.765.i.i, align 8, !noalias !185
  %.769.i.i = mul nsw i64 %.680.sroa.0.0446.i.i, %factor.op.mul.i.reass
  %.771.i.i = add nsw i64 %.769.i.i, %.282.i.i
  %.785.i.i = icmp slt i64 %.771.i.i, 0
  %.786.i.i = select i1 %.785.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %296 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.771.i.i
  %.800.i8119.i = getelementptr double, ptr %296, i64 %.786.i.i
  %.801.i.i = load double, ptr %.800.i8119.i, align 8, !noalias !185
  %.803.i.i = add nsw i64 %.680.sroa.0.0446.i.i, 1
  %.805.i.i = mul nsw i64 %.803.i.i, %factor.op.mul.i.reass
  %.807.i.i = add nsw i64 %.805.i.i, %.282.i.i
  %.821.i.i = icmp slt i64 %.807.i.i, 0
  %.822.i.i = select i1 %.821.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %297 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.807.i.i
  %.836.i.i = getelementptr double, ptr %297, i64 %.822.i.i
  %.837.i.i = load double, ptr %.836.i.i, align 8, !noalias !185
  %.860.i8120.i = fcmp olt double %.801.i.i, 0.000000e+00
  %.863.i.i = fneg double %.766.i.i
  %.867.i.i = fneg double %.801.i.i
  %.871.i.i = fneg double %.837.i.i
  %c.2.3.i.i = select i1 %.860.i8120.i, double %.871.i.i, double %.837.i.i
  %b.2.3.i.i = select i1 %.860.i8120.i, double %.867.i.i, double %.801.i.i
  %a.2.3.i.i = select i1 %.860.i8120.i, double %.863.i.i, double %.766.i.i
  %.888.i.i = icmp eq i64 %.680.sroa.0.0446.i.i, 1
  %.895.i.i = fcmp ogt double %a.2.3.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.888.i.i, i1 true, i1 %.895.i.i
  br i1 %or.cond.i.i, label %B694.i.i, label %B750.i.i9848

B694.i.i:                                         ; preds = %B542.i.i
  %.901.i.i = icmp eq i64 %.680.sroa.0.0446.i.i, 8
  %.907.i.i = fcmp ogt double %c.2.3.i.i, 0.000000e+00
  %or.cond410.i.i = select i1 %.901.i.i, i1 true, i1 %.907.i.i
  br i1 %or.cond410.i.i, label %B718.i.i, label %B750.i.i9848

B718.i.i:                                         ; preds = %B694.i.i
  %.10.i.i8147.i = fcmp olt double %b.2.3.i.i, %nearest.3.2443.i.i
  %.11.i.i8148.i = select i1 %.10.i.i8147.i, double %b.2.3.i.i, double %nearest.3.2443.i.i
  br label %B750.i.i9848

B750.i.i9848:                                     ; preds = %B718.i.i, %B694.i.i, %B542.i.i
  %nearest.5.4.i.i = phi double [ %.11.i.i8148.i, %B718.i.i ], [ %nearest.3.2443.i.i, %B694.i.i ], [ %nearest.3.2443.i.i, %B542.i.i ]
  %.952.i.i = icmp slt i64 %.680.sroa.0.0446.i.i, 8
  br i1 %.952.i.i, label %B762.i.i, label %B1226.i.i

B762.i.i:                                         ; preds = %B750.i.i9848
  %.961.i.i = fsub double %a.2.3.i.i, %b.2.3.i.i
  %.962.i.i = tail call double @llvm.fabs.f64(double %.961.i.i)
  %.965.i.i = fsub double %c.2.3.i.i, %b.2.3.i.i
  %.966.i.i = tail call double @llvm.fabs.f64(double %.965.i.i)
  %.967.i.i = fadd double %.962.i.i, %.966.i.i
  %.968.i.i = fmul double %.967.i.i, 3.000000e+00
  %.969.i.i = fadd double %.958.i.i9847, %.968.i.i
  %.971.i.i = fcmp olt double %b.2.3.i.i, %.969.i.i
  br i1 %.971.i.i, label %B872.i.i, label %B1226.i.i

B872.i.i:                                         ; preds = %B762.i.i
  %switch.tableidx = add i64 %.680.sroa.0.0446.i.i, 9
  %298 = icmp ult i64 %switch.tableidx, 18
  br i1 %298, label %switch.lookup10526, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B1078.i.i:                                        ; preds = %switch.lookup10538
  %.1180.i.i = fneg double %.1121.i.i
  %.1184.i.i = fmul double %.1170.i.i, 5.000000e-01
  %.1189.i.i9850 = fdiv double %.1184.i.i, %.1153.i.i
  %.1190.i.i9851 = fcmp ogt double %.1189.i.i9850, %.1180.i.i
  %.1200.i8125.i = fcmp olt double %.1189.i.i9850, %.1047.i.i
  %or.cond411.i.i = and i1 %.1190.i.i9851, %.1200.i8125.i
  br i1 %or.cond411.i.i, label %B1118.i.i, label %B1226.i.i

B1118.i.i:                                        ; preds = %B1078.i.i
  %.1227.i.i = fmul double %.1170.i.i, 2.500000e-01
  %.1229.i.i = fmul double %.1170.i.i, %.1227.i.i
  %.1236.i.i = fdiv double %.1229.i.i, %.1153.i.i
  %.1240.i.i = fsub double %b.2.3.i.i, %.1236.i.i
  %.10.i412.i.i = fcmp olt double %.1240.i.i, %nearest.5.4.i.i
  %.11.i413.i.i = select i1 %.10.i412.i.i, double %.1240.i.i, double %nearest.5.4.i.i
  br label %B1226.i.i

B1186.i.i:                                        ; preds = %B1226.i.i
  %.1312.i.i = fcmp ugt double %nearest.4.3.i.i, %.958.i.i9847
  br i1 %.1312.i.i, label %B1225.i.i, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B1225.i.i:                                        ; preds = %B1186.i.i, %B178.i.i
  %.239.i.i = icmp sgt i64 %.183.1453.i.i, 0
  %.252.i.i = zext i1 %.239.i.i to i64
  %.180.1.i.i = add i64 %.180.1452.i.i, %.252.i.i
  %.248.i.i = sext i1 %.239.i.i to i64
  %.183.1.i.i = add nsw i64 %.183.1453.i.i, %.248.i.i
  %.229.sroa.0.0.i.i = select i1 %.239.i.i, i64 %.180.1452.i.i, i64 0
  br i1 %.239.i.i, label %B178.i.i, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B1226.i.i:                                        ; preds = %switch.lookup10538, %B1118.i.i, %B1078.i.i, %B762.i.i, %B750.i.i9848
  %nearest.4.3.i.i = phi double [ %nearest.5.4.i.i, %B1078.i.i ], [ %.11.i413.i.i, %B1118.i.i ], [ %nearest.5.4.i.i, %B750.i.i9848 ], [ %nearest.5.4.i.i, %switch.lookup10538 ], [ %nearest.5.4.i.i, %B762.i.i ]
  %.690.i.i = icmp ne i64 %.636.1445.i.i, 0
  %.703.i.i = zext i1 %.690.i.i to i64
  %.633.1.i.i = add i64 %.633.1444.i.i, %.703.i.i
  %.699.i.i = sext i1 %.690.i.i to i64
  %.636.1.i.i = add nsw i64 %.636.1445.i.i, %.699.i.i
  %.680.sroa.0.0.i.i = select i1 %.690.i.i, i64 %.633.1444.i.i, i64 0
  br i1 %.690.i.i, label %B542.i.i, label %B1186.i.i

switch.lookup10526:                               ; preds = %B872.i.i
  %switch.tableidx10529 = add i64 %.680.sroa.0.0446.i.i, 8
  %299 = icmp ult i64 %switch.tableidx10529, 18
  br i1 %299, label %switch.lookup10530, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup10530:                               ; preds = %switch.lookup10526
  %switch.gep10527 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx
  %switch.load10528 = load double, ptr %switch.gep10527, align 8
  %switch.gep10531 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10529
  %switch.load10532 = load double, ptr %switch.gep10531, align 8
  %.1047.i.i = fsub double %switch.load10528, %switch.load10532
  %switch.tableidx10533 = add i64 %.680.sroa.0.0446.i.i, 10
  %300 = icmp ult i64 %switch.tableidx10533, 18
  br i1 %300, label %switch.lookup10534, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup10534:                               ; preds = %switch.lookup10530
  %switch.tableidx10537 = add i64 %.680.sroa.0.0446.i.i, 9
  %301 = icmp ult i64 %switch.tableidx10537, 18
  br i1 %301, label %switch.lookup10538, label %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup10538:                               ; preds = %switch.lookup10534
  %switch.gep10535 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10533
  %switch.load10536 = load double, ptr %switch.gep10535, align 8
  %switch.gep10539 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10537
  %switch.load10540 = load double, ptr %switch.gep10539, align 8
  %.1121.i.i = fsub double %switch.load10536, %switch.load10540
  %.1137.i.i = fdiv double %.965.i.i, %.1121.i.i
  %.1140.i.i = fsub double %b.2.3.i.i, %a.2.3.i.i
  %.1145.i.i = fdiv double %.1140.i.i, %.1047.i.i
  %.1146.i.i = fsub double %.1137.i.i, %.1145.i.i
  %.1149.i.i = fadd double %.1047.i.i, %.1121.i.i
  %.1153.i.i = fdiv double %.1146.i.i, %.1149.i.i
  %.1169.i.i = fmul double %.1047.i.i, %.1153.i.i
  %.1170.i.i = fadd double %.1145.i.i, %.1169.i.i
  %.1175.i.i = fcmp ogt double %.1153.i.i, 0.000000e+00
  br i1 %.1175.i.i, label %B1078.i.i, label %B1226.i.i

_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1225.i.i, %B1186.i.i, %B872.i.i, %switch.lookup10526, %switch.lookup10530, %switch.lookup10534, %B1718.i
  %.2597.not.i = phi i1 [ true, %B1718.i ], [ true, %B872.i.i ], [ true, %switch.lookup10534 ], [ true, %switch.lookup10530 ], [ true, %switch.lookup10526 ], [ true, %B1225.i.i ], [ false, %B1186.i.i ]
  %excinfo.12.4.i = phi ptr [ %excinfo.12.08373.i, %B1718.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %B872.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup10534 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup10530 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup10526 ], [ %excinfo.12.08373.i, %B1186.i.i ], [ %excinfo.12.08373.i, %B1225.i.i ]
  %.2586.not.i = phi i1 [ true, %B1718.i ], [ false, %B872.i.i ], [ false, %switch.lookup10534 ], [ false, %switch.lookup10530 ], [ false, %switch.lookup10526 ], [ true, %B1186.i.i ], [ true, %B1225.i.i ]
  %common.ret.op.i8114.i = phi i32 [ 0, %B1718.i ], [ 1, %B872.i.i ], [ 1, %switch.lookup10534 ], [ 1, %switch.lookup10530 ], [ 1, %switch.lookup10526 ], [ 0, %B1186.i.i ], [ 0, %B1225.i.i ]
  br i1 %.2586.not.i, label %B1718.endif.endif.i, label %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, !prof !57

B1768.i:                                          ; preds = %B1718.endif.endif.i, %B1714.i
  %excinfo.12.3.i = phi ptr [ %excinfo.12.08373.i, %B1714.i ], [ %excinfo.12.4.i, %B1718.endif.endif.i ]
  %.2616.i = fmul double %.2043.i, 5.000000e-01
  %.108.i8475.i = getelementptr double, ptr %64, i64 %.1737.08369.i
  store double 0.000000e+00, ptr %.108.i8475.i, align 8, !noalias !193
  %.161.i8517.i = getelementptr double, ptr %.2012, i64 %.1737.08369.i
  store double 0.000000e+00, ptr %.161.i8517.i, align 8, !noalias !193
  %.214.i8561.i = getelementptr double, ptr %65, i64 %.1737.08369.i
  store double %.2616.i, ptr %.214.i8561.i, align 8, !noalias !193
  %.267.i8607.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1737.08369.i
  %.268.i8608.i = load i64, ptr %.267.i8607.i, align 8, !noalias !193
  %.294.i8629.i = icmp slt i64 %.268.i8608.i, 0
  %.295.i.i9842 = select i1 %.294.i8629.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i8630.i = add i64 %.295.i.i9842, %.268.i8608.i
  %.316.i8649.i = mul i64 %.296.i8630.i, %arg.batch.3.3.5.1
  %.320.i8653.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i8649.i
  %.321.i8654.i = load i64, ptr %.320.i8653.i, align 8, !noalias !193
  %.322.i8655.i = add nsw i64 %.321.i8654.i, -1
  store i64 %.322.i8655.i, ptr %.320.i8653.i, align 8, !noalias !193
  %.426.i8743.i = load i64, ptr %.267.i8607.i, align 8, !noalias !193
  %.452.i8764.i = icmp slt i64 %.426.i8743.i, 0
  %.453.i8765.i = select i1 %.452.i8764.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i8766.i = add i64 %.453.i8765.i, %.426.i8743.i
  %.474.i8786.i = mul i64 %.454.i8766.i, %arg.batch.3.3.5.1
  %302 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i8786.i
  %.478.i8790.i = getelementptr i8, ptr %302, i64 24
  %.479.i8791.i = load i64, ptr %.478.i8790.i, align 8, !noalias !193
  %.480.i8792.i = add nsw i64 %.479.i8791.i, 1
  store i64 %.480.i8792.i, ptr %.478.i8790.i, align 8, !noalias !193
  br label %B1919.i

B1814.i:                                          ; preds = %B1718.endif.endif.i, %B1710.i
  %excinfo.12.2.i = phi ptr [ %excinfo.12.4.i, %B1718.endif.endif.i ], [ %excinfo.12.08373.i, %B1710.i ]
  br label %B34.i.i

B34.i.i:                                          ; preds = %B34.if.i.i9841, %B1814.i
  %.51.i9329.0.i = phi i64 [ 0, %B1814.i ], [ %.122.i9474.i, %B34.if.i.i9841 ]
  %exitcond8430.not.i = icmp eq i64 %.51.i9329.0.i, %storemerge8004.i
  br i1 %exitcond8430.not.i, label %B1919.i, label %B34.if.i.i9841

B128.i.i:                                         ; preds = %B34.if.i.i9841
  %303 = icmp sgt i64 %.51.i9329.0.i, -1
  br i1 %303, label %B1870.i, label %B1919.i

B34.if.i.i9841:                                   ; preds = %B34.i.i
  %.122.i9474.i = add i64 %.51.i9329.0.i, 1
  %.157.i9396.i = add nsw i64 %.51.i9329.0.i, %.155.i9394.i
  %.159.i9398.i = mul nsw i64 %.157.i9396.i, %arg.shape.0
  %.161.i9400.i = add nsw i64 %.159.i9398.i, %.1737.08369.i
  %.175.i9410.i = icmp slt i64 %.161.i9400.i, 0
  %.176.i9411.i = select i1 %.175.i9410.i, i64 %arg.batch.5.4.5.0, i64 0
  %304 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i9400.i
  %.190.i9425.i = getelementptr double, ptr %304, i64 %.176.i9411.i
  %.191.i9426.i = load double, ptr %.190.i9425.i, align 8, !noalias !196
  %.195.i9430.i = add nsw i64 %.161.i9400.i, %.194.i.i738.i
  %.209.i9440.i = icmp slt i64 %.195.i9430.i, 0
  %.210.i9441.i = select i1 %.209.i9440.i, i64 %arg.batch.5.4.5.0, i64 0
  %305 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i9430.i
  %.224.i9454.i = getelementptr double, ptr %305, i64 %.210.i9441.i
  %.225.i9455.i = load double, ptr %.224.i9454.i, align 8, !noalias !196
  %.226.i9456.i = fneg double %.225.i9455.i
  %.227.i9457.i = fcmp olt double %.191.i9426.i, %.226.i9456.i
  br i1 %.227.i9457.i, label %B128.i.i, label %B34.i.i

B1870.i:                                          ; preds = %B128.i.i
  %.2751.i = getelementptr double, ptr %63, i64 %.1737.08369.i
  store double 1.000000e+00, ptr %.2751.i, align 8, !noalias !65
  br label %B1919.i

B1919.i:                                          ; preds = %B34.i.i, %B1028.if.i, %B1870.i, %B128.i.i, %B1768.i, %B1662.i, %B1552.i
  %excinfo.12.1.i = phi ptr [ %excinfo.12.08373.i, %B1028.if.i ], [ %excinfo.12.08373.i, %B1552.i ], [ %excinfo.12.08373.i, %B1662.i ], [ %excinfo.12.3.i, %B1768.i ], [ %excinfo.12.2.i, %B1870.i ], [ %excinfo.12.2.i, %B128.i.i ], [ %excinfo.12.2.i, %B34.i.i ]
  %exitcond8431.not.i = icmp eq i64 %arg.shape.0, %.1807.i
  br i1 %exitcond8431.not.i, label %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B1028.if.i

B296.if.i9834:                                    ; preds = %B296.if.i9834.preheader, %B296.loopexit.i
  %.622.08188.i = phi i64 [ %.691.i9835, %B296.loopexit.i ], [ 0, %B296.if.i9834.preheader ]
  %.691.i9835 = add nsw i64 %.622.08188.i, 1
  br i1 %216, label %switch.lookup10542, label %switch.end.i

switch.lookup10542:                               ; preds = %B296.if.i9834
  %switch.load10544 = load double, ptr %switch.gep10543, align 8
  br label %switch.end.i

switch.end.i:                                     ; preds = %B296.if.i9834, %switch.lookup10542
  %.733.i = phi double [ %switch.load10544, %switch.lookup10542 ], [ 1.000000e+00, %B296.if.i9834 ]
  %.92.i107.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.622.08188.i
  %.93.i108.i = load double, ptr %.92.i107.i, align 8, !noalias !200
  %.146.i144.i = getelementptr double, ptr %54, i64 %.622.08188.i
  %.147.i145.i = load double, ptr %.146.i144.i, align 8, !noalias !200
  %.149.i147.i = fmul double %.733.i, %.147.i145.i
  %.150.i148.i = fadd double %.93.i108.i, %.149.i147.i
  %.203.i184.i = getelementptr double, ptr %.577, i64 %.622.08188.i
  store double %.150.i148.i, ptr %.203.i184.i, align 8, !noalias !200
  br i1 %.287.i2218184.not.i, label %B296.loopexit.i, label %B122.if.i467.lr.ph.i

B122.if.i467.lr.ph.i:                             ; preds = %switch.end.i
  %.247.i.i437.i = fsub double 1.000000e+00, %.733.i
  %invariant.gep10313 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10315 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10317 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10319 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10321 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10323 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10325 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10327 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  %invariant.gep10329 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.622.08188.i
  br label %B122.if.i467.i

B122.if.i467.i:                                   ; preds = %B122.if.i467.i, %B122.if.i467.lr.ph.i
  %.229.i60.08185.i = phi i64 [ 0, %B122.if.i467.lr.ph.i ], [ %.300.i473.i, %B122.if.i467.i ]
  %.157.i.i394.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.i
  %.159.i.i396.i = mul nsw i64 %.157.i.i394.i, %arg.shape.0
  %gep10314 = getelementptr double, ptr %invariant.gep10313, i64 %.159.i.i396.i
  %.191.i.i418.i = load double, ptr %gep10314, align 8, !noalias !204
  %.193.i.i420.i = fadd double %.191.i.i418.i, 0.000000e+00
  %.253.i.i442.i = fmul double %.733.i, %.193.i.i420.i
  %.157.i.i394.1.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.1.i
  %.159.i.i396.1.i = mul nsw i64 %.157.i.i394.1.i, %arg.shape.0
  %gep10316 = getelementptr double, ptr %invariant.gep10315, i64 %.159.i.i396.1.i
  %.191.i.i418.1.i = load double, ptr %gep10316, align 8, !noalias !204
  %.193.i.i420.1.i = fadd double %.191.i.i418.1.i, %.253.i.i442.i
  %.253.i.i442.1.i = fmul double %.247.i.i437.i, %.193.i.i420.1.i
  %.157.i.i394.2.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.2.i
  %.159.i.i396.2.i = mul nsw i64 %.157.i.i394.2.i, %arg.shape.0
  %gep10318 = getelementptr double, ptr %invariant.gep10317, i64 %.159.i.i396.2.i
  %.191.i.i418.2.i = load double, ptr %gep10318, align 8, !noalias !204
  %.193.i.i420.2.i = fadd double %.191.i.i418.2.i, %.253.i.i442.1.i
  %.253.i.i442.2.i = fmul double %.733.i, %.193.i.i420.2.i
  %.157.i.i394.3.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.3.i
  %.159.i.i396.3.i = mul nsw i64 %.157.i.i394.3.i, %arg.shape.0
  %gep10320 = getelementptr double, ptr %invariant.gep10319, i64 %.159.i.i396.3.i
  %.191.i.i418.3.i = load double, ptr %gep10320, align 8, !noalias !204
  %.193.i.i420.3.i = fadd double %.191.i.i418.3.i, %.253.i.i442.2.i
  %.253.i.i442.3.i = fmul double %.247.i.i437.i, %.193.i.i420.3.i
  %.157.i.i394.4.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.4.i
  %.159.i.i396.4.i = mul nsw i64 %.157.i.i394.4.i, %arg.shape.0
  %gep10322 = getelementptr double, ptr %invariant.gep10321, i64 %.159.i.i396.4.i
  %.191.i.i418.4.i = load double, ptr %gep10322, align 8, !noalias !204
  %.193.i.i420.4.i = fadd double %.191.i.i418.4.i, %.253.i.i442.3.i
  %.253.i.i442.4.i = fmul double %.733.i, %.193.i.i420.4.i
  %.157.i.i394.5.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.5.i
  %.159.i.i396.5.i = mul nsw i64 %.157.i.i394.5.i, %arg.shape.0
  %gep10324 = getelementptr double, ptr %invariant.gep10323, i64 %.159.i.i396.5.i
  %.191.i.i418.5.i = load double, ptr %gep10324, align 8, !noalias !204
  %.193.i.i420.5.i = fadd double %.191.i.i418.5.i, %.253.i.i442.4.i
  %.253.i.i442.5.i = fmul double %.247.i.i437.i, %.193.i.i420.5.i
  %.157.i.i394.6.i = add nsw i64 %.229.i60.08185.i, %.155.i.i392.6.i
  %.159.i.i396.6.i = mul nsw i64 %.157.i.i394.6.i, %arg.shape.0
  %gep10326 = getelementptr double, ptr %invariant.gep10325, i64 %.159.i.i396.6.i
  %.191.i.i418.6.i = load double, ptr %gep10326, align 8, !noalias !204
  %.193.i.i420.6.i = fadd double %.191.i.i418.6.i, %.253.i.i442.5.i
  %.253.i.i442.6.i = fmul double %.733.i, %.193.i.i420.6.i
  %.300.i473.i = add nsw i64 %.229.i60.08185.i, 1
  %.271.i.i315.i = mul nsw i64 %.229.i60.08185.i, %arg.shape.0
  %gep10328 = getelementptr double, ptr %invariant.gep10327, i64 %.271.i.i315.i
  %.309.i.i340.i = load double, ptr %gep10328, align 8, !noalias !204
  %.313.i.i343.i = fadd double %.309.i.i340.i, %.253.i.i442.6.i
  %.359.i356.i = add nsw i64 %.229.i60.08185.i, %.358.i355.i
  %.361.i358.i = mul nsw i64 %.359.i356.i, %arg.shape.0
  %gep10330 = getelementptr double, ptr %invariant.gep10329, i64 %.361.i358.i
  store double %.313.i.i343.i, ptr %gep10330, align 8, !noalias !200
  %exitcond8397.not.i = icmp eq i64 %arg.shape.1, %.300.i473.i
  br i1 %exitcond8397.not.i, label %B296.loopexit.i, label %B122.if.i467.i

B364.endif.i:                                     ; preds = %B1136.i.loopexit.i, %B296.preheader.i, %B392.i.i
  %.557.i = icmp ne i64 %.504.18213.i, 0
  %.566.i = sext i1 %.557.i to i64
  %.504.1.i = add nsw i64 %.504.18213.i, %.566.i
  br i1 %.557.i, label %B296.preheader.i, label %B448.i

B492.endif.endif.i:                               ; preds = %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.1004.0.i, label %B904.i, label %B154.i.preheader.i.preheader

B154.i.preheader.i.preheader:                     ; preds = %B492.endif.endif.i
  br i1 %.815, label %B678.endif.i.critedge, label %B154.i.preheader.i

B596.if.i:                                        ; preds = %B596.if.i.preheader, %B596.loopexit.i
  %.1162.08276.i = phi i64 [ %.1231.i, %B596.loopexit.i ], [ 0, %B596.if.i.preheader ]
  %.1231.i = add nsw i64 %.1162.08276.i, 1
  %306 = getelementptr double, ptr %58, i64 %.1162.08276.i
  %.1306.i = load double, ptr %306, align 8, !noalias !65
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1162.08276.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !129
  %.146.i.i = getelementptr double, ptr %54, i64 %.1162.08276.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !129
  %.149.i.i = fmul double %.1306.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.577, i64 %.1162.08276.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !129
  br i1 %.287.i2218184.not.i, label %B596.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B596.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %.1306.i
  %invariant.gep10353 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10355 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10357 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10359 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10361 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10363 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10365 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10367 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  %invariant.gep10369 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1162.08276.i
  br label %B122.if.i.i

B678.endif.i.critedge:                            ; preds = %B154.i.preheader.i.preheader
  %.1380.i.c = load i64, ptr %.648.i1956.i, align 8, !noalias !65
  %.1496.i.c = inttoptr i64 %.1380.i.c to ptr
  tail call void %.1496.i.c(ptr %.577, ptr %.1470.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1495.i), !noalias !65
  br label %B678.endif.i

B678.endif.i:                                     ; preds = %B1136.i6151.loopexit.i, %B678.endif.i.critedge, %B392.i5517.i
  %.945.i = icmp ne i64 %.892.18311.i, 0
  %.954.i9839 = sext i1 %.945.i to i64
  %.892.1.i = add nsw i64 %.892.18311.i, %.954.i9839
  br i1 %.945.i, label %B448.i, label %B904.i

B904.endif.endif.i:                               ; preds = %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.1586.0.i, label %B996.i, label %B154.i3220.preheader.i.preheader

B154.i3220.preheader.i.preheader:                 ; preds = %B904.endif.endif.i
  br i1 %.815, label %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B154.i3220.preheader.i

B1028.if.i:                                       ; preds = %B1919.i, %B1028.if.lr.ph.i
  %excinfo.12.08373.i = phi ptr [ null, %B1028.if.lr.ph.i ], [ %excinfo.12.1.i, %B1919.i ]
  %.1737.08369.i = phi i64 [ 0, %B1028.if.lr.ph.i ], [ %.1807.i, %B1919.i ]
  %.1807.i = add nsw i64 %.1737.08369.i, 1
  %.1884.i = getelementptr double, ptr %62, i64 %.1737.08369.i
  %.1885.i = load double, ptr %.1884.i, align 8, !noalias !65
  %.1935.i = getelementptr double, ptr %.577, i64 %.1737.08369.i
  store double %.1885.i, ptr %.1935.i, align 8, !noalias !65
  %.1986.i = getelementptr i64, ptr %55, i64 %.1737.08369.i
  %.1987.i = load i64, ptr %.1986.i, align 8, !noalias !65
  %.1988.i = icmp slt i64 %.1987.i, 0
  br i1 %.1988.i, label %B1919.i, label %B1152.i

B1718.endif.endif.i:                              ; preds = %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.2597.not.i, label %B1814.i, label %B1768.i

_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1919.i, %B154.i3220.preheader.i.preheader, %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B996.i
  %excinfo.13.3 = phi ptr [ %excinfo.13.0, %B996.i ], [ %excinfo.13.0, %B1919.i ], [ %excinfo.7.6.i, %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %excinfo.13.0, %B154.i3220.preheader.i.preheader ], [ %excinfo.12.4.i, %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.19, %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %common.ret.op.i = phi i32 [ 0, %B996.i ], [ 0, %B1919.i ], [ %.16118378.i, %_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B154.i3220.preheader.i.preheader ], [ %common.ret.op.i8114.i, %_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.10291638.i, %_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.4956.not = icmp eq i32 %common.ret.op.i, 0
  br i1 %.4956.not, label %B3892, label %B3850.if, !prof !57

B3892:                                            ; preds = %B3778, %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3782.endif.endif
  %excinfo.13.2 = phi ptr [ %excinfo.13.3, %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.13.0, %B3782.endif.endif ], [ %excinfo.13.0, %B3778 ]
  br i1 %.4976.not, label %B3936, label %B3896

B3896:                                            ; preds = %B3892
  br i1 %.815, label %B116.loopexit.8.i, label %B150.if.i

B150.if.1.i:                                      ; preds = %B150.if.i, %B150.if.1.i
  %.363.0606.1.i = phi i64 [ %.432.1.i, %B150.if.1.i ], [ 0, %B150.if.i ]
  %.432.1.i = add nsw i64 %.363.0606.1.i, 1
  %gep10396 = getelementptr double, ptr %invariant.gep10395, i64 %.363.0606.1.i
  store double 1.000000e-09, ptr %gep10396, align 8, !noalias !208
  %exitcond.1.not.i = icmp eq i64 %arg.shape.0, %.432.1.i
  br i1 %exitcond.1.not.i, label %B150.if.2.i, label %B150.if.1.i

B150.if.2.i:                                      ; preds = %B150.if.1.i, %B150.if.2.i
  %.363.0606.2.i = phi i64 [ %.432.2.i, %B150.if.2.i ], [ 0, %B150.if.1.i ]
  %.432.2.i = add nsw i64 %.363.0606.2.i, 1
  %gep10398 = getelementptr double, ptr %invariant.gep10397, i64 %.363.0606.2.i
  store double 1.000000e-09, ptr %gep10398, align 8, !noalias !208
  %exitcond.2.not.i = icmp eq i64 %arg.shape.0, %.432.2.i
  br i1 %exitcond.2.not.i, label %B150.if.3.i, label %B150.if.2.i

B150.if.3.i:                                      ; preds = %B150.if.2.i, %B150.if.3.i
  %.363.0606.3.i = phi i64 [ %.432.3.i, %B150.if.3.i ], [ 0, %B150.if.2.i ]
  %.432.3.i = add nsw i64 %.363.0606.3.i, 1
  %gep10400 = getelementptr double, ptr %invariant.gep10399, i64 %.363.0606.3.i
  store double 1.000000e-09, ptr %gep10400, align 8, !noalias !208
  %exitcond.3.not.i = icmp eq i64 %arg.shape.0, %.432.3.i
  br i1 %exitcond.3.not.i, label %B150.if.4.i, label %B150.if.3.i

B150.if.4.i:                                      ; preds = %B150.if.3.i, %B150.if.4.i
  %.363.0606.4.i = phi i64 [ %.432.4.i, %B150.if.4.i ], [ 0, %B150.if.3.i ]
  %.432.4.i = add nsw i64 %.363.0606.4.i, 1
  %gep10402 = getelementptr double, ptr %invariant.gep10401, i64 %.363.0606.4.i
  store double 1.000000e-09, ptr %gep10402, align 8, !noalias !208
  %exitcond.4.not.i = icmp eq i64 %arg.shape.0, %.432.4.i
  br i1 %exitcond.4.not.i, label %B150.if.5.i, label %B150.if.4.i

B150.if.5.i:                                      ; preds = %B150.if.4.i, %B150.if.5.i
  %.363.0606.5.i = phi i64 [ %.432.5.i, %B150.if.5.i ], [ 0, %B150.if.4.i ]
  %.432.5.i = add nsw i64 %.363.0606.5.i, 1
  %gep10404 = getelementptr double, ptr %invariant.gep10403, i64 %.363.0606.5.i
  store double 1.000000e-09, ptr %gep10404, align 8, !noalias !208
  %exitcond.5.not.i = icmp eq i64 %arg.shape.0, %.432.5.i
  br i1 %exitcond.5.not.i, label %B150.if.6.i, label %B150.if.5.i

B150.if.6.i:                                      ; preds = %B150.if.5.i, %B150.if.6.i
  %.363.0606.6.i = phi i64 [ %.432.6.i, %B150.if.6.i ], [ 0, %B150.if.5.i ]
  %.432.6.i = add nsw i64 %.363.0606.6.i, 1
  %gep10406 = getelementptr double, ptr %invariant.gep10405, i64 %.363.0606.6.i
  store double 1.000000e-09, ptr %gep10406, align 8, !noalias !208
  %exitcond.6.not.i = icmp eq i64 %arg.shape.0, %.432.6.i
  br i1 %exitcond.6.not.i, label %B150.if.7.i, label %B150.if.6.i

B150.if.7.i:                                      ; preds = %B150.if.6.i, %B150.if.7.i
  %.363.0606.7.i = phi i64 [ %.432.7.i, %B150.if.7.i ], [ 0, %B150.if.6.i ]
  %.432.7.i = add nsw i64 %.363.0606.7.i, 1
  %gep10408 = getelementptr double, ptr %invariant.gep10407, i64 %.363.0606.7.i
  store double 1.000000e-09, ptr %gep10408, align 8, !noalias !208
  %exitcond.7.not.i = icmp eq i64 %arg.shape.0, %.432.7.i
  br i1 %exitcond.7.not.i, label %B150.if.8.i, label %B150.if.7.i

B150.if.8.i:                                      ; preds = %B150.if.7.i, %B150.if.8.i
  %.363.0606.8.i = phi i64 [ %.432.8.i, %B150.if.8.i ], [ 0, %B150.if.7.i ]
  %.432.8.i = add nsw i64 %.363.0606.8.i, 1
  %gep10410 = getelementptr double, ptr %invariant.gep10409, i64 %.363.0606.8.i
  store double 1.000000e-09, ptr %gep10410, align 8, !noalias !208
  %exitcond.8.not.i = icmp eq i64 %arg.shape.0, %.432.8.i
  br i1 %exitcond.8.not.i, label %B116.loopexit.8.i, label %B150.if.8.i

B116.loopexit.8.i:                                ; preds = %B150.if.8.i, %B3896
  %.229.i.i = load double, ptr %.228.i.i, align 8, !noalias !212
  %.258.i.i9865 = load double, ptr %arg.batch.2.4, align 8, !noalias !212
  br label %B256.if.i.i

B290.loopexit.i.i:                                ; preds = %B122.if.i.i.i9924, %switch.end.i.i9919
  %exitcond1313.not.i.i = icmp eq i64 %arg.shape.0, %.535.i.i
  br i1 %exitcond1313.not.i.i, label %B358.i.i, label %B290.if.i.i

B358.i.i:                                         ; preds = %B290.loopexit.i.i, %B256.if.i.i
  %.636.i.i = icmp ult i64 %.343.01301.i.i, 8
  %.1287.i.i9869 = select i1 %.636.i.i, i64 16, i64 17
  %.646.i.i = mul nsw i64 %.343.01301.i.i, 3
  %.6521283.i.i = add nsw i64 %.646.i.i, 1
  %.675.i.i = mul i64 %.6521283.i.i, %arg.shape.0
  %.710.i.i = load i64, ptr %.709.i.i, align 8, !noalias !212
  %.785.i.i9870 = mul i64 %.1287.i.i9869, %.469
  %.803.i.i9871 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.785.i.i9870
  %.828.i.i9872 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.675.i.i
  %.829.i.i = inttoptr i64 %.710.i.i to ptr
  tail call void %.829.i.i(ptr %.577, ptr %.803.i.i9871, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.828.i.i9872), !noalias !212
  %.401.i.i = icmp sgt i64 %.346.01302.i.i, 1
  br i1 %.401.i.i, label %B256.if.i.i, label %B600.i.i

B600.i.i:                                         ; preds = %B358.i.i
  br i1 %.5221298.not.i.i, label %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B634.lr.ph.i.i

B634.lr.ph.i.i:                                   ; preds = %B600.i.i
  %.259.i.i9883 = fsub double %.229.i.i, %.258.i.i9865
  %.260.i.i = fmul double %.259.i.i9883, 1.000000e-13
  %.1818.i.i = fmul double %.260.i.i, 2.000000e+00
  br label %B634.i.i9885

B634.i.i9885:                                     ; preds = %B1544.i.i, %B634.lr.ph.i.i
  %.927.sroa.0.01311.i.i = phi i64 [ 0, %B634.lr.ph.i.i ], [ %.927.sroa.0.0.i.i, %B1544.i.i ]
  %.883.11310.i.i = phi i64 [ %.883.11306.i.i, %B634.lr.ph.i.i ], [ %.883.1.i.i, %B1544.i.i ]
  %.880.11309.i.i = phi i64 [ 1, %B634.lr.ph.i.i ], [ %.880.1.i.i, %B1544.i.i ]
  %some.2.01308.i.i = phi i1 [ false, %B634.lr.ph.i.i ], [ %some.3.1.i.i, %B1544.i.i ]
  %excinfo.3.01307.i.i = phi ptr [ null, %B634.lr.ph.i.i ], [ %excinfo.3.1.i.i, %B1544.i.i ]
  %.1008.i.i9886 = icmp slt i64 %.927.sroa.0.01311.i.i, 0
  %.1009.i.i = select i1 %.1008.i.i9886, i64 %arg.batch.4.0.5.1, i64 0
  %.1010.i.i = add i64 %.1009.i.i, %.927.sroa.0.01311.i.i
  %.1031.i.i = getelementptr double, ptr %68, i64 %.1010.i.i
  %.1032.i.i = load double, ptr %.1031.i.i, align 8, !noalias !212
  %.1060.i.i9887 = select i1 %.1008.i.i9886, i64 %arg.batch.4.1.5.1, i64 0
  %.1061.i.i = add i64 %.1060.i.i9887, %.927.sroa.0.01311.i.i
  %.1082.i.i9888 = getelementptr i64, ptr %69, i64 %.1061.i.i
  store i64 -1, ptr %.1082.i.i9888, align 8, !noalias !212
  %.1133.i.i = getelementptr double, ptr %.577, i64 %.1010.i.i
  store double %.1032.i.i, ptr %.1133.i.i, align 8, !noalias !212
  %.1184.i.i9889 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1061.i.i
  %.1185.i.i = load i64, ptr %.1184.i.i9889, align 8, !noalias !212
  %.1186.i.i = icmp sgt i64 %.1185.i.i, -1
  br i1 %.1186.i.i, label %B792.i.i9890, label %B1544.i.i

B792.i.i9890:                                     ; preds = %B634.i.i9885
  %.1240.i.i9891 = getelementptr double, ptr %70, i64 %.1010.i.i
  %.1241.i.i = load double, ptr %.1240.i.i9891, align 8, !noalias !212
  %.1242.i.i = fcmp ogt double %.1241.i.i, 5.000000e-01
  br i1 %.1242.i.i, label %B842.i.i, label %B1544.i.i

B842.i.i:                                         ; preds = %B792.i.i9890
  %.1328.i.i9892 = load i64, ptr %.1082.i.i9888, align 8, !noalias !212
  %.1329.i.i = icmp slt i64 %.1328.i.i9892, 0
  br i1 %.1329.i.i, label %B940.i.i, label %B1088.i.i

B940.i.i:                                         ; preds = %B842.i.i, %B940.i.i
  %last.2.3.i.i = phi i64 [ %.1335.i.i, %B940.i.i ], [ %.1288.i.i9884, %B842.i.i ]
  %.1335.i.i = add nsw i64 %last.2.3.i.i, 1
  %.151.i51.i.i = mul nsw i64 %.1335.i.i, 3
  %.155.i.i.i9914 = add nsw i64 %.151.i51.i.i, 1
  %.159.i.i.i9915 = mul nsw i64 %.155.i.i.i9914, %arg.shape.0
  %.161.i.i.i = add nsw i64 %.159.i.i.i9915, %.927.sroa.0.01311.i.i
  %.175.i63.i.i = icmp slt i64 %.161.i.i.i, 0
  %.176.i64.i.i = select i1 %.175.i63.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %307 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i.i
  %.190.i.i.i = getelementptr double, ptr %307, i64 %.176.i64.i.i
  %.191.i.i.i9916 = load double, ptr %.190.i.i.i, align 8, !noalias !216
  %.195.i80.i.i = add nsw i64 %.161.i.i.i, %arg.shape.0
  %.209.i.i.i = icmp slt i64 %.195.i80.i.i, 0
  %.210.i.i.i9917 = select i1 %.209.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %308 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i80.i.i
  %.224.i91.i.i = getelementptr double, ptr %308, i64 %.210.i.i.i9917
  %.225.i92.i.i = load double, ptr %.224.i91.i.i, align 8, !noalias !216
  %.226.i93.i.i = fneg double %.225.i92.i.i
  %.227.i94.i.i = fcmp uge double %.191.i.i.i9916, %.226.i93.i.i
  %.1350.0.i.i = sext i1 %.227.i94.i.i to i64
  store i64 %.1350.0.i.i, ptr %.1082.i.i9888, align 8, !noalias !212
  %exitcond1315.not.i.i = icmp ne i64 %last.2.3.i.i, 7
  %brmerge.not.i.i = and i1 %exitcond1315.not.i.i, %.227.i94.i.i
  br i1 %brmerge.not.i.i, label %B940.i.i, label %B1088.i.i

B1088.i.i:                                        ; preds = %B940.i.i, %B842.i.i
  %last.3.2.i.i = phi i64 [ %.1288.i.i9884, %B842.i.i ], [ %.1335.i.i, %B940.i.i ]
  br i1 %.298.i.i, label %B1096.i.i, label %B1126.i.i

B1096.i.i:                                        ; preds = %B1088.i.i
  %309 = getelementptr double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %last.3.2.i.i
  %switch.gep10547 = getelementptr i8, ptr %309, i64 64
  %switch.load10548 = load double, ptr %switch.gep10547, align 8
  br label %B1126.i.i

B1126.i.i:                                        ; preds = %B1096.i.i, %B1088.i.i
  %"$phi1126.1.2.2.i.i" = phi double [ 0.000000e+00, %B1088.i.i ], [ %switch.load10548, %B1096.i.i ]
  %.1597.i.i = getelementptr double, ptr %71, i64 %.1010.i.i
  store double %"$phi1126.1.2.2.i.i", ptr %.1597.i.i, align 8, !noalias !212
  %310 = getelementptr double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %last.3.2.i.i
  %switch.gep10551 = getelementptr i8, ptr %310, i64 72
  %switch.load10552 = load double, ptr %switch.gep10551, align 8
  %.1685.i.i = getelementptr double, ptr %72, i64 %.1010.i.i
  store double %switch.load10552, ptr %.1685.i.i, align 8, !noalias !212
  %.1737.i.i = load i64, ptr %.1082.i.i9888, align 8, !noalias !212
  %.1738.i.i = icmp sgt i64 %.1737.i.i, -1
  %.1748.i.i9896 = sext i1 %.1738.i.i to i64
  %"$phi1274.1.2.2.i.i" = add nsw i64 %last.3.2.i.i, %.1748.i.i9896
  br i1 %.298.i.i, label %B1282.i.i, label %B1492.i.i

B1282.i.i:                                        ; preds = %B1126.i.i
  %.1815.i.i = getelementptr double, ptr %67, i64 %.1010.i.i
  %.1816.i.i = load double, ptr %.1815.i.i, align 8, !noalias !212
  %.1819.i.i = fcmp ogt double %.1816.i.i, %.1818.i.i
  br i1 %.1819.i.i, label %B1340.i.i, label %B1492.i.i

B1340.i.i:                                        ; preds = %B1282.i.i
  %.96.i.i.i = load double, ptr %.1031.i.i, align 8, !noalias !220
  %.97.i.i.i = tail call double @llvm.fabs.f64(double %.96.i.i.i)
  %.98.i.i.i = fmul double %.97.i.i.i, 1.000000e-15
  %.152.i.i.i = fdiv double %.98.i.i.i, %.1816.i.i
  %311 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1274.1.2.2.i.i", i64 0)
  %storemerge.i.i.i = tail call i64 @llvm.smin.i64(i64 %311, i64 7)
  %.690443.i.i.i = icmp sgt i64 %"$phi1274.1.2.2.i.i", 0
  %.633.1445.i.i.i = select i1 %.690443.i.i.i, i64 2, i64 1
  %.699446.i.i.i = sext i1 %.690443.i.i.i to i64
  %.636.1447.i.i.i = add nsw i64 %storemerge.i.i.i, %.699446.i.i.i
  %.680.sroa.0.0448.i.i.i = zext i1 %.690443.i.i.i to i64
  %.282.i.i.i = add nsw i64 %.927.sroa.0.01311.i.i, %arg.shape.0
  %.192.i.i.i.i = add nsw i64 %.282.i.i.i, %.43.i.i.i
  %.206.i.i.i.i = icmp slt i64 %.192.i.i.i.i, 0
  %.207.i.i.i.i = select i1 %.206.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %312 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i.i
  %.221.i.i.i.i = getelementptr double, ptr %312, i64 %.207.i.i.i.i
  %.222.i.i.i.i = load double, ptr %.221.i.i.i.i, align 8, !noalias !224
  %.472.i.i.i.i = icmp slt i64 %.282.i.i.i, 0
  %.473.i.i.i.i = select i1 %.472.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %313 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.282.i.i.i
  %.487.i.i.i.i = getelementptr double, ptr %313, i64 %.473.i.i.i.i
  %.488.i.i.i.i = load double, ptr %.487.i.i.i.i, align 8, !noalias !224
  %.489.i.i.i.i = fmul double %.488.i.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i.i = fsub double %.222.i.i.i.i, %.489.i.i.i.i
  %.458.i.1.i.i.i = add nsw i64 %.282.i.i.i, %.454.i.i.i.i
  %.472.i.1.i.i.i = icmp slt i64 %.458.i.1.i.i.i, 0
  %.473.i.1.i.i.i = select i1 %.472.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %314 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i.i
  %.487.i.1.i.i.i = getelementptr double, ptr %314, i64 %.473.i.1.i.i.i
  %.488.i.1.i.i.i = load double, ptr %.487.i.1.i.i.i, align 8, !noalias !224
  %.489.i.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i.i = fsub double %.491.i.i.i.i, %.489.i.1.i.i.i
  %.458.i.2.i.i.i = add nsw i64 %.282.i.i.i, %.456.i.2.i.i.i
  %.472.i.2.i.i.i = icmp slt i64 %.458.i.2.i.i.i, 0
  %.473.i.2.i.i.i = select i1 %.472.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %315 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i.i
  %.487.i.2.i.i.i = getelementptr double, ptr %315, i64 %.473.i.2.i.i.i
  %.488.i.2.i.i.i = load double, ptr %.487.i.2.i.i.i, align 8, !noalias !224
  %.489.i.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1306AA3D795F4
  %316 = fadd double %.491.i.1.i.i.i, %.489.i.2.i.i.i
  %.458.i.3.i.i.i = add nsw i64 %.282.i.i.i, %.456.i.3.i.i.i
  %.472.i.3.i.i.i = icmp slt i64 %.458.i.3.i.i.i, 0
  %.473.i.3.i.i.i = select i1 %.472.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %317 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i.i
  %.487.i.3.i.i.i = getelementptr double, ptr %317, i64 %.473.i.3.i.i.i
  %.488.i.3.i.i.i = load double, ptr %.487.i.3.i.i.i, align 8, !noalias !224
  %.489.i.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i.i = fsub double %316, %.489.i.3.i.i.i
  %.458.i.4.i.i.i = add nsw i64 %.282.i.i.i, %.456.i.4.i.i.i
  %.472.i.4.i.i.i = icmp slt i64 %.458.i.4.i.i.i, 0
  %.473.i.4.i.i.i = select i1 %.472.i.4.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %318 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i.i
  %.487.i.4.i.i.i = getelementptr double, ptr %318, i64 %.473.i.4.i.i.i
  %.488.i.4.i.i.i = load double, ptr %.487.i.4.i.i.i, align 8, !noalias !224
  %.489.i.4.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA4EAF2D6B11E79
  %319 = fadd double %.491.i.3.i.i.i, %.489.i.4.i.i.i
  %.502.i.i.i.i = tail call double @llvm.fabs.f64(double %319)
  %.10.i.i.i.i.i = fcmp ogt double %.502.i.i.i.i, 0.000000e+00
  %.11.i.i.i.i.i = select i1 %.10.i.i.i.i.i, double %.502.i.i.i.i, double 0.000000e+00
  %.192.i.1.i.i.i = add nsw i64 %.282.i.i.i, %.190.i.1.i.i.i
  %.206.i.1.i.i.i = icmp slt i64 %.192.i.1.i.i.i, 0
  %.207.i.1.i.i.i = select i1 %.206.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %320 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i.i
  %.221.i.1.i.i.i = getelementptr double, ptr %320, i64 %.207.i.1.i.i.i
  %.222.i.1.i.i.i = load double, ptr %.221.i.1.i.i.i, align 8, !noalias !224
  %.489.i.1494.i.i.i = fmul double %.488.i.i.i.i, 0x3FA5118805F8B876
  %321 = fadd double %.489.i.1494.i.i.i, %.222.i.1.i.i.i
  %.489.i.1.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i.i = fsub double %321, %.489.i.1.1.i.i.i
  %.489.i.2.1.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i.i = fsub double %.491.i.1.1.i.i.i, %.489.i.2.1.i.i.i
  %.489.i.3.1.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FC0DA0C684D1D67
  %322 = fadd double %.489.i.3.1.i.i.i, %.491.i.2.1.i.i.i
  %.489.i.4.1.i.i.i = fmul double %.488.i.4.i.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i.i = fsub double %322, %.489.i.4.1.i.i.i
  %.502.i.1.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i.i)
  %.10.i.i.1.i.i.i = fcmp ogt double %.502.i.1.i.i.i, %.11.i.i.i.i.i
  %.11.i.i.1.i.i.i = select i1 %.10.i.i.1.i.i.i, double %.502.i.1.i.i.i, double %.11.i.i.i.i.i
  %.192.i.2.i.i.i = add nsw i64 %.282.i.i.i, %.190.i.2.i.i.i
  %.206.i.2.i.i.i = icmp slt i64 %.192.i.2.i.i.i, 0
  %.207.i.2.i.i.i = select i1 %.206.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %323 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i.i
  %.221.i.2.i.i.i = getelementptr double, ptr %323, i64 %.207.i.2.i.i.i
  %.222.i.2.i.i.i = load double, ptr %.221.i.2.i.i.i, align 8, !noalias !224
  %.489.i.2521.i.i.i = fmul double %.488.i.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2522.i.i.i = fsub double %.222.i.2.i.i.i, %.489.i.2521.i.i.i
  %.489.i.1.2.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FC1EAE0FF33D241
  %324 = fadd double %.489.i.1.2.i.i.i, %.491.i.2522.i.i.i
  %.489.i.2.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i.i = fsub double %324, %.489.i.2.2.i.i.i
  %.489.i.3.2.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i.i = fsub double %.491.i.2.2.i.i.i, %.489.i.3.2.i.i.i
  %.489.i.4.2.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA55161A739EB34
  %325 = fadd double %.489.i.4.2.i.i.i, %.491.i.3.2.i.i.i
  %.502.i.2.i.i.i = tail call double @llvm.fabs.f64(double %325)
  %.10.i.i.2.i.i.i = fcmp ogt double %.502.i.2.i.i.i, %.11.i.i.1.i.i.i
  %.11.i.i.2.i.i.i = select i1 %.10.i.i.2.i.i.i, double %.502.i.2.i.i.i, double %.11.i.i.1.i.i.i
  %.192.i.3.i.i.i = add nsw i64 %.282.i.i.i, %.190.i.3.i.i.i
  %.206.i.3.i.i.i = icmp slt i64 %.192.i.3.i.i.i, 0
  %.207.i.3.i.i.i = select i1 %.206.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %326 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i.i
  %.221.i.3.i.i.i = getelementptr double, ptr %326, i64 %.207.i.3.i.i.i
  %.222.i.3.i.i.i = load double, ptr %.221.i.3.i.i.i, align 8, !noalias !224
  %.489.i.3548.i.i.i = fmul double %.488.i.i.i.i, 0x3FA4F0C0BB579409
  %327 = fadd double %.489.i.3548.i.i.i, %.222.i.3.i.i.i
  %.489.i.1.3.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i.i = fsub double %327, %.489.i.1.3.i.i.i
  %.489.i.2.3.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1F2DB6FEE3151
  %328 = fadd double %.489.i.2.3.i.i.i, %.491.i.1.3.i.i.i
  %.489.i.3.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i.i = fsub double %328, %.489.i.3.3.i.i.i
  %.489.i.4.3.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i.i = fsub double %.491.i.3.3.i.i.i, %.489.i.4.3.i.i.i
  %.502.i.3.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i.i)
  %.10.i.i.3.i.i.i = fcmp ogt double %.502.i.3.i.i.i, %.11.i.i.2.i.i.i
  %.11.i.i.3.i.i.i = select i1 %.10.i.i.3.i.i.i, double %.502.i.3.i.i.i, double %.11.i.i.2.i.i.i
  %.325.i.i.i = add nsw i64 %.927.sroa.0.01311.i.i, %.323.i.i.i
  %329 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.325.i.i.i
  %.339.i.i.i = icmp slt i64 %.325.i.i.i, 0
  %.340.i.i.i = select i1 %.339.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %.354.i.i.i = getelementptr double, ptr %329, i64 %.340.i.i.i
  %.355.i.i.i = load double, ptr %.354.i.i.i, align 8, !noalias !220
  %.548.i.i.i = fsub double %.222.i.i.i.i, %.488.i.i.i.i
  %.549.i.i.i = tail call double @llvm.fabs.f64(double %.548.i.i.i)
  %.551.i.i.i = fmul double %.152.i.i.i, %.549.i.i.i
  %.553.i.i.i = fadd double %.551.i.i.i, %.355.i.i.i
  %.548.1.i.i.i = fsub double %.488.i.1.i.i.i, %.222.i.i.i.i
  %.549.1.i.i.i = tail call double @llvm.fabs.f64(double %.548.1.i.i.i)
  %.551.1.i.i.i = fmul double %.152.i.i.i, %.549.1.i.i.i
  %.553.1.i.i.i = fadd double %.551.1.i.i.i, %.553.i.i.i
  %.548.2.i.i.i = fsub double %.222.i.1.i.i.i, %.488.i.1.i.i.i
  %.549.2.i.i.i = tail call double @llvm.fabs.f64(double %.548.2.i.i.i)
  %.551.2.i.i.i = fmul double %.152.i.i.i, %.549.2.i.i.i
  %.553.2.i.i.i = fadd double %.551.2.i.i.i, %.553.1.i.i.i
  %.548.3.i.i.i = fsub double %.488.i.2.i.i.i, %.222.i.1.i.i.i
  %.549.3.i.i.i = tail call double @llvm.fabs.f64(double %.548.3.i.i.i)
  %.551.3.i.i.i = fmul double %.152.i.i.i, %.549.3.i.i.i
  %.553.3.i.i.i = fadd double %.551.3.i.i.i, %.553.2.i.i.i
  %.548.4.i.i.i = fsub double %.222.i.2.i.i.i, %.488.i.2.i.i.i
  %.549.4.i.i.i = tail call double @llvm.fabs.f64(double %.548.4.i.i.i)
  %.551.4.i.i.i = fmul double %.152.i.i.i, %.549.4.i.i.i
  %.553.4.i.i.i = fadd double %.551.4.i.i.i, %.553.3.i.i.i
  %.548.5.i.i.i = fsub double %.488.i.3.i.i.i, %.222.i.2.i.i.i
  %.549.5.i.i.i = tail call double @llvm.fabs.f64(double %.548.5.i.i.i)
  %.551.5.i.i.i = fmul double %.152.i.i.i, %.549.5.i.i.i
  %.553.5.i.i.i = fadd double %.551.5.i.i.i, %.553.4.i.i.i
  %.548.6.i.i.i = fsub double %.222.i.3.i.i.i, %.488.i.3.i.i.i
  %.549.6.i.i.i = tail call double @llvm.fabs.f64(double %.548.6.i.i.i)
  %.551.6.i.i.i = fmul double %.152.i.i.i, %.549.6.i.i.i
  %.553.6.i.i.i = fadd double %.551.6.i.i.i, %.553.5.i.i.i
  %.548.7.i.i.i = fsub double %.488.i.4.i.i.i, %.222.i.3.i.i.i
  %.549.7.i.i.i = tail call double @llvm.fabs.f64(double %.548.7.i.i.i)
  %.551.7.i.i.i = fmul double %.152.i.i.i, %.549.7.i.i.i
  %.553.7.i.i.i = fadd double %.551.7.i.i.i, %.553.6.i.i.i
  %.563.i.i.i = fcmp ugt double %.11.i.i.3.i.i.i, %.553.7.i.i.i
  br i1 %.563.i.i.i, label %B462.i.i.i, label %B1225.i.i.i

B462.i.i.i:                                       ; preds = %B1340.i.i
  br i1 %.690443.i.i.i, label %B542.lr.ph.i.i.i, label %B1186.i.i.i

B542.lr.ph.i.i.i:                                 ; preds = %B462.i.i.i
  %.958.i.i.i = fmul double %.11.i.i.3.i.i.i, 1.000000e+01
  br label %B542.i.i.i

B542.i.i.i:                                       ; preds = %B1226.i.i.i, %B542.lr.ph.i.i.i
  %.680.sroa.0.0452.i.i.i = phi i64 [ %.680.sroa.0.0448.i.i.i, %B542.lr.ph.i.i.i ], [ %.680.sroa.0.0.i.i.i, %B1226.i.i.i ]
  %.636.1451.i.i.i = phi i64 [ %.636.1447.i.i.i, %B542.lr.ph.i.i.i ], [ %.636.1.i.i.i, %B1226.i.i.i ]
  %.633.1450.i.i.i = phi i64 [ %.633.1445.i.i.i, %B542.lr.ph.i.i.i ], [ %.633.1.i.i.i, %B1226.i.i.i ]
  %nearest.3.2449.i.i.i = phi double [ 0x7FF0000000000000, %B542.lr.ph.i.i.i ], [ %nearest.4.3.i.i.i, %B1226.i.i.i ]
  %.732.i.i.i = add nsw i64 %.680.sroa.0.0452.i.i.i, -1
  %.734.i.i.i = mul nsw i64 %.732.i.i.i, %.43.i.i.i
  %.736.i.i.i = add nsw i64 %.734.i.i.i, %.282.i.i.i
  %.750.i.i.i = icmp slt i64 %.736.i.i.i, 0
  %.751.i.i.i = select i1 %.750.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %330 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.736.i.i.i
  %.765.i.i.i = getelementptr double, ptr %330, i64 %.751.i.i.i
  %.766.i.i.i = load double, ptr %.765.i.i.i, align 8, !noalias !220
  %.769.i.i.i = mul nsw i64 %.680.sroa.0.0452.i.i.i, %.43.i.i.i
  %.771.i.i.i = add nsw i64 %.769.i.i.i, %.282.i.i.i
  %.785.i.i.i = icmp slt i64 %.771.i.i.i, 0
  %.786.i.i.i = select i1 %.785.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %331 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.771.i.i.i
  %.800.i.i.i = getelementptr double, ptr %331, i64 %.786.i.i.i
  %.801.i.i.i = load double, ptr %.800.i.i.i, align 8, !noalias !220
  %.803.i.i.i = add nsw i64 %.680.sroa.0.0452.i.i.i, 1
  %.805.i.i.i = mul nsw i64 %.803.i.i.i, %.43.i.i.i
  %.807.i.i.i = add nsw i64 %.805.i.i.i, %.282.i.i.i
  %.821.i.i.i = icmp slt i64 %.807.i.i.i, 0
  %.822.i.i.i = select i1 %.821.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %332 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.807.i.i.i
  %.836.i.i.i = getelementptr double, ptr %332, i64 %.822.i.i.i
  %.837.i.i.i = load double, ptr %.836.i.i.i, align 8, !noalias !220
  %.860.i.i.i = fcmp olt double %.801.i.i.i, 0.000000e+00
  %.863.i.i.i = fneg double %.766.i.i.i
  %.867.i.i.i = fneg double %.801.i.i.i
  %.871.i.i.i = fneg double %.837.i.i.i
  %c.2.3.i.i.i = select i1 %.860.i.i.i, double %.871.i.i.i, double %.837.i.i.i
  %b.2.3.i.i.i = select i1 %.860.i.i.i, double %.867.i.i.i, double %.801.i.i.i
  %a.2.3.i.i.i = select i1 %.860.i.i.i, double %.863.i.i.i, double %.766.i.i.i
  %.888.i.i.i = icmp eq i64 %.680.sroa.0.0452.i.i.i, 1
  %.895.i.i.i = fcmp ogt double %a.2.3.i.i.i, 0.000000e+00
  %or.cond.i.i.i = select i1 %.888.i.i.i, i1 true, i1 %.895.i.i.i
  br i1 %or.cond.i.i.i, label %B694.i.i.i, label %B750.i.i.i

B694.i.i.i:                                       ; preds = %B542.i.i.i
  %.901.i.i.i = icmp eq i64 %.680.sroa.0.0452.i.i.i, %"$phi1274.1.2.2.i.i"
  %.907.i.i.i = fcmp ogt double %c.2.3.i.i.i, 0.000000e+00
  %or.cond409.i.i.i = select i1 %.901.i.i.i, i1 true, i1 %.907.i.i.i
  br i1 %or.cond409.i.i.i, label %B718.i.i.i, label %B750.i.i.i

B718.i.i.i:                                       ; preds = %B694.i.i.i
  %.10.i.i.i.i9898 = fcmp olt double %b.2.3.i.i.i, %nearest.3.2449.i.i.i
  %.11.i411.i.i.i = select i1 %.10.i.i.i.i9898, double %b.2.3.i.i.i, double %nearest.3.2449.i.i.i
  br label %B750.i.i.i

B750.i.i.i:                                       ; preds = %B718.i.i.i, %B694.i.i.i, %B542.i.i.i
  %nearest.5.4.i.i.i = phi double [ %.11.i411.i.i.i, %B718.i.i.i ], [ %nearest.3.2449.i.i.i, %B694.i.i.i ], [ %nearest.3.2449.i.i.i, %B542.i.i.i ]
  %.952.i.i.i = icmp slt i64 %.680.sroa.0.0452.i.i.i, %"$phi1274.1.2.2.i.i"
  br i1 %.952.i.i.i, label %B762.i.i.i, label %B1226.i.i.i

B762.i.i.i:                                       ; preds = %B750.i.i.i
  %.961.i.i.i = fsub double %a.2.3.i.i.i, %b.2.3.i.i.i
  %.962.i.i.i = tail call double @llvm.fabs.f64(double %.961.i.i.i)
  %.965.i.i.i = fsub double %c.2.3.i.i.i, %b.2.3.i.i.i
  %.966.i.i.i = tail call double @llvm.fabs.f64(double %.965.i.i.i)
  %.967.i.i.i = fadd double %.962.i.i.i, %.966.i.i.i
  %.968.i.i.i = fmul double %.967.i.i.i, 3.000000e+00
  %.969.i.i.i = fadd double %.958.i.i.i, %.968.i.i.i
  %.971.i.i.i = fcmp olt double %b.2.3.i.i.i, %.969.i.i.i
  br i1 %.971.i.i.i, label %B872.i.i.i, label %B1226.i.i.i

B872.i.i.i:                                       ; preds = %B762.i.i.i
  %switch.tableidx10553 = add i64 %.680.sroa.0.0452.i.i.i, 9
  %333 = icmp ult i64 %switch.tableidx10553, 18
  br i1 %333, label %switch.lookup10554, label %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B1078.i.i.i:                                      ; preds = %switch.lookup10566
  %.1180.i.i.i = fneg double %.1121.i.i.i
  %.1184.i.i.i = fmul double %.1170.i.i.i, 5.000000e-01
  %.1189.i.i.i = fdiv double %.1184.i.i.i, %.1153.i.i.i
  %.1190.i.i.i = fcmp ogt double %.1189.i.i.i, %.1180.i.i.i
  %.1200.i.i.i = fcmp olt double %.1189.i.i.i, %.1047.i.i.i
  %or.cond410.i.i.i = and i1 %.1190.i.i.i, %.1200.i.i.i
  br i1 %or.cond410.i.i.i, label %B1118.i.i.i, label %B1226.i.i.i

B1118.i.i.i:                                      ; preds = %B1078.i.i.i
  %.1227.i.i.i = fmul double %.1170.i.i.i, 2.500000e-01
  %.1229.i.i.i = fmul double %.1170.i.i.i, %.1227.i.i.i
  %.1236.i.i.i = fdiv double %.1229.i.i.i, %.1153.i.i.i
  %.1240.i.i.i = fsub double %b.2.3.i.i.i, %.1236.i.i.i
  %.10.i412.i.i.i = fcmp olt double %.1240.i.i.i, %nearest.5.4.i.i.i
  %.11.i413.i.i.i = select i1 %.10.i412.i.i.i, double %.1240.i.i.i, double %nearest.5.4.i.i.i
  br label %B1226.i.i.i

B1186.i.i.i:                                      ; preds = %B1226.i.i.i, %B462.i.i.i
  %nearest.3.2.lcssa.i.i.i = phi double [ 0x7FF0000000000000, %B462.i.i.i ], [ %nearest.4.3.i.i.i, %B1226.i.i.i ]
  %.1308.i.i.i = fmul double %.11.i.i.3.i.i.i, 1.000000e+01
  %.1312.i.i.i = fcmp ugt double %nearest.3.2.lcssa.i.i.i, %.1308.i.i.i
  br i1 %.1312.i.i.i, label %B1225.i.i.i, label %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B1225.i.i.i:                                      ; preds = %B1186.i.i.i, %B1340.i.i
  br label %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B1226.i.i.i:                                      ; preds = %switch.lookup10566, %B1118.i.i.i, %B1078.i.i.i, %B762.i.i.i, %B750.i.i.i
  %nearest.4.3.i.i.i = phi double [ %nearest.5.4.i.i.i, %B1078.i.i.i ], [ %.11.i413.i.i.i, %B1118.i.i.i ], [ %nearest.5.4.i.i.i, %B750.i.i.i ], [ %nearest.5.4.i.i.i, %switch.lookup10566 ], [ %nearest.5.4.i.i.i, %B762.i.i.i ]
  %.690.i.i.i = icmp sgt i64 %.636.1451.i.i.i, 0
  %.703.i.i.i = zext i1 %.690.i.i.i to i64
  %.633.1.i.i.i = add i64 %.633.1450.i.i.i, %.703.i.i.i
  %.699.i.i.i = sext i1 %.690.i.i.i to i64
  %.636.1.i.i.i = add nsw i64 %.636.1451.i.i.i, %.699.i.i.i
  %.680.sroa.0.0.i.i.i = select i1 %.690.i.i.i, i64 %.633.1450.i.i.i, i64 0
  br i1 %.690.i.i.i, label %B542.i.i.i, label %B1186.i.i.i

switch.lookup10554:                               ; preds = %B872.i.i.i
  %switch.tableidx10557 = add i64 %.680.sroa.0.0452.i.i.i, 8
  %334 = icmp ult i64 %switch.tableidx10557, 18
  br i1 %334, label %switch.lookup10558, label %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup10558:                               ; preds = %switch.lookup10554
  %switch.gep10555 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10553
  %switch.load10556 = load double, ptr %switch.gep10555, align 8
  %switch.gep10559 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10557
  %switch.load10560 = load double, ptr %switch.gep10559, align 8
  %.1047.i.i.i = fsub double %switch.load10556, %switch.load10560
  %switch.tableidx10561 = add i64 %.680.sroa.0.0452.i.i.i, 10
  %335 = icmp ult i64 %switch.tableidx10561, 18
  br i1 %335, label %switch.lookup10562, label %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup10562:                               ; preds = %switch.lookup10558
  %switch.tableidx10565 = add i64 %.680.sroa.0.0452.i.i.i, 9
  %336 = icmp ult i64 %switch.tableidx10565, 18
  br i1 %336, label %switch.lookup10566, label %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup10566:                               ; preds = %switch.lookup10562
  %switch.gep10563 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10561
  %switch.load10564 = load double, ptr %switch.gep10563, align 8
  %switch.gep10567 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10565
  %switch.load10568 = load double, ptr %switch.gep10567, align 8
  %.1121.i.i.i = fsub double %switch.load10564, %switch.load10568
  %.1137.i.i.i = fdiv double %.965.i.i.i, %.1121.i.i.i
  %.1140.i.i.i = fsub double %b.2.3.i.i.i, %a.2.3.i.i.i
  %.1145.i.i.i = fdiv double %.1140.i.i.i, %.1047.i.i.i
  %.1146.i.i.i = fsub double %.1137.i.i.i, %.1145.i.i.i
  %.1149.i.i.i = fadd double %.1047.i.i.i, %.1121.i.i.i
  %.1153.i.i.i = fdiv double %.1146.i.i.i, %.1149.i.i.i
  %.1169.i.i.i = fmul double %.1047.i.i.i, %.1153.i.i.i
  %.1170.i.i.i = fadd double %.1145.i.i.i, %.1169.i.i.i
  %.1175.i.i.i = fcmp ogt double %.1153.i.i.i, 0.000000e+00
  br i1 %.1175.i.i.i, label %B1078.i.i.i, label %B1226.i.i.i

_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B872.i.i.i, %switch.lookup10554, %switch.lookup10558, %switch.lookup10562, %B1225.i.i.i, %B1186.i.i.i
  %.1857.not.i.i = phi i1 [ false, %B1186.i.i.i ], [ true, %B1225.i.i.i ], [ true, %switch.lookup10562 ], [ true, %switch.lookup10558 ], [ true, %switch.lookup10554 ], [ true, %B872.i.i.i ]
  %excinfo.3.3.i.i = phi ptr [ %excinfo.3.01307.i.i, %B1186.i.i.i ], [ %excinfo.3.01307.i.i, %B1225.i.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.114, %switch.lookup10562 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.114, %switch.lookup10558 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.114, %switch.lookup10554 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.114, %B872.i.i.i ]
  %.1846.not.i.i = phi i1 [ true, %B1186.i.i.i ], [ true, %B1225.i.i.i ], [ false, %switch.lookup10562 ], [ false, %switch.lookup10558 ], [ false, %switch.lookup10554 ], [ false, %B872.i.i.i ]
  br i1 %.1846.not.i.i, label %B1340.endif.endif.i.i, label %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, !prof !57

B1380.i.i:                                        ; preds = %B1340.endif.endif.i.i
  %.1928.i.i = fmul double %.1816.i.i, 5.000000e-01
  store double 0.000000e+00, ptr %.1240.i.i9891, align 8, !noalias !228
  %.161.i230.i.i = getelementptr double, ptr %.2012, i64 %.1010.i.i
  store double 0.000000e+00, ptr %.161.i230.i.i, align 8, !noalias !228
  %.214.i273.i.i = getelementptr double, ptr %73, i64 %.1010.i.i
  store double %.1928.i.i, ptr %.214.i273.i.i, align 8, !noalias !228
  %.268.i313.i.i = load i64, ptr %.1184.i.i9889, align 8, !noalias !228
  %.294.i.i.i = icmp slt i64 %.268.i313.i.i, 0
  %.295.i.i.i = select i1 %.294.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i324.i.i = add i64 %.295.i.i.i, %.268.i313.i.i
  %.316.i333.i.i = mul i64 %.296.i324.i.i, %arg.batch.3.3.5.1
  %.320.i.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i333.i.i
  %.321.i.i.i = load i64, ptr %.320.i.i.i, align 8, !noalias !228
  %.322.i336.i.i = add nsw i64 %.321.i.i.i, -1
  store i64 %.322.i336.i.i, ptr %.320.i.i.i, align 8, !noalias !228
  %.426.i.i.i = load i64, ptr %.1184.i.i9889, align 8, !noalias !228
  %.452.i.i.i = icmp slt i64 %.426.i.i.i, 0
  %.453.i.i.i = select i1 %.452.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i.i9897 = add i64 %.453.i.i.i, %.426.i.i.i
  %.474.i.i.i = mul i64 %.454.i.i.i9897, %arg.batch.3.3.5.1
  %337 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i.i
  %.478.i.i.i = getelementptr i8, ptr %337, i64 24
  %.479.i.i.i = load i64, ptr %.478.i.i.i, align 8, !noalias !228
  %.480.i.i.i = add nsw i64 %.479.i.i.i, 1
  store i64 %.480.i.i.i, ptr %.478.i.i.i, align 8, !noalias !228
  store i64 -1, ptr %.1082.i.i9888, align 8, !noalias !212
  br label %B1492.i.i

B1492.i.i:                                        ; preds = %B1340.endif.endif.i.i, %B1126.i.i, %B1380.i.i, %B1282.i.i
  %excinfo.3.2.i.i = phi ptr [ %excinfo.3.3.i.i, %B1340.endif.endif.i.i ], [ %excinfo.3.3.i.i, %B1380.i.i ], [ %excinfo.3.01307.i.i, %B1282.i.i ], [ %excinfo.3.01307.i.i, %B1126.i.i ]
  br i1 %some.2.01308.i.i, label %B1544.i.i, label %B1496.i.i

B1496.i.i:                                        ; preds = %B1492.i.i
  %.2084.i.i = load i64, ptr %.1082.i.i9888, align 8, !noalias !212
  %.2085.i.i = icmp sgt i64 %.2084.i.i, -1
  br label %B1544.i.i

B1544.i.i:                                        ; preds = %B1496.i.i, %B1492.i.i, %B792.i.i9890, %B634.i.i9885
  %excinfo.3.1.i.i = phi ptr [ %excinfo.3.2.i.i, %B1492.i.i ], [ %excinfo.3.2.i.i, %B1496.i.i ], [ %excinfo.3.01307.i.i, %B792.i.i9890 ], [ %excinfo.3.01307.i.i, %B634.i.i9885 ]
  %some.3.1.i.i = phi i1 [ true, %B1492.i.i ], [ %.2085.i.i, %B1496.i.i ], [ %some.2.01308.i.i, %B792.i.i9890 ], [ %some.2.01308.i.i, %B634.i.i9885 ]
  %.937.i.i = icmp sgt i64 %.883.11310.i.i, 0
  %.950.i.i = zext i1 %.937.i.i to i64
  %.880.1.i.i = add i64 %.880.11309.i.i, %.950.i.i
  %.946.i.i = sext i1 %.937.i.i to i64
  %.883.1.i.i = add nsw i64 %.883.11310.i.i, %.946.i.i
  %.927.sroa.0.0.i.i = select i1 %.937.i.i, i64 %.880.11309.i.i, i64 0
  br i1 %.937.i.i, label %B634.i.i9885, label %B1548.loopexit.i.i

B1548.loopexit.i.i:                               ; preds = %B1544.i.i
  %338 = xor i1 %some.3.1.i.i, true
  br label %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i

B256.if.i.i:                                      ; preds = %B358.i.i, %B116.loopexit.8.i
  %.346.01302.i.i = phi i64 [ %.356.i.i9866, %B116.loopexit.8.i ], [ %.410.i.i, %B358.i.i ]
  %.343.01301.i.i = phi i64 [ %..i.i, %B116.loopexit.8.i ], [ %.414.i.i, %B358.i.i ]
  %.410.i.i = add nsw i64 %.346.01302.i.i, -1
  %.414.i.i = add nsw i64 %.343.01301.i.i, 1
  br i1 %.5221298.not.i.i, label %B358.i.i, label %B290.if.i.i.preheader

B290.if.i.i.preheader:                            ; preds = %B256.if.i.i
  %339 = icmp ult i64 %.343.01301.i.i, 8
  %switch.gep10570 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.23, i64 %.343.01301.i.i
  br label %B290.if.i.i

B290.if.i.i:                                      ; preds = %B290.if.i.i.preheader, %B290.loopexit.i.i
  %.466.01299.i.i = phi i64 [ %.535.i.i, %B290.loopexit.i.i ], [ 0, %B290.if.i.i.preheader ]
  %.535.i.i = add nsw i64 %.466.01299.i.i, 1
  br i1 %339, label %switch.lookup10569, label %switch.end.i.i9919

switch.lookup10569:                               ; preds = %B290.if.i.i
  %switch.load10571 = load double, ptr %switch.gep10570, align 8
  br label %switch.end.i.i9919

switch.end.i.i9919:                               ; preds = %B290.if.i.i, %switch.lookup10569
  %.577.i.i9920 = phi double [ %switch.load10571, %switch.lookup10569 ], [ 1.000000e+00, %B290.if.i.i ]
  %.92.i.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.466.01299.i.i
  %.93.i.i.i = load double, ptr %.92.i.i.i, align 8, !noalias !231
  %.146.i.i.i = getelementptr double, ptr %67, i64 %.466.01299.i.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !231
  %.149.i.i.i = fmul double %.577.i.i9920, %.147.i.i.i
  %.150.i.i.i9921 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.577, i64 %.466.01299.i.i
  store double %.150.i.i.i9921, ptr %.203.i.i.i, align 8, !noalias !231
  br i1 %.287.i1295.not.i.i, label %B290.loopexit.i.i, label %B122.if.i.lr.ph.i.i

B122.if.i.lr.ph.i.i:                              ; preds = %switch.end.i.i9919
  %.247.i.i.i.i9922 = fsub double 1.000000e+00, %.577.i.i9920
  %invariant.gep.i9923 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.466.01299.i.i
  br label %B122.if.i.i.i9924

B122.if.i.i.i9924:                                ; preds = %B122.if.i.i.i9924, %B122.if.i.lr.ph.i.i
  %.229.i.01296.i.i = phi i64 [ 0, %B122.if.i.lr.ph.i.i ], [ %.300.i.i.i9931, %B122.if.i.i.i9924 ]
  %.157.i.i.i.i9925 = add nsw i64 %.229.i.01296.i.i, %.155.i.i.i.i9868
  %.159.i.i.i.i9926 = mul nsw i64 %.157.i.i.i.i9925, %arg.shape.0
  %gep.i9927 = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.i.i9926
  %.191.i.i.i.i9928 = load double, ptr %gep.i9927, align 8, !noalias !235
  %.193.i.i.i.i9929 = fadd double %.191.i.i.i.i9928, 0.000000e+00
  %.253.i.i.i.i9930 = fmul double %.577.i.i9920, %.193.i.i.i.i9929
  %.157.i.i.1.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.1.i.i
  %.159.i.i.1.i.i = mul nsw i64 %.157.i.i.1.i.i, %arg.shape.0
  %gep611.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.1.i.i
  %.191.i.i.1.i.i = load double, ptr %gep611.i, align 8, !noalias !235
  %.193.i.i.1.i.i = fadd double %.191.i.i.1.i.i, %.253.i.i.i.i9930
  %.253.i.i.1.i.i = fmul double %.247.i.i.i.i9922, %.193.i.i.1.i.i
  %.157.i.i.2.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.2.i.i
  %.159.i.i.2.i.i = mul nsw i64 %.157.i.i.2.i.i, %arg.shape.0
  %gep613.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.2.i.i
  %.191.i.i.2.i.i = load double, ptr %gep613.i, align 8, !noalias !235
  %.193.i.i.2.i.i = fadd double %.191.i.i.2.i.i, %.253.i.i.1.i.i
  %.253.i.i.2.i.i = fmul double %.577.i.i9920, %.193.i.i.2.i.i
  %.157.i.i.3.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.3.i.i
  %.159.i.i.3.i.i = mul nsw i64 %.157.i.i.3.i.i, %arg.shape.0
  %gep615.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.3.i.i
  %.191.i.i.3.i.i = load double, ptr %gep615.i, align 8, !noalias !235
  %.193.i.i.3.i.i = fadd double %.191.i.i.3.i.i, %.253.i.i.2.i.i
  %.253.i.i.3.i.i = fmul double %.247.i.i.i.i9922, %.193.i.i.3.i.i
  %.157.i.i.4.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.4.i.i
  %.159.i.i.4.i.i = mul nsw i64 %.157.i.i.4.i.i, %arg.shape.0
  %gep617.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.4.i.i
  %.191.i.i.4.i.i = load double, ptr %gep617.i, align 8, !noalias !235
  %.193.i.i.4.i.i = fadd double %.191.i.i.4.i.i, %.253.i.i.3.i.i
  %.253.i.i.4.i.i = fmul double %.577.i.i9920, %.193.i.i.4.i.i
  %.157.i.i.5.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.5.i.i
  %.159.i.i.5.i.i = mul nsw i64 %.157.i.i.5.i.i, %arg.shape.0
  %gep619.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.5.i.i
  %.191.i.i.5.i.i = load double, ptr %gep619.i, align 8, !noalias !235
  %.193.i.i.5.i.i = fadd double %.191.i.i.5.i.i, %.253.i.i.4.i.i
  %.253.i.i.5.i.i = fmul double %.247.i.i.i.i9922, %.193.i.i.5.i.i
  %.157.i.i.6.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.6.i.i
  %.159.i.i.6.i.i = mul nsw i64 %.157.i.i.6.i.i, %arg.shape.0
  %gep621.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.159.i.i.6.i.i
  %.191.i.i.6.i.i = load double, ptr %gep621.i, align 8, !noalias !235
  %.193.i.i.6.i.i = fadd double %.191.i.i.6.i.i, %.253.i.i.5.i.i
  %.253.i.i.6.i.i = fmul double %.577.i.i9920, %.193.i.i.6.i.i
  %.300.i.i.i9931 = add nsw i64 %.229.i.01296.i.i, 1
  %.271.i.i.i.i9932 = mul nsw i64 %.229.i.01296.i.i, %arg.shape.0
  %gep623.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.271.i.i.i.i9932
  %.309.i.i.i.i9933 = load double, ptr %gep623.i, align 8, !noalias !235
  %.313.i.i.i.i9934 = fadd double %.309.i.i.i.i9933, %.253.i.i.6.i.i
  %.359.i.i.i9935 = add nsw i64 %.229.i.01296.i.i, %.358.i.i.i9867
  %.361.i.i.i9936 = mul nsw i64 %.359.i.i.i9935, %arg.shape.0
  %gep625.i = getelementptr double, ptr %invariant.gep.i9923, i64 %.361.i.i.i9936
  store double %.313.i.i.i.i9934, ptr %gep625.i, align 8, !noalias !231
  %exitcond.not.i.i9937 = icmp eq i64 %arg.shape.1, %.300.i.i.i9931
  br i1 %exitcond.not.i.i9937, label %B290.loopexit.i.i, label %B122.if.i.i.i9924

B1340.endif.endif.i.i:                            ; preds = %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %.1857.not.i.i, label %B1492.i.i, label %B1380.i.i

_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1548.loopexit.i.i, %B600.i.i
  %.514.0.i = phi i1 [ %338, %B1548.loopexit.i.i ], [ true, %B600.i.i ], [ true, %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %excinfo.1.0.i = phi ptr [ null, %B1548.loopexit.i.i ], [ null, %B600.i.i ], [ %excinfo.3.3.i.i, %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %common.ret.op.i.i.not = phi i1 [ false, %B1548.loopexit.i.i ], [ false, %B600.i.i ], [ true, %_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %brmerge10234 = select i1 %common.ret.op.i.i.not, i1 true, i1 %.514.0.i, !prof !97
  %brmerge10235 = or i1 %.5221298.not.i.i, %brmerge10234
  %excinfo.1.0.i.mux.mux = select i1 %common.ret.op.i.i.not, ptr %excinfo.1.0.i, ptr %excinfo.14.0, !prof !239
  %.mux.mux = zext i1 %common.ret.op.i.i.not to i32
  br i1 %brmerge10235, label %_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B306.if.i, !prof !240

B358.i:                                           ; preds = %B306.if.i
  %340 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.637.0627.i
  %.84.i.i9876 = load i64, ptr %340, align 8, !noalias !241
  %.89.i.i9877 = icmp sgt i64 %.84.i.i9876, -1
  br i1 %.89.i.i9877, label %B46.i.i9878, label %B358.endif.i

B46.i.i9878:                                      ; preds = %B358.i
  %.120.i.i9879 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i9876
  %.121.i.i9880 = load i64, ptr %.120.i.i9879, align 8, !noalias !241
  %.122.i.i9881 = icmp eq i64 %.121.i.i9880, 0
  br i1 %.122.i.i9881, label %B80.i.i9882, label %B358.endif.i

B80.i.i9882:                                      ; preds = %B46.i.i9878
  store i64 4, ptr %.120.i.i9879, align 8, !noalias !241
  br label %B358.endif.i

B448.i9875:                                       ; preds = %B358.endif.i, %B306.if.i
  %exitcond630.not.i = icmp eq i64 %.706.i, %arg.shape.0
  br i1 %exitcond630.not.i, label %_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B306.if.i

B150.if.i:                                        ; preds = %B3896, %B150.if.i
  %.363.0606.i = phi i64 [ %.432.i, %B150.if.i ], [ 0, %B3896 ]
  %.432.i = add nsw i64 %.363.0606.i, 1
  %gep10394 = getelementptr double, ptr %invariant.gep10393, i64 %.363.0606.i
  store double 1.000000e-09, ptr %gep10394, align 8, !noalias !208
  %exitcond.not.i9864 = icmp eq i64 %arg.shape.0, %.432.i
  br i1 %exitcond.not.i9864, label %B150.if.1.i, label %B150.if.i

B306.if.i:                                        ; preds = %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, %B448.i9875
  %.637.0627.i = phi i64 [ %.706.i, %B448.i9875 ], [ 0, %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  %.706.i = add nsw i64 %.637.0627.i, 1
  %341 = getelementptr i64, ptr %74, i64 %.637.0627.i
  %.784.i = load i64, ptr %341, align 8, !noalias !208
  %.785.i = icmp sgt i64 %.784.i, -1
  br i1 %.785.i, label %B358.i, label %B448.i9875

B358.endif.i:                                     ; preds = %B80.i.i9882, %B46.i.i9878, %B358.i
  %342 = getelementptr double, ptr %75, i64 %.637.0627.i
  store double 0.000000e+00, ptr %342, align 8, !noalias !208
  br label %B448.i9875

_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %B448.i9875, %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %excinfo.14.3 = phi ptr [ %excinfo.1.0.i.mux.mux, %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %excinfo.14.0, %B448.i9875 ]
  %common.ret.op.i9873 = phi i32 [ %.mux.mux, %_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ 0, %B448.i9875 ]
  %.5042.not = icmp eq i32 %common.ret.op.i9873, 0
  br i1 %.5042.not, label %B3936, label %B3896.if, !prof !57

B3936:                                            ; preds = %_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3892
  %excinfo.14.2 = phi ptr [ %excinfo.14.0, %B3892 ], [ %excinfo.14.3, %_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ]
  br i1 %spec.select9803, label %B3940, label %B3982

B3940:                                            ; preds = %B3936
  call void @llvm.lifetime.start.p0(ptr nonnull %.833.i9945)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1589.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1648.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1853.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2538.i)
  store double 0.000000e+00, ptr %.833.i9945, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1589.i, i8 0, i64 24, i1 false), !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1648.i, i8 0, i64 24, i1 false), !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1853.i, i8 0, i64 24, i1 false), !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.2538.i, i8 0, i64 24, i1 false), !noalias !244
  %.264.i9947 = load i64, ptr %.263.i9946, align 8, !noalias !244
  %.265.i9948 = icmp sgt i64 %.264.i9947, 1000
  br i1 %.265.i9948, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B112.i

B112.i:                                           ; preds = %B3940
  %.342.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !244
  %.396.i = load double, ptr %.395.i9949, align 8, !noalias !244
  %.450.i = load i64, ptr %arg.batch.4.1.4, align 8, !noalias !244
  %.513.i9951 = load double, ptr %.512.i9950, align 8, !noalias !244
  %.514.i = fmul double %.513.i9951, 6.000000e+00
  %.10.i.i9952 = fcmp ogt double %.514.i, 5.000000e+01
  %.11.i.i9953 = select i1 %.10.i.i9952, double %.514.i, double 5.000000e+01
  %.601.i = load i64, ptr %.600.i, align 8, !noalias !244
  %.645.i = fmul double %.11.i.i9953, 2.000000e+00
  %.749.i = icmp slt i64 %.450.i, 0
  %.750.i = select i1 %.749.i, i64 %arg.batch.3.3.5.0, i64 0
  %.751.i = add i64 %.750.i, %.450.i
  %.771.i = mul i64 %.751.i, %arg.batch.3.3.5.1
  %343 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.771.i
  %.775.i = getelementptr i8, ptr %343, i64 8
  br label %B424.i9954

B424.i9954:                                       ; preds = %B622.i, %B112.i
  %largest.2.0.i = phi double [ 0.000000e+00, %B112.i ], [ %largest.3.2.i, %B622.i ]
  %place.4.0.i = phi i64 [ 0, %B112.i ], [ %.666.sroa.5.0.i, %B622.i ]
  %done.4.0.i = phi i64 [ %.601.i, %B112.i ], [ %.666.sroa.10.0.i, %B622.i ]
  %excinfo.2.0.i = phi ptr [ null, %B112.i ], [ %excinfo.2.1.i, %B622.i ]
  %.104.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !248
  %.157.i.i = load double, ptr %.395.i9949, align 8, !noalias !248
  %.169.i.i = icmp slt i64 %place.4.0.i, 4
  br i1 %.169.i.i, label %B132.i.i, label %B160.i.i

B132.i.i:                                         ; preds = %B424.i9954
  %switch.tableidx10572 = add i64 %place.4.0.i, 4
  %344 = icmp ult i64 %switch.tableidx10572, 8
  br i1 %344, label %switch.lookup10573, label %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i

switch.lookup10573:                               ; preds = %B132.i.i
  %switch.gep10574 = getelementptr inbounds double, ptr @switch.table.advance_of_many.17, i64 %switch.tableidx10572
  %switch.load10575 = load double, ptr %switch.gep10574, align 8
  br label %B160.i.i

B160.i.i:                                         ; preds = %switch.lookup10573, %B424.i9954
  %"$phi160.0.2.i.0.i" = phi double [ 1.000000e+00, %B424.i9954 ], [ %switch.load10575, %switch.lookup10573 ]
  %.223.i.i = icmp slt i64 %done.4.0.i, %arg.batch.2.5.0
  %or.cond.i9955 = select i1 %.210.i.i, i1 %.223.i.i, i1 false
  br i1 %or.cond.i9955, label %B224.i.i, label %B300.i.i

B224.i.i:                                         ; preds = %B160.i.i
  %.239.i.i10022 = icmp slt i64 %done.4.0.i, 0
  %.240.i.i = select i1 %.239.i.i10022, i64 %arg.batch.2.5.0, i64 0
  %345 = getelementptr double, ptr %arg.batch.2.4, i64 %done.4.0.i
  %.254.i.i = getelementptr double, ptr %345, i64 %.240.i.i
  %.255.i.i = load double, ptr %.254.i.i, align 8, !noalias !248
  %.258.i.i10023 = fmul double %.157.i.i, %"$phi160.0.2.i.0.i"
  %.260.i.i10024 = fadd double %.104.i.i, %.258.i.i10023
  %.261.i.i = fcmp olt double %.255.i.i, %.260.i.i10024
  br i1 %.261.i.i, label %B260.i.i, label %B300.i.i

B260.i.i:                                         ; preds = %B224.i.i
  %.299.i.i = fsub double %.255.i.i, %.104.i.i
  %.306.i.i = fdiv double %.299.i.i, %.157.i.i
  %.310.i.i = add nsw i64 %done.4.0.i, 1
  br label %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i

B300.i.i:                                         ; preds = %B224.i.i, %B160.i.i
  %.331.i.i = add nsw i64 %place.4.0.i, 1
  br label %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i

_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i: ; preds = %B132.i.i, %B300.i.i, %B260.i.i
  %.666.sroa.10.0.i = phi i64 [ %done.4.0.i, %B300.i.i ], [ %.310.i.i, %B260.i.i ], [ 0, %B132.i.i ]
  %.666.sroa.5.0.i = phi i64 [ %.331.i.i, %B300.i.i ], [ %place.4.0.i, %B260.i.i ], [ 0, %B132.i.i ]
  %.666.sroa.0.0.i = phi double [ %"$phi160.0.2.i.0.i", %B300.i.i ], [ %.306.i.i, %B260.i.i ], [ 0.000000e+00, %B132.i.i ]
  %excinfo.2.1.i = phi ptr [ %excinfo.2.0.i, %B300.i.i ], [ %excinfo.2.0.i, %B260.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.127, %B132.i.i ]
  %.691.i9956 = phi i1 [ false, %B300.i.i ], [ false, %B260.i.i ], [ true, %B132.i.i ]
  %.6841.i = phi i32 [ 0, %B300.i.i ], [ 0, %B260.i.i ], [ 1, %B132.i.i ]
  br i1 %.691.i9956, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B424.endif.i, !prof !97

B482.i:                                           ; preds = %B424.endif.i
  %.776.i = load i64, ptr %.775.i, align 8, !noalias !244
  %.777.i9957 = add nsw i64 %.776.i, 1
  store i64 %.777.i9957, ptr %.775.i, align 8, !noalias !244
  store double 0.000000e+00, ptr %.833.i9945, align 8, !noalias !244
  call fastcc void @_ZN5pages10rate_jumps9put_ratesB3v56B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_287_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.833.i9945, double %.666.sroa.0.0.i, ptr readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.870.i9958 = load double, ptr %.833.i9945, align 8, !noalias !244
  %.10.i3221.i = fcmp ogt double %.870.i9958, %largest.2.0.i
  %.11.i3222.i = select i1 %.10.i3221.i, double %.870.i9958, double %largest.2.0.i
  br label %B622.i

B622.i:                                           ; preds = %B424.endif.i, %B482.i
  %largest.3.2.i = phi double [ %.11.i3222.i, %B482.i ], [ %largest.2.0.i, %B424.endif.i ]
  %.943.i = fcmp ugt double %largest.3.2.i, %.645.i
  %or.cond3219.i = select i1 %.724.i, i1 true, i1 %.943.i
  br i1 %or.cond3219.i, label %B662.i, label %B424.i9954

B662.i:                                           ; preds = %B622.i
  %.1023.i = load double, ptr %.512.i9950, align 8, !noalias !244
  %.1024.i = fmul double %.1023.i, 1.500000e+00
  %.1025.i = fadd double %.1024.i, 5.000000e+01
  %.10.i3223.i = fcmp olt double %.1025.i, %largest.3.2.i
  %.11.i3224.i = select i1 %.10.i3223.i, double %.1025.i, double %largest.3.2.i
  %.1055.i = fsub double %.11.i3224.i, %.1023.i
  %.1056.i = fmul double %.1055.i, 2.500000e-01
  %.1057.i = fadd double %.1023.i, %.1056.i
  %.1063.i = fcmp ugt double %largest.3.2.i, %.11.i.i9953
  br i1 %.1063.i, label %B824.i, label %B786.i

B786.i:                                           ; preds = %B662.i
  store double %.1057.i, ptr %.512.i9950, align 8, !noalias !244
  br label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B824.i:                                           ; preds = %B662.i
  %.156.i3225.i = load double, ptr %.395.i9949, align 8, !noalias !252
  %.93.i.i.i9960 = load double, ptr %arg.batch.4.0.4, align 8, !noalias !255
  %.149.i.i.i9961 = fmul double %.156.i3225.i, 0.000000e+00
  %.150.i.i.i9962 = fadd double %.93.i.i.i9960, %.149.i.i.i9961
  store double %.150.i.i.i9962, ptr %.577, align 8, !noalias !255
  br i1 %.287.i531.not.i.i, label %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i.critedge, label %B122.if.i.i.i9965

B122.if.i.i.i9965:                                ; preds = %B824.i, %B122.if.i.i.i9965
  %.229.i.0532.i.i = phi i64 [ %.300.i.i.i9984, %B122.if.i.i.i9965 ], [ 0, %B824.i ]
  %346 = getelementptr double, ptr %76, i64 %.229.i.0532.i.i
  %.191.i.i.i.i9966 = load double, ptr %346, align 8, !noalias !259
  %.193.i.i.i.i9967 = fadd double %.191.i.i.i.i9966, 0.000000e+00
  %.253.i.i.i.i9968 = fmul double %.193.i.i.i.i9967, 0.000000e+00
  %347 = getelementptr double, ptr %77, i64 %.229.i.0532.i.i
  %.191.i.i.1.i.i9969 = load double, ptr %347, align 8, !noalias !259
  %.193.i.i.1.i.i9970 = fadd double %.191.i.i.1.i.i9969, %.253.i.i.i.i9968
  %348 = getelementptr double, ptr %78, i64 %.229.i.0532.i.i
  %.191.i.i.2.i.i9971 = load double, ptr %348, align 8, !noalias !259
  %.193.i.i.2.i.i9972 = fadd double %.191.i.i.2.i.i9971, %.193.i.i.1.i.i9970
  %.253.i.i.2.i.i9973 = fmul double %.193.i.i.2.i.i9972, 0.000000e+00
  %349 = getelementptr double, ptr %79, i64 %.229.i.0532.i.i
  %.191.i.i.3.i.i9974 = load double, ptr %349, align 8, !noalias !259
  %.193.i.i.3.i.i9975 = fadd double %.191.i.i.3.i.i9974, %.253.i.i.2.i.i9973
  %350 = getelementptr double, ptr %80, i64 %.229.i.0532.i.i
  %.191.i.i.4.i.i9976 = load double, ptr %350, align 8, !noalias !259
  %.193.i.i.4.i.i9977 = fadd double %.191.i.i.4.i.i9976, %.193.i.i.3.i.i9975
  %.253.i.i.4.i.i9978 = fmul double %.193.i.i.4.i.i9977, 0.000000e+00
  %351 = getelementptr double, ptr %81, i64 %.229.i.0532.i.i
  %.191.i.i.5.i.i9979 = load double, ptr %351, align 8, !noalias !259
  %.193.i.i.5.i.i9980 = fadd double %.191.i.i.5.i.i9979, %.253.i.i.4.i.i9978
  %352 = getelementptr double, ptr %82, i64 %.229.i.0532.i.i
  %.191.i.i.6.i.i9981 = load double, ptr %352, align 8, !noalias !259
  %.193.i.i.6.i.i9982 = fadd double %.191.i.i.6.i.i9981, %.193.i.i.5.i.i9980
  %.253.i.i.6.i.i9983 = fmul double %.193.i.i.6.i.i9982, 0.000000e+00
  %.300.i.i.i9984 = add nsw i64 %.229.i.0532.i.i, 1
  %353 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.229.i.0532.i.i
  %.309.i.i.i.i9985 = load double, ptr %353, align 8, !noalias !259
  %.313.i.i.i.i9986 = fadd double %.309.i.i.i.i9985, %.253.i.i.6.i.i9983
  %354 = getelementptr i8, ptr %353, i64 %.idx550.i.i
  store double %.313.i.i.i.i9986, ptr %354, align 8, !noalias !255
  %exitcond.not.i.i9987 = icmp eq i64 %arg.shape.1, %.300.i.i.i9984
  br i1 %exitcond.not.i.i9987, label %B0.endif.i.i, label %B122.if.i.i.i9965

B0.endif.i.i:                                     ; preds = %B122.if.i.i.i9965
  %.227.i.i = load i64, ptr %arg.code.4, align 8, !noalias !252
  %.339.i.i9989 = inttoptr i64 %.227.i.i to ptr
  tail call void %.339.i.i9989(ptr nonnull %.577, ptr %.313.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.338.i.i), !noalias !252
  br label %B296.if.i.i

B296.if.i.i:                                      ; preds = %B0.endif.i.i, %B296.if.i.i
  %.365.0539.i.i = phi i64 [ %.434.i.i, %B296.if.i.i ], [ 0, %B0.endif.i.i ]
  %.488.i.i9990 = load double, ptr %.487.i.i, align 8, !noalias !252
  %.518.i.i9991 = load double, ptr %arg.tolerances.4, align 8, !noalias !252
  %355 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.365.0539.i.i
  %.548.i.i9992 = load double, ptr %355, align 8, !noalias !252
  %.549.i.i9993 = tail call double @llvm.fabs.f64(double %.548.i.i9992)
  %356 = getelementptr double, ptr %355, i64 %.296.i.i
  %.582.i.i9994 = load double, ptr %356, align 8, !noalias !252
  %.583.i.i = tail call double @llvm.fabs.f64(double %.582.i.i9994)
  %.10.i.i.i9995 = fcmp ogt double %.583.i.i, %.549.i.i9993
  %.11.i.i.i9996 = select i1 %.10.i.i.i9995, double %.583.i.i, double %.549.i.i9993
  %.612.i.i = fmul double %.518.i.i9991, %.11.i.i.i9996
  %.613.i.i = fadd double %.488.i.i9990, %.612.i.i
  %357 = getelementptr double, ptr %355, i64 %.298.i.i9988
  %.646.i.i9997 = load double, ptr %357, align 8, !noalias !252
  %.648.i.i = fmul double %.156.i3225.i, %.646.i.i9997
  %.652.i3226.i = fdiv double %.648.i.i, %.613.i.i
  %358 = getelementptr i8, ptr %355, i64 %.296.i.i
  store double %.652.i3226.i, ptr %358, align 8, !noalias !252
  %.434.i.i = add nsw i64 %.365.0539.i.i, 1
  %exitcond543.not.i.i = icmp eq i64 %arg.shape.1, %.434.i.i
  br i1 %exitcond543.not.i.i, label %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B296.if.i.i

_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i.critedge: ; preds = %B824.i
  %.227.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !252
  %.339.i.i9989.c = inttoptr i64 %.227.i.i.c to ptr
  tail call void %.339.i.i9989.c(ptr nonnull %.577, ptr %.313.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.338.i.i), !noalias !252
  br label %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i

_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %B296.if.i.i, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i.critedge
  %.1260.i = load i64, ptr %.600.i, align 8, !noalias !244
  br label %B962.i

B962.i:                                           ; preds = %B1494.i, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %share.4.1.i = phi double [ 0.000000e+00, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %.1371.sroa.0.0.i, %B1494.i ]
  %place.5.1.i = phi i64 [ 0, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %.1371.sroa.5.0.i, %B1494.i ]
  %done.5.1.i = phi i64 [ %.1260.i, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %.1371.sroa.10.0.i, %B1494.i ]
  %excinfo.7.0.i = phi ptr [ null, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %excinfo.7.1.i, %B1494.i ]
  %.104.i66.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !263
  %.157.i92.i = load double, ptr %.395.i9949, align 8, !noalias !263
  %.169.i96.i = icmp slt i64 %place.5.1.i, 4
  br i1 %.169.i96.i, label %B132.i203.i, label %B160.i99.i

B132.i203.i:                                      ; preds = %B962.i
  %switch.tableidx10576 = add i64 %place.5.1.i, 4
  %359 = icmp ult i64 %switch.tableidx10576, 8
  br i1 %359, label %switch.lookup10577, label %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i

switch.lookup10577:                               ; preds = %B132.i203.i
  %switch.gep10578 = getelementptr inbounds double, ptr @switch.table.advance_of_many.17, i64 %switch.tableidx10576
  %switch.load10579 = load double, ptr %switch.gep10578, align 8
  br label %B160.i99.i

B160.i99.i:                                       ; preds = %switch.lookup10577, %B962.i
  %"$phi160.0.2.i39.0.i" = phi double [ 1.000000e+00, %B962.i ], [ %switch.load10579, %switch.lookup10577 ]
  %.223.i130.i = icmp slt i64 %done.5.1.i, %arg.batch.2.5.0
  %or.cond3220.i = select i1 %.210.i.i, i1 %.223.i130.i, i1 false
  br i1 %or.cond3220.i, label %B224.i131.i, label %B300.i107.i

B224.i131.i:                                      ; preds = %B160.i99.i
  %.239.i140.i = icmp slt i64 %done.5.1.i, 0
  %.240.i141.i = select i1 %.239.i140.i, i64 %arg.batch.2.5.0, i64 0
  %360 = getelementptr double, ptr %arg.batch.2.4, i64 %done.5.1.i
  %.254.i151.i = getelementptr double, ptr %360, i64 %.240.i141.i
  %.255.i152.i = load double, ptr %.254.i151.i, align 8, !noalias !263
  %.258.i155.i = fmul double %.157.i92.i, %"$phi160.0.2.i39.0.i"
  %.260.i157.i = fadd double %.104.i66.i, %.258.i155.i
  %.261.i158.i = fcmp olt double %.255.i152.i, %.260.i157.i
  br i1 %.261.i158.i, label %B260.i159.i, label %B300.i107.i

B260.i159.i:                                      ; preds = %B224.i131.i
  %.299.i184.i = fsub double %.255.i152.i, %.104.i66.i
  %.306.i189.i = fdiv double %.299.i184.i, %.157.i92.i
  %.310.i192.i = add nsw i64 %done.5.1.i, 1
  br label %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i

B300.i107.i:                                      ; preds = %B224.i131.i, %B160.i99.i
  %.331.i112.i = add nsw i64 %place.5.1.i, 1
  br label %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i

_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i: ; preds = %B132.i203.i, %B300.i107.i, %B260.i159.i
  %.1371.sroa.10.0.i = phi i64 [ %done.5.1.i, %B300.i107.i ], [ %.310.i192.i, %B260.i159.i ], [ 0, %B132.i203.i ]
  %.1371.sroa.5.0.i = phi i64 [ %.331.i112.i, %B300.i107.i ], [ %place.5.1.i, %B260.i159.i ], [ 0, %B132.i203.i ]
  %.1371.sroa.0.0.i = phi double [ %"$phi160.0.2.i39.0.i", %B300.i107.i ], [ %.306.i189.i, %B260.i159.i ], [ 0.000000e+00, %B132.i203.i ]
  %excinfo.7.1.i = phi ptr [ %excinfo.7.0.i, %B300.i107.i ], [ %excinfo.7.0.i, %B260.i159.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.127, %B132.i203.i ]
  %.1396.i = phi i1 [ false, %B300.i107.i ], [ false, %B260.i159.i ], [ true, %B132.i203.i ]
  %.1389217.i = phi i32 [ 0, %B300.i107.i ], [ 0, %B260.i159.i ], [ 1, %B132.i203.i ]
  br i1 %.1396.i, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B962.endif.i, !prof !97

B1276.i:                                          ; preds = %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %.1795.i = load i64, ptr %.775.i, align 8, !noalias !244
  %.1796.i = add nsw i64 %.1795.i, 3
  store i64 %.1796.i, ptr %.775.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1853.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.1853.i, double %.1685.fca.0.load.i, double %.1685.fca.1.load.i, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.1890.fca.0.load.i = load double, ptr %.1853.i, align 8, !noalias !244
  %.1890.fca.1.load.i = load double, ptr %.fca.1.gep238.i, align 8, !noalias !244
  %.1890.fca.2.load.i = load double, ptr %.fca.2.gep239.i, align 8, !noalias !244
  %.1944.i = fcmp ogt double %.1890.fca.2.load.i, %.11.i3470.i
  br label %B1438.i

B1438.i:                                          ; preds = %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, %B1276.i
  %found.2.2.i = phi i1 [ %.1944.i, %B1276.i ], [ false, %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  %low.9.2.i = phi double [ %.1890.fca.0.load.i, %B1276.i ], [ %.1685.fca.0.load.i, %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  %high.8.2.i = phi double [ %.1890.fca.1.load.i, %B1276.i ], [ %.1685.fca.1.load.i, %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  br i1 %found.2.2.i, label %B1494.i, label %B1442.i

B1442.i:                                          ; preds = %B1438.i
  %.156.i3231.i = load double, ptr %.395.i9949, align 8, !noalias !267
  %.93.i.i3232.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !270
  %.149.i.i3233.i = fmul double %.1371.sroa.0.0.i, %.156.i3231.i
  %.150.i.i3234.i = fadd double %.93.i.i3232.i, %.149.i.i3233.i
  store double %.150.i.i3234.i, ptr %.577, align 8, !noalias !270
  br i1 %.287.i531.not.i.i, label %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit3339.critedge.i, label %B122.if.i.lr.ph.i3238.i

B122.if.i.lr.ph.i3238.i:                          ; preds = %B1442.i
  %.247.i.i.i.i10000 = fsub double 1.000000e+00, %.1371.sroa.0.0.i
  br label %B122.if.i.i3239.i

B122.if.i.i3239.i:                                ; preds = %B122.if.i.i3239.i, %B122.if.i.lr.ph.i3238.i
  %.229.i.0532.i3240.i = phi i64 [ 0, %B122.if.i.lr.ph.i3238.i ], [ %.300.i.i3266.i, %B122.if.i.i3239.i ]
  %361 = getelementptr double, ptr %83, i64 %.229.i.0532.i3240.i
  %.191.i.i.i3242.i = load double, ptr %361, align 8, !noalias !274
  %.193.i.i.i3243.i = fadd double %.191.i.i.i3242.i, 0.000000e+00
  %.253.i.i.i3244.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.i3243.i
  %362 = getelementptr double, ptr %84, i64 %.229.i.0532.i3240.i
  %.191.i.i.1.i3246.i = load double, ptr %362, align 8, !noalias !274
  %.193.i.i.1.i3247.i = fadd double %.191.i.i.1.i3246.i, %.253.i.i.i3244.i
  %.253.i.i.1.i.i10001 = fmul double %.247.i.i.i.i10000, %.193.i.i.1.i3247.i
  %363 = getelementptr double, ptr %85, i64 %.229.i.0532.i3240.i
  %.191.i.i.2.i3249.i = load double, ptr %363, align 8, !noalias !274
  %.193.i.i.2.i3250.i = fadd double %.191.i.i.2.i3249.i, %.253.i.i.1.i.i10001
  %.253.i.i.2.i3251.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.2.i3250.i
  %364 = getelementptr double, ptr %86, i64 %.229.i.0532.i3240.i
  %.191.i.i.3.i3253.i = load double, ptr %364, align 8, !noalias !274
  %.193.i.i.3.i3254.i = fadd double %.191.i.i.3.i3253.i, %.253.i.i.2.i3251.i
  %.253.i.i.3.i.i10002 = fmul double %.247.i.i.i.i10000, %.193.i.i.3.i3254.i
  %365 = getelementptr double, ptr %87, i64 %.229.i.0532.i3240.i
  %.191.i.i.4.i3256.i = load double, ptr %365, align 8, !noalias !274
  %.193.i.i.4.i3257.i = fadd double %.191.i.i.4.i3256.i, %.253.i.i.3.i.i10002
  %.253.i.i.4.i3258.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.4.i3257.i
  %366 = getelementptr double, ptr %88, i64 %.229.i.0532.i3240.i
  %.191.i.i.5.i3260.i = load double, ptr %366, align 8, !noalias !274
  %.193.i.i.5.i3261.i = fadd double %.191.i.i.5.i3260.i, %.253.i.i.4.i3258.i
  %.253.i.i.5.i.i10003 = fmul double %.247.i.i.i.i10000, %.193.i.i.5.i3261.i
  %367 = getelementptr double, ptr %89, i64 %.229.i.0532.i3240.i
  %.191.i.i.6.i3263.i = load double, ptr %367, align 8, !noalias !274
  %.193.i.i.6.i3264.i = fadd double %.191.i.i.6.i3263.i, %.253.i.i.5.i.i10003
  %.253.i.i.6.i3265.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.6.i3264.i
  %.300.i.i3266.i = add nsw i64 %.229.i.0532.i3240.i, 1
  %368 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.229.i.0532.i3240.i
  %.309.i.i.i3267.i = load double, ptr %368, align 8, !noalias !274
  %.313.i.i.i3268.i = fadd double %.309.i.i.i3267.i, %.253.i.i.6.i3265.i
  %369 = getelementptr i8, ptr %368, i64 %.idx550.i3390.i
  store double %.313.i.i.i3268.i, ptr %369, align 8, !noalias !270
  %exitcond.not.i3270.i = icmp eq i64 %arg.shape.1, %.300.i.i3266.i
  br i1 %exitcond.not.i3270.i, label %B0.endif.i3271.i, label %B122.if.i.i3239.i

B0.endif.i3271.i:                                 ; preds = %B122.if.i.i3239.i
  %.227.i3272.i = load i64, ptr %arg.code.4, align 8, !noalias !267
  %.339.i3277.i = inttoptr i64 %.227.i3272.i to ptr
  tail call void %.339.i3277.i(ptr nonnull %.577, ptr %.313.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.338.i.i), !noalias !267
  br label %B296.if.i3281.i

B296.if.i3281.i:                                  ; preds = %B296.if.i3281.i, %B0.endif.i3271.i
  %.365.0539.i3283.i = phi i64 [ 0, %B0.endif.i3271.i ], [ %.434.i3331.i, %B296.if.i3281.i ]
  %.488.i3284.i = load double, ptr %.487.i3401.i, align 8, !noalias !267
  %.518.i3285.i = load double, ptr %arg.tolerances.4, align 8, !noalias !267
  %370 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.365.0539.i3283.i
  %.548.i3286.i = load double, ptr %370, align 8, !noalias !267
  %.549.i3287.i = tail call double @llvm.fabs.f64(double %.548.i3286.i)
  %371 = getelementptr double, ptr %370, i64 %.296.i.i
  %.582.i3288.i = load double, ptr %371, align 8, !noalias !267
  %.583.i3289.i = tail call double @llvm.fabs.f64(double %.582.i3288.i)
  %.10.i.i3290.i = fcmp ogt double %.583.i3289.i, %.549.i3287.i
  %.11.i.i3291.i = select i1 %.10.i.i3290.i, double %.583.i3289.i, double %.549.i3287.i
  %.612.i3292.i = fmul double %.518.i3285.i, %.11.i.i3291.i
  %.613.i3293.i = fadd double %.488.i3284.i, %.612.i3292.i
  %372 = getelementptr double, ptr %370, i64 %.298.i.i9988
  %.646.i3294.i = load double, ptr %372, align 8, !noalias !267
  %.648.i3295.i = fmul double %.156.i3231.i, %.646.i3294.i
  %.652.i3296.i = fdiv double %.648.i3295.i, %.613.i3293.i
  %373 = getelementptr i8, ptr %370, i64 %.296.i.i
  store double %.652.i3296.i, ptr %373, align 8, !noalias !267
  %.434.i3331.i = add nsw i64 %.365.0539.i3283.i, 1
  %exitcond543.not.i3337.i = icmp eq i64 %arg.shape.1, %.434.i3331.i
  br i1 %exitcond543.not.i3337.i, label %B1494.i, label %B296.if.i3281.i

_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit3339.critedge.i: ; preds = %B1442.i
  %.227.i3272.c.i = load i64, ptr %arg.code.4, align 8, !noalias !267
  %.339.i3277.c.i = inttoptr i64 %.227.i3272.c.i to ptr
  tail call void %.339.i3277.c.i(ptr nonnull %.577, ptr %.313.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.338.i.i), !noalias !267
  br label %B1494.i

B1494.i:                                          ; preds = %B296.if.i3281.i, %_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit3339.critedge.i, %B1438.i
  %.2021.i = fcmp uge double %.1371.sroa.0.0.i, 1.000000e+00
  %brmerge.i = or i1 %.2021.i, %found.2.2.i
  br i1 %brmerge.i, label %B1512.i, label %B962.i

B1512.i:                                          ; preds = %B1494.i
  %not..2021.i = xor i1 %.2021.i, true
  %found.2.2.mux.i = or i1 %found.2.2.i, %not..2021.i
  br i1 %found.2.2.mux.i, label %B1828.if.i, label %B1516.i

B1516.i:                                          ; preds = %B1512.i
  store double %.1057.i, ptr %.512.i9950, align 8, !noalias !244
  %.2181.i = fcmp ogt double %largest.3.2.i, %.645.i
  br i1 %.2181.i, label %B1578.i, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B1578.i:                                          ; preds = %B1516.i
  %.2238.i = load double, ptr %.2237.i, align 8, !noalias !244
  %.2241.i = fcmp ogt double %.2238.i, 5.000000e-01
  br i1 %.2241.i, label %B1626.i, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B1626.i:                                          ; preds = %B1578.i
  %.2245.i = fmul double %.396.i, 5.000000e-01
  store double 0.000000e+00, ptr %.2237.i, align 8, !noalias !278
  store double 0.000000e+00, ptr %.2012, align 8, !noalias !278
  store double %.2245.i, ptr %.214.i.i, align 8, !noalias !278
  %.268.i.i10005 = load i64, ptr %arg.batch.4.1.4, align 8, !noalias !278
  %.294.i334.i = icmp slt i64 %.268.i.i10005, 0
  %.295.i335.i = select i1 %.294.i334.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i336.i = add i64 %.295.i335.i, %.268.i.i10005
  %.316.i350.i = mul i64 %.296.i336.i, %arg.batch.3.3.5.1
  %.320.i353.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i350.i
  %.321.i354.i = load i64, ptr %.320.i353.i, align 8, !noalias !278
  %.322.i.i = add nsw i64 %.321.i354.i, -1
  store i64 %.322.i.i, ptr %.320.i353.i, align 8, !noalias !278
  %.426.i.i10006 = load i64, ptr %arg.batch.4.1.4, align 8, !noalias !278
  %.452.i.i10007 = icmp slt i64 %.426.i.i10006, 0
  %.453.i.i10008 = select i1 %.452.i.i10007, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i10009 = add i64 %.453.i.i10008, %.426.i.i10006
  %.474.i.i10010 = mul i64 %.454.i.i10009, %arg.batch.3.3.5.1
  %374 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i10010
  %.478.i.i10011 = getelementptr i8, ptr %374, i64 24
  %.479.i.i10012 = load i64, ptr %.478.i.i10011, align 8, !noalias !278
  %.480.i.i10013 = add nsw i64 %.479.i.i10012, 1
  store i64 %.480.i.i10013, ptr %.478.i.i10011, align 8, !noalias !278
  br label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B1946.i:                                          ; preds = %B1924.if.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.110.i.i), !noalias !244
  %.107.i.i = fadd double %high.9.03481.i, %low.10.03480.i
  %.108.i.i = fmul double %.107.i.i, 5.000000e-01
  store double 0.000000e+00, ptr %.110.i.i, align 8, !noalias !281
  call fastcc void @_ZN5pages10rate_jumps9put_ratesB3v56B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_287_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.110.i.i, double %.108.i.i, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  br i1 %.287.i531.not.i.i, label %B392.i.i10020, label %B122.if.i.i10018

B392.i.i10020:                                    ; preds = %B122.if.i.i10018, %B1946.i
  %above.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B1946.i ], [ %.11.i279.i.i, %B122.if.i.i10018 ]
  %below.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B1946.i ], [ %.11.i.i3344.i, %B122.if.i.i10018 ]
  %.482.i.i = fcmp ult double %below.2.0.lcssa.i.i, %above.2.0.lcssa.i.i
  br i1 %.482.i.i, label %B34.i60.preheader.i.i, label %B34.i.preheader.i.i

B34.i.preheader.i.i:                              ; preds = %B392.i.i10020
  br i1 %.287.i531.not.i.i, label %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B34.if.i.i.i10021

B34.i60.preheader.i.i:                            ; preds = %B392.i.i10020
  br i1 %.287.i531.not.i.i, label %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B34.if.i130.i.i

B34.if.i.i.i10021:                                ; preds = %B34.i.preheader.i.i, %B34.if.i.i.i10021
  %.48.i.0287.i.i = phi i64 [ %.119.i.i.i, %B34.if.i.i.i10021 ], [ 0, %B34.i.preheader.i.i ]
  %.119.i.i.i = add nsw i64 %.48.i.0287.i.i, 1
  %375 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.48.i.0287.i.i
  %376 = getelementptr i8, ptr %375, i64 %.idx.i3342.i
  %.177.i.i.i = load double, ptr %376, align 8, !noalias !284
  %377 = getelementptr i8, ptr %375, i64 %.idx551.i3419.i
  store double %.177.i.i.i, ptr %377, align 8, !noalias !284
  %exitcond292.not.i.i = icmp eq i64 %arg.shape.1, %.119.i.i.i
  br i1 %exitcond292.not.i.i, label %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B34.if.i.i.i10021

B34.if.i130.i.i:                                  ; preds = %B34.i60.preheader.i.i, %B34.if.i130.i.i
  %.48.i18.0291.i.i = phi i64 [ %.119.i136.i.i, %B34.if.i130.i.i ], [ 0, %B34.i60.preheader.i.i ]
  %.119.i136.i.i = add nsw i64 %.48.i18.0291.i.i, 1
  %378 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.48.i18.0291.i.i
  %379 = getelementptr i8, ptr %378, i64 %.idx.i3342.i
  %.177.i106.i.i = load double, ptr %379, align 8, !noalias !288
  %380 = getelementptr i8, ptr %378, i64 %.296.i.i
  store double %.177.i106.i.i, ptr %380, align 8, !noalias !288
  %exitcond293.not.i.i = icmp eq i64 %arg.shape.1, %.119.i136.i.i
  br i1 %exitcond293.not.i.i, label %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B34.if.i130.i.i

B122.if.i.i10018:                                 ; preds = %B1946.i, %B122.if.i.i10018
  %below.2.0284.i.i = phi double [ %.11.i.i3344.i, %B122.if.i.i10018 ], [ 0.000000e+00, %B1946.i ]
  %above.2.0283.i.i = phi double [ %.11.i279.i.i, %B122.if.i.i10018 ], [ 0.000000e+00, %B1946.i ]
  %.183.0281.i.i = phi i64 [ %.252.i.i10019, %B122.if.i.i10018 ], [ 0, %B1946.i ]
  %.252.i.i10019 = add nsw i64 %.183.0281.i.i, 1
  %381 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.183.0281.i.i
  %382 = getelementptr i8, ptr %381, i64 %.idx.i3342.i
  %.309.i.i = load double, ptr %382, align 8, !noalias !281
  %383 = getelementptr i8, ptr %381, i64 %.296.i.i
  %.342.i.i = load double, ptr %383, align 8, !noalias !281
  %.343.i.i = fsub double %.309.i.i, %.342.i.i
  %.344.i.i = tail call double @llvm.fabs.f64(double %.343.i.i)
  %.10.i.i3343.i = fcmp ogt double %.344.i.i, %below.2.0284.i.i
  %.11.i.i3344.i = select i1 %.10.i.i3343.i, double %.344.i.i, double %below.2.0284.i.i
  %384 = getelementptr i8, ptr %381, i64 %.idx551.i3419.i
  %.408.i.i = load double, ptr %384, align 8, !noalias !281
  %.442.i.i = fsub double %.408.i.i, %.309.i.i
  %.443.i.i = tail call double @llvm.fabs.f64(double %.442.i.i)
  %.10.i278.i.i = fcmp ogt double %.443.i.i, %above.2.0283.i.i
  %.11.i279.i.i = select i1 %.10.i278.i.i, double %.443.i.i, double %above.2.0283.i.i
  %exitcond.not.i3345.i = icmp eq i64 %arg.shape.1, %.252.i.i10019
  br i1 %exitcond.not.i3345.i, label %B392.i.i10020, label %B122.if.i.i10018

_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %B34.if.i.i.i10021, %B34.if.i130.i.i, %B34.i60.preheader.i.i, %B34.i.preheader.i.i
  %.2748.sroa.5.0.i = phi double [ %.108.i.i, %B34.i.preheader.i.i ], [ %high.9.03481.i, %B34.if.i130.i.i ], [ %high.9.03481.i, %B34.i60.preheader.i.i ], [ %.108.i.i, %B34.if.i.i.i10021 ]
  %.2748.sroa.0.0.i = phi double [ %low.10.03480.i, %B34.i.preheader.i.i ], [ %.108.i.i, %B34.if.i130.i.i ], [ %.108.i.i, %B34.i60.preheader.i.i ], [ %low.10.03480.i, %B34.if.i.i.i10021 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.110.i.i), !noalias !244
  br label %B1994.i

B1994.i:                                          ; preds = %B1924.if.i, %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %low.11.1.i = phi double [ %.2748.sroa.0.0.i, %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %low.10.03480.i, %B1924.if.i ]
  %high.10.1.i = phi double [ %.2748.sroa.5.0.i, %_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %high.9.03481.i, %B1924.if.i ]
  %.2688.i = icmp ugt i64 %.2635.03479.i, 1
  br i1 %.2688.i, label %B1924.if.i, label %B1996.i

B1996.i:                                          ; preds = %B1994.i
  %.2883.i = load i64, ptr %.775.i, align 8, !noalias !244
  %.2886.i = add nsw i64 %.2883.i, 56
  store i64 %.2886.i, ptr %.775.i, align 8, !noalias !244
  %.2937.i = fmul double %.396.i, %high.10.1.i
  %.2939.i = fadd double %.342.i, %.2937.i
  store double %.2939.i, ptr %.2992.i, align 8, !noalias !244
  %.2996.i = fmul double %.396.i, %low.11.1.i
  %.2998.i = tail call double @llvm.fabs.f64(double %.342.i)
  %.2999.i = fmul double %.2998.i, 0x3D06849B86A12B9B
  %.3000.i = fcmp ole double %.2996.i, %.2999.i
  br i1 %.3000.i, label %B2184.i, label %B2248.i

B2184.i:                                          ; preds = %B1996.i
  %.3068.i = load double, ptr %.3067.i, align 8, !noalias !244
  %.3069.i = fcmp ult double %.2939.i, %.3068.i
  br i1 %.3069.i, label %B2248.i, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B2248.i:                                          ; preds = %B2184.i, %B1996.i
  %.3144.i = load double, ptr %.3143.i, align 8, !noalias !244
  %.3145.i = fcmp ogt double %.3144.i, 5.000000e-01
  br i1 %.3145.i, label %B2296.i, label %B2332.i

B2296.i:                                          ; preds = %B2248.i
  store double 0.000000e+00, ptr %.3143.i, align 8, !noalias !292
  store double 0.000000e+00, ptr %.2012, align 8, !noalias !292
  store double %.396.i, ptr %.214.i516.i, align 8, !noalias !292
  %.268.i549.i = load i64, ptr %arg.batch.4.1.4, align 8, !noalias !292
  %.294.i570.i = icmp slt i64 %.268.i549.i, 0
  %.295.i571.i = select i1 %.294.i570.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i572.i = add i64 %.295.i571.i, %.268.i549.i
  %.316.i589.i = mul i64 %.296.i572.i, %arg.batch.3.3.5.1
  %.320.i592.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i589.i
  %.321.i593.i = load i64, ptr %.320.i592.i, align 8, !noalias !292
  %.322.i594.i = add nsw i64 %.321.i593.i, -1
  store i64 %.322.i594.i, ptr %.320.i592.i, align 8, !noalias !292
  %.426.i650.i = load i64, ptr %arg.batch.4.1.4, align 8, !noalias !292
  %.452.i665.i = icmp slt i64 %.426.i650.i, 0
  %.453.i666.i = select i1 %.452.i665.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i667.i = add i64 %.453.i666.i, %.426.i650.i
  %.474.i681.i = mul i64 %.454.i667.i, %arg.batch.3.3.5.1
  %385 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i681.i
  %.478.i683.i = getelementptr i8, ptr %385, i64 24
  %.479.i684.i = load i64, ptr %.478.i683.i, align 8, !noalias !292
  %.480.i685.i = add nsw i64 %.479.i684.i, 1
  store i64 %.480.i685.i, ptr %.478.i683.i, align 8, !noalias !292
  br label %B2332.i

B2332.i:                                          ; preds = %B2296.i, %B2248.i
  %.396..2996.i = select i1 %.3000.i, double %.396.i, double %.2996.i
  store double %.396..2996.i, ptr %.3268.i, align 8, !noalias !244
  br i1 %.3000.i, label %B2384.i, label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B2384.i:                                          ; preds = %B2332.i
  %.115.i.i = load double, ptr %.2992.i, align 8, !noalias !295
  %.169.i826.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !295
  %.170.i.i = fsub double %.115.i.i, %.169.i826.i
  %.171.i827.i = fcmp ogt double %.170.i.i, 0.000000e+00
  br i1 %.171.i827.i, label %B114.i.i, label %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i

B114.i.i:                                         ; preds = %B2384.i
  %.229.i.i10014 = load double, ptr %.395.i9949, align 8, !noalias !295
  %.230.i858.i = fmul double %.229.i.i10014, 1.000000e-08
  %.285.i895.i = tail call double @llvm.fabs.f64(double %.169.i826.i)
  %.286.i896.i = fmul double %.285.i895.i, 4.000000e-15
  %.287.i897.i = fadd double %.286.i896.i, %.230.i858.i
  %.289.i899.i = fcmp ugt double %.170.i.i, %.287.i897.i
  br i1 %.289.i899.i, label %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i, label %B240.i.i

B240.i.i:                                         ; preds = %B114.i.i
  %.410.i948.i = load double, ptr %.409.i947.i, align 8, !noalias !295
  %.411.i949.i = fsub double %.115.i.i, %.410.i948.i
  %.441.i960.i = load double, ptr %.440.i.i, align 8, !noalias !295
  %.471.i980.i = load double, ptr %arg.batch.2.4, align 8, !noalias !295
  %.474.i982.i = fsub double %.441.i960.i, %.471.i980.i
  %.475.i.i = fmul double %.474.i982.i, 0x3E7AD7F29ABCAF48
  %.476.i.i = fcmp olt double %.411.i949.i, %.475.i.i
  br i1 %.476.i.i, label %B390.i.i, label %B438.i.i10015

B390.i.i:                                         ; preds = %B240.i.i
  %.531.i.i = load i64, ptr %.263.i9946, align 8, !noalias !295
  %.532.i.i = add nsw i64 %.531.i.i, 1
  br label %B438.i.i10015

B438.i.i10015:                                    ; preds = %B390.i.i, %B240.i.i
  %"$phi438.0.2.i.0.i" = phi i64 [ %.532.i.i, %B390.i.i ], [ 0, %B240.i.i ]
  store i64 %"$phi438.0.2.i.0.i", ptr %.263.i9946, align 8, !noalias !295
  %.652.i.i = load double, ptr %.2992.i, align 8, !noalias !295
  store double %.652.i.i, ptr %arg.batch.4.0.4, align 8, !noalias !295
  store double %.652.i.i, ptr %.409.i947.i, align 8, !noalias !295
  store double 1.000000e+00, ptr %.813.i.i10016, align 8, !noalias !295
  store i64 2, ptr %.1180, align 8, !noalias !295
  br label %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i

_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i: ; preds = %B438.i.i10015, %B114.i.i, %B2384.i
  store double 0xFFF0000000000000, ptr %.2992.i, align 8, !noalias !295
  br label %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

B424.endif.i:                                     ; preds = %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i
  %.724.i = fcmp uge double %.666.sroa.0.0.i, 1.000000e+00
  br i1 %.724.i, label %B622.i, label %B482.i

B962.endif.i:                                     ; preds = %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i
  %.149.i.i3350.i = fmul double %.157.i92.i, %.1371.sroa.0.0.i
  %.150.i.i3351.i = fadd double %.104.i66.i, %.149.i.i3350.i
  store double %.150.i.i3351.i, ptr %.577, align 8, !noalias !298
  br i1 %.287.i531.not.i.i, label %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.critedge.i, label %B122.if.i.lr.ph.i3355.i

B122.if.i.lr.ph.i3355.i:                          ; preds = %B962.endif.i
  %.247.i.i.i3356.i = fsub double 1.000000e+00, %.1371.sroa.0.0.i
  br label %B122.if.i.i3357.i

B122.if.i.i3357.i:                                ; preds = %B122.if.i.i3357.i, %B122.if.i.lr.ph.i3355.i
  %.229.i.0532.i3358.i = phi i64 [ 0, %B122.if.i.lr.ph.i3355.i ], [ %.300.i.i3387.i, %B122.if.i.i3357.i ]
  %386 = getelementptr double, ptr %83, i64 %.229.i.0532.i3358.i
  %.191.i.i.i3360.i = load double, ptr %386, align 8, !noalias !304
  %.193.i.i.i3361.i = fadd double %.191.i.i.i3360.i, 0.000000e+00
  %.253.i.i.i3362.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.i3361.i
  %387 = getelementptr double, ptr %84, i64 %.229.i.0532.i3358.i
  %.191.i.i.1.i3364.i = load double, ptr %387, align 8, !noalias !304
  %.193.i.i.1.i3365.i = fadd double %.191.i.i.1.i3364.i, %.253.i.i.i3362.i
  %.253.i.i.1.i3366.i = fmul double %.247.i.i.i3356.i, %.193.i.i.1.i3365.i
  %388 = getelementptr double, ptr %85, i64 %.229.i.0532.i3358.i
  %.191.i.i.2.i3368.i = load double, ptr %388, align 8, !noalias !304
  %.193.i.i.2.i3369.i = fadd double %.191.i.i.2.i3368.i, %.253.i.i.1.i3366.i
  %.253.i.i.2.i3370.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.2.i3369.i
  %389 = getelementptr double, ptr %86, i64 %.229.i.0532.i3358.i
  %.191.i.i.3.i3372.i = load double, ptr %389, align 8, !noalias !304
  %.193.i.i.3.i3373.i = fadd double %.191.i.i.3.i3372.i, %.253.i.i.2.i3370.i
  %.253.i.i.3.i3374.i = fmul double %.247.i.i.i3356.i, %.193.i.i.3.i3373.i
  %390 = getelementptr double, ptr %87, i64 %.229.i.0532.i3358.i
  %.191.i.i.4.i3376.i = load double, ptr %390, align 8, !noalias !304
  %.193.i.i.4.i3377.i = fadd double %.191.i.i.4.i3376.i, %.253.i.i.3.i3374.i
  %.253.i.i.4.i3378.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.4.i3377.i
  %391 = getelementptr double, ptr %88, i64 %.229.i.0532.i3358.i
  %.191.i.i.5.i3380.i = load double, ptr %391, align 8, !noalias !304
  %.193.i.i.5.i3381.i = fadd double %.191.i.i.5.i3380.i, %.253.i.i.4.i3378.i
  %.253.i.i.5.i3382.i = fmul double %.247.i.i.i3356.i, %.193.i.i.5.i3381.i
  %392 = getelementptr double, ptr %89, i64 %.229.i.0532.i3358.i
  %.191.i.i.6.i3384.i = load double, ptr %392, align 8, !noalias !304
  %.193.i.i.6.i3385.i = fadd double %.191.i.i.6.i3384.i, %.253.i.i.5.i3382.i
  %.253.i.i.6.i3386.i = fmul double %.1371.sroa.0.0.i, %.193.i.i.6.i3385.i
  %.300.i.i3387.i = add nsw i64 %.229.i.0532.i3358.i, 1
  %393 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.229.i.0532.i3358.i
  %.309.i.i.i3388.i = load double, ptr %393, align 8, !noalias !304
  %.313.i.i.i3389.i = fadd double %.309.i.i.i3388.i, %.253.i.i.6.i3386.i
  %394 = getelementptr i8, ptr %393, i64 %.idx550.i3390.i
  store double %.313.i.i.i3389.i, ptr %394, align 8, !noalias !298
  %exitcond.not.i3391.i = icmp eq i64 %arg.shape.1, %.300.i.i3387.i
  br i1 %exitcond.not.i3391.i, label %B0.endif.i3392.i, label %B122.if.i.i3357.i

B0.endif.i3392.i:                                 ; preds = %B122.if.i.i3357.i
  %.227.i3393.i = load i64, ptr %arg.code.4, align 8, !noalias !308
  %.339.i3398.i = inttoptr i64 %.227.i3393.i to ptr
  tail call void %.339.i3398.i(ptr nonnull %.577, ptr %.313.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.338.i.i), !noalias !308
  br label %B296.if.i3403.i

B296.if.i3403.i:                                  ; preds = %B296.if.i3403.i, %B0.endif.i3392.i
  %.365.0539.i3405.i = phi i64 [ 0, %B0.endif.i3392.i ], [ %.434.i3461.i, %B296.if.i3403.i ]
  %.488.i3406.i = load double, ptr %.487.i3401.i, align 8, !noalias !308
  %.518.i3407.i = load double, ptr %arg.tolerances.4, align 8, !noalias !308
  %395 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.365.0539.i3405.i
  %.548.i3408.i = load double, ptr %395, align 8, !noalias !308
  %.549.i3409.i = tail call double @llvm.fabs.f64(double %.548.i3408.i)
  %396 = getelementptr double, ptr %395, i64 %.296.i.i
  %.582.i3410.i = load double, ptr %396, align 8, !noalias !308
  %.583.i3411.i = tail call double @llvm.fabs.f64(double %.582.i3410.i)
  %.10.i.i3412.i = fcmp ogt double %.583.i3411.i, %.549.i3409.i
  %.11.i.i3413.i = select i1 %.10.i.i3412.i, double %.583.i3411.i, double %.549.i3409.i
  %.612.i3414.i = fmul double %.518.i3407.i, %.11.i.i3413.i
  %.613.i3415.i = fadd double %.488.i3406.i, %.612.i3414.i
  %397 = getelementptr double, ptr %395, i64 %.298.i.i9988
  %.646.i3416.i = load double, ptr %397, align 8, !noalias !308
  %.648.i3417.i = fmul double %.157.i92.i, %.646.i3416.i
  %.652.i3418.i = fdiv double %.648.i3417.i, %.613.i3415.i
  %398 = getelementptr i8, ptr %395, i64 %.idx551.i3419.i
  store double %.652.i3418.i, ptr %398, align 8, !noalias !308
  %.434.i3461.i = add nsw i64 %.365.0539.i3405.i, 1
  %exitcond543.not.i3467.i = icmp eq i64 %arg.shape.1, %.434.i3461.i
  br i1 %exitcond543.not.i3467.i, label %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B296.if.i3403.i

_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.critedge.i: ; preds = %B962.endif.i
  %.227.i3393.c.i = load i64, ptr %arg.code.4, align 8, !noalias !308
  %.339.i3398.c.i = inttoptr i64 %.227.i3393.c.i to ptr
  tail call void %.339.i3398.c.i(ptr nonnull %.577, ptr %.313.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.338.i.i), !noalias !308
  br label %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i

_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %B296.if.i3403.i, %_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.critedge.i
  %.1532.i = load i64, ptr %.775.i, align 8, !noalias !244
  %.1533.i = add nsw i64 %.1532.i, 8
  store i64 %.1533.i, ptr %.775.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1589.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.1589.i, double %share.4.1.i, double %.1371.sroa.0.0.i, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.1626.fca.2.load.i = load double, ptr %.fca.2.gep283.i, align 8, !noalias !244
  %.1626.fca.1.load.i = load double, ptr %.fca.1.gep282.i, align 8, !noalias !244
  %.1626.fca.0.load.i = load double, ptr %.1589.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.1648.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.1648.i, double %.1626.fca.0.load.i, double %.1626.fca.1.load.i, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.1685.fca.0.load.i = load double, ptr %.1648.i, align 8, !noalias !244
  %.1685.fca.1.load.i = load double, ptr %.fca.1.gep276.i, align 8, !noalias !244
  %.1685.fca.2.load.i = load double, ptr %.fca.2.gep277.i, align 8, !noalias !244
  %.1713.i = fmul double %.1626.fca.2.load.i, 3.000000e-01
  %.10.i3469.i = fcmp ogt double %.1713.i, %.11.i.i9953
  %.11.i3470.i = select i1 %.10.i3469.i, double %.1713.i, double %.11.i.i9953
  %.1743.i = fcmp ogt double %.1685.fca.2.load.i, %.11.i3470.i
  br i1 %.1743.i, label %B1276.i, label %B1438.i

B1828.if.i:                                       ; preds = %B1512.i
  %.2374.i = load double, ptr %.2373.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.2538.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.2538.i, double %low.9.2.i, double %high.8.2.i, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.2575.fca.1.load.i = load double, ptr %.fca.1.gep131.i, align 8, !noalias !244
  %.2575.fca.0.load.i = load double, ptr %.2538.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.2538.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.2538.i, double %.2575.fca.0.load.i, double %.2575.fca.1.load.i, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.2575.fca.1.load.i.1 = load double, ptr %.fca.1.gep131.i, align 8, !noalias !244
  %.2575.fca.0.load.i.1 = load double, ptr %.2538.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.2538.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.2538.i, double %.2575.fca.0.load.i.1, double %.2575.fca.1.load.i.1, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.2575.fca.1.load.i.2 = load double, ptr %.fca.1.gep131.i, align 8, !noalias !244
  %.2575.fca.0.load.i.2 = load double, ptr %.2538.i, align 8, !noalias !244
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %.2538.i, i8 0, i64 24, i1 false), !noalias !244
  call fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.2538.i, double %.2575.fca.0.load.i.2, double %.2575.fca.1.load.i.2, ptr nonnull readonly %arg.code.4, i64 %arg.shape.1, ptr readonly %arg.tolerances.4, ptr nonnull %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4)
  %.2575.fca.1.load.i.3 = load double, ptr %.fca.1.gep131.i, align 8, !noalias !244
  %.2575.fca.0.load.i.3 = load double, ptr %.2538.i, align 8, !noalias !244
  %.2375.i = tail call double @llvm.fabs.f64(double %.2374.i)
  %.2376.i = fmul double %.2375.i, 4.000000e-16
  %.2381.i = fdiv double %.2376.i, %.396.i
  %.10.i3340.i = fcmp ogt double %.2381.i, 1.000000e-13
  %.11.i3341.i = select i1 %.10.i3340.i, double %.2381.i, double 1.000000e-13
  br label %B1924.if.i

B1924.if.i:                                       ; preds = %B1994.i, %B1828.if.i
  %high.9.03481.i = phi double [ %.2575.fca.1.load.i.3, %B1828.if.i ], [ %high.10.1.i, %B1994.i ]
  %low.10.03480.i = phi double [ %.2575.fca.0.load.i.3, %B1828.if.i ], [ %low.11.1.i, %B1994.i ]
  %.2635.03479.i = phi i64 [ 44, %B1828.if.i ], [ %.2697.i, %B1994.i ]
  %.2697.i = add nsw i64 %.2635.03479.i, -1
  %.2736.i = fsub double %high.9.03481.i, %low.10.03480.i
  %.2738.i = fcmp ogt double %.2736.i, %.11.i3341.i
  br i1 %.2738.i, label %B1946.i, label %B1994.i

_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i, %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i, %B2332.i, %B2184.i, %B1516.i, %B1578.i, %B1626.i, %B3940, %B786.i, %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i
  %excinfo.15.2 = phi ptr [ %excinfo.15.0, %B786.i ], [ %excinfo.15.0, %B2332.i ], [ %excinfo.7.1.i, %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i ], [ %excinfo.15.0, %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i ], [ %excinfo.15.0, %B2184.i ], [ %excinfo.15.0, %B1516.i ], [ %excinfo.15.0, %B3940 ], [ %excinfo.15.0, %B1626.i ], [ %excinfo.15.0, %B1578.i ], [ %excinfo.2.1.i, %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i ]
  %common.ret.op.i9959 = phi i32 [ 0, %B786.i ], [ 0, %B2332.i ], [ %.1389217.i, %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit216.i ], [ 0, %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit.i ], [ 0, %B2184.i ], [ 0, %B1516.i ], [ 0, %B3940 ], [ 0, %B1626.i ], [ 0, %B1578.i ], [ %.6841.i, %_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE.exit.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.833.i9945)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1589.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1648.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1853.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2538.i)
  %.5132.not = icmp eq i32 %common.ret.op.i9959, 0
  br i1 %.5132.not, label %B3982, label %B3940.if, !prof !57

B3982:                                            ; preds = %B3342, %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3936
  %excinfo.13.1 = phi ptr [ %excinfo.13.2, %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.13.2, %B3936 ], [ %excinfo.13.0, %B3342 ]
  %excinfo.14.1 = phi ptr [ %excinfo.14.2, %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.14.2, %B3936 ], [ %excinfo.14.0, %B3342 ]
  %excinfo.15.1 = phi ptr [ %excinfo.15.2, %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.15.0, %B3936 ], [ %excinfo.15.0, %B3342 ]
  %399 = select i1 %looked.2.1.lcssa, i1 %good.2.1.lcssa, i1 false
  br i1 %399, label %B3990, label %B4042

B3990:                                            ; preds = %B3982
  %brmerge9794.not = select i1 %within.5.1, i1 %.620, i1 false
  %"$phi4026.7.2.2" = select i1 %brmerge9794.not, i64 3, i64 0
  br i1 %.815, label %B4042, label %B96.if.i

B192.i:                                           ; preds = %B96.if.i
  %.442.i = getelementptr double, ptr %92, i64 %.182.0654.i
  %.443.i10030 = load double, ptr %.442.i, align 8, !noalias !309
  %.444.i10031 = fcmp olt double %.443.i10030, 5.000000e-01
  br i1 %.444.i10031, label %B899.i, label %B240.i10032

B240.i10032:                                      ; preds = %B192.i
  %.475.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.332.i
  %.476.i = load i64, ptr %.475.i, align 8, !noalias !309
  %.477.not.i = icmp eq i64 %.476.i, 0
  br i1 %.477.not.i, label %B286.i, label %B899.i

B286.i:                                           ; preds = %B240.i10032
  %.535.i10033 = mul i64 %.332.i, %arg.batch.3.3.5.1
  %400 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.535.i10033
  %.539.i = getelementptr i8, ptr %400, i64 8
  %.540.i = load i64, ptr %.539.i, align 8, !noalias !309
  %.542.i = add nsw i64 %.540.i, %"$phi4026.7.2.2"
  store i64 %.542.i, ptr %.539.i, align 8, !noalias !309
  %.640.i10034 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.182.0654.i
  %.641.i10035 = load double, ptr %.640.i10034, align 8, !noalias !309
  %.691.i10036 = getelementptr double, ptr %93, i64 %.182.0654.i
  %.692.i = load double, ptr %.691.i10036, align 8, !noalias !309
  %.742.i = getelementptr double, ptr %94, i64 %.182.0654.i
  %.743.i = load double, ptr %.742.i, align 8, !noalias !309
  %.764.i = icmp slt i64 %.383.i, %arg.batch.2.5.0
  br i1 %.764.i, label %B500.i, label %B860.i

B500.i:                                           ; preds = %B286.i
  %.787.i = icmp slt i64 %.383.i, 0
  %.788.i = select i1 %.787.i, i64 %arg.batch.2.5.0, i64 0
  %401 = getelementptr double, ptr %arg.batch.2.4, i64 %.383.i
  %.802.i = getelementptr double, ptr %401, i64 %.788.i
  %.803.i = load double, ptr %.802.i, align 8, !noalias !309
  %.807.i = fcmp ugt double %.803.i, %.743.i
  br i1 %.807.i, label %B860.i, label %B524.preheader.i

B524.preheader.i:                                 ; preds = %B500.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.332.i
  %.1290.i = getelementptr double, ptr %95, i64 %.182.0654.i
  %402 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep10411 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10413 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10415 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10417 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10419 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10421 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10423 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10425 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  %invariant.gep10427 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.182.0654.i
  br label %B524.i

B524.i:                                           ; preds = %B836.i, %B524.preheader.i
  %done.2.3.i = phi i64 [ %.1232.i, %B836.i ], [ %.383.i, %B524.preheader.i ]
  br i1 %.894649.not.i, label %B734.i, label %B554.if.lr.ph.i

B554.if.lr.ph.i:                                  ; preds = %B524.i
  %.949.i = icmp slt i64 %done.2.3.i, 0
  %.950.i = select i1 %.949.i, i64 %arg.batch.2.5.0, i64 0
  %403 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.964.i = getelementptr double, ptr %403, i64 %.950.i
  %.1190.i = select i1 %.949.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1191.i = add i64 %.1190.i, %done.2.3.i
  %.1220.i = mul i64 %.1191.i, %arg.batch.3.0.5.2
  %404 = getelementptr double, ptr %402, i64 %.1220.i
  br label %B554.if.i

B582.i10042:                                      ; preds = %B554.if.i
  %.972.i = add nsw i64 %.838.0650.i, %.970.i
  %.974.i = mul nsw i64 %.972.i, %arg.shape.0
  %gep10428 = getelementptr double, ptr %invariant.gep10427, i64 %.974.i
  %.1006.i = load double, ptr %gep10428, align 8, !noalias !309
  br label %B900.i

B734.i:                                           ; preds = %B900.i, %B524.i
  store double 0x7FF0000000000000, ptr %.1290.i, align 8, !noalias !309
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %96
  br i1 %exitcond656.not.i, label %B860.i, label %B836.i

B836.i:                                           ; preds = %B734.i
  %.1232.i = add i64 %done.2.3.i, 1
  %.1325.i = icmp slt i64 %done.2.3.i, -1
  %.1326.i = select i1 %.1325.i, i64 %arg.batch.2.5.0, i64 0
  %405 = getelementptr double, ptr %arg.batch.2.4, i64 %.1232.i
  %.1340.i = getelementptr double, ptr %405, i64 %.1326.i
  %.1341.i = load double, ptr %.1340.i, align 8, !noalias !309
  %.1345.i = fcmp ugt double %.1341.i, %.743.i
  br i1 %.1345.i, label %B860.i, label %B524.i

B860.i:                                           ; preds = %B836.i, %B734.i, %B500.i, %B286.i
  %done.3.2.i = phi i64 [ %.383.i, %B500.i ], [ %.383.i, %B286.i ], [ %arg.batch.2.5.0, %B734.i ], [ %.1232.i, %B836.i ]
  store i64 %done.3.2.i, ptr %.382.i, align 8, !noalias !309
  br label %B899.i

B899.i:                                           ; preds = %B96.if.i, %B860.i, %B240.i10032, %B192.i
  %exitcond657.not.i = icmp eq i64 %.254.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B4042, label %B96.if.i

B900.i:                                           ; preds = %B38.if.i.i, %B582.i10042
  %.313.i.i10040.sink = phi double [ %.313.i.i10040, %B38.if.i.i ], [ %.1006.i, %B582.i10042 ]
  %406 = getelementptr double, ptr %404, i64 %.838.0650.i
  store double %.313.i.i10040.sink, ptr %406, align 8, !noalias !309
  %exitcond.not.i10041 = icmp eq i64 %arg.shape.1, %.907.i
  br i1 %exitcond.not.i10041, label %B734.i, label %B554.if.i

B96.if.i:                                         ; preds = %B3990, %B899.i
  %.182.0654.i = phi i64 [ %.254.i, %B899.i ], [ 0, %B3990 ]
  %.254.i = add nsw i64 %.182.0654.i, 1
  %.331.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.182.0654.i
  %.332.i = load i64, ptr %.331.i, align 8, !noalias !309
  %.382.i = getelementptr i64, ptr %91, i64 %.182.0654.i
  %.383.i = load i64, ptr %.382.i, align 8, !noalias !309
  %.391.i = icmp slt i64 %.332.i, 0
  br i1 %.391.i, label %B899.i, label %B192.i

B554.if.i:                                        ; preds = %B900.i, %B554.if.lr.ph.i
  %.838.0650.i = phi i64 [ 0, %B554.if.lr.ph.i ], [ %.907.i, %B900.i ]
  %.907.i = add nsw i64 %.838.0650.i, 1
  %.965.i = load double, ptr %.964.i, align 8, !noalias !309
  %.967.i = fcmp oeq double %.965.i, %.743.i
  br i1 %.967.i, label %B582.i10042, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B554.if.i
  %.1115.i = fsub double %.965.i, %.641.i10035
  %.1120.i = fdiv double %.1115.i, %.692.i
  %.247.i.i = fsub double 1.000000e+00, %.1120.i
  %.157.i.i10037 = add nsw i64 %.838.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i10037, %arg.shape.0
  %gep10412 = getelementptr double, ptr %invariant.gep10411, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep10412, align 8, !noalias !312
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.1120.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.838.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep10414 = getelementptr double, ptr %invariant.gep10413, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep10414, align 8, !noalias !312
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.838.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep10416 = getelementptr double, ptr %invariant.gep10415, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep10416, align 8, !noalias !312
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1120.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.838.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep10418 = getelementptr double, ptr %invariant.gep10417, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep10418, align 8, !noalias !312
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.838.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep10420 = getelementptr double, ptr %invariant.gep10419, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep10420, align 8, !noalias !312
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1120.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.838.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep10422 = getelementptr double, ptr %invariant.gep10421, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep10422, align 8, !noalias !312
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.838.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep10424 = getelementptr double, ptr %invariant.gep10423, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep10424, align 8, !noalias !312
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1120.i, %.193.i.6.i
  %.271.i.i10038 = mul nsw i64 %.838.0650.i, %arg.shape.0
  %gep10426 = getelementptr double, ptr %invariant.gep10425, i64 %.271.i.i10038
  %.309.i.i10039 = load double, ptr %gep10426, align 8, !noalias !312
  %.313.i.i10040 = fadd double %.309.i.i10039, %.253.i.6.i
  br label %B900.i

B4042:                                            ; preds = %B899.i, %B3990, %B3982
  br i1 %.5280, label %B4102, label %B4054

B4054:                                            ; preds = %B4042
  %.5335 = load double, ptr %.5334, align 8
  %.5336 = fcmp ogt double %.5335, 5.000000e-01
  br i1 %.5336, label %B4102, label %B4180

B4102:                                            ; preds = %B4054, %B4042
  %.5367 = load i64, ptr %.5366, align 8
  %.5412 = inttoptr i64 %.5367 to ptr
  tail call void %.5412(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B4180

B4180:                                            ; preds = %B4102, %B4054
  %.not = xor i1 %212, true
  %brmerge10460 = or i1 %.815, %.not
  br i1 %brmerge10460, label %B4236, label %B80.if.i

B144.i:                                           ; preds = %B80.if.i
  %.345.i4031 = getelementptr double, ptr %98, i64 %.143.i3849.010436
  %.346.i4032 = load double, ptr %.345.i4031, align 8, !noalias !316
  %.347.i4033 = fcmp ogt double %.346.i4032, 5.000000e-01
  br i1 %.347.i4033, label %B194.i, label %B920.i

B194.i:                                           ; preds = %B144.i
  %.398.i4078 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.143.i3849.010436
  %.399.i4079 = load double, ptr %.398.i4078, align 8, !noalias !316
  %.449.i4124 = getelementptr double, ptr %99, i64 %.143.i3849.010436
  %.450.i4125 = load double, ptr %.449.i4124, align 8, !noalias !316
  %.451.i4126 = fsub double %.399.i4079, %.450.i4125
  br i1 %.538.i416410429.not, label %B510.i, label %B310.if.i.preheader

B310.if.i.preheader:                              ; preds = %B194.i
  %invariant.gep10618 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.143.i3849.010436
  %invariant.gep10620 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.143.i3849.010436
  br label %B310.if.i

B410.i:                                           ; preds = %B310.if.i
  %.582.i4592 = add nsw i64 %.482.i3864.010431, %arg.shape.1
  %.584.i4594 = mul nsw i64 %.582.i4592, %arg.shape.0
  %gep10619 = getelementptr double, ptr %invariant.gep10618, i64 %.584.i4594
  %.616.i4621 = load double, ptr %gep10619, align 8, !noalias !316
  %.617.i4622 = tail call double @llvm.fabs.f64(double %.616.i4621)
  %.619.i4624 = fmul double %.451.i4126, %.617.i4622
  %.660.i4654 = load double, ptr %.659.i4653, align 8, !noalias !316
  %.690.i4679 = load double, ptr %arg.tolerances.4, align 8, !noalias !316
  %.693.i4682 = mul nsw i64 %.482.i3864.010431, %arg.shape.0
  %gep10621 = getelementptr double, ptr %invariant.gep10620, i64 %.693.i4682
  %.727.i4711 = load double, ptr %gep10621, align 8, !noalias !316
  %.728.i4712 = tail call double @llvm.fabs.f64(double %.727.i4711)
  %.729.i4713 = fmul double %.690.i4679, %.728.i4712
  %.730.i4714 = fadd double %.660.i4654, %.729.i4713
  %.732.i4716 = fcmp ogt double %.619.i4624, %.730.i4714
  br label %B506.i

B506.i:                                           ; preds = %B410.i, %B310.if.i
  %"$phi506.2.2.i.3" = phi i1 [ true, %B310.if.i ], [ %.732.i4716, %B410.i ]
  %exitcond10494.not = icmp eq i64 %arg.shape.1, %.551.i4730
  br i1 %exitcond10494.not, label %B510.i.loopexit, label %B310.if.i

B510.i.loopexit:                                  ; preds = %B506.i
  %407 = select i1 %"$phi506.2.2.i.3", double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %B510.i

B510.i:                                           ; preds = %B510.i.loopexit, %B194.i
  %felt.2.i.2.lcssa = phi double [ 5.000000e-06, %B194.i ], [ %407, %B510.i.loopexit ]
  %.798.i4203 = load double, ptr %.797.i4202, align 8, !noalias !316
  %.828.i4226 = load double, ptr %arg.batch.2.4, align 8, !noalias !316
  %.829.i4227 = fsub double %.798.i4203, %.828.i4226
  %.831.i4229 = fmul double %felt.2.i.2.lcssa, %.829.i4227
  %.835.i4232 = fcmp olt double %.451.i4126, %.831.i4229
  br i1 %.835.i4232, label %B590.i, label %B638.i

B590.i:                                           ; preds = %B510.i
  %408 = getelementptr i64, ptr %101, i64 %.143.i3849.010436
  %.889.i4582 = load i64, ptr %408, align 8, !noalias !316
  %.890.i4583 = add nsw i64 %.889.i4582, 1
  br label %B638.i

B638.i:                                           ; preds = %B510.i, %B590.i
  %"$phi638.1.2.i.2" = phi i64 [ %.890.i4583, %B590.i ], [ 0, %B510.i ]
  %409 = getelementptr i64, ptr %102, i64 %.143.i3849.010436
  store i64 %"$phi638.1.2.i.2", ptr %409, align 8, !noalias !316
  %.1002.i4309 = load double, ptr %.398.i4078, align 8, !noalias !316
  store double %.1002.i4309, ptr %.449.i4124, align 8, !noalias !316
  %.1103.i4388 = getelementptr double, ptr %103, i64 %.143.i3849.010436
  store double 1.000000e+00, ptr %.1103.i4388, align 8, !noalias !316
  store i64 2, ptr %.1180, align 8, !noalias !316
  %.1185.i = load i64, ptr %409, align 8, !noalias !316
  %.1186.i = icmp sgt i64 %.1185.i, 1000
  br i1 %.1186.i, label %B864.i, label %B920.i

B864.i:                                           ; preds = %B638.i
  %410 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.143.i3849.010436
  %.84.i.i4478 = load i64, ptr %410, align 8, !noalias !320
  %.89.i.i4481 = icmp sgt i64 %.84.i.i4478, -1
  br i1 %.89.i.i4481, label %B46.i.i4487, label %B920.i

B46.i.i4487:                                      ; preds = %B864.i
  %.120.i.i4507 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i4478
  %.121.i.i4508 = load i64, ptr %.120.i.i4507, align 8, !noalias !320
  %.122.i.i4509 = icmp eq i64 %.121.i.i4508, 0
  br i1 %.122.i.i4509, label %B80.i.i4514, label %B920.i

B80.i.i4514:                                      ; preds = %B46.i.i4487
  store i64 6, ptr %.120.i.i4507, align 8, !noalias !320
  br label %B920.i

B920.i:                                           ; preds = %B80.i.i4514, %B864.i, %B46.i.i4487, %B638.i, %B144.i, %B80.if.i
  store double 0.000000e+00, ptr %.292.i3984, align 8, !noalias !316
  %.202.i3930 = icmp sgt i64 %.146.i3850.010435, 1
  br i1 %.202.i3930, label %B80.if.i, label %B4236

B80.if.i:                                         ; preds = %B4180, %B920.i
  %.143.i3849.010436 = phi i64 [ %.215.i4745, %B920.i ], [ 0, %B4180 ]
  %.146.i3850.010435 = phi i64 [ %.211.i4742, %B920.i ], [ %storemerge, %B4180 ]
  %.211.i4742 = add nsw i64 %.146.i3850.010435, -1
  %.215.i4745 = add nsw i64 %.143.i3849.010436, 1
  %.292.i3984 = getelementptr double, ptr %97, i64 %.143.i3849.010436
  %.293.i3985 = load double, ptr %.292.i3984, align 8, !noalias !316
  %.294.i3986 = fcmp oeq double %.293.i3985, 1.000000e+00
  br i1 %.294.i3986, label %B144.i, label %B920.i

B310.if.i:                                        ; preds = %B310.if.i.preheader, %B506.i
  %felt.2.i.210432 = phi i1 [ %"$phi506.2.2.i.3", %B506.i ], [ false, %B310.if.i.preheader ]
  %.482.i3864.010431 = phi i64 [ %.551.i4730, %B506.i ], [ 0, %B310.if.i.preheader ]
  %.551.i4730 = add nsw i64 %.482.i3864.010431, 1
  br i1 %felt.2.i.210432, label %B506.i, label %B410.i

B4236:                                            ; preds = %B920.i, %B4180
  br i1 %.2655, label %B4248, label %B4328

B4248:                                            ; preds = %B4236
  %.5538 = load double, ptr %.5537, align 8
  %.5539 = fcmp ogt double %.5538, 5.000000e-01
  br i1 %.5539, label %B4296, label %B4328

B4296:                                            ; preds = %B4248
  %.115.i4858 = load double, ptr %.114.i4857, align 8, !noalias !323
  %.169.i4898 = load double, ptr %arg.batch.4.0.4, align 8, !noalias !323
  %.170.i4899 = fsub double %.115.i4858, %.169.i4898
  %.171.i4900 = fcmp ogt double %.170.i4899, 0.000000e+00
  br i1 %.171.i4900, label %B114.i, label %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit

B114.i:                                           ; preds = %B4296
  %.229.i4988 = load double, ptr %.228.i4987, align 8, !noalias !323
  %.230.i4989 = fmul double %.229.i4988, 1.000000e-08
  %.285.i5029 = tail call double @llvm.fabs.f64(double %.169.i4898)
  %.286.i5030 = fmul double %.285.i5029, 4.000000e-15
  %.287.i5031 = fadd double %.286.i5030, %.230.i4989
  %.289.i5033 = fcmp ugt double %.170.i4899, %.287.i5031
  br i1 %.289.i5033, label %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit, label %B240.i

B240.i:                                           ; preds = %B114.i
  %.410.i5115 = load double, ptr %.409.i5114, align 8, !noalias !323
  %.411.i5116 = fsub double %.115.i4858, %.410.i5115
  %.441.i5141 = load double, ptr %.440.i5140, align 8, !noalias !323
  %.471.i5166 = load double, ptr %arg.batch.2.4, align 8, !noalias !323
  %.474.i5168 = fsub double %.441.i5141, %.471.i5166
  %.475.i5169 = fmul double %.474.i5168, 0x3E7AD7F29ABCAF48
  %.476.i5170 = fcmp olt double %.411.i5116, %.475.i5169
  br i1 %.476.i5170, label %B390.i, label %B438.i

B390.i:                                           ; preds = %B240.i
  %.531.i5433 = load i64, ptr %.530.i5432, align 8, !noalias !323
  %.532.i5434 = add nsw i64 %.531.i5433, 1
  br label %B438.i

B438.i:                                           ; preds = %B240.i, %B390.i
  %"$phi438.0.2.i.0" = phi i64 [ %.532.i5434, %B390.i ], [ 0, %B240.i ]
  store i64 %"$phi438.0.2.i.0", ptr %.593.i5211, align 8, !noalias !323
  %.652.i5253 = load double, ptr %.114.i4857, align 8, !noalias !323
  store double %.652.i5253, ptr %arg.batch.4.0.4, align 8, !noalias !323
  store double %.652.i5253, ptr %.409.i5114, align 8, !noalias !323
  store double 1.000000e+00, ptr %.813.i5369, align 8, !noalias !323
  store i64 2, ptr %.1180, align 8, !noalias !323
  br label %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit

_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit: ; preds = %B4296, %B438.i, %B114.i
  store double 0xFFF0000000000000, ptr %.114.i4857, align 8, !noalias !323
  br label %B4328

B4328:                                            ; preds = %_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE.exit, %B4248, %B4236
  %brmerge9800.not = and i1 %.5582.not, %looked.2.1.lcssa
  %brmerge9800.not.not = xor i1 %brmerge9800.not, true
  %brmerge10458 = or i1 %.815, %brmerge9800.not.not
  br i1 %brmerge10458, label %B4378, label %B114.if.i

B56.i.i:                                          ; preds = %B114.if.i
  %.131.i.i10044 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.95.i.i
  %.132.i.i = load i64, ptr %.131.i.i10044, align 8, !noalias !326
  %.137.i.not.i = icmp eq i64 %.132.i.i, 0
  br i1 %.137.i.not.i, label %B100.i.i, label %B238.i

B100.i.i:                                         ; preds = %B56.i.i
  %.188.i.i10058 = getelementptr double, ptr %105, i64 %.304.01646.i
  %.189.i.i = load double, ptr %.188.i.i10058, align 8, !noalias !326
  %.190.i.i = fcmp olt double %.189.i.i, 5.000000e-01
  br i1 %.190.i.i, label %B238.i, label %B152.i.i

B152.i.i:                                         ; preds = %B100.i.i
  %.252.i.i10059 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.304.01646.i
  %.253.i.i10060 = load double, ptr %.252.i.i10059, align 8, !noalias !326
  %.305.i.i = getelementptr double, ptr %106, i64 %.304.01646.i
  %.306.i.i10061 = load double, ptr %.305.i.i, align 8, !noalias !326
  %.309.i.i10062 = fcmp une double %.253.i.i10060, %.306.i.i10061
  %brmerge.i10063 = select i1 %.309.i.i10062, i1 true, i1 %.175.i1642.not.i
  %not..309.i.i = xor i1 %.309.i.i10062, true
  %some.2.01648.mux.i = select i1 %not..309.i.i, i1 true, i1 %some.2.01648.i
  br i1 %brmerge.i10063, label %B238.i, label %B76.if.i.lr.ph.i10064

B76.if.i.lr.ph.i10064:                            ; preds = %B152.i.i
  %411 = getelementptr i64, ptr %107, i64 %.304.01646.i
  %.511.i = load i64, ptr %411, align 8, !noalias !331
  %.512.i10065 = add nsw i64 %.511.i, 1
  %.236.i322.i = icmp slt i64 %.511.i, -1
  %.237.i323.i = select i1 %.236.i322.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i324.i = add i64 %.512.i10065, %.237.i323.i
  %.258.i.i10066 = mul i64 %.238.i324.i, %arg.batch.1.3.5.1
  %412 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i10066
  br label %B76.if.i.i10067

B76.if.i.i10067:                                  ; preds = %B76.if.i.i10067, %B76.if.i.lr.ph.i10064
  %.117.i261.01643.i = phi i64 [ 0, %B76.if.i.lr.ph.i10064 ], [ %.188.i378.i, %B76.if.i.i10067 ]
  %.188.i378.i = add nsw i64 %.117.i261.01643.i, 1
  %413 = getelementptr double, ptr %412, i64 %.117.i261.01643.i
  %.263.i.i10068 = load double, ptr %413, align 8, !noalias !332
  %414 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i261.01643.i
  %.293.i.i10069 = load i64, ptr %414, align 8, !noalias !332
  %.295.i362.i = mul nsw i64 %.293.i.i10069, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.304.01646.i
  %.311.i.i10070 = icmp slt i64 %.297.i364.i, 0
  %.312.i.i10071 = select i1 %.311.i.i10070, i64 %arg.batch.5.1.5.0, i64 0
  %415 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i.i10072 = getelementptr double, ptr %415, i64 %.312.i.i10071
  store double %.263.i.i10068, ptr %.326.i.i10072, align 8, !noalias !332
  %exitcond.not.i10073 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i378.i
  br i1 %exitcond.not.i10073, label %B238.i, label %B76.if.i.i10067

B238.i:                                           ; preds = %B76.if.i.i10067, %B114.if.i, %B152.i.i, %B100.i.i, %B56.i.i
  %some.3.1.i = phi i1 [ %some.2.01648.mux.i, %B152.i.i ], [ %some.2.01648.i, %B100.i.i ], [ %some.2.01648.i, %B114.if.i ], [ %some.2.01648.i, %B56.i.i ], [ true, %B76.if.i.i10067 ]
  %exitcond1657.not.i = icmp eq i64 %arg.shape.0, %.375.i
  br i1 %exitcond1657.not.i, label %B240.i10045, label %B114.if.i

B240.i10045:                                      ; preds = %B238.i
  br i1 %some.3.1.i, label %B248.i10046, label %B4378

B248.i10046:                                      ; preds = %B240.i10045
  %.635.i = load i64, ptr %.634.i, align 8, !noalias !331
  %.747.i10047 = inttoptr i64 %.635.i to ptr
  tail call void %.747.i10047(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !331
  %.778.i10049 = load i64, ptr %.777.i10048, align 8, !noalias !331
  %.894.i10052 = inttoptr i64 %.778.i10049 to ptr
  tail call void %.894.i10052(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.893.i10051), !noalias !331
  br i1 %.898.not.i, label %B690.if.i.preheader, label %B516.i

B516.i:                                           ; preds = %B248.i10046
  %.929.i = load i64, ptr %.928.i, align 8, !noalias !331
  %.1047.i = inttoptr i64 %.929.i to ptr
  tail call void %.1047.i(ptr %arg.batch.4.0.4, ptr %.893.i10051, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !331
  br label %B690.if.i.preheader

B690.if.i.preheader:                              ; preds = %B516.i, %B248.i10046
  br label %B690.if.i

B56.i80.i:                                        ; preds = %B690.if.i
  %.131.i100.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.95.i76.i
  %.132.i101.i = load i64, ptr %.131.i100.i, align 8, !noalias !336
  %.137.i104.not.i = icmp eq i64 %.132.i101.i, 0
  br i1 %.137.i104.not.i, label %B100.i105.i, label %B1238.i

B100.i105.i:                                      ; preds = %B56.i80.i
  %.188.i140.i = getelementptr double, ptr %105, i64 %.1088.01655.i
  %.189.i141.i = load double, ptr %.188.i140.i, align 8, !noalias !336
  %.190.i142.i = fcmp olt double %.189.i141.i, 5.000000e-01
  br i1 %.190.i142.i, label %B1238.i, label %B152.i143.i

B152.i143.i:                                      ; preds = %B100.i105.i
  %.252.i178.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1088.01655.i
  %.253.i179.i = load double, ptr %.252.i178.i, align 8, !noalias !336
  %.305.i215.i = getelementptr double, ptr %106, i64 %.1088.01655.i
  %.306.i216.i = load double, ptr %.305.i215.i, align 8, !noalias !336
  %.309.i218.i = fcmp une double %.253.i179.i, %.306.i216.i
  br i1 %.309.i218.i, label %B1238.i, label %B730.i

B730.i:                                           ; preds = %B152.i143.i
  %.1335.i = getelementptr i64, ptr %108, i64 %.1088.01655.i
  %.1336.i = load i64, ptr %.1335.i, align 8, !noalias !331
  %.1347.i = icmp sgt i64 %.1336.i, 0
  br i1 %.1347.i, label %B826.i, label %B890.i

B826.i:                                           ; preds = %B730.i
  %416 = getelementptr double, ptr %arg.batch.2.4, i64 %.1336.i
  %.1382.i = getelementptr i8, ptr %416, i64 -8
  %.1383.i = load double, ptr %.1382.i, align 8, !noalias !331
  %.1435.i = fcmp oeq double %.1383.i, %.253.i179.i
  br label %B890.i

B890.i:                                           ; preds = %B826.i, %B730.i
  %"$phi890.1.2.1.i" = phi i1 [ %.1435.i, %B826.i ], [ false, %B730.i ]
  br i1 %.15311649.not.i, label %B1120.i, label %B922.if.lr.ph.i

B922.if.lr.ph.i:                                  ; preds = %B890.i
  %.1661.i = add nsw i64 %.1336.i, -1
  %.1700.i = select i1 %.1347.i, i64 0, i64 %arg.batch.3.0.5.1
  %.1701.i = add i64 %.1661.i, %.1700.i
  %.1728.i = mul i64 %.1726.i, %.95.i76.i
  %.1730.i = mul i64 %.1701.i, %arg.batch.3.0.5.2
  %417 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1728.i
  %418 = getelementptr double, ptr %417, i64 %.1730.i
  %invariant.gep10437 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1088.01655.i
  %invariant.gep10439 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1088.01655.i
  br label %B922.if.i

B1028.i:                                          ; preds = %B922.if.i
  %419 = getelementptr double, ptr %418, i64 %.1475.01650.i
  store double %.1609.i, ptr %419, align 8, !noalias !331
  br label %B1050.i

B1050.i:                                          ; preds = %B922.if.i, %B1028.i
  %exitcond1658.not.i = icmp eq i64 %arg.shape.1, %.1544.i
  br i1 %exitcond1658.not.i, label %B1052.loopexit.i, label %B922.if.i

B1052.loopexit.i:                                 ; preds = %B1050.i
  %420 = fcmp une double %.1616.i10055, 0.000000e+00
  br i1 %420, label %B1064.i, label %B1120.i

B1064.i:                                          ; preds = %B1052.loopexit.i
  %.84.i441.i = load i64, ptr %423, align 8, !noalias !339
  %.89.i444.i = icmp sgt i64 %.84.i441.i, -1
  br i1 %.89.i444.i, label %B46.i.i10056, label %B1120.i

B46.i.i10056:                                     ; preds = %B1064.i
  %.120.i468.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i441.i
  %.121.i469.i = load i64, ptr %.120.i468.i, align 8, !noalias !339
  %.122.i470.i = icmp eq i64 %.121.i469.i, 0
  br i1 %.122.i470.i, label %B80.i.i10057, label %B1120.i

B80.i.i10057:                                     ; preds = %B46.i.i10056
  store i64 3, ptr %.120.i468.i, align 8, !noalias !339
  br label %B1120.i

B1120.i:                                          ; preds = %B80.i.i10057, %B46.i.i10056, %B1064.i, %B1052.loopexit.i, %B890.i
  br i1 %.898.not.i, label %B1238.i, label %B1136.i

B1136.i:                                          ; preds = %B1120.i
  %421 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1088.01655.i
  %.1833.i = load double, ptr %421, align 8, !noalias !331
  %.1835.i = fcmp olt double %.1833.i, -1.000000e-09
  br i1 %.1835.i, label %B1182.i, label %B1238.i

B1182.i:                                          ; preds = %B1136.i
  %.84.i571.i = load i64, ptr %423, align 8, !noalias !342
  %.89.i574.i = icmp sgt i64 %.84.i571.i, -1
  br i1 %.89.i574.i, label %B46.i579.i, label %B1238.i

B46.i579.i:                                       ; preds = %B1182.i
  %.120.i603.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i571.i
  %.121.i604.i = load i64, ptr %.120.i603.i, align 8, !noalias !342
  %.122.i605.i = icmp eq i64 %.121.i604.i, 0
  br i1 %.122.i605.i, label %B80.i610.i, label %B1238.i

B80.i610.i:                                       ; preds = %B46.i579.i
  store i64 4, ptr %.120.i603.i, align 8, !noalias !342
  br label %B1238.i

B1238.i:                                          ; preds = %B690.if.i, %B80.i610.i, %B46.i579.i, %B1182.i, %B1136.i, %B1120.i, %B152.i143.i, %B100.i105.i, %B56.i80.i
  %.1145.i = icmp sgt i64 %.1091.01656.i, 1
  br i1 %.1145.i, label %B690.if.i, label %B4378

B114.if.i:                                        ; preds = %B4328, %B238.i
  %some.2.01648.i = phi i1 [ %some.3.1.i, %B238.i ], [ false, %B4328 ]
  %.304.01646.i = phi i64 [ %.375.i, %B238.i ], [ 0, %B4328 ]
  %.375.i = add nsw i64 %.304.01646.i, 1
  %422 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.304.01646.i
  %.95.i.i = load i64, ptr %422, align 8, !noalias !326
  %.100.i.i = icmp slt i64 %.95.i.i, 0
  br i1 %.100.i.i, label %B238.i, label %B56.i.i

B690.if.i:                                        ; preds = %B690.if.i.preheader, %B1238.i
  %.1091.01656.i = phi i64 [ %.1154.i, %B1238.i ], [ %storemerge.i10043, %B690.if.i.preheader ]
  %.1088.01655.i = phi i64 [ %.1158.i10054, %B1238.i ], [ 0, %B690.if.i.preheader ]
  %.1154.i = add nsw i64 %.1091.01656.i, -1
  %.1158.i10054 = add nsw i64 %.1088.01655.i, 1
  %423 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1088.01655.i
  %.95.i76.i = load i64, ptr %423, align 8, !noalias !336
  %.100.i79.i = icmp slt i64 %.95.i76.i, 0
  br i1 %.100.i79.i, label %B1238.i, label %B56.i80.i

B922.if.i:                                        ; preds = %B1050.i, %B922.if.lr.ph.i
  %trouble.2.11652.i = phi double [ 0.000000e+00, %B922.if.lr.ph.i ], [ %.1616.i10055, %B1050.i ]
  %.1475.01650.i = phi i64 [ 0, %B922.if.lr.ph.i ], [ %.1544.i, %B1050.i ]
  %.1544.i = add nsw i64 %.1475.01650.i, 1
  %.1575.i = add nsw i64 %.1475.01650.i, %.848.i
  %.1577.i = mul nsw i64 %.1575.i, %arg.shape.0
  %gep10438 = getelementptr double, ptr %invariant.gep10437, i64 %.1577.i
  %.1609.i = load double, ptr %gep10438, align 8, !noalias !331
  %.1614.i = fmul double %.1609.i, 0.000000e+00
  %.1616.i10055 = fadd double %trouble.2.11652.i, %.1614.i
  %.1624.i = mul nsw i64 %.1475.01650.i, %arg.shape.0
  %gep10440 = getelementptr double, ptr %invariant.gep10439, i64 %.1624.i
  store double %.1609.i, ptr %gep10440, align 8, !noalias !331
  br i1 %"$phi890.1.2.1.i", label %B1028.i, label %B1050.i

B4378:                                            ; preds = %B1238.i, %B4328, %B240.i10045
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge10461 = or i1 %.815, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge10461, label %B5554, label %B4420.if

B4478:                                            ; preds = %B4420.if
  %.5960 = mul i64 %.5891, %arg.batch.3.3.5.1
  %.5964 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5960
  %.5965 = load i64, ptr %.5964, align 8
  %.6017 = getelementptr i8, ptr %.5964, i64 24
  %.6018 = load i64, ptr %.6017, align 8
  %424 = add i64 %.5965, %.6018
  %.6019 = sub i64 %arg.most, %424
  %.6024 = icmp slt i64 %.6019, 1
  br i1 %.6024, label %B4578, label %B4634

B4578:                                            ; preds = %B4478
  %425 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5733.010445
  %.84.i2609 = load i64, ptr %425, align 8, !noalias !345
  %.89.i2612 = icmp sgt i64 %.84.i2609, -1
  br i1 %.89.i2612, label %B46.i, label %B4634

B46.i:                                            ; preds = %B4578
  %.120.i2637 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2609
  %.121.i2638 = load i64, ptr %.120.i2637, align 8, !noalias !345
  %.122.i2639 = icmp eq i64 %.121.i2638, 0
  br i1 %.122.i2639, label %B80.i2643, label %B4634

B80.i2643:                                        ; preds = %B46.i
  store i64 5, ptr %.120.i2637, align 8, !noalias !345
  br label %B4634

B4634:                                            ; preds = %B80.i2643, %B4578, %B46.i, %B4478
  %.6110 = getelementptr double, ptr %109, i64 %.5733.010445
  %.6111 = load double, ptr %.6110, align 8
  %.6112 = fcmp ogt double %.6111, 5.000000e-01
  br i1 %.6112, label %B4682, label %B4806

B4682:                                            ; preds = %B4634
  %.6163 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5733.010445
  %.6164 = load double, ptr %.6163, align 8
  %.6214 = getelementptr double, ptr %110, i64 %.5733.010445
  %.6215 = load double, ptr %.6214, align 8
  %.6216 = fcmp oeq double %.6164, %.6215
  br i1 %.6216, label %B4766, label %B4806

B4766:                                            ; preds = %B4682
  %.188.i5633 = load i64, ptr %.5890, align 8, !noalias !348
  %.240.i5678 = getelementptr i64, ptr %111, i64 %.5733.010445
  %.241.i5679 = load i64, ptr %.240.i5678, align 8, !noalias !348
  %.242.i5680 = add nsw i64 %.241.i5679, 1
  store i64 %.242.i5680, ptr %.240.i5678, align 8, !noalias !348
  %.357.i5779 = icmp slt i64 %.241.i5679, -1
  %.358.i5780 = select i1 %.357.i5779, i64 %arg.batch.1.2.5.0, i64 0
  %426 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.242.i5680
  %.372.i5794 = getelementptr double, ptr %426, i64 %.358.i5780
  %.373.i5795 = load double, ptr %.372.i5794, align 8, !noalias !348
  %.374.i5796 = fcmp oeq double %.373.i5795, 0x7FF0000000000000
  br i1 %.374.i5796, label %B212.i, label %B290.i5797

B212.i:                                           ; preds = %B4766
  %.408.i6404 = icmp slt i64 %.188.i5633, 0
  %.409.i6405 = select i1 %.408.i6404, i64 %arg.batch.3.1.5.0, i64 0
  %427 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.188.i5633
  %.423.i6419 = getelementptr i64, ptr %427, i64 %.409.i6405
  %.424.i6420 = load i64, ptr %.423.i6419, align 8, !noalias !348
  %.425.i6421 = icmp eq i64 %.424.i6420, 0
  br i1 %.425.i6421, label %B256.i, label %B4806

B256.i:                                           ; preds = %B212.i
  store i64 1, ptr %.423.i6419, align 8, !noalias !348
  br label %B4806

B290.i5797:                                       ; preds = %B4766
  store double %.373.i5795, ptr %.6214, align 8, !noalias !348
  %.572.i5884 = select i1 %.357.i5779, i64 %arg.batch.1.4.5.0, i64 0
  %428 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.242.i5680
  %.586.i5898 = getelementptr i64, ptr %428, i64 %.572.i5884
  %.587.i5899 = load i64, ptr %.586.i5898, align 8, !noalias !348
  %.590.i5901 = icmp eq i64 %.587.i5899, 0
  br i1 %.590.i5901, label %B360.i, label %B428.i

B360.i:                                           ; preds = %B290.i5797
  %.641.i6358 = getelementptr double, ptr %113, i64 %.5733.010445
  store double 1.000000e+00, ptr %.641.i6358, align 8, !noalias !348
  br label %B616.i

B428.i:                                           ; preds = %B290.i5797
  %.727.i5946 = getelementptr double, ptr %112, i64 %.5733.010445
  %.728.i5947 = load double, ptr %.727.i5946, align 8, !noalias !348
  %.10.i.i = fcmp olt double %.728.i5947, 2.500000e-01
  %.11.i.i = select i1 %.10.i.i, double 2.500000e-01, double %.728.i5947
  store double %.11.i.i, ptr %.727.i5946, align 8, !noalias !348
  %.841.i6025 = load i64, ptr %.1180, align 8, !noalias !348
  %.11.i4.i = tail call i64 @llvm.smax.i64(i64 %.841.i6025, i64 1)
  br label %B616.i

B616.i:                                           ; preds = %B428.i, %B360.i
  %storemerge9728 = phi i64 [ %.11.i4.i, %B428.i ], [ 2, %B360.i ]
  store i64 %storemerge9728, ptr %.1180, align 8, !noalias !348
  br i1 %.175.i.i620110441.not, label %B4806, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B616.i
  %.237.i.i6249 = select i1 %.357.i5779, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i6250 = add i64 %.237.i.i6249, %.242.i5680
  %.258.i.i6263 = mul i64 %.238.i.i6250, %arg.batch.1.3.5.1
  %429 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i6263
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i5441.010443 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i6307, %B76.if.i.i ]
  %.188.i.i6307 = add nsw i64 %.117.i.i5441.010443, 1
  %430 = getelementptr double, ptr %429, i64 %.117.i.i5441.010443
  %.263.i.i6266 = load double, ptr %430, align 8, !noalias !352
  %431 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i5441.010443
  %.293.i.i6283 = load i64, ptr %431, align 8, !noalias !352
  %.295.i.i6285 = mul nsw i64 %.293.i.i6283, %arg.shape.0
  %.297.i.i6287 = add nsw i64 %.295.i.i6285, %.5733.010445
  %.311.i.i6293 = icmp slt i64 %.297.i.i6287, 0
  %.312.i.i6294 = select i1 %.311.i.i6293, i64 %arg.batch.5.1.5.0, i64 0
  %432 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i6287
  %.326.i.i6301 = getelementptr double, ptr %432, i64 %.312.i.i6294
  store double %.263.i.i6266, ptr %.326.i.i6301, align 8, !noalias !352
  %exitcond10495.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i6307
  br i1 %exitcond10495.not, label %B4806, label %B76.if.i.i

B4806:                                            ; preds = %B76.if.i.i, %B616.i, %B256.i, %B212.i, %B4682, %B4634
  %.6305 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5891
  %.6306 = load i64, ptr %.6305, align 8
  %.6307.not = icmp eq i64 %.6306, 0
  br i1 %.6307.not, label %B4978, label %B4850

B4850:                                            ; preds = %B4806
  %.6364 = getelementptr i64, ptr %114, i64 %.5733.010445
  %.6365 = load i64, ptr %.6364, align 8
  %.6395 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5891
  store i64 %.6365, ptr %.6395, align 8
  store i64 -1, ptr %.5890, align 8
  %.238.i10074 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !356
  %.291.i10079 = getelementptr double, ptr %115, i64 %.5733.010445
  store double 0.000000e+00, ptr %.291.i10079, align 8, !noalias !356
  %.322.i10081 = load i64, ptr %.321.i10080, align 8, !noalias !356
  %.324.i10082 = icmp eq i64 %.238.i10074, %.322.i10081
  br i1 %.324.i10082, label %B5236, label %B142.i10083

B142.i10083:                                      ; preds = %B4850
  %.357.i10084 = add nsw i64 %.238.i10074, 1
  store i64 %.357.i10084, ptr %arg.batch.4.2.4, align 8, !noalias !356
  store i64 2, ptr %.1180, align 8, !noalias !356
  %.436.i10086 = icmp slt i64 %.238.i10074, 0
  %.437.i10087 = select i1 %.436.i10086, i64 %arg.batch.0.2.5.0, i64 0
  %433 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.238.i10074
  %.451.i10088 = getelementptr i64, ptr %433, i64 %.437.i10087
  %.452.i10089 = load i64, ptr %.451.i10088, align 8, !noalias !356
  %.467.i10090 = icmp slt i64 %.452.i10089, 0
  %.468.i10091 = select i1 %.467.i10090, i64 %arg.batch.1.0.5.0, i64 0
  %434 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.452.i10089
  %.482.i10092 = getelementptr i64, ptr %434, i64 %.468.i10091
  %.483.i10093 = load i64, ptr %.482.i10092, align 8, !noalias !356
  store i64 %.238.i10074, ptr %.5890, align 8, !noalias !356
  %.585.i10097 = getelementptr i64, ptr %116, i64 %.5733.010445
  store i64 %.483.i10093, ptr %.585.i10097, align 8, !noalias !356
  store i64 1, ptr %.6364, align 8, !noalias !356
  %.691.i10101 = getelementptr i64, ptr %117, i64 %.5733.010445
  store i64 0, ptr %.691.i10101, align 8, !noalias !356
  br i1 %.7871131.not.i10102, label %B462.i10117, label %B418.if.lr.ph.i10103

B418.if.lr.ph.i10103:                             ; preds = %B142.i10083
  %.849.i10104 = select i1 %.436.i10086, i64 %arg.batch.0.1.5.0, i64 0
  %.850.i10105 = add i64 %.849.i10104, %.238.i10074
  %.870.i10106 = mul i64 %.850.i10105, %arg.batch.0.1.5.1
  %435 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.870.i10106
  %invariant.gep10622 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5733.010445
  br label %B418.if.i10107

B462.i10117:                                      ; preds = %B418.if.i10107, %B142.i10083
  br i1 %.175.i1134.not.i10118, label %B462.endif.i10136, label %B76.if.i.lr.ph.i10119

B76.if.i.lr.ph.i10119:                            ; preds = %B462.i10117
  %.968.i10120 = load i64, ptr %.585.i10097, align 8, !noalias !356
  %.236.i.i10121 = icmp slt i64 %.968.i10120, 0
  %.237.i.i10122 = select i1 %.236.i.i10121, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i10123 = add i64 %.237.i.i10122, %.968.i10120
  %.258.i.i10124 = mul i64 %.238.i.i10123, %arg.batch.1.3.5.1
  %436 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i10124
  br label %B76.if.i.i10125

B76.if.i.i10125:                                  ; preds = %B76.if.i.i10125, %B76.if.i.lr.ph.i10119
  %.117.i.01135.i10126 = phi i64 [ 0, %B76.if.i.lr.ph.i10119 ], [ %.188.i.i10127, %B76.if.i.i10125 ]
  %.188.i.i10127 = add nsw i64 %.117.i.01135.i10126, 1
  %437 = getelementptr double, ptr %436, i64 %.117.i.01135.i10126
  %.263.i.i10128 = load double, ptr %437, align 8, !noalias !359
  %438 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i10126
  %.293.i.i10129 = load i64, ptr %438, align 8, !noalias !359
  %.295.i.i10130 = mul nsw i64 %.293.i.i10129, %arg.shape.0
  %.297.i.i10131 = add nsw i64 %.295.i.i10130, %.5733.010445
  %.311.i.i10132 = icmp slt i64 %.297.i.i10131, 0
  %.312.i.i10133 = select i1 %.311.i.i10132, i64 %arg.batch.5.1.5.0, i64 0
  %439 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i10131
  %.326.i.i10134 = getelementptr double, ptr %439, i64 %.312.i.i10133
  store double %.263.i.i10128, ptr %.326.i.i10134, align 8, !noalias !359
  %exitcond1142.not.i10135 = icmp eq i64 %.188.i.i10127, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i10135, label %B462.endif.i10136, label %B76.if.i.i10125

B1038.i10230:                                     ; preds = %B660.if.i10152
  store double 0.000000e+00, ptr %.1827.i10227, align 8, !noalias !356
  br label %B5236

B418.if.i10107:                                   ; preds = %B418.if.i10107, %B418.if.lr.ph.i10103
  %.729.01132.i10108 = phi i64 [ 0, %B418.if.lr.ph.i10103 ], [ %.800.i10109, %B418.if.i10107 ]
  %.800.i10109 = add nsw i64 %.729.01132.i10108, 1
  %440 = getelementptr double, ptr %435, i64 %.729.01132.i10108
  %.875.i10110 = load double, ptr %440, align 8, !noalias !356
  %.877.i10111 = mul nsw i64 %.729.01132.i10108, %arg.shape.0
  %gep10623 = getelementptr double, ptr %invariant.gep10622, i64 %.877.i10111
  store double %.875.i10110, ptr %gep10623, align 8, !noalias !356
  %exitcond.not.i10116 = icmp eq i64 %.800.i10109, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i10116, label %B462.i10117, label %B418.if.i10107

B462.endif.i10136:                                ; preds = %B76.if.i.i10125, %B462.i10117
  br i1 %.10951137.not.i10137, label %B660.if.i10152, label %B566.if.lr.ph.i10138

B566.if.lr.ph.i10138:                             ; preds = %B462.endif.i10136
  %.1157.i10139 = select i1 %.436.i10086, i64 %arg.batch.0.0.5.0, i64 0
  %.1158.i10140 = add i64 %.1157.i10139, %.238.i10074
  %.1178.i10141 = mul i64 %.1158.i10140, %arg.batch.0.0.5.1
  %441 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1178.i10141
  %invariant.gep10624 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5733.010445
  br label %B566.if.i10142

B566.if.i10142:                                   ; preds = %B566.if.i10142, %B566.if.lr.ph.i10138
  %.1039.01138.i10143 = phi i64 [ 0, %B566.if.lr.ph.i10138 ], [ %.1108.i10144, %B566.if.i10142 ]
  %.1108.i10144 = add nsw i64 %.1039.01138.i10143, 1
  %442 = getelementptr double, ptr %441, i64 %.1039.01138.i10143
  %.1183.i10145 = load double, ptr %442, align 8, !noalias !356
  %.1185.i10146 = mul nsw i64 %.1039.01138.i10143, %arg.shape.0
  %gep10625 = getelementptr double, ptr %invariant.gep10624, i64 %.1185.i10146
  store double %.1183.i10145, ptr %gep10625, align 8, !noalias !356
  %exitcond1143.not.i10151 = icmp eq i64 %.1108.i10144, %arg.shape.1
  br i1 %exitcond1143.not.i10151, label %B660.if.i10152, label %B566.if.i10142

B660.if.i10152:                                   ; preds = %B566.if.i10142, %B462.endif.i10136
  %invariant.gep.i10153 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5733.010445
  store double 0.000000e+00, ptr %invariant.gep.i10153, align 8, !noalias !356
  %gep.1.i10154 = getelementptr double, ptr %invariant.gep.i10153, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i10154, align 8, !noalias !356
  %gep.2.i10156 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.2.idx.i10155
  store double 0.000000e+00, ptr %gep.2.i10156, align 8, !noalias !356
  %gep.3.i10158 = getelementptr i8, ptr %invariant.gep.i10153, i64 %.idx.i10078
  store double 0.000000e+00, ptr %gep.3.i10158, align 8, !noalias !356
  %gep.4.i10160 = getelementptr i8, ptr %invariant.gep.i10153, i64 %.2012.idx
  store double 0.000000e+00, ptr %gep.4.i10160, align 8, !noalias !356
  %gep.5.i10162 = getelementptr i8, ptr %invariant.gep.i10153, i64 %.idx9725
  store double 0.000000e+00, ptr %gep.5.i10162, align 8, !noalias !356
  %gep.6.i10164 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.6.idx.i10163
  store double 0.000000e+00, ptr %gep.6.i10164, align 8, !noalias !356
  %gep.7.i10166 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.7.idx.i10165
  store double 0.000000e+00, ptr %gep.7.i10166, align 8, !noalias !356
  %gep.8.i10168 = getelementptr i8, ptr %invariant.gep.i10153, i64 %.577.idx
  store double 0.000000e+00, ptr %gep.8.i10168, align 8, !noalias !356
  %gep.9.i10170 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.9.idx.i10169
  store double 0.000000e+00, ptr %gep.9.i10170, align 8, !noalias !356
  %gep.10.i10172 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.10.idx.i10171
  store double 0.000000e+00, ptr %gep.10.i10172, align 8, !noalias !356
  %gep.11.i10174 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.11.idx.i10173
  store double 0.000000e+00, ptr %gep.11.i10174, align 8, !noalias !356
  %gep.12.i10176 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.12.idx.i10175
  store double 0.000000e+00, ptr %gep.12.i10176, align 8, !noalias !356
  %gep.13.i10178 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.13.idx.i10177
  store double 0.000000e+00, ptr %gep.13.i10178, align 8, !noalias !356
  %gep.14.i10180 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.14.idx.i10179
  store double 0.000000e+00, ptr %gep.14.i10180, align 8, !noalias !356
  %gep.15.i10182 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.15.idx.i10181
  store double 0.000000e+00, ptr %gep.15.i10182, align 8, !noalias !356
  %gep.16.i10184 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.16.idx.i10183
  store double 0.000000e+00, ptr %gep.16.i10184, align 8, !noalias !356
  %gep.17.i10186 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.17.idx.i10185
  store double 0.000000e+00, ptr %gep.17.i10186, align 8, !noalias !356
  %gep.18.i10188 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.18.idx.i10187
  store double 0.000000e+00, ptr %gep.18.i10188, align 8, !noalias !356
  %gep.19.i10190 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.19.idx.i10189
  store double 0.000000e+00, ptr %gep.19.i10190, align 8, !noalias !356
  %gep.20.i10192 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.20.idx.i10191
  store double 0.000000e+00, ptr %gep.20.i10192, align 8, !noalias !356
  %gep.21.i10194 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.21.idx.i10193
  store double 0.000000e+00, ptr %gep.21.i10194, align 8, !noalias !356
  %gep.22.i10196 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.22.idx.i10195
  store double 0.000000e+00, ptr %gep.22.i10196, align 8, !noalias !356
  %gep.23.i10198 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.23.idx.i10197
  store double 0.000000e+00, ptr %gep.23.i10198, align 8, !noalias !356
  %gep.24.i10200 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.24.idx.i10199
  store double 0.000000e+00, ptr %gep.24.i10200, align 8, !noalias !356
  %gep.25.i10202 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.25.idx.i10201
  store double 0.000000e+00, ptr %gep.25.i10202, align 8, !noalias !356
  %gep.26.i10204 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.26.idx.i10203
  store double 0.000000e+00, ptr %gep.26.i10204, align 8, !noalias !356
  %gep.27.i10206 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.27.idx.i10205
  store double 0.000000e+00, ptr %gep.27.i10206, align 8, !noalias !356
  %gep.28.i10208 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.28.idx.i10207
  store double 0.000000e+00, ptr %gep.28.i10208, align 8, !noalias !356
  %gep.29.i10210 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.29.idx.i10209
  store double 0.000000e+00, ptr %gep.29.i10210, align 8, !noalias !356
  %gep.30.i10212 = getelementptr i8, ptr %invariant.gep.i10153, i64 %gep.30.idx.i10211
  store double 0.000000e+00, ptr %gep.30.i10212, align 8, !noalias !356
  %.1433.i10213 = load double, ptr %arg.batch.2.4, align 8, !noalias !356
  %.1490.i10214 = load i64, ptr %.585.i10097, align 8, !noalias !356
  %.1505.i10215 = icmp slt i64 %.1490.i10214, 0
  %.1506.i10216 = select i1 %.1505.i10215, i64 %arg.batch.1.2.5.0, i64 0
  %443 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1490.i10214
  %.1520.i10217 = getelementptr double, ptr %443, i64 %.1506.i10216
  %.1521.i10218 = load double, ptr %.1520.i10217, align 8, !noalias !356
  store double %.1433.i10213, ptr %invariant.gep.i10153, align 8, !noalias !356
  %.1622.i10221 = getelementptr double, ptr %118, i64 %.5733.010445
  store double %.1521.i10218, ptr %.1622.i10221, align 8, !noalias !356
  store double 1.000000e+00, ptr %.291.i10079, align 8, !noalias !356
  %.1725.i10223 = getelementptr double, ptr %119, i64 %.5733.010445
  store double 0xFFF0000000000000, ptr %.1725.i10223, align 8, !noalias !356
  %.1776.i10225 = getelementptr double, ptr %120, i64 %.5733.010445
  store double 0x7FF0000000000000, ptr %.1776.i10225, align 8, !noalias !356
  %.1827.i10227 = getelementptr double, ptr %121, i64 %.5733.010445
  %.1828.i10228 = load double, ptr %.1827.i10227, align 8, !noalias !356
  %.1830.i10229 = fcmp ueq double %.1828.i10228, 0xFFF0000000000000
  br i1 %.1830.i10229, label %B5236, label %B1038.i10230

B4978:                                            ; preds = %B4806
  %.6584 = getelementptr double, ptr %122, i64 %.5733.010445
  %.6585 = load double, ptr %.6584, align 8
  %.6587 = fcmp ult double %.6585, 1.500000e+01
  br i1 %.6587, label %B5236, label %B5046

B5046:                                            ; preds = %B4978
  %.6631 = load double, ptr %.6630, align 8
  %.6681 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5733.010445
  %.6682 = load double, ptr %.6681, align 8
  %.6683 = fsub double %.6631, %.6682
  %.6733 = getelementptr double, ptr %125, i64 %.5733.010445
  %.6734 = load double, ptr %.6733, align 8
  %.6736 = fmul double %.6734, 5.000000e+03
  %.6737 = fcmp ogt double %.6683, %.6736
  br i1 %.6737, label %B5236, label %B5202

B5202:                                            ; preds = %B5046
  store double 0.000000e+00, ptr %.6584, align 8
  br label %B5236

B5236:                                            ; preds = %B1038.i10230, %B4850, %B660.if.i10152, %B5046, %B5202, %B4978
  %budget.7.4 = phi i64 [ %budget.5.210447, %B4978 ], [ 0, %B5046 ], [ %budget.5.210447, %B5202 ], [ %budget.5.210447, %B660.if.i10152 ], [ %budget.5.210447, %B4850 ], [ %budget.5.210447, %B1038.i10230 ]
  %.6857 = load i64, ptr %.5890, align 8
  %.6858 = icmp sgt i64 %.6857, -1
  br i1 %.6858, label %B5284, label %B5581

B5284:                                            ; preds = %B5236
  %.6863 = add nsw i64 %active.5.210448, 1
  %.6964 = mul i64 %.6857, %arg.batch.3.3.5.1
  %.6968 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6964
  %.6969 = load i64, ptr %.6968, align 8
  %.6980.0 = and i64 %.6969, 127
  %.7010 = sub nsw i64 128, %.6980.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.7010, i64 %.6019)
  %.7094 = getelementptr double, ptr %126, i64 %.5733.010445
  %.7095 = load double, ptr %.7094, align 8
  %.7097 = fcmp ogt double %.7095, 0.000000e+00
  %.7108 = sitofp i64 %.11.i to double
  %"$phi5484.1.2.5" = select i1 %.7097, double 1.000000e+00, double %.7108
  %.7167 = getelementptr double, ptr %127, i64 %.5733.010445
  store double %"$phi5484.1.2.5", ptr %.7167, align 8
  %.107.i6557 = getelementptr i64, ptr %128, i64 %.5733.010445
  %.108.i6558 = load i64, ptr %.107.i6557, align 8, !noalias !363
  %.161.i6604 = getelementptr double, ptr %129, i64 %.5733.010445
  %.162.i6605 = load double, ptr %.161.i6604, align 8, !noalias !363
  %.212.i6650 = getelementptr double, ptr %130, i64 %.5733.010445
  store double %.162.i6605, ptr %.212.i6650, align 8, !noalias !363
  %.225.i6658 = icmp slt i64 %.108.i6558, %arg.batch.2.5.0
  br i1 %.225.i6658, label %B164.i, label %B5581

B164.i:                                           ; preds = %B5284
  %.241.i6673 = icmp slt i64 %.108.i6558, 0
  %.242.i6674 = select i1 %.241.i6673, i64 %arg.batch.2.5.0, i64 0
  %444 = getelementptr double, ptr %arg.batch.2.4, i64 %.108.i6558
  %.256.i6688 = getelementptr double, ptr %444, i64 %.242.i6674
  %.257.i6689 = load double, ptr %.256.i6688, align 8, !noalias !363
  %.312.i6737 = load double, ptr %.161.i6604, align 8, !noalias !363
  %.10.i.i6744 = fcmp olt double %.312.i6737, %.257.i6689
  %.11.i.i6745 = select i1 %.10.i.i6744, double %.312.i6737, double %.257.i6689
  store double %.11.i.i6745, ptr %.212.i6650, align 8, !noalias !363
  br label %B5581

B5554:                                            ; preds = %B5581, %B4378
  %budget.4.2 = phi i64 [ %.1146, %B4378 ], [ %budget.6.3, %B5581 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B4378 ], [ %active.6.3, %B5581 ]
  %.7245 = icmp sgt i64 %active.8.2, 0
  %.7259 = icmp sgt i64 %budget.4.2, 0
  %or.cond9801 = select i1 %.7245, i1 %.7259, i1 false
  br i1 %or.cond9801, label %B740, label %B5580

B5580:                                            ; preds = %B5554, %B712
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B712 ], [ %active.8.2, %B5554 ]
  br i1 %.815, label %B5580.endif, label %B82.if.i2534.lr.ph

B82.if.i2534.lr.ph:                               ; preds = %B5580
  %.idx = mul i64 %arg.batch.4.0.5.1, 208
  %445 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx9723 = mul i64 %arg.batch.4.0.5.1, 216
  %446 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9723
  %.674.i2207 = add nsw i64 %arg.shape.2, -1
  %.idx9724 = mul i64 %arg.batch.4.0.5.1, 192
  %447 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx9724
  br label %B82.if.i2534

B140.i1881:                                       ; preds = %B82.if.i2534
  %.313.i1926 = getelementptr double, ptr %445, i64 %.107.i1729.010455
  %.314.i1927 = load double, ptr %.313.i1926, align 8, !noalias !367
  %.5.i.i1928 = fptosi double %.314.i1927 to i64
  %.388.i1976 = getelementptr double, ptr %446, i64 %.107.i1729.010455
  %.389.i1977 = load double, ptr %.388.i1976, align 8, !noalias !367
  %.5.i1.i1978 = fptosi double %.389.i1977 to i64
  %.465.i2023 = mul i64 %.257.i1874, %arg.batch.3.3.5.1
  %.469.i2027 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.465.i2023
  %.470.i2028 = load i64, ptr %.469.i2027, align 8, !noalias !367
  %.472.i2030 = add nsw i64 %.470.i2028, %.5.i.i1928
  store i64 %.472.i2030, ptr %.469.i2027, align 8, !noalias !367
  %.570.i2113 = getelementptr i8, ptr %.469.i2027, i64 24
  %.571.i2114 = load i64, ptr %.570.i2113, align 8, !noalias !367
  %.573.i2116 = add nsw i64 %.571.i2114, %.5.i1.i1978
  store i64 %.573.i2116, ptr %.570.i2113, align 8, !noalias !367
  %.671.i2204 = getelementptr i8, ptr %.469.i2027, i64 8
  %.672.i2205 = load i64, ptr %.671.i2204, align 8, !noalias !367
  %.677.i2210 = add nsw i64 %.5.i1.i1978, %.5.i.i1928
  %.678.i2211 = mul nsw i64 %.677.i2210, %.674.i2207
  %..5.i.i1928 = select i1 %.631, i64 %.5.i.i1928, i64 0
  %.679.i2212 = add i64 %.678.i2211, %..5.i.i1928
  %.804.i2316 = add i64 %.679.i2212, %.672.i2205
  store i64 %.804.i2316, ptr %.671.i2204, align 8, !noalias !367
  store double 0.000000e+00, ptr %.313.i1926, align 8, !noalias !367
  store double 0.000000e+00, ptr %.388.i1976, align 8, !noalias !367
  %.1019.i2483 = getelementptr double, ptr %447, i64 %.107.i1729.010455
  %.1020.i2484 = load double, ptr %.1019.i2483, align 8, !noalias !367
  %.1028.i2490 = sitofp i64 %.677.i2210 to double
  %.1029.i2491 = fsub double %.1020.i2484, %.1028.i2490
  store double %.1029.i2491, ptr %.1019.i2483, align 8, !noalias !367
  br label %B682.i1878

B682.i1878:                                       ; preds = %B140.i1881, %B82.if.i2534
  %.166.i1811 = icmp sgt i64 %.110.i1730.010456, 1
  br i1 %.166.i1811, label %B82.if.i2534, label %B5580.endif

B82.if.i2534:                                     ; preds = %B82.if.i2534.lr.ph, %B682.i1878
  %.110.i1730.010456 = phi i64 [ %storemerge, %B82.if.i2534.lr.ph ], [ %.175.i2539, %B682.i1878 ]
  %.107.i1729.010455 = phi i64 [ 0, %B82.if.i2534.lr.ph ], [ %.179.i2542, %B682.i1878 ]
  %.175.i2539 = add nsw i64 %.110.i1730.010456, -1
  %.179.i2542 = add nsw i64 %.107.i1729.010455, 1
  %448 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.107.i1729.010455
  %.257.i1874 = load i64, ptr %448, align 8, !noalias !367
  %.262.i1877 = icmp sgt i64 %.257.i1874, -1
  br i1 %.262.i1877, label %B140.i1881, label %B682.i1878

B5581:                                            ; preds = %B5284, %B164.i, %B5236, %B4420.if
  %budget.6.3 = phi i64 [ %budget.5.210447, %B4420.if ], [ %budget.7.4, %B5236 ], [ %budget.7.4, %B164.i ], [ %budget.7.4, %B5284 ]
  %active.6.3 = phi i64 [ %active.5.210448, %B4420.if ], [ %active.5.210448, %B5236 ], [ %.6863, %B164.i ], [ %.6863, %B5284 ]
  %.5796 = icmp sgt i64 %.5736.010446, 1
  br i1 %.5796, label %B4420.if, label %B5554

common.ret:                                       ; preds = %B3940.if, %B3896.if, %B3850.if, %B3782.endif.if, %B3200.endif.if, %B5580.endif
  %common.ret.op = phi i32 [ %common.ret.op.i9873, %B3896.if ], [ %.4271, %B3200.endif.if ], [ 0, %B5580.endif ], [ %common.ret.op.i, %B3850.if ], [ %common.ret.op.i9959, %B3940.if ], [ %.4853, %B3782.endif.if ]
  ret i32 %common.ret.op

B552.if:                                          ; preds = %B552.if.lr.ph, %B648
  %active.4.010264 = phi i64 [ 0, %B552.if.lr.ph ], [ %.1103, %B648 ]
  %.804.010263 = phi i64 [ %storemerge, %B552.if.lr.ph ], [ %.868, %B648 ]
  %.801.010262 = phi i64 [ 0, %B552.if.lr.ph ], [ %.872, %B648 ]
  %.868 = add nsw i64 %.804.010263, -1
  %.872 = add nsw i64 %.801.010262, 1
  %449 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.801.010262
  %.950 = load i64, ptr %449, align 8
  %.951 = icmp slt i64 %.950, 0
  br i1 %.951, label %B604, label %B648

B918.endif.endif:                                 ; preds = %B466.i, %B918
  %some.2.i.0.lcssa = phi i1 [ false, %B918 ], [ %some.3.i.1, %B466.i ]
  %"$phi956.0.2.2" = or i1 %.1182, %some.2.i.0.lcssa
  br label %B958

B1808.if:                                         ; preds = %B1776, %B1994
  %.2248.010289 = phi i64 [ %.2317, %B1994 ], [ 1, %B1776 ]
  %.2317 = add i64 %.2248.010289, 1
  %450 = getelementptr i64, ptr %arg.code.4, i64 %.2248.010289
  %451 = getelementptr i8, ptr %450, i64 128
  %.2376 = load i64, ptr %451, align 8
  %.2421 = inttoptr i64 %.2376 to ptr
  tail call void %.2421(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2425 = add nsw i64 %.2248.010289, %.
  %.2427 = mul nsw i64 %.2425, %.469
  %.2473 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2427
  tail call void %.2474(ptr %.577, ptr %.2448, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2473)
  br i1 %or.cond10240.not, label %B68.if.lr.ph.i, label %B1994

B2160.if:                                         ; preds = %B1996, %B2266
  %looked.2.110295 = phi i1 [ %"$phi2266.1.2.2", %B2266 ], [ %spec.select9802, %B1996 ]
  %good.2.110294 = phi i1 [ %"$phi2214.1.2.2", %B2266 ], [ false, %B1996 ]
  %.2698.010293 = phi i64 [ %.2760, %B2266 ], [ %storemerge, %B1996 ]
  %.2695.010292 = phi i64 [ %.2764, %B2266 ], [ 0, %B1996 ]
  %.2760 = add nsw i64 %.2698.010293, -1
  %.2764 = add nsw i64 %.2695.010292, 1
  br i1 %good.2.110294, label %B2214, label %B2168

B2342.if:                                         ; preds = %B2340.preheader, %B2948
  %checked.3.210305 = phi i1 [ %checked.4.3, %B2948 ], [ false, %B2340.preheader ]
  %within.3.210304 = phi i1 [ %within.4.3, %B2948 ], [ false, %B2340.preheader ]
  %.3046.010303 = phi i64 [ %.3115, %B2948 ], [ %storemerge, %B2340.preheader ]
  %.3043.010302 = phi i64 [ %.3119, %B2948 ], [ 0, %B2340.preheader ]
  %.3115 = add nsw i64 %.3046.010303, -1
  %.3119 = add nsw i64 %.3043.010302, 1
  %.3200 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.3043.010302
  %.3201 = load i64, ptr %.3200, align 8
  %.3251 = getelementptr i64, ptr %39, i64 %.3043.010302
  %.3252 = load i64, ptr %.3251, align 8
  %.3308 = getelementptr double, ptr %40, i64 %.3043.010302
  store double 0.000000e+00, ptr %.3308, align 8
  %.3311 = icmp sgt i64 %.3201, -1
  br i1 %.3311, label %B2472, label %B2948

B46.i2751:                                        ; preds = %B2520
  %.120.i2776 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2743
  %.121.i2777 = load i64, ptr %.120.i2776, align 8, !noalias !54
  %.122.i2778 = icmp eq i64 %.121.i2777, 0
  br i1 %.122.i2778, label %B80.i2783, label %B2630

B80.i2783:                                        ; preds = %B46.i2751
  store i64 %.5.i, ptr %.120.i2776, align 8, !noalias !54
  br label %B2630

B3200.endif.if:                                   ; preds = %B3200
  %.4272 = load ptr, ptr %excinfo.10, align 8
  store ptr %.4272, ptr %excinfo, align 8
  br label %common.ret

B3404.if:                                         ; preds = %B3356
  %.4464 = load i64, ptr %132, align 8
  %.4509 = inttoptr i64 %.4464 to ptr
  tail call void %.4509(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.4560(ptr %.577, ptr %.4534, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4559)
  %.4464.1 = load i64, ptr %133, align 8
  %.4509.1 = inttoptr i64 %.4464.1 to ptr
  tail call void %.4509.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.4560(ptr %.577, ptr %.4534, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4559.1)
  %.4464.2 = load i64, ptr %134, align 8
  %.4509.2 = inttoptr i64 %.4464.2 to ptr
  tail call void %.4509.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.4560(ptr %.577, ptr %.4534, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4559.2)
  %.4598 = load i64, ptr %.4597, align 8
  %.4643 = inttoptr i64 %.4598 to ptr
  tail call void %.4643(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4675 = load i64, ptr %.4674, align 8
  %.4720 = inttoptr i64 %.4675 to ptr
  tail call void %.4720(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %good.2.1.lcssa.not = xor i1 %good.2.1.lcssa, true
  %brmerge10459 = or i1 %.815, %good.2.1.lcssa.not
  br i1 %brmerge10459, label %B3778, label %B64.if.i3739

B3782.endif.if:                                   ; preds = %B3782
  %.4854 = load ptr, ptr %excinfo.12, align 8
  store ptr %.4854, ptr %excinfo, align 8
  br label %common.ret

B3782.endif.endif:                                ; preds = %B3782
  %.4863 = load i8, ptr %.4798, align 1
  %.4866.not = icmp eq i8 %.4863, 0
  br i1 %.4866.not, label %B3892, label %B3850

B3850.if:                                         ; preds = %_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.13.3, ptr %excinfo, align 8
  br label %common.ret

B3896.if:                                         ; preds = %_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.14.3, ptr %excinfo, align 8
  br label %common.ret

B3940.if:                                         ; preds = %_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.15.2, ptr %excinfo, align 8
  br label %common.ret

B4420.if:                                         ; preds = %B4378, %B5581
  %active.5.210448 = phi i64 [ %active.6.3, %B5581 ], [ 0, %B4378 ]
  %budget.5.210447 = phi i64 [ %budget.6.3, %B5581 ], [ %.1146, %B4378 ]
  %.5736.010446 = phi i64 [ %.5805, %B5581 ], [ %storemerge, %B4378 ]
  %.5733.010445 = phi i64 [ %.5809, %B5581 ], [ 0, %B4378 ]
  %.5805 = add nsw i64 %.5736.010446, -1
  %.5809 = add nsw i64 %.5733.010445, 1
  %.5890 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5733.010445
  %.5891 = load i64, ptr %.5890, align 8
  %.5896 = icmp slt i64 %.5891, 0
  br i1 %.5896, label %B5581, label %B4478

B5580.endif:                                      ; preds = %B682.i1878, %B5580
  store i64 %active.10.0, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr noalias nonnull %retptr, ptr noalias nonnull %excinfo, ptr readonly %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.decided, ptr readonly %arg.times.4, i64 %arg.times.5.0, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0) unnamed_addr {
entry:
  %0 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.228 = getelementptr i8, ptr %0, i64 -8
  %.229 = load double, ptr %.228, align 8
  %.258 = load double, ptr %arg.times.4, align 8
  %.259 = fsub double %.229, %.258
  %.260 = fmul double %.259, 1.000000e-13
  %.298 = icmp sgt i64 %arg.shape.2, 4
  %. = select i1 %.298, i64 0, i64 8
  %.356 = sub nsw i64 9, %.
  %.5221302.not = icmp slt i64 %arg.shape.0, 1
  %factor.op.mul = mul i64 %arg.decided, 3
  %.idx1285 = mul i64 %arg.lane.0.5.1, 48
  %1 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1285
  %.idx1286 = shl i64 %arg.lane.0.5.1, 6
  %2 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1286
  %.287.i1299.not = icmp slt i64 %arg.shape.1, 1
  %.358.i = shl nsw i64 %arg.shape.1, 4
  %.646.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.709 = getelementptr i8, ptr %arg.code.4, i64 40
  %.750.idx = shl i64 %arg.lane.0.5.1, 6
  %.750 = getelementptr i8, ptr %arg.lane.0.4, i64 %.750.idx
  %.781 = mul i64 %arg.shape.1, %arg.shape.0
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6 = mul nsw i64 %arg.shape.1, 18
  br label %B256.if

B290.loopexit:                                    ; preds = %B122.if.i, %switch.end
  %exitcond1319.not = icmp eq i64 %arg.shape.0, %.535
  br i1 %exitcond1319.not, label %B358, label %B290.if

B358:                                             ; preds = %B290.loopexit, %B256.if
  %.636 = icmp ult i64 %.343.01305, 8
  %.1288 = select i1 %.636, i64 16, i64 17
  %.652 = mul i64 %.646.reass, %.343.01305
  %.710 = load i64, ptr %.709, align 8
  %.785 = mul i64 %.781, %.1288
  %.803 = getelementptr double, ptr %arg.arrays.0.4, i64 %.785
  %.828 = getelementptr double, ptr %arg.arrays.4.4, i64 %.652
  %.829 = inttoptr i64 %.710 to ptr
  tail call void %.829(ptr %.750, ptr %.803, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.828)
  %.401 = icmp sgt i64 %.346.01306, 1
  br i1 %.401, label %B256.if, label %B600

B600:                                             ; preds = %B358
  %.9371308 = icmp sgt i64 %arg.shape.0, 0
  br i1 %.9371308, label %B634.lr.ph, label %B1548

B634.lr.ph:                                       ; preds = %B600
  %.883.11311 = add nsw i64 %arg.shape.0, -1
  %factor.op.mul1307 = mul i64 %arg.decided, 3
  %.idx = mul i64 %arg.lane.0.5.1, 56
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx1274 = shl i64 %arg.lane.1.5.1, 5
  %4 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1274
  %.idx1275 = shl i64 %arg.lane.0.5.1, 6
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1275
  %.idx1276 = mul i64 %arg.lane.0.5.1, 40
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1276
  %.1289 = select i1 %.298, i64 0, i64 7
  %storemerge1277 = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.194.i79 = mul nsw i64 %arg.decided, %arg.shape.0
  %.idx1279 = mul i64 %arg.lane.0.5.1, 112
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1279
  %.idx1280 = mul i64 %arg.lane.0.5.1, 120
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1280
  %.idx1281 = mul i64 %arg.lane.0.5.1, 48
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1281
  %.1818 = fmul double %.260, 2.000000e+00
  %.41.i.reass = mul i64 %factor.op.mul1307, %arg.shape.0
  %.239454.i = icmp sgt i64 %arg.decided, 0
  %.183.1457.i = add nsw i64 %arg.decided, -1
  %.454.i.i = shl i64 %.41.i.reass, 1
  %.320.i1291 = shl nsw i64 %arg.decided, 1
  %.456.i.2.i = shl i64 %.41.i.reass, 2
  %.456.i.3.i = mul i64 %.41.i.reass, 6
  %.456.i.4.i = shl i64 %.41.i.reass, 3
  %.190.i.1.i = mul nsw i64 %.41.i.reass, 3
  %.190.i.2.i = mul nsw i64 %.41.i.reass, 5
  %.190.i.3.i = mul nsw i64 %.41.i.reass, 7
  %.idx1283 = shl i64 %arg.lane.0.5.1, 5
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1283
  %11 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  br label %B634

B634:                                             ; preds = %B634.lr.ph, %B1544
  %.927.sroa.0.01316 = phi i64 [ 0, %B634.lr.ph ], [ %.927.sroa.0.0, %B1544 ]
  %.883.11315 = phi i64 [ %.883.11311, %B634.lr.ph ], [ %.883.1, %B1544 ]
  %.880.11314 = phi i64 [ 1, %B634.lr.ph ], [ %.880.1, %B1544 ]
  %some.2.01313 = phi i1 [ false, %B634.lr.ph ], [ %some.3.1, %B1544 ]
  %excinfo.3.01312 = phi ptr [ null, %B634.lr.ph ], [ %excinfo.3.1, %B1544 ]
  %.1008 = icmp slt i64 %.927.sroa.0.01316, 0
  %.1009 = select i1 %.1008, i64 %arg.lane.0.5.1, i64 0
  %.1010 = add i64 %.1009, %.927.sroa.0.01316
  %.1031 = getelementptr double, ptr %3, i64 %.1010
  %.1032 = load double, ptr %.1031, align 8
  %.1060 = select i1 %.1008, i64 %arg.lane.1.5.1, i64 0
  %.1061 = add i64 %.1060, %.927.sroa.0.01316
  %.1082 = getelementptr i64, ptr %4, i64 %.1061
  store i64 -1, ptr %.1082, align 8
  %.1133 = getelementptr double, ptr %5, i64 %.1010
  store double %.1032, ptr %.1133, align 8
  %.1184 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1061
  %.1185 = load i64, ptr %.1184, align 8
  %.1186 = icmp sgt i64 %.1185, -1
  br i1 %.1186, label %B792, label %B1544

B792:                                             ; preds = %B634
  %.1240 = getelementptr double, ptr %6, i64 %.1010
  %.1241 = load double, ptr %.1240, align 8
  %.1242 = fcmp ogt double %.1241, 5.000000e-01
  br i1 %.1242, label %B842, label %B1544

B842:                                             ; preds = %B792
  %.1328 = load i64, ptr %.1082, align 8
  %.1329 = icmp slt i64 %.1328, 0
  br i1 %.1329, label %B940, label %B1088

B940:                                             ; preds = %B842, %B1040
  %last.2.3 = phi i64 [ %.1335, %B1040 ], [ %.1289, %B842 ]
  %.1335 = add nsw i64 %last.2.3, 1
  %.151.i51 = mul nsw i64 %.1335, 3
  %.153.i521278 = add nsw i64 %.151.i51, 1
  %.155.i = mul i64 %.153.i521278, %arg.decided
  br label %B34.i

B34.i:                                            ; preds = %B36.i, %B940
  %.51.i13.0 = phi i64 [ 0, %B940 ], [ %.122.i103, %B36.i ]
  %exitcond1320.not = icmp eq i64 %.51.i13.0, %storemerge1277
  br i1 %exitcond1320.not, label %B940.endif, label %B36.i

B36.i:                                            ; preds = %B34.i
  %.122.i103 = add i64 %.51.i13.0, 1
  %.157.i54 = add nsw i64 %.51.i13.0, %.155.i
  %.159.i = mul nsw i64 %.157.i54, %arg.shape.0
  %.161.i = add nsw i64 %.159.i, %.927.sroa.0.01316
  %.175.i63 = icmp slt i64 %.161.i, 0
  %.176.i64 = select i1 %.175.i63, i64 %arg.arrays.4.5.0, i64 0
  %12 = getelementptr double, ptr %arg.arrays.4.4, i64 %.161.i
  %.190.i = getelementptr double, ptr %12, i64 %.176.i64
  %.191.i = load double, ptr %.190.i, align 8, !noalias !371
  %.195.i80 = add nsw i64 %.161.i, %.194.i79
  %.209.i = icmp slt i64 %.195.i80, 0
  %.210.i = select i1 %.209.i, i64 %arg.arrays.4.5.0, i64 0
  %13 = getelementptr double, ptr %arg.arrays.4.4, i64 %.195.i80
  %.224.i91 = getelementptr double, ptr %13, i64 %.210.i
  %.225.i92 = load double, ptr %.224.i91, align 8, !noalias !371
  %.226.i93 = fneg double %.225.i92
  %.227.i94 = fcmp olt double %.191.i, %.226.i93
  br i1 %.227.i94, label %B940.endif, label %B34.i

B1040:                                            ; preds = %B940.endif
  %.1489 = icmp slt i64 %.1350.0, 0
  br i1 %.1489, label %B940, label %B1088

B1088:                                            ; preds = %B940.endif, %B1040, %B842
  %last.3.2 = phi i64 [ %.1289, %B842 ], [ %.1335, %B1040 ], [ 8, %B940.endif ]
  br i1 %.298, label %B1096, label %B1126

B1096:                                            ; preds = %B1088
  %14 = getelementptr double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %last.3.2
  %switch.gep = getelementptr i8, ptr %14, i64 64
  %switch.load = load double, ptr %switch.gep, align 8
  br label %B1126

B1126:                                            ; preds = %B1096, %B1088
  %"$phi1126.1.2.2" = phi double [ 0.000000e+00, %B1088 ], [ %switch.load, %B1096 ]
  %.1597 = getelementptr double, ptr %7, i64 %.1010
  store double %"$phi1126.1.2.2", ptr %.1597, align 8
  %15 = getelementptr double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %last.3.2
  %switch.gep4 = getelementptr i8, ptr %15, i64 72
  %switch.load5 = load double, ptr %switch.gep4, align 8
  %.1685 = getelementptr double, ptr %8, i64 %.1010
  store double %switch.load5, ptr %.1685, align 8
  %.1737 = load i64, ptr %.1082, align 8
  %.1738 = icmp sgt i64 %.1737, -1
  %.1748 = sext i1 %.1738 to i64
  %"$phi1274.1.2.2" = add nsw i64 %last.3.2, %.1748
  br i1 %.298, label %B1282, label %B1492

B1282:                                            ; preds = %B1126
  %.1815 = getelementptr double, ptr %9, i64 %.1010
  %.1816 = load double, ptr %.1815, align 8
  %.1819 = fcmp ogt double %.1816, %.1818
  br i1 %.1819, label %B1340, label %B1492

B1340:                                            ; preds = %B1282
  %.96.i = load double, ptr %.1031, align 8, !noalias !375
  %.97.i = tail call double @llvm.fabs.f64(double %.96.i)
  %.98.i = fmul double %.97.i, 1.000000e-15
  %.152.i = fdiv double %.98.i, %.1816
  br i1 %.239454.i, label %B178.lr.ph.i, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B178.lr.ph.i:                                     ; preds = %B1340
  %16 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1274.1.2.2", i64 0)
  %storemerge409.i = tail call i64 @llvm.smin.i64(i64 %16, i64 7)
  %.690444.i = icmp sgt i64 %"$phi1274.1.2.2", 0
  %.633.1446.i = select i1 %.690444.i, i64 2, i64 1
  %.699447.i = sext i1 %.690444.i to i64
  %.636.1448.i = add nsw i64 %storemerge409.i, %.699447.i
  %.680.sroa.0.0449.i = zext i1 %.690444.i to i64
  br label %B178.i

B178.i:                                           ; preds = %B1225.i, %B178.lr.ph.i
  %.229.sroa.0.0461.i = phi i64 [ 0, %B178.lr.ph.i ], [ %.229.sroa.0.0.i, %B1225.i ]
  %.183.1460.i = phi i64 [ %.183.1457.i, %B178.lr.ph.i ], [ %.183.1.i, %B1225.i ]
  %.180.1459.i = phi i64 [ 1, %B178.lr.ph.i ], [ %.180.1.i, %B1225.i ]
  %.278.i = add nsw i64 %.229.sroa.0.0461.i, %arg.decided
  %.280.i = mul nsw i64 %.278.i, %arg.shape.0
  %.282.i = add nsw i64 %.280.i, %.927.sroa.0.01316
  %.192.i.i = add nsw i64 %.282.i, %.41.i.reass
  %.206.i.i = icmp slt i64 %.192.i.i, 0
  %.207.i.i = select i1 %.206.i.i, i64 %arg.arrays.4.5.0, i64 0
  %17 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.i
  %.221.i.i = getelementptr double, ptr %17, i64 %.207.i.i
  %.222.i.i = load double, ptr %.221.i.i, align 8, !noalias !379
  %.472.i.i = icmp slt i64 %.282.i, 0
  %.473.i.i = select i1 %.472.i.i, i64 %arg.arrays.4.5.0, i64 0
  %18 = getelementptr double, ptr %arg.arrays.4.4, i64 %.282.i
  %.487.i.i = getelementptr double, ptr %18, i64 %.473.i.i
  %.488.i.i = load double, ptr %.487.i.i, align 8, !noalias !379
  %.489.i.i = fmul double %.488.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i = fsub double %.222.i.i, %.489.i.i
  %.458.i.1.i = add nsw i64 %.282.i, %.454.i.i
  %.472.i.1.i = icmp slt i64 %.458.i.1.i, 0
  %.473.i.1.i = select i1 %.472.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %19 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.1.i
  %.487.i.1.i = getelementptr double, ptr %19, i64 %.473.i.1.i
  %.488.i.1.i = load double, ptr %.487.i.1.i, align 8, !noalias !379
  %.489.i.1.i = fmul double %.488.i.1.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i = fsub double %.491.i.i, %.489.i.1.i
  %.458.i.2.i = add nsw i64 %.282.i, %.456.i.2.i
  %.472.i.2.i = icmp slt i64 %.458.i.2.i, 0
  %.473.i.2.i = select i1 %.472.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %20 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.2.i
  %.487.i.2.i = getelementptr double, ptr %20, i64 %.473.i.2.i
  %.488.i.2.i = load double, ptr %.487.i.2.i, align 8, !noalias !379
  %.489.i.2.i = fmul double %.488.i.2.i, 0x3FE1306AA3D795F4
  %21 = fadd double %.491.i.1.i, %.489.i.2.i
  %.458.i.3.i = add nsw i64 %.282.i, %.456.i.3.i
  %.472.i.3.i = icmp slt i64 %.458.i.3.i, 0
  %.473.i.3.i = select i1 %.472.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %22 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.3.i
  %.487.i.3.i = getelementptr double, ptr %22, i64 %.473.i.3.i
  %.488.i.3.i = load double, ptr %.487.i.3.i, align 8, !noalias !379
  %.489.i.3.i = fmul double %.488.i.3.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i = fsub double %21, %.489.i.3.i
  %.458.i.4.i = add nsw i64 %.282.i, %.456.i.4.i
  %.472.i.4.i = icmp slt i64 %.458.i.4.i, 0
  %.473.i.4.i = select i1 %.472.i.4.i, i64 %arg.arrays.4.5.0, i64 0
  %23 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.4.i
  %.487.i.4.i = getelementptr double, ptr %23, i64 %.473.i.4.i
  %.488.i.4.i = load double, ptr %.487.i.4.i, align 8, !noalias !379
  %.489.i.4.i = fmul double %.488.i.4.i, 0x3FA4EAF2D6B11E79
  %24 = fadd double %.491.i.3.i, %.489.i.4.i
  %.502.i.i = tail call double @llvm.fabs.f64(double %24)
  %.10.i.i.i = fcmp ogt double %.502.i.i, 0.000000e+00
  %.11.i.i.i = select i1 %.10.i.i.i, double %.502.i.i, double 0.000000e+00
  %.192.i.1.i = add nsw i64 %.282.i, %.190.i.1.i
  %.206.i.1.i = icmp slt i64 %.192.i.1.i, 0
  %.207.i.1.i = select i1 %.206.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %25 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.1.i
  %.221.i.1.i = getelementptr double, ptr %25, i64 %.207.i.1.i
  %.222.i.1.i = load double, ptr %.221.i.1.i, align 8, !noalias !379
  %.489.i.1499.i = fmul double %.488.i.i, 0x3FA5118805F8B876
  %26 = fadd double %.222.i.1.i, %.489.i.1499.i
  %.489.i.1.1.i = fmul double %.488.i.1.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i = fsub double %26, %.489.i.1.1.i
  %.489.i.2.1.i = fmul double %.488.i.2.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i = fsub double %.491.i.1.1.i, %.489.i.2.1.i
  %.489.i.3.1.i = fmul double %.488.i.3.i, 0x3FC0DA0C684D1D67
  %27 = fadd double %.491.i.2.1.i, %.489.i.3.1.i
  %.489.i.4.1.i = fmul double %.488.i.4.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i = fsub double %27, %.489.i.4.1.i
  %.502.i.1.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i)
  %.10.i.i.1.i = fcmp ogt double %.502.i.1.i, %.11.i.i.i
  %.11.i.i.1.i = select i1 %.10.i.i.1.i, double %.502.i.1.i, double %.11.i.i.i
  %.192.i.2.i = add nsw i64 %.282.i, %.190.i.2.i
  %.206.i.2.i = icmp slt i64 %.192.i.2.i, 0
  %.207.i.2.i = select i1 %.206.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %28 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.2.i
  %.221.i.2.i = getelementptr double, ptr %28, i64 %.207.i.2.i
  %.222.i.2.i = load double, ptr %.221.i.2.i, align 8, !noalias !379
  %.489.i.2526.i = fmul double %.488.i.i, 0x3F9635A30F8F142F
  %.491.i.2527.i = fsub double %.222.i.2.i, %.489.i.2526.i
  %.489.i.1.2.i = fmul double %.488.i.1.i, 0x3FC1EAE0FF33D241
  %29 = fadd double %.491.i.2527.i, %.489.i.1.2.i
  %.489.i.2.2.i = fmul double %.488.i.2.i, 0x3FE1625D59218460
  %.491.i.2.2.i = fsub double %29, %.489.i.2.2.i
  %.489.i.3.2.i = fmul double %.488.i.3.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i = fsub double %.491.i.2.2.i, %.489.i.3.2.i
  %.489.i.4.2.i = fmul double %.488.i.4.i, 0x3FA55161A739EB34
  %30 = fadd double %.491.i.3.2.i, %.489.i.4.2.i
  %.502.i.2.i = tail call double @llvm.fabs.f64(double %30)
  %.10.i.i.2.i = fcmp ogt double %.502.i.2.i, %.11.i.i.1.i
  %.11.i.i.2.i = select i1 %.10.i.i.2.i, double %.502.i.2.i, double %.11.i.i.1.i
  %.192.i.3.i = add nsw i64 %.282.i, %.190.i.3.i
  %.206.i.3.i = icmp slt i64 %.192.i.3.i, 0
  %.207.i.3.i = select i1 %.206.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %31 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.3.i
  %.221.i.3.i = getelementptr double, ptr %31, i64 %.207.i.3.i
  %.222.i.3.i = load double, ptr %.221.i.3.i, align 8, !noalias !379
  %.489.i.3553.i = fmul double %.488.i.i, 0x3FA4F0C0BB579409
  %32 = fadd double %.222.i.3.i, %.489.i.3553.i
  %.489.i.1.3.i = fmul double %.488.i.1.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i = fsub double %32, %.489.i.1.3.i
  %.489.i.2.3.i = fmul double %.488.i.2.i, 0x3FE1F2DB6FEE3151
  %33 = fadd double %.491.i.1.3.i, %.489.i.2.3.i
  %.489.i.3.3.i = fmul double %.488.i.3.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i = fsub double %33, %.489.i.3.3.i
  %.489.i.4.3.i = fmul double %.488.i.4.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i = fsub double %.491.i.3.3.i, %.489.i.4.3.i
  %.502.i.3.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i)
  %.10.i.i.3.i = fcmp ogt double %.502.i.3.i, %.11.i.i.2.i
  %.11.i.i.3.i = select i1 %.10.i.i.3.i, double %.502.i.3.i, double %.11.i.i.2.i
  %.321.i1292 = add nsw i64 %.229.sroa.0.0461.i, %.320.i1291
  %.323.i = mul nsw i64 %.321.i1292, %arg.shape.0
  %.325.i = add nsw i64 %.323.i, %.927.sroa.0.01316
  %34 = getelementptr double, ptr %arg.arrays.4.4, i64 %.325.i
  %.339.i = icmp slt i64 %.325.i, 0
  %.340.i = select i1 %.339.i, i64 %arg.arrays.4.5.0, i64 0
  %.354.i = getelementptr double, ptr %34, i64 %.340.i
  %.355.i = load double, ptr %.354.i, align 8, !noalias !375
  %.548.i = fsub double %.222.i.i, %.488.i.i
  %.549.i = tail call double @llvm.fabs.f64(double %.548.i)
  %.551.i = fmul double %.152.i, %.549.i
  %.553.i = fadd double %.551.i, %.355.i
  %.548.1.i = fsub double %.488.i.1.i, %.222.i.i
  %.549.1.i = tail call double @llvm.fabs.f64(double %.548.1.i)
  %.551.1.i = fmul double %.152.i, %.549.1.i
  %.553.1.i = fadd double %.551.1.i, %.553.i
  %.548.2.i = fsub double %.222.i.1.i, %.488.i.1.i
  %.549.2.i = tail call double @llvm.fabs.f64(double %.548.2.i)
  %.551.2.i = fmul double %.152.i, %.549.2.i
  %.553.2.i = fadd double %.551.2.i, %.553.1.i
  %.548.3.i = fsub double %.488.i.2.i, %.222.i.1.i
  %.549.3.i = tail call double @llvm.fabs.f64(double %.548.3.i)
  %.551.3.i = fmul double %.152.i, %.549.3.i
  %.553.3.i = fadd double %.551.3.i, %.553.2.i
  %.548.4.i = fsub double %.222.i.2.i, %.488.i.2.i
  %.549.4.i = tail call double @llvm.fabs.f64(double %.548.4.i)
  %.551.4.i = fmul double %.152.i, %.549.4.i
  %.553.4.i = fadd double %.551.4.i, %.553.3.i
  %.548.5.i = fsub double %.488.i.3.i, %.222.i.2.i
  %.549.5.i = tail call double @llvm.fabs.f64(double %.548.5.i)
  %.551.5.i = fmul double %.152.i, %.549.5.i
  %.553.5.i = fadd double %.551.5.i, %.553.4.i
  %.548.6.i = fsub double %.222.i.3.i, %.488.i.3.i
  %.549.6.i = tail call double @llvm.fabs.f64(double %.548.6.i)
  %.551.6.i = fmul double %.152.i, %.549.6.i
  %.553.6.i = fadd double %.551.6.i, %.553.5.i
  %.548.7.i = fsub double %.488.i.4.i, %.222.i.3.i
  %.549.7.i = tail call double @llvm.fabs.f64(double %.548.7.i)
  %.551.7.i = fmul double %.152.i, %.549.7.i
  %.553.7.i = fadd double %.551.7.i, %.553.6.i
  %.563.i = fcmp ugt double %.11.i.i.3.i, %.553.7.i
  br i1 %.563.i, label %B462.i, label %B1225.i

B462.i:                                           ; preds = %B178.i
  br i1 %.690444.i, label %B542.lr.ph.i, label %B1186.i

B542.lr.ph.i:                                     ; preds = %B462.i
  %.958.i = fmul double %.11.i.i.3.i, 1.000000e+01
  br label %B542.i

B542.i:                                           ; preds = %B1226.i, %B542.lr.ph.i
  %.680.sroa.0.0453.i = phi i64 [ %.680.sroa.0.0449.i, %B542.lr.ph.i ], [ %.680.sroa.0.0.i, %B1226.i ]
  %.636.1452.i = phi i64 [ %.636.1448.i, %B542.lr.ph.i ], [ %.636.1.i, %B1226.i ]
  %.633.1451.i = phi i64 [ %.633.1446.i, %B542.lr.ph.i ], [ %.633.1.i, %B1226.i ]
  %nearest.3.2450.i = phi double [ 0x7FF0000000000000, %B542.lr.ph.i ], [ %nearest.4.3.i, %B1226.i ]
  %.732.i = add nsw i64 %.680.sroa.0.0453.i, -1
  %.734.i = mul nsw i64 %.732.i, %.41.i.reass
  %.736.i = add nsw i64 %.734.i, %.282.i
  %.750.i = icmp slt i64 %.736.i, 0
  %.751.i = select i1 %.750.i, i64 %arg.arrays.4.5.0, i64 0
  %35 = getelementptr double, ptr %arg.arrays.4.4, i64 %.736.i
  %.765.i = getelementptr double, ptr %35, i64 %.751.i
  %.766.i = load double, ptr %.765.i, align 8, !noalias !375
  %.769.i = mul nsw i64 %.680.sroa.0.0453.i, %.41.i.reass
  %.771.i = add nsw i64 %.769.i, %.282.i
  %.785.i = icmp slt i64 %.771.i, 0
  %.786.i = select i1 %.785.i, i64 %arg.arrays.4.5.0, i64 0
  %36 = getelementptr double, ptr %arg.arrays.4.4, i64 %.771.i
  %.800.i = getelementptr double, ptr %36, i64 %.786.i
  %.801.i = load double, ptr %.800.i, align 8, !noalias !375
  %.803.i = add nsw i64 %.680.sroa.0.0453.i, 1
  %.805.i = mul nsw i64 %.803.i, %.41.i.reass
  %.807.i = add nsw i64 %.805.i, %.282.i
  %.821.i = icmp slt i64 %.807.i, 0
  %.822.i = select i1 %.821.i, i64 %arg.arrays.4.5.0, i64 0
  %37 = getelementptr double, ptr %arg.arrays.4.4, i64 %.807.i
  %.836.i = getelementptr double, ptr %37, i64 %.822.i
  %.837.i = load double, ptr %.836.i, align 8, !noalias !375
  %.860.i = fcmp olt double %.801.i, 0.000000e+00
  %.863.i = fneg double %.766.i
  %.867.i = fneg double %.801.i
  %.871.i = fneg double %.837.i
  %c.2.3.i = select i1 %.860.i, double %.871.i, double %.837.i
  %b.2.3.i = select i1 %.860.i, double %.867.i, double %.801.i
  %a.2.3.i = select i1 %.860.i, double %.863.i, double %.766.i
  %.888.i = icmp eq i64 %.680.sroa.0.0453.i, 1
  %.895.i = fcmp ogt double %a.2.3.i, 0.000000e+00
  %or.cond.i = select i1 %.888.i, i1 true, i1 %.895.i
  br i1 %or.cond.i, label %B694.i, label %B750.i

B694.i:                                           ; preds = %B542.i
  %.901.i = icmp eq i64 %.680.sroa.0.0453.i, %"$phi1274.1.2.2"
  %.907.i = fcmp ogt double %c.2.3.i, 0.000000e+00
  %or.cond410.i = select i1 %.901.i, i1 true, i1 %.907.i
  br i1 %or.cond410.i, label %B718.i, label %B750.i

B718.i:                                           ; preds = %B694.i
  %.10.i.i = fcmp olt double %b.2.3.i, %nearest.3.2450.i
  %.11.i412.i = select i1 %.10.i.i, double %b.2.3.i, double %nearest.3.2450.i
  br label %B750.i

B750.i:                                           ; preds = %B718.i, %B694.i, %B542.i
  %nearest.5.4.i = phi double [ %.11.i412.i, %B718.i ], [ %nearest.3.2450.i, %B694.i ], [ %nearest.3.2450.i, %B542.i ]
  %.952.i = icmp slt i64 %.680.sroa.0.0453.i, %"$phi1274.1.2.2"
  br i1 %.952.i, label %B762.i, label %B1226.i

B762.i:                                           ; preds = %B750.i
  %.961.i = fsub double %a.2.3.i, %b.2.3.i
  %.962.i = tail call double @llvm.fabs.f64(double %.961.i)
  %.965.i = fsub double %c.2.3.i, %b.2.3.i
  %.966.i = tail call double @llvm.fabs.f64(double %.965.i)
  %.967.i = fadd double %.962.i, %.966.i
  %.968.i = fmul double %.967.i, 3.000000e+00
  %.969.i = fadd double %.958.i, %.968.i
  %.971.i = fcmp olt double %b.2.3.i, %.969.i
  br i1 %.971.i, label %B872.i, label %B1226.i

B872.i:                                           ; preds = %B762.i
  %switch.tableidx6 = add i64 %.680.sroa.0.0453.i, 9
  %38 = icmp ult i64 %switch.tableidx6, 18
  br i1 %38, label %switch.lookup7, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1078.i:                                          ; preds = %switch.lookup19
  %.1180.i = fneg double %.1121.i
  %.1184.i = fmul double %.1170.i, 5.000000e-01
  %.1189.i = fdiv double %.1184.i, %.1153.i
  %.1190.i = fcmp ogt double %.1189.i, %.1180.i
  %.1200.i = fcmp olt double %.1189.i, %.1047.i
  %or.cond411.i = and i1 %.1190.i, %.1200.i
  br i1 %or.cond411.i, label %B1118.i, label %B1226.i

B1118.i:                                          ; preds = %B1078.i
  %.1227.i = fmul double %.1170.i, 2.500000e-01
  %.1229.i = fmul double %.1170.i, %.1227.i
  %.1236.i = fdiv double %.1229.i, %.1153.i
  %.1240.i = fsub double %b.2.3.i, %.1236.i
  %.10.i413.i = fcmp olt double %.1240.i, %nearest.5.4.i
  %.11.i414.i = select i1 %.10.i413.i, double %.1240.i, double %nearest.5.4.i
  br label %B1226.i

B1186.i:                                          ; preds = %B1226.i, %B462.i
  %nearest.3.2.lcssa.i = phi double [ 0x7FF0000000000000, %B462.i ], [ %nearest.4.3.i, %B1226.i ]
  %.1308.i = fmul double %.11.i.i.3.i, 1.000000e+01
  %.1312.i = fcmp ugt double %nearest.3.2.lcssa.i, %.1308.i
  br i1 %.1312.i, label %B1225.i, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1225.i:                                          ; preds = %B1186.i, %B178.i
  %.239.i = icmp sgt i64 %.183.1460.i, 0
  %.252.i = zext i1 %.239.i to i64
  %.180.1.i = add i64 %.180.1459.i, %.252.i
  %.248.i = sext i1 %.239.i to i64
  %.183.1.i = add nsw i64 %.183.1460.i, %.248.i
  %.229.sroa.0.0.i = select i1 %.239.i, i64 %.180.1459.i, i64 0
  br i1 %.239.i, label %B178.i, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1226.i:                                          ; preds = %switch.lookup19, %B1118.i, %B1078.i, %B762.i, %B750.i
  %nearest.4.3.i = phi double [ %nearest.5.4.i, %B1078.i ], [ %.11.i414.i, %B1118.i ], [ %nearest.5.4.i, %B750.i ], [ %nearest.5.4.i, %switch.lookup19 ], [ %nearest.5.4.i, %B762.i ]
  %.690.i = icmp sgt i64 %.636.1452.i, 0
  %.703.i = zext i1 %.690.i to i64
  %.633.1.i = add i64 %.633.1451.i, %.703.i
  %.699.i = sext i1 %.690.i to i64
  %.636.1.i = add nsw i64 %.636.1452.i, %.699.i
  %.680.sroa.0.0.i = select i1 %.690.i, i64 %.633.1451.i, i64 0
  br i1 %.690.i, label %B542.i, label %B1186.i

switch.lookup7:                                   ; preds = %B872.i
  %switch.tableidx10 = add i64 %.680.sroa.0.0453.i, 8
  %39 = icmp ult i64 %switch.tableidx10, 18
  br i1 %39, label %switch.lookup11, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup11:                                  ; preds = %switch.lookup7
  %switch.gep8 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx6
  %switch.load9 = load double, ptr %switch.gep8, align 8
  %switch.gep12 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx10
  %switch.load13 = load double, ptr %switch.gep12, align 8
  %.1047.i = fsub double %switch.load9, %switch.load13
  %switch.tableidx14 = add i64 %.680.sroa.0.0453.i, 10
  %40 = icmp ult i64 %switch.tableidx14, 18
  br i1 %40, label %switch.lookup15, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup15:                                  ; preds = %switch.lookup11
  %switch.tableidx18 = add i64 %.680.sroa.0.0453.i, 9
  %41 = icmp ult i64 %switch.tableidx18, 18
  br i1 %41, label %switch.lookup19, label %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup19:                                  ; preds = %switch.lookup15
  %switch.gep16 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx14
  %switch.load17 = load double, ptr %switch.gep16, align 8
  %switch.gep20 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.22, i64 %switch.tableidx18
  %switch.load21 = load double, ptr %switch.gep20, align 8
  %.1121.i = fsub double %switch.load17, %switch.load21
  %.1137.i = fdiv double %.965.i, %.1121.i
  %.1140.i = fsub double %b.2.3.i, %a.2.3.i
  %.1145.i = fdiv double %.1140.i, %.1047.i
  %.1146.i = fsub double %.1137.i, %.1145.i
  %.1149.i = fadd double %.1047.i, %.1121.i
  %.1153.i = fdiv double %.1146.i, %.1149.i
  %.1169.i = fmul double %.1047.i, %.1153.i
  %.1170.i = fadd double %.1145.i, %.1169.i
  %.1175.i = fcmp ogt double %.1153.i, 0.000000e+00
  br i1 %.1175.i, label %B1078.i, label %B1226.i

_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1225.i, %B1186.i, %B872.i, %switch.lookup7, %switch.lookup11, %switch.lookup15, %B1340
  %.1857.not = phi i1 [ true, %B1340 ], [ true, %B872.i ], [ true, %switch.lookup15 ], [ true, %switch.lookup11 ], [ true, %switch.lookup7 ], [ true, %B1225.i ], [ false, %B1186.i ]
  %excinfo.3.3 = phi ptr [ %excinfo.3.01312, %B1340 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %B872.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup15 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup11 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup7 ], [ %excinfo.3.01312, %B1186.i ], [ %excinfo.3.01312, %B1225.i ]
  %.1846.not = phi i1 [ true, %B1340 ], [ false, %B872.i ], [ false, %switch.lookup15 ], [ false, %switch.lookup11 ], [ false, %switch.lookup7 ], [ true, %B1186.i ], [ true, %B1225.i ]
  %common.ret.op.i = phi i32 [ 0, %B1340 ], [ 1, %B872.i ], [ 1, %switch.lookup15 ], [ 1, %switch.lookup11 ], [ 1, %switch.lookup7 ], [ 0, %B1186.i ], [ 0, %B1225.i ]
  br i1 %.1846.not, label %B1340.endif.endif, label %B1340.endif.if, !prof !57

B1380:                                            ; preds = %B1340.endif.endif
  %.1928 = fmul double %.1816, 5.000000e-01
  store double 0.000000e+00, ptr %.1240, align 8, !noalias !383
  %.161.i230 = getelementptr double, ptr %10, i64 %.1010
  store double 0.000000e+00, ptr %.161.i230, align 8, !noalias !383
  %.214.i273 = getelementptr double, ptr %11, i64 %.1010
  store double %.1928, ptr %.214.i273, align 8, !noalias !383
  %.268.i313 = load i64, ptr %.1184, align 8, !noalias !383
  %.294.i = icmp slt i64 %.268.i313, 0
  %.295.i = select i1 %.294.i, i64 %arg.results.3.5.0, i64 0
  %.296.i324 = add i64 %.295.i, %.268.i313
  %.316.i333 = mul i64 %.296.i324, %arg.results.3.5.1
  %.320.i = getelementptr i64, ptr %arg.results.3.4, i64 %.316.i333
  %.321.i = load i64, ptr %.320.i, align 8, !noalias !383
  %.322.i336 = add nsw i64 %.321.i, -1
  store i64 %.322.i336, ptr %.320.i, align 8, !noalias !383
  %.426.i = load i64, ptr %.1184, align 8, !noalias !383
  %.452.i = icmp slt i64 %.426.i, 0
  %.453.i = select i1 %.452.i, i64 %arg.results.3.5.0, i64 0
  %.454.i = add i64 %.453.i, %.426.i
  %.474.i = mul i64 %.454.i, %arg.results.3.5.1
  %42 = getelementptr i64, ptr %arg.results.3.4, i64 %.474.i
  %.478.i = getelementptr i8, ptr %42, i64 24
  %.479.i = load i64, ptr %.478.i, align 8, !noalias !383
  %.480.i = add nsw i64 %.479.i, 1
  store i64 %.480.i, ptr %.478.i, align 8, !noalias !383
  store i64 -1, ptr %.1082, align 8
  br label %B1492

B1492:                                            ; preds = %B1126, %B1380, %B1340.endif.endif, %B1282
  %excinfo.3.2 = phi ptr [ %excinfo.3.3, %B1340.endif.endif ], [ %excinfo.3.3, %B1380 ], [ %excinfo.3.01312, %B1282 ], [ %excinfo.3.01312, %B1126 ]
  br i1 %some.2.01313, label %B1544, label %B1496

B1496:                                            ; preds = %B1492
  %.2084 = load i64, ptr %.1082, align 8
  %.2085 = icmp sgt i64 %.2084, -1
  br label %B1544

B1544:                                            ; preds = %B1492, %B1496, %B792, %B634
  %excinfo.3.1 = phi ptr [ %excinfo.3.2, %B1492 ], [ %excinfo.3.2, %B1496 ], [ %excinfo.3.01312, %B792 ], [ %excinfo.3.01312, %B634 ]
  %some.3.1 = phi i1 [ true, %B1492 ], [ %.2085, %B1496 ], [ %some.2.01313, %B792 ], [ %some.2.01313, %B634 ]
  %.937 = icmp sgt i64 %.883.11315, 0
  %.950 = zext i1 %.937 to i64
  %.880.1 = add i64 %.880.11314, %.950
  %.946 = sext i1 %.937 to i64
  %.883.1 = add nsw i64 %.883.11315, %.946
  %.927.sroa.0.0 = select i1 %.937, i64 %.880.11314, i64 0
  br i1 %.937, label %B634, label %B1548.loopexit

common.ret:                                       ; preds = %B1340.endif.if, %B1548
  %common.ret.op = phi i32 [ 0, %B1548 ], [ %common.ret.op.i, %B1340.endif.if ]
  ret i32 %common.ret.op

B1548.loopexit:                                   ; preds = %B1544
  %43 = zext i1 %some.3.1 to i8
  br label %B1548

B1548:                                            ; preds = %B1548.loopexit, %B600
  %some.2.0.lcssa = phi i8 [ 0, %B600 ], [ %43, %B1548.loopexit ]
  store i8 %some.2.0.lcssa, ptr %retptr, align 1
  br label %common.ret

B256.if:                                          ; preds = %entry, %B358
  %.346.01306 = phi i64 [ %.356, %entry ], [ %.410, %B358 ]
  %.343.01305 = phi i64 [ %., %entry ], [ %.414, %B358 ]
  %.410 = add nsw i64 %.346.01306, -1
  %.414 = add nsw i64 %.343.01305, 1
  br i1 %.5221302.not, label %B358, label %B290.if.preheader

B290.if.preheader:                                ; preds = %B256.if
  %44 = icmp ult i64 %.343.01305, 8
  %switch.gep23 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks11mark_passedB3v24B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.23, i64 %.343.01305
  br label %B290.if

B290.if:                                          ; preds = %B290.if.preheader, %B290.loopexit
  %.466.01303 = phi i64 [ %.535, %B290.loopexit ], [ 0, %B290.if.preheader ]
  %.535 = add nsw i64 %.466.01303, 1
  br i1 %44, label %switch.lookup22, label %switch.end

switch.lookup22:                                  ; preds = %B290.if
  %switch.load24 = load double, ptr %switch.gep23, align 8
  br label %switch.end

switch.end:                                       ; preds = %B290.if, %switch.lookup22
  %.577 = phi double [ %switch.load24, %switch.lookup22 ], [ 1.000000e+00, %B290.if ]
  %.92.i = getelementptr double, ptr %arg.lane.0.4, i64 %.466.01303
  %.93.i = load double, ptr %.92.i, align 8, !noalias !386
  %.146.i = getelementptr double, ptr %1, i64 %.466.01303
  %.147.i = load double, ptr %.146.i, align 8, !noalias !386
  %.149.i = fmul double %.577, %.147.i
  %.150.i = fadd double %.93.i, %.149.i
  %.203.i = getelementptr double, ptr %2, i64 %.466.01303
  store double %.150.i, ptr %.203.i, align 8, !noalias !386
  br i1 %.287.i1299.not, label %B290.loopexit, label %B122.if.i.lr.ph

B122.if.i.lr.ph:                                  ; preds = %switch.end
  %.247.i.i = fsub double 1.000000e+00, %.577
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep26 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep28 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep30 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep32 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep34 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep36 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep38 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  %invariant.gep40 = getelementptr double, ptr %arg.arrays.0.4, i64 %.466.01303
  br label %B122.if.i

B122.if.i:                                        ; preds = %B122.if.i.lr.ph, %B122.if.i
  %.229.i.01300 = phi i64 [ 0, %B122.if.i.lr.ph ], [ %.300.i, %B122.if.i ]
  %.157.i.i = add nsw i64 %.155.i.i, %.229.i.01300
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep, align 8, !noalias !390
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.577, %.193.i.i
  %.157.i.i.1 = add nsw i64 %.155.i.i.1, %.229.i.01300
  %.159.i.i.1 = mul nsw i64 %.157.i.i.1, %arg.shape.0
  %gep27 = getelementptr double, ptr %invariant.gep26, i64 %.159.i.i.1
  %.191.i.i.1 = load double, ptr %gep27, align 8, !noalias !390
  %.193.i.i.1 = fadd double %.253.i.i, %.191.i.i.1
  %.253.i.i.1 = fmul double %.247.i.i, %.193.i.i.1
  %.157.i.i.2 = add nsw i64 %.155.i.i.2, %.229.i.01300
  %.159.i.i.2 = mul nsw i64 %.157.i.i.2, %arg.shape.0
  %gep29 = getelementptr double, ptr %invariant.gep28, i64 %.159.i.i.2
  %.191.i.i.2 = load double, ptr %gep29, align 8, !noalias !390
  %.193.i.i.2 = fadd double %.253.i.i.1, %.191.i.i.2
  %.253.i.i.2 = fmul double %.577, %.193.i.i.2
  %.157.i.i.3 = add nsw i64 %.155.i.i.3, %.229.i.01300
  %.159.i.i.3 = mul nsw i64 %.157.i.i.3, %arg.shape.0
  %gep31 = getelementptr double, ptr %invariant.gep30, i64 %.159.i.i.3
  %.191.i.i.3 = load double, ptr %gep31, align 8, !noalias !390
  %.193.i.i.3 = fadd double %.253.i.i.2, %.191.i.i.3
  %.253.i.i.3 = fmul double %.247.i.i, %.193.i.i.3
  %.157.i.i.4 = add nsw i64 %.155.i.i.4, %.229.i.01300
  %.159.i.i.4 = mul nsw i64 %.157.i.i.4, %arg.shape.0
  %gep33 = getelementptr double, ptr %invariant.gep32, i64 %.159.i.i.4
  %.191.i.i.4 = load double, ptr %gep33, align 8, !noalias !390
  %.193.i.i.4 = fadd double %.253.i.i.3, %.191.i.i.4
  %.253.i.i.4 = fmul double %.577, %.193.i.i.4
  %.157.i.i.5 = add nsw i64 %.155.i.i.5, %.229.i.01300
  %.159.i.i.5 = mul nsw i64 %.157.i.i.5, %arg.shape.0
  %gep35 = getelementptr double, ptr %invariant.gep34, i64 %.159.i.i.5
  %.191.i.i.5 = load double, ptr %gep35, align 8, !noalias !390
  %.193.i.i.5 = fadd double %.253.i.i.4, %.191.i.i.5
  %.253.i.i.5 = fmul double %.247.i.i, %.193.i.i.5
  %.157.i.i.6 = add nsw i64 %.155.i.i.6, %.229.i.01300
  %.159.i.i.6 = mul nsw i64 %.157.i.i.6, %arg.shape.0
  %gep37 = getelementptr double, ptr %invariant.gep36, i64 %.159.i.i.6
  %.191.i.i.6 = load double, ptr %gep37, align 8, !noalias !390
  %.193.i.i.6 = fadd double %.253.i.i.5, %.191.i.i.6
  %.253.i.i.6 = fmul double %.577, %.193.i.i.6
  %.300.i = add nsw i64 %.229.i.01300, 1
  %.271.i.i = mul nsw i64 %.229.i.01300, %arg.shape.0
  %gep39 = getelementptr double, ptr %invariant.gep38, i64 %.271.i.i
  %.309.i.i = load double, ptr %gep39, align 8, !noalias !390
  %.313.i.i = fadd double %.253.i.i.6, %.309.i.i
  %.359.i = add nsw i64 %.229.i.01300, %.358.i
  %.361.i = mul nsw i64 %.359.i, %arg.shape.0
  %gep41 = getelementptr double, ptr %invariant.gep40, i64 %.361.i
  store double %.313.i.i, ptr %gep41, align 8, !noalias !386
  %exitcond.not = icmp eq i64 %arg.shape.1, %.300.i
  br i1 %exitcond.not, label %B290.loopexit, label %B122.if.i

B940.endif:                                       ; preds = %B36.i, %B34.i
  %.1350.0 = phi i64 [ %.51.i13.0, %B36.i ], [ -1, %B34.i ]
  store i64 %.1350.0, ptr %.1082, align 8
  %exitcond1321.not = icmp eq i64 %last.2.3, 7
  br i1 %exitcond1321.not, label %B1088, label %B1040

B1340.endif.if:                                   ; preds = %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.3.3, ptr %excinfo, align 8
  br label %common.ret

B1340.endif.endif:                                ; preds = %_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1857.not, label %B1492, label %B1380
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.copysign.f64(double, double)

define internal fastcc void @_ZN5pages10rate_jumps9put_ratesB3v56B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_287_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr noalias nonnull %retptr, double %arg.share, ptr readonly %arg.code.4, i64 %arg.n, ptr readonly %arg.tolerances.4, ptr %arg.numbers.4, i64 %arg.numbers.5.1, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4) unnamed_addr {
entry:
  %.155.idx = mul i64 %arg.numbers.5.1, 48
  %.155 = getelementptr i8, ptr %arg.numbers.4, i64 %.155.idx
  %.156 = load double, ptr %.155, align 8
  %.93.i = load double, ptr %arg.numbers.4, align 8, !noalias !394
  %.149.i = fmul double %arg.share, %.156
  %.150.i = fadd double %.93.i, %.149.i
  %.203.i.idx = shl i64 %arg.numbers.5.1, 6
  %.203.i = getelementptr i8, ptr %arg.numbers.4, i64 %.203.i.idx
  store double %.150.i, ptr %.203.i, align 8, !noalias !394
  %.287.i531.not = icmp slt i64 %arg.n, 1
  br i1 %.287.i531.not, label %B0.endif, label %B122.if.i.lr.ph

B122.if.i.lr.ph:                                  ; preds = %entry
  %.247.i.i = fsub double 1.000000e+00, %arg.share
  %.idx = mul i64 %arg.n, 192
  %0 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx
  %.idx544 = mul i64 %arg.n, 184
  %1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx544
  %.idx545 = mul i64 %arg.n, 176
  %2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx545
  %.idx546 = mul i64 %arg.n, 168
  %3 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx546
  %.idx547 = mul i64 %arg.n, 160
  %4 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx547
  %.idx548 = mul i64 %arg.n, 152
  %5 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx548
  %.idx549 = mul i64 %arg.n, 144
  %6 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx549
  %.idx550 = shl i64 %arg.n, 7
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx550
  br label %B122.if.i

B122.if.i:                                        ; preds = %B122.if.i.lr.ph, %B122.if.i
  %.229.i.0532 = phi i64 [ 0, %B122.if.i.lr.ph ], [ %.300.i, %B122.if.i ]
  %7 = getelementptr double, ptr %0, i64 %.229.i.0532
  %.191.i.i = load double, ptr %7, align 8, !noalias !398
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %arg.share, %.193.i.i
  %8 = getelementptr double, ptr %1, i64 %.229.i.0532
  %.191.i.i.1 = load double, ptr %8, align 8, !noalias !398
  %.193.i.i.1 = fadd double %.253.i.i, %.191.i.i.1
  %.253.i.i.1 = fmul double %.247.i.i, %.193.i.i.1
  %9 = getelementptr double, ptr %2, i64 %.229.i.0532
  %.191.i.i.2 = load double, ptr %9, align 8, !noalias !398
  %.193.i.i.2 = fadd double %.253.i.i.1, %.191.i.i.2
  %.253.i.i.2 = fmul double %arg.share, %.193.i.i.2
  %10 = getelementptr double, ptr %3, i64 %.229.i.0532
  %.191.i.i.3 = load double, ptr %10, align 8, !noalias !398
  %.193.i.i.3 = fadd double %.253.i.i.2, %.191.i.i.3
  %.253.i.i.3 = fmul double %.247.i.i, %.193.i.i.3
  %11 = getelementptr double, ptr %4, i64 %.229.i.0532
  %.191.i.i.4 = load double, ptr %11, align 8, !noalias !398
  %.193.i.i.4 = fadd double %.253.i.i.3, %.191.i.i.4
  %.253.i.i.4 = fmul double %arg.share, %.193.i.i.4
  %12 = getelementptr double, ptr %5, i64 %.229.i.0532
  %.191.i.i.5 = load double, ptr %12, align 8, !noalias !398
  %.193.i.i.5 = fadd double %.253.i.i.4, %.191.i.i.5
  %.253.i.i.5 = fmul double %.247.i.i, %.193.i.i.5
  %13 = getelementptr double, ptr %6, i64 %.229.i.0532
  %.191.i.i.6 = load double, ptr %13, align 8, !noalias !398
  %.193.i.i.6 = fadd double %.253.i.i.5, %.191.i.i.6
  %.253.i.i.6 = fmul double %arg.share, %.193.i.i.6
  %.300.i = add nsw i64 %.229.i.0532, 1
  %14 = getelementptr double, ptr %arg.arrays.0.4, i64 %.229.i.0532
  %.309.i.i = load double, ptr %14, align 8, !noalias !398
  %.313.i.i = fadd double %.253.i.i.6, %.309.i.i
  %gep = getelementptr double, ptr %invariant.gep, i64 %.229.i.0532
  store double %.313.i.i, ptr %gep, align 8, !noalias !394
  %exitcond.not = icmp eq i64 %arg.n, %.300.i
  br i1 %exitcond.not, label %B0.endif, label %B122.if.i

B682:                                             ; preds = %B296.if, %B0.endif
  %largest.2.0.lcssa = phi double [ 0.000000e+00, %B0.endif ], [ %.11.i527, %B296.if ]
  store double %largest.2.0.lcssa, ptr %retptr, align 8
  ret void

B0.endif:                                         ; preds = %B122.if.i, %entry
  %.227 = load i64, ptr %arg.code.4, align 8
  %.296 = shl nsw i64 %arg.n, 4
  %.298 = mul nsw i64 %arg.n, 15
  %.313 = getelementptr double, ptr %arg.arrays.0.4, i64 %.296
  %.338 = getelementptr double, ptr %arg.arrays.0.4, i64 %.298
  %.339 = inttoptr i64 %.227 to ptr
  tail call void %.339(ptr nonnull %.203.i, ptr %.313, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.338)
  %.421538.not = icmp slt i64 %arg.n, 1
  br i1 %.421538.not, label %B682, label %B296.if.lr.ph

B296.if.lr.ph:                                    ; preds = %B0.endif
  %.487 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.255.i = fsub double 1.000000e+00, %arg.share
  %invariant.gep1 = getelementptr double, ptr %arg.arrays.0.4, i64 %.296
  %invariant.gep3 = getelementptr double, ptr %arg.arrays.0.4, i64 %.298
  %.idx551 = mul i64 %arg.n, 56
  %invariant.gep5 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx551
  %.idx552 = mul i64 %arg.n, 192
  %15 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx552
  %.261.i69 = fmul double %arg.share, 0.000000e+00
  %.idx553 = mul i64 %arg.n, 184
  %16 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx553
  %.idx554 = mul i64 %arg.n, 176
  %17 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx554
  %.idx555 = mul i64 %arg.n, 168
  %18 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx555
  %.idx556 = mul i64 %arg.n, 160
  %19 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx556
  %.idx557 = mul i64 %arg.n, 152
  %20 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx557
  %.idx558 = mul i64 %arg.n, 144
  %21 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx558
  br label %B296.if

B296.if:                                          ; preds = %B296.if.lr.ph, %B296.if
  %largest.2.0541 = phi double [ 0.000000e+00, %B296.if.lr.ph ], [ %.11.i527, %B296.if ]
  %.365.0539 = phi i64 [ 0, %B296.if.lr.ph ], [ %.434, %B296.if ]
  %.488 = load double, ptr %.487, align 8
  %.518 = load double, ptr %arg.tolerances.4, align 8
  %22 = getelementptr double, ptr %arg.arrays.0.4, i64 %.365.0539
  %.548 = load double, ptr %22, align 8
  %.549 = tail call double @llvm.fabs.f64(double %.548)
  %gep2 = getelementptr double, ptr %invariant.gep1, i64 %.365.0539
  %.582 = load double, ptr %gep2, align 8
  %.583 = tail call double @llvm.fabs.f64(double %.582)
  %.10.i = fcmp ogt double %.583, %.549
  %.11.i = select i1 %.10.i, double %.583, double %.549
  %.612 = fmul double %.518, %.11.i
  %.613 = fadd double %.488, %.612
  %gep4 = getelementptr double, ptr %invariant.gep3, i64 %.365.0539
  %.646 = load double, ptr %gep4, align 8
  %.648 = fmul double %.156, %.646
  %.652 = fdiv double %.648, %.613
  %gep6 = getelementptr double, ptr %invariant.gep5, i64 %.365.0539
  store double %.652, ptr %gep6, align 8
  %23 = getelementptr double, ptr %15, i64 %.365.0539
  %.192.i57 = load double, ptr %23, align 8, !noalias !402
  %.194.i59 = fadd double %.192.i57, 0.000000e+00
  %.324.i = fadd double %.261.i69, %.194.i59
  %.400.i = fmul double %arg.share, %.194.i59
  %24 = getelementptr double, ptr %16, i64 %.365.0539
  %.192.i57.1 = load double, ptr %24, align 8, !noalias !402
  %.194.i59.1 = fadd double %.400.i, %.192.i57.1
  %.261.i69.1 = fmul double %.324.i, %.255.i
  %.324.i.1 = fsub double %.261.i69.1, %.194.i59.1
  %.400.i.1 = fmul double %.255.i, %.194.i59.1
  %25 = getelementptr double, ptr %17, i64 %.365.0539
  %.192.i57.2 = load double, ptr %25, align 8, !noalias !402
  %.194.i59.2 = fadd double %.400.i.1, %.192.i57.2
  %.261.i69.2 = fmul double %.324.i.1, %arg.share
  %.324.i.2 = fadd double %.261.i69.2, %.194.i59.2
  %.400.i.2 = fmul double %arg.share, %.194.i59.2
  %26 = getelementptr double, ptr %18, i64 %.365.0539
  %.192.i57.3 = load double, ptr %26, align 8, !noalias !402
  %.194.i59.3 = fadd double %.400.i.2, %.192.i57.3
  %.261.i69.3 = fmul double %.324.i.2, %.255.i
  %.324.i.3 = fsub double %.261.i69.3, %.194.i59.3
  %.400.i.3 = fmul double %.255.i, %.194.i59.3
  %27 = getelementptr double, ptr %19, i64 %.365.0539
  %.192.i57.4 = load double, ptr %27, align 8, !noalias !402
  %.194.i59.4 = fadd double %.400.i.3, %.192.i57.4
  %.261.i69.4 = fmul double %.324.i.3, %arg.share
  %.324.i.4 = fadd double %.261.i69.4, %.194.i59.4
  %.400.i.4 = fmul double %arg.share, %.194.i59.4
  %28 = getelementptr double, ptr %20, i64 %.365.0539
  %.192.i57.5 = load double, ptr %28, align 8, !noalias !402
  %.194.i59.5 = fadd double %.400.i.4, %.192.i57.5
  %.261.i69.5 = fmul double %.324.i.4, %.255.i
  %.324.i.5 = fsub double %.261.i69.5, %.194.i59.5
  %.400.i.5 = fmul double %.255.i, %.194.i59.5
  %29 = getelementptr double, ptr %21, i64 %.365.0539
  %.192.i57.6 = load double, ptr %29, align 8, !noalias !402
  %.194.i59.6 = fadd double %.400.i.5, %.192.i57.6
  %.261.i69.6 = fmul double %.324.i.5, %arg.share
  %.324.i.6 = fadd double %.261.i69.6, %.194.i59.6
  %.434 = add nsw i64 %.365.0539, 1
  %.754 = fdiv double %.324.i.6, %.613
  %.755 = fsub double %.652, %.754
  %.756 = tail call double @llvm.fabs.f64(double %.755)
  %.10.i526 = fcmp ogt double %.756, %largest.2.0541
  %.11.i527 = select i1 %.10.i526, double %.756, double %largest.2.0541
  %exitcond543.not = icmp eq i64 %arg.n, %.434
  br i1 %exitcond543.not, label %B682, label %B296.if
}

define internal fastcc void @_ZN5pages10rate_jumps7quarterB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr noalias nonnull %retptr, double %arg.low, double %arg.high, ptr readonly %arg.code.4, i64 %arg.n, ptr readonly %arg.tolerances.4, ptr %arg.numbers.4, i64 %arg.numbers.5.1, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4) unnamed_addr {
entry:
  %.103 = fsub double %arg.high, %arg.low
  %.104 = fmul double %.103, 2.500000e-01
  %.155.idx.i = mul i64 %arg.numbers.5.1, 48
  %.155.i = getelementptr i8, ptr %arg.numbers.4, i64 %.155.idx.i
  %.203.i.idx.i = shl i64 %arg.numbers.5.1, 6
  %.203.i.i = getelementptr i8, ptr %arg.numbers.4, i64 %.203.i.idx.i
  %.287.i531.not.i = icmp slt i64 %arg.n, 1
  %.idx.i = mul i64 %arg.n, 192
  %0 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i
  %.idx544.i = mul i64 %arg.n, 184
  %1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx544.i
  %.idx545.i = mul i64 %arg.n, 176
  %2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx545.i
  %.idx546.i = mul i64 %arg.n, 168
  %3 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx546.i
  %.idx547.i = mul i64 %arg.n, 160
  %4 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx547.i
  %.idx548.i = mul i64 %arg.n, 152
  %5 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx548.i
  %.idx549.i = mul i64 %arg.n, 144
  %6 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx549.i
  %.idx550.i = shl i64 %arg.n, 7
  %.296.i = shl nsw i64 %arg.n, 4
  %.298.i = mul nsw i64 %arg.n, 15
  %.313.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.296.i
  %.338.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.298.i
  %.487.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.313.i.c.idx = shl i64 %arg.n, 7
  %.313.i.c = getelementptr i8, ptr %arg.arrays.0.4, i64 %.313.i.c.idx
  %.338.i.c.idx = mul i64 %arg.n, 120
  %.338.i.c = getelementptr i8, ptr %arg.arrays.0.4, i64 %.338.i.c.idx
  br label %B68.if

B44.i.preheader:                                  ; preds = %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  %.233.i554.not = icmp slt i64 %arg.n, 1
  br i1 %.233.i554.not, label %B338.i, label %B82.if.i.lr.ph

B338.i:                                           ; preds = %B82.if.i, %B44.i.preheader
  %largest.2.i.1.lcssa = phi double [ 0.000000e+00, %B44.i.preheader ], [ %.11.i.i, %B82.if.i ]
  %.465.i = fcmp ogt double %largest.2.i.1.lcssa, -1.000000e+00
  %most.3.i.1 = select i1 %.465.i, double %largest.2.i.1.lcssa, double -1.000000e+00
  br i1 %.233.i554.not, label %B338.i.1, label %B82.if.i.lr.ph.1

B82.if.i.lr.ph.1:                                 ; preds = %B338.i
  %.idx.1 = mul i64 %arg.n, 48
  %invariant.gep15 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.1
  %.idx576.1 = shl i64 %arg.n, 4
  %invariant.gep17 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx576.1
  %.idx3 = shl i64 %arg.n, 5
  %invariant.gep19 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx3
  %.idx4 = mul i64 %arg.n, 24
  %invariant.gep21 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx4
  br label %B82.if.i.1

B82.if.i.1:                                       ; preds = %B82.if.i.1, %B82.if.i.lr.ph.1
  %largest.2.i.1557.1 = phi double [ 0.000000e+00, %B82.if.i.lr.ph.1 ], [ %.11.i.i.1, %B82.if.i.1 ]
  %.177.i.0555.1 = phi i64 [ 0, %B82.if.i.lr.ph.1 ], [ %.246.i.1, %B82.if.i.1 ]
  %.246.i.1 = add nsw i64 %.177.i.0555.1, 1
  %gep16 = getelementptr double, ptr %invariant.gep15, i64 %.177.i.0555.1
  %.303.i.1 = load double, ptr %gep16, align 8, !noalias !406
  %gep18 = getelementptr double, ptr %invariant.gep17, i64 %.177.i.0555.1
  %.336.i.1 = load double, ptr %gep18, align 8, !noalias !406
  %.337.i.1 = fsub double %.303.i.1, %.336.i.1
  %gep20 = getelementptr double, ptr %invariant.gep19, i64 %.177.i.0555.1
  %.373.i.1 = load double, ptr %gep20, align 8, !noalias !406
  %gep22 = getelementptr double, ptr %invariant.gep21, i64 %.177.i.0555.1
  %.408.i.1 = load double, ptr %gep22, align 8, !noalias !406
  %.409.i.1 = fsub double %.373.i.1, %.408.i.1
  %.410.i.1 = fmul double %.409.i.1, 4.000000e+00
  %.411.i.1 = fsub double %.410.i.1, %.337.i.1
  %.412.i.1 = tail call double @llvm.fabs.f64(double %.411.i.1)
  %.416.i.1 = fdiv double %.412.i.1, 3.000000e+00
  %.10.i.i.1 = fcmp ogt double %.416.i.1, %largest.2.i.1557.1
  %.11.i.i.1 = select i1 %.10.i.i.1, double %.416.i.1, double %largest.2.i.1557.1
  %exitcond571.not.1 = icmp eq i64 %arg.n, %.246.i.1
  br i1 %exitcond571.not.1, label %B338.i.1, label %B82.if.i.1

B338.i.1:                                         ; preds = %B82.if.i.1, %B338.i
  %largest.2.i.1.lcssa.1 = phi double [ 0.000000e+00, %B338.i ], [ %.11.i.i.1, %B82.if.i.1 ]
  %.465.i.1 = fcmp ogt double %largest.2.i.1.lcssa.1, %most.3.i.1
  %odd.3.i.1.1 = zext i1 %.465.i.1 to i64
  %most.3.i.1.1 = select i1 %.465.i.1, double %largest.2.i.1.lcssa.1, double %most.3.i.1
  br i1 %.233.i554.not, label %B338.i.2, label %B82.if.i.lr.ph.2

B82.if.i.lr.ph.2:                                 ; preds = %B338.i.1
  %.idx.2 = mul i64 %arg.n, 48
  %invariant.gep23 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.2
  %.idx576.2 = shl i64 %arg.n, 4
  %invariant.gep25 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx576.2
  %.idx5 = mul i64 %arg.n, 40
  %invariant.gep27 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx5
  %.idx6 = shl i64 %arg.n, 5
  %invariant.gep29 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx6
  br label %B82.if.i.2

B82.if.i.2:                                       ; preds = %B82.if.i.2, %B82.if.i.lr.ph.2
  %largest.2.i.1557.2 = phi double [ 0.000000e+00, %B82.if.i.lr.ph.2 ], [ %.11.i.i.2, %B82.if.i.2 ]
  %.177.i.0555.2 = phi i64 [ 0, %B82.if.i.lr.ph.2 ], [ %.246.i.2, %B82.if.i.2 ]
  %.246.i.2 = add nsw i64 %.177.i.0555.2, 1
  %gep24 = getelementptr double, ptr %invariant.gep23, i64 %.177.i.0555.2
  %.303.i.2 = load double, ptr %gep24, align 8, !noalias !406
  %gep26 = getelementptr double, ptr %invariant.gep25, i64 %.177.i.0555.2
  %.336.i.2 = load double, ptr %gep26, align 8, !noalias !406
  %.337.i.2 = fsub double %.303.i.2, %.336.i.2
  %gep28 = getelementptr double, ptr %invariant.gep27, i64 %.177.i.0555.2
  %.373.i.2 = load double, ptr %gep28, align 8, !noalias !406
  %gep30 = getelementptr double, ptr %invariant.gep29, i64 %.177.i.0555.2
  %.408.i.2 = load double, ptr %gep30, align 8, !noalias !406
  %.409.i.2 = fsub double %.373.i.2, %.408.i.2
  %.410.i.2 = fmul double %.409.i.2, 4.000000e+00
  %.411.i.2 = fsub double %.410.i.2, %.337.i.2
  %.412.i.2 = tail call double @llvm.fabs.f64(double %.411.i.2)
  %.416.i.2 = fdiv double %.412.i.2, 3.000000e+00
  %.10.i.i.2 = fcmp ogt double %.416.i.2, %largest.2.i.1557.2
  %.11.i.i.2 = select i1 %.10.i.i.2, double %.416.i.2, double %largest.2.i.1557.2
  %exitcond571.not.2 = icmp eq i64 %arg.n, %.246.i.2
  br i1 %exitcond571.not.2, label %B338.i.2, label %B82.if.i.2

B338.i.2:                                         ; preds = %B82.if.i.2, %B338.i.1
  %largest.2.i.1.lcssa.2 = phi double [ 0.000000e+00, %B338.i.1 ], [ %.11.i.i.2, %B82.if.i.2 ]
  %.465.i.2 = fcmp ogt double %largest.2.i.1.lcssa.2, %most.3.i.1.1
  %odd.3.i.1.2 = select i1 %.465.i.2, i64 2, i64 %odd.3.i.1.1
  %most.3.i.1.2 = select i1 %.465.i.2, double %largest.2.i.1.lcssa.2, double %most.3.i.1.1
  br i1 %.233.i554.not, label %B338.i.3, label %B82.if.i.lr.ph.3

B82.if.i.lr.ph.3:                                 ; preds = %B338.i.2
  %.idx.3 = mul i64 %arg.n, 48
  %invariant.gep31 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.3
  %.idx576.3 = shl i64 %arg.n, 4
  %invariant.gep33 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx576.3
  %.idx7 = mul i64 %arg.n, 48
  %invariant.gep35 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx7
  %.idx8 = mul i64 %arg.n, 40
  %invariant.gep37 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx8
  br label %B82.if.i.3

B82.if.i.3:                                       ; preds = %B82.if.i.3, %B82.if.i.lr.ph.3
  %largest.2.i.1557.3 = phi double [ 0.000000e+00, %B82.if.i.lr.ph.3 ], [ %.11.i.i.3, %B82.if.i.3 ]
  %.177.i.0555.3 = phi i64 [ 0, %B82.if.i.lr.ph.3 ], [ %.246.i.3, %B82.if.i.3 ]
  %.246.i.3 = add nsw i64 %.177.i.0555.3, 1
  %gep32 = getelementptr double, ptr %invariant.gep31, i64 %.177.i.0555.3
  %.303.i.3 = load double, ptr %gep32, align 8, !noalias !406
  %gep34 = getelementptr double, ptr %invariant.gep33, i64 %.177.i.0555.3
  %.336.i.3 = load double, ptr %gep34, align 8, !noalias !406
  %.337.i.3 = fsub double %.303.i.3, %.336.i.3
  %gep36 = getelementptr double, ptr %invariant.gep35, i64 %.177.i.0555.3
  %.373.i.3 = load double, ptr %gep36, align 8, !noalias !406
  %gep38 = getelementptr double, ptr %invariant.gep37, i64 %.177.i.0555.3
  %.408.i.3 = load double, ptr %gep38, align 8, !noalias !406
  %.409.i.3 = fsub double %.373.i.3, %.408.i.3
  %.410.i.3 = fmul double %.409.i.3, 4.000000e+00
  %.411.i.3 = fsub double %.410.i.3, %.337.i.3
  %.412.i.3 = tail call double @llvm.fabs.f64(double %.411.i.3)
  %.416.i.3 = fdiv double %.412.i.3, 3.000000e+00
  %.10.i.i.3 = fcmp ogt double %.416.i.3, %largest.2.i.1557.3
  %.11.i.i.3 = select i1 %.10.i.i.3, double %.416.i.3, double %largest.2.i.1557.3
  %exitcond571.not.3 = icmp eq i64 %arg.n, %.246.i.3
  br i1 %exitcond571.not.3, label %B338.i.3, label %B82.if.i.3

B338.i.3:                                         ; preds = %B82.if.i.3, %B338.i.2
  %largest.2.i.1.lcssa.3 = phi double [ 0.000000e+00, %B338.i.2 ], [ %.11.i.i.3, %B82.if.i.3 ]
  %.465.i.3 = fcmp ogt double %largest.2.i.1.lcssa.3, %most.3.i.1.2
  %odd.3.i.1.3 = select i1 %.465.i.3, i64 3, i64 %odd.3.i.1.2
  %.336 = add nsw i64 %odd.3.i.1.3, 2
  %.106.i35562.not = icmp slt i64 %arg.n, 1
  br i1 %.106.i35562.not, label %B34.i146.preheader, label %B34.if.i.lr.ph

B82.if.i.lr.ph:                                   ; preds = %B44.i.preheader
  %.idx = mul i64 %arg.n, 48
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx
  %.idx576 = shl i64 %arg.n, 4
  %invariant.gep9 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx576
  %.idx1 = mul i64 %arg.n, 24
  %invariant.gep11 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx1
  %.idx2 = shl i64 %arg.n, 4
  %invariant.gep13 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx2
  br label %B82.if.i

B82.if.i:                                         ; preds = %B82.if.i.lr.ph, %B82.if.i
  %largest.2.i.1557 = phi double [ 0.000000e+00, %B82.if.i.lr.ph ], [ %.11.i.i, %B82.if.i ]
  %.177.i.0555 = phi i64 [ 0, %B82.if.i.lr.ph ], [ %.246.i, %B82.if.i ]
  %.246.i = add nsw i64 %.177.i.0555, 1
  %gep = getelementptr double, ptr %invariant.gep, i64 %.177.i.0555
  %.303.i = load double, ptr %gep, align 8, !noalias !406
  %gep10 = getelementptr double, ptr %invariant.gep9, i64 %.177.i.0555
  %.336.i = load double, ptr %gep10, align 8, !noalias !406
  %.337.i = fsub double %.303.i, %.336.i
  %gep12 = getelementptr double, ptr %invariant.gep11, i64 %.177.i.0555
  %.373.i = load double, ptr %gep12, align 8, !noalias !406
  %gep14 = getelementptr double, ptr %invariant.gep13, i64 %.177.i.0555
  %.408.i = load double, ptr %gep14, align 8, !noalias !406
  %.409.i = fsub double %.373.i, %.408.i
  %.410.i = fmul double %.409.i, 4.000000e+00
  %.411.i = fsub double %.410.i, %.337.i
  %.412.i = tail call double @llvm.fabs.f64(double %.411.i)
  %.416.i = fdiv double %.412.i, 3.000000e+00
  %.10.i.i = fcmp ogt double %.416.i, %largest.2.i.1557
  %.11.i.i = select i1 %.10.i.i, double %.416.i, double %largest.2.i.1557
  %exitcond571.not = icmp eq i64 %arg.n, %.246.i
  br i1 %exitcond571.not, label %B338.i, label %B82.if.i

B68.if:                                           ; preds = %entry, %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  %.134.0552 = phi i64 [ 1, %entry ], [ %.205, %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ]
  %.205 = add nsw i64 %.134.0552, 1
  %.232 = uitofp i64 %.134.0552 to double
  %.233 = fmul double %.104, %.232
  %.235 = fadd double %arg.low, %.233
  %.236 = add nsw i64 %.134.0552, 2
  %.156.i = load double, ptr %.155.i, align 8, !noalias !410
  %.93.i.i = load double, ptr %arg.numbers.4, align 8, !noalias !413
  %.149.i.i = fmul double %.235, %.156.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !413
  br i1 %.287.i531.not.i, label %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.critedge, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B68.if
  %.247.i.i.i = fsub double 1.000000e+00, %.235
  br label %B122.if.i.i

B122.if.i.i:                                      ; preds = %B122.if.i.i, %B122.if.i.lr.ph.i
  %.229.i.0532.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %7 = getelementptr double, ptr %0, i64 %.229.i.0532.i
  %.191.i.i.i = load double, ptr %7, align 8, !noalias !417
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.235, %.193.i.i.i
  %8 = getelementptr double, ptr %1, i64 %.229.i.0532.i
  %.191.i.i.1.i = load double, ptr %8, align 8, !noalias !417
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %9 = getelementptr double, ptr %2, i64 %.229.i.0532.i
  %.191.i.i.2.i = load double, ptr %9, align 8, !noalias !417
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.235, %.193.i.i.2.i
  %10 = getelementptr double, ptr %3, i64 %.229.i.0532.i
  %.191.i.i.3.i = load double, ptr %10, align 8, !noalias !417
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %11 = getelementptr double, ptr %4, i64 %.229.i.0532.i
  %.191.i.i.4.i = load double, ptr %11, align 8, !noalias !417
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.235, %.193.i.i.4.i
  %12 = getelementptr double, ptr %5, i64 %.229.i.0532.i
  %.191.i.i.5.i = load double, ptr %12, align 8, !noalias !417
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %13 = getelementptr double, ptr %6, i64 %.229.i.0532.i
  %.191.i.i.6.i = load double, ptr %13, align 8, !noalias !417
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.235, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.0532.i, 1
  %14 = getelementptr double, ptr %arg.arrays.0.4, i64 %.229.i.0532.i
  %.309.i.i.i = load double, ptr %14, align 8, !noalias !417
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %15 = getelementptr i8, ptr %14, i64 %.idx550.i
  store double %.313.i.i.i, ptr %15, align 8, !noalias !413
  %exitcond.not.i = icmp eq i64 %arg.n, %.300.i.i
  br i1 %exitcond.not.i, label %B0.endif.i, label %B122.if.i.i

B0.endif.i:                                       ; preds = %B122.if.i.i
  %.227.i = load i64, ptr %arg.code.4, align 8, !noalias !410
  %.339.i549 = inttoptr i64 %.227.i to ptr
  tail call void %.339.i549(ptr nonnull %.203.i.i, ptr %.313.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.338.i), !noalias !410
  %.655.i = mul nsw i64 %.236, %arg.n
  %invariant.gep39 = getelementptr double, ptr %arg.arrays.0.4, i64 %.655.i
  br label %B296.if.i

B296.if.i:                                        ; preds = %B296.if.i, %B0.endif.i
  %.365.0539.i = phi i64 [ 0, %B0.endif.i ], [ %.434.i, %B296.if.i ]
  %.488.i = load double, ptr %.487.i, align 8, !noalias !410
  %.518.i = load double, ptr %arg.tolerances.4, align 8, !noalias !410
  %16 = getelementptr double, ptr %arg.arrays.0.4, i64 %.365.0539.i
  %.548.i = load double, ptr %16, align 8, !noalias !410
  %.549.i = tail call double @llvm.fabs.f64(double %.548.i)
  %17 = getelementptr double, ptr %16, i64 %.296.i
  %.582.i = load double, ptr %17, align 8, !noalias !410
  %.583.i = tail call double @llvm.fabs.f64(double %.582.i)
  %.10.i.i550 = fcmp ogt double %.583.i, %.549.i
  %.11.i.i551 = select i1 %.10.i.i550, double %.583.i, double %.549.i
  %.612.i = fmul double %.518.i, %.11.i.i551
  %.613.i = fadd double %.488.i, %.612.i
  %18 = getelementptr double, ptr %16, i64 %.298.i
  %.646.i = load double, ptr %18, align 8, !noalias !410
  %.648.i = fmul double %.156.i, %.646.i
  %.652.i = fdiv double %.648.i, %.613.i
  %gep40 = getelementptr double, ptr %invariant.gep39, i64 %.365.0539.i
  store double %.652.i, ptr %gep40, align 8, !noalias !410
  %.434.i = add nsw i64 %.365.0539.i, 1
  %exitcond543.not.i = icmp eq i64 %arg.n, %.434.i
  br i1 %exitcond543.not.i, label %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B296.if.i

_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.critedge: ; preds = %B68.if
  %.227.i.c = load i64, ptr %arg.code.4, align 8, !noalias !410
  %.339.i549.c = inttoptr i64 %.227.i.c to ptr
  tail call void %.339.i549.c(ptr nonnull %.203.i.i, ptr %.313.i.c, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.338.i.c), !noalias !410
  br label %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit

_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %B296.if.i, %_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.critedge
  %exitcond.not = icmp eq i64 %.205, 4
  br i1 %exitcond.not, label %B44.i.preheader, label %B68.if

B34.if.i.lr.ph:                                   ; preds = %B338.i.3
  %.337 = add nsw i64 %odd.3.i.1.3, 3
  %.146.i45 = mul nsw i64 %.337, %arg.n
  %invariant.gep41 = getelementptr double, ptr %arg.arrays.0.4, i64 %.146.i45
  %.idx577 = mul i64 %arg.n, 56
  %invariant.gep43 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx577
  br label %B34.if.i

B34.i146.preheader:                               ; preds = %B34.if.i, %B338.i.3
  %.106.i151565.not = icmp slt i64 %arg.n, 1
  br i1 %.106.i151565.not, label %B34.i304.preheader, label %B34.if.i226.lr.ph

B34.if.i226.lr.ph:                                ; preds = %B34.i146.preheader
  %.146.i171 = mul nsw i64 %.336, %arg.n
  %invariant.gep45 = getelementptr double, ptr %arg.arrays.0.4, i64 %.146.i171
  %.idx578 = shl i64 %arg.n, 4
  %invariant.gep47 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx578
  br label %B34.if.i226

B34.if.i:                                         ; preds = %B34.if.i.lr.ph, %B34.if.i
  %.48.i12.0563 = phi i64 [ 0, %B34.if.i.lr.ph ], [ %.119.i, %B34.if.i ]
  %.119.i = add nsw i64 %.48.i12.0563, 1
  %gep42 = getelementptr double, ptr %invariant.gep41, i64 %.48.i12.0563
  %.177.i59 = load double, ptr %gep42, align 8, !noalias !421
  %gep44 = getelementptr double, ptr %invariant.gep43, i64 %.48.i12.0563
  store double %.177.i59, ptr %gep44, align 8, !noalias !421
  %exitcond573.not = icmp eq i64 %arg.n, %.119.i
  br i1 %exitcond573.not, label %B34.i146.preheader, label %B34.if.i

B34.i304.preheader:                               ; preds = %B34.if.i226, %B34.i146.preheader
  %.106.i309568.not = icmp slt i64 %arg.n, 1
  br i1 %.106.i309568.not, label %B144.endif.endif.endif.endif, label %B34.if.i384.preheader

B34.if.i384.preheader:                            ; preds = %B34.i304.preheader
  %.idx579 = mul i64 %arg.n, 56
  %invariant.gep49 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx579
  %.idx580 = mul i64 %arg.n, 48
  %invariant.gep51 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx580
  br label %B34.if.i384

B34.if.i226:                                      ; preds = %B34.if.i226.lr.ph, %B34.if.i226
  %.48.i102.0566 = phi i64 [ 0, %B34.if.i226.lr.ph ], [ %.119.i233, %B34.if.i226 ]
  %.119.i233 = add nsw i64 %.48.i102.0566, 1
  %gep46 = getelementptr double, ptr %invariant.gep45, i64 %.48.i102.0566
  %.177.i196 = load double, ptr %gep46, align 8, !noalias !425
  %gep48 = getelementptr double, ptr %invariant.gep47, i64 %.48.i102.0566
  store double %.177.i196, ptr %gep48, align 8, !noalias !425
  %exitcond574.not = icmp eq i64 %arg.n, %.119.i233
  br i1 %exitcond574.not, label %B34.i304.preheader, label %B34.if.i226

B34.if.i384:                                      ; preds = %B34.if.i384.preheader, %B34.if.i384
  %.48.i260.0570 = phi i64 [ %.119.i391, %B34.if.i384 ], [ 0, %B34.if.i384.preheader ]
  %.119.i391 = add nsw i64 %.48.i260.0570, 1
  %gep50 = getelementptr double, ptr %invariant.gep49, i64 %.48.i260.0570
  %.177.i354 = load double, ptr %gep50, align 8, !noalias !429
  %gep52 = getelementptr double, ptr %invariant.gep51, i64 %.48.i260.0570
  store double %.177.i354, ptr %gep52, align 8, !noalias !429
  %exitcond575.not = icmp eq i64 %arg.n, %.119.i391
  br i1 %exitcond575.not, label %B144.endif.endif.endif.endif, label %B34.if.i384

B144.endif.endif.endif.endif:                     ; preds = %B34.if.i384, %B34.i304.preheader
  %most.3.i.1.3 = select i1 %.465.i.3, double %largest.2.i.1.lcssa.3, double %most.3.i.1.2
  %.430 = uitofp i64 %odd.3.i.1.3 to double
  %.431 = fmul double %.104, %.430
  %.433 = fadd double %arg.low, %.431
  %.434 = add nsw i64 %odd.3.i.1.3, 1
  %.436 = uitofp i64 %.434 to double
  %.437 = fmul double %.104, %.436
  %.441 = fadd double %arg.low, %.437
  store double %.433, ptr %retptr, align 8
  %retptr.repack544 = getelementptr inbounds i8, ptr %retptr, i64 8
  store double %.441, ptr %retptr.repack544, align 8
  %retptr.repack546 = getelementptr inbounds i8, ptr %retptr, i64 16
  store double %most.3.i.1.3, ptr %retptr.repack546, align 8
  ret void
}

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr)

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr)

; Function Attrs: nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)

define dso_local noundef i32 @evaluate_of_many(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.role, i64 %arg.n, i64 %arg.decisions.0, i64 %arg.decisions.1, ptr readnone %arg.points.0.0, ptr readnone %arg.points.0.1, i64 %arg.points.0.2, i64 %arg.points.0.3, ptr readonly %arg.points.0.4, i64 %arg.points.0.5.0, i64 %arg.points.0.6.0, ptr readnone %arg.points.1.0, ptr readnone %arg.points.1.1, i64 %arg.points.1.2, i64 %arg.points.1.3, ptr readonly %arg.points.1.4, i64 %arg.points.1.5.0, i64 %arg.points.1.6.0, ptr readnone %arg.points.2.0, ptr readnone %arg.points.2.1, i64 %arg.points.2.2, i64 %arg.points.2.3, ptr %arg.points.2.4, i64 %arg.points.2.5.0, i64 %arg.points.2.6.0, ptr readnone %arg.points.3.0, ptr readnone %arg.points.3.1, i64 %arg.points.3.2, i64 %arg.points.3.3, ptr %arg.points.3.4, i64 %arg.points.3.5.0, i64 %arg.points.3.6.0, ptr readnone %arg.pieces.0.0, ptr readnone %arg.pieces.0.1, i64 %arg.pieces.0.2, i64 %arg.pieces.0.3, ptr readonly %arg.pieces.0.4, i64 %arg.pieces.0.5.0, i64 %arg.pieces.0.6.0, ptr readnone %arg.pieces.1.0, ptr readnone %arg.pieces.1.1, i64 %arg.pieces.1.2, i64 %arg.pieces.1.3, ptr readonly %arg.pieces.1.4, i64 %arg.pieces.1.5.0, i64 %arg.pieces.1.5.1, i64 %arg.pieces.1.6.0, i64 %arg.pieces.1.6.1, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.281834.not = icmp slt i64 %arg.points.0.5.0, 1
  br i1 %.281834.not, label %B844, label %B118.if.lr.ph

B118.if.lr.ph:                                    ; preds = %entry
  %.548826.not = icmp slt i64 %arg.pieces.0.5.0, 1
  %.735 = getelementptr i8, ptr %arg.code.4, i64 8
  %.788 = icmp eq i64 %arg.role, 0
  %.791 = icmp sgt i64 %arg.decisions.1, 0
  %or.cond = select i1 %.788, i1 %.791, i1 false
  %.821 = getelementptr i8, ptr %arg.code.4, i64 40
  %.1085 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1151 = icmp slt i64 %arg.role, 0
  %.1152 = select i1 %.1151, i64 %arg.code.5.0, i64 0
  %0 = getelementptr i64, ptr %arg.code.4, i64 %arg.role
  %.1166 = getelementptr i64, ptr %0, i64 %.1152
  %.1309831.not = icmp slt i64 %arg.out.5.1, 1
  %.1351 = icmp eq i64 %arg.role, 3
  %"$phi826.2.2.2.in.v" = select i1 %.1351, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4
  br label %B118.if

B116.loopexit:                                    ; preds = %B760.if, %B644
  %exitcond840.not = icmp eq i64 %.294, %arg.points.0.5.0
  br i1 %exitcond840.not, label %B844, label %B118.if

B168:                                             ; preds = %B118.if
  br i1 %.548826.not, label %B284, label %B240.if.lr.ph

B240.if.lr.ph:                                    ; preds = %B168
  %.609 = icmp slt i64 %.417, 0
  %.610 = select i1 %.609, i64 %arg.pieces.1.5.0, i64 0
  %.611 = add i64 %.610, %.417
  %.631 = mul i64 %.611, %arg.pieces.1.5.1
  %1 = getelementptr double, ptr %arg.pieces.1.4, i64 %.631
  br label %B240.if

B284:                                             ; preds = %B240.if, %B168
  %.736 = load i64, ptr %.735, align 8
  %.739 = mul nsw i64 %.222.0835, %arg.n
  %.758 = getelementptr double, ptr %arg.points.3.4, i64 %.739
  %.784 = inttoptr i64 %.736 to ptr
  tail call void %.784(ptr nonnull %arg.points.2.4, ptr %.758, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B368

B368:                                             ; preds = %B284, %B118.if
  %piece.3.1 = phi i64 [ %.417, %B284 ], [ %piece.2.0837, %B118.if ]
  br i1 %or.cond, label %B412, label %B644

B412:                                             ; preds = %B368
  %.822 = load i64, ptr %.821, align 8
  %.825 = mul nsw i64 %.222.0835, %arg.n
  %.844 = getelementptr double, ptr %arg.points.3.4, i64 %.825
  %.870 = inttoptr i64 %.822 to ptr
  tail call void %.870(ptr nonnull %arg.points.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br label %B526.if

B560:                                             ; preds = %B526.if
  %.1086 = load i64, ptr %.1085, align 8
  %.1134 = inttoptr i64 %.1086 to ptr
  tail call void %.1134(ptr nonnull %arg.points.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B644

B644:                                             ; preds = %B560, %B368
  %.1167 = load i64, ptr %.1166, align 8
  %.1170 = mul nsw i64 %.222.0835, %arg.n
  %.1189 = getelementptr double, ptr %arg.points.3.4, i64 %.1170
  %.1215 = inttoptr i64 %.1167 to ptr
  tail call void %.1215(ptr nonnull %arg.points.2.4, ptr %.1189, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br i1 %.1309831.not, label %B116.loopexit, label %B760.if.lr.ph

B760.if.lr.ph:                                    ; preds = %B644
  %.1471 = mul i64 %.222.0835, %arg.out.5.1
  %2 = getelementptr double, ptr %arg.out.4, i64 %.1471
  br label %B760.if

B844:                                             ; preds = %B116.loopexit, %entry
  store ptr null, ptr %retptr, align 8
  ret i32 0

B118.if:                                          ; preds = %B118.if.lr.ph, %B116.loopexit
  %piece.2.0837 = phi i64 [ -1, %B118.if.lr.ph ], [ %piece.3.1, %B116.loopexit ]
  %.222.0835 = phi i64 [ 0, %B118.if.lr.ph ], [ %.294, %B116.loopexit ]
  %.294 = add nsw i64 %.222.0835, 1
  %3 = getelementptr double, ptr %arg.points.0.4, i64 %.222.0835
  %.356 = load double, ptr %3, align 8
  store double %.356, ptr %arg.points.2.4, align 8
  %4 = getelementptr i64, ptr %arg.points.1.4, i64 %.222.0835
  %.417 = load i64, ptr %4, align 8
  %.419.not = icmp eq i64 %.417, %piece.2.0837
  br i1 %.419.not, label %B368, label %B168

B240.if:                                          ; preds = %B240.if.lr.ph, %B240.if
  %.492.0827 = phi i64 [ 0, %B240.if.lr.ph ], [ %.561, %B240.if ]
  %.561 = add nsw i64 %.492.0827, 1
  %5 = getelementptr double, ptr %1, i64 %.492.0827
  %.636 = load double, ptr %5, align 8
  %6 = getelementptr i64, ptr %arg.pieces.0.4, i64 %.492.0827
  %.666 = load i64, ptr %6, align 8
  %.680 = icmp slt i64 %.666, 0
  %.681 = select i1 %.680, i64 %arg.arrays.0.5.0, i64 0
  %7 = getelementptr double, ptr %arg.arrays.0.4, i64 %.666
  %.695 = getelementptr double, ptr %7, i64 %.681
  store double %.636, ptr %.695, align 8
  %exitcond.not = icmp eq i64 %arg.pieces.0.5.0, %.561
  br i1 %exitcond.not, label %B284, label %B240.if

B526.if:                                          ; preds = %B412, %B526.if
  %.896.0829 = phi i64 [ 0, %B412 ], [ %.965, %B526.if ]
  %.965 = add nsw i64 %.896.0829, 1
  %8 = getelementptr double, ptr %arg.arrays.3.4, i64 %.896.0829
  %.1019 = load double, ptr %8, align 8
  %.1021 = add nsw i64 %.896.0829, %arg.decisions.0
  %.1035 = icmp slt i64 %.1021, 0
  %.1036 = select i1 %.1035, i64 %arg.arrays.0.5.0, i64 0
  %9 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1021
  %.1050 = getelementptr double, ptr %9, i64 %.1036
  store double %.1019, ptr %.1050, align 8
  %exitcond838.not = icmp eq i64 %.965, %arg.decisions.1
  br i1 %exitcond838.not, label %B560, label %B526.if

B760.if:                                          ; preds = %B760.if.lr.ph, %B760.if
  %.1253.0832 = phi i64 [ 0, %B760.if.lr.ph ], [ %.1322, %B760.if ]
  %.1322 = add nsw i64 %.1253.0832, 1
  %"$phi826.2.2.2.in" = getelementptr double, ptr %"$phi826.2.2.2.in.v", i64 %.1253.0832
  %"$phi826.2.2.2" = load double, ptr %"$phi826.2.2.2.in", align 8
  %10 = getelementptr double, ptr %2, i64 %.1253.0832
  store double %"$phi826.2.2.2", ptr %10, align 8
  %exitcond839.not = icmp eq i64 %arg.out.5.1, %.1322
  br i1 %exitcond839.not, label %B116.loopexit, label %B760.if
}


!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = distinct !{!6, !5, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!7 = !{!8, !10}
!8 = distinct !{!8, !9, !"_ZN5pages12event_checks15is_decided_anewB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!9 = distinct !{!9, !"_ZN5pages12event_checks15is_decided_anewB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!10 = distinct !{!10, !9, !"_ZN5pages12event_checks15is_decided_anewB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN5pages12event_checks6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!13 = distinct !{!13, !"_ZN5pages12event_checks6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!14 = distinct !{!14, !13, !"_ZN5pages12event_checks6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!15 = !{!16, !18}
!16 = distinct !{!16, !17, !"_ZN5pages8segments11begin_pieceB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!17 = distinct !{!17, !"_ZN5pages8segments11begin_pieceB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!18 = distinct !{!18, !17, !"_ZN5pages8segments11begin_pieceB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!19 = !{!20, !16, !18}
!20 = distinct !{!20, !21, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!21 = distinct !{!21, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!22 = !{!23, !16, !18}
!23 = distinct !{!23, !24, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!24 = distinct !{!24, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!25 = !{!26, !28, !16, !18}
!26 = distinct !{!26, !27, !"_ZN5pages8segments10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!27 = distinct !{!27, !"_ZN5pages8segments10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!28 = distinct !{!28, !27, !"_ZN5pages8segments10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!29 = !{!30}
!30 = distinct !{!30, !31, !"_ZN5pages8implicit9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!31 = distinct !{!31, !"_ZN5pages8implicit9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!32 = !{!33, !35, !30}
!33 = distinct !{!33, !34, !"_ZN5pages8implicit13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!34 = distinct !{!34, !"_ZN5pages8implicit13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!35 = distinct !{!35, !34, !"_ZN5pages8implicit13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!36 = !{!37, !39, !33, !35, !30}
!37 = distinct !{!37, !38, !"_ZN5pages8implicit14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!38 = distinct !{!38, !"_ZN5pages8implicit14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!39 = distinct !{!39, !38, !"_ZN5pages8implicit14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!40 = !{!41, !30}
!41 = distinct !{!41, !42, !"_ZN5pages8implicit6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!42 = distinct !{!42, !"_ZN5pages8implicit6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!43 = !{!44, !46, !47}
!44 = distinct !{!44, !45, !"_ZN5pages8implicit5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!45 = distinct !{!45, !"_ZN5pages8implicit5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!46 = distinct !{!46, !45, !"_ZN5pages8implicit5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!47 = distinct !{!47, !48, !"_ZN5pages8implicit11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!48 = distinct !{!48, !"_ZN5pages8implicit11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!49 = !{!47}
!50 = !{!51, !53}
!51 = distinct !{!51, !52, !"_ZN5pages12time_stepper11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!52 = distinct !{!52, !"_ZN5pages12time_stepper11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!53 = distinct !{!53, !52, !"_ZN5pages12time_stepper11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!54 = !{!55}
!55 = distinct !{!55, !56, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!56 = distinct !{!56, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!57 = !{!"branch_weights", i32 99, i32 1}
!58 = !{!59, !61}
!59 = distinct !{!59, !60, !"_ZN5pages12time_stepper17check_interpolantB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!60 = distinct !{!60, !"_ZN5pages12time_stepper17check_interpolantB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!61 = distinct !{!61, !60, !"_ZN5pages12time_stepper17check_interpolantB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!62 = !{!63, !59, !61}
!63 = distinct !{!63, !64, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!64 = distinct !{!64, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!65 = !{!66, !68}
!66 = distinct !{!66, !67, !"_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!67 = distinct !{!67, !"_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!68 = distinct !{!68, !67, !"_ZN5pages14event_location12locate_kinksB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!69 = !{!70, !72, !66, !68}
!70 = distinct !{!70, !71, !"_ZN5pages14event_location14measure_effectB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!71 = distinct !{!71, !"_ZN5pages14event_location14measure_effectB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!72 = distinct !{!72, !71, !"_ZN5pages14event_location14measure_effectB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!73 = !{!74, !76, !70, !72, !66, !68}
!74 = distinct !{!74, !75, !"_ZN5pages12event_checks12first_passedB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!75 = distinct !{!75, !"_ZN5pages12event_checks12first_passedB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!76 = distinct !{!76, !75, !"_ZN5pages12event_checks12first_passedB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!77 = !{!78, !80, !70, !72, !66, !68}
!78 = distinct !{!78, !79, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!79 = distinct !{!79, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!80 = distinct !{!80, !79, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!81 = !{!82, !84, !70, !72, !66, !68}
!82 = distinct !{!82, !83, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!83 = distinct !{!83, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!84 = distinct !{!84, !83, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!85 = !{!86, !88, !66, !68}
!86 = distinct !{!86, !87, !"_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!87 = distinct !{!87, !"_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!88 = distinct !{!88, !87, !"_ZN5pages14event_location7bracketB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!89 = !{!90, !92, !86, !88, !66, !68}
!90 = distinct !{!90, !91, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!92 = distinct !{!92, !91, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!93 = !{!94, !96, !86, !88, !66, !68}
!94 = distinct !{!94, !95, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!95 = distinct !{!95, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!96 = distinct !{!96, !95, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!97 = !{!"branch_weights", i32 1, i32 99}
!98 = !{!99, !101, !66, !68}
!99 = distinct !{!99, !100, !"_ZN5pages14event_location6narrowB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!100 = distinct !{!100, !"_ZN5pages14event_location6narrowB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!101 = distinct !{!101, !100, !"_ZN5pages14event_location6narrowB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!102 = !{!103, !105, !99, !101, !66, !68}
!103 = distinct !{!103, !104, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!104 = distinct !{!104, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!105 = distinct !{!105, !104, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!106 = !{!107, !109, !99, !101, !66, !68}
!107 = distinct !{!107, !108, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!108 = distinct !{!108, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!109 = distinct !{!109, !108, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!110 = !{!111, !113, !99, !101, !66, !68}
!111 = distinct !{!111, !112, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!112 = distinct !{!112, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!113 = distinct !{!113, !112, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!114 = !{!115, !117, !111, !113, !99, !101, !66, !68}
!115 = distinct !{!115, !116, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!116 = distinct !{!116, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!117 = distinct !{!117, !116, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!118 = !{!119, !121, !99, !101, !66, !68}
!119 = distinct !{!119, !120, !"_ZN5pages14event_location7to_turnB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!120 = distinct !{!120, !"_ZN5pages14event_location7to_turnB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!121 = distinct !{!121, !120, !"_ZN5pages14event_location7to_turnB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!122 = !{!123, !125, !126, !128, !66, !68}
!123 = distinct !{!123, !124, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!124 = distinct !{!124, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!125 = distinct !{!125, !124, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!126 = distinct !{!126, !127, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!127 = distinct !{!127, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!128 = distinct !{!128, !127, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!129 = !{!126, !128, !66, !68}
!130 = !{!131, !133, !66, !68}
!131 = distinct !{!131, !132, !"_ZN5pages14event_location14measure_effectB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!132 = distinct !{!132, !"_ZN5pages14event_location14measure_effectB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!133 = distinct !{!133, !132, !"_ZN5pages14event_location14measure_effectB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!134 = !{!135, !137, !131, !133, !66, !68}
!135 = distinct !{!135, !136, !"_ZN5pages12event_checks12first_passedB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!136 = distinct !{!136, !"_ZN5pages12event_checks12first_passedB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!137 = distinct !{!137, !136, !"_ZN5pages12event_checks12first_passedB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!138 = !{!139, !141, !131, !133, !66, !68}
!139 = distinct !{!139, !140, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!140 = distinct !{!140, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!141 = distinct !{!141, !140, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!142 = !{!143, !145, !131, !133, !66, !68}
!143 = distinct !{!143, !144, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!144 = distinct !{!144, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!145 = distinct !{!145, !144, !"_ZN5pages14event_location8exchangeB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!146 = !{!147, !149, !66, !68}
!147 = distinct !{!147, !148, !"_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !148, !"_ZN5pages14event_location7bracketB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!150 = !{!151, !153, !147, !149, !66, !68}
!151 = distinct !{!151, !152, !"_ZN5pages14event_location7to_turnB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN5pages14event_location7to_turnB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!153 = distinct !{!153, !152, !"_ZN5pages14event_location7to_turnB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!154 = !{!155, !157, !147, !149, !66, !68}
!155 = distinct !{!155, !156, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!156 = distinct !{!156, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!157 = distinct !{!157, !156, !"_ZN5pages14event_location7to_turnB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!158 = !{!159, !161, !66, !68}
!159 = distinct !{!159, !160, !"_ZN5pages14event_location6narrowB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!160 = distinct !{!160, !"_ZN5pages14event_location6narrowB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!161 = distinct !{!161, !160, !"_ZN5pages14event_location6narrowB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!162 = !{!163, !165, !159, !161, !66, !68}
!163 = distinct !{!163, !164, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!164 = distinct !{!164, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!165 = distinct !{!165, !164, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!166 = !{!167, !169, !159, !161, !66, !68}
!167 = distinct !{!167, !168, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!168 = distinct !{!168, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!169 = distinct !{!169, !168, !"_ZN5pages14event_location5triedB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!170 = !{!171, !173, !159, !161, !66, !68}
!171 = distinct !{!171, !172, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!172 = distinct !{!172, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!173 = distinct !{!173, !172, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!174 = !{!175, !177, !171, !173, !159, !161, !66, !68}
!175 = distinct !{!175, !176, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!176 = distinct !{!176, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!177 = distinct !{!177, !176, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!178 = !{!179, !181, !159, !161, !66, !68}
!179 = distinct !{!179, !180, !"_ZN5pages14event_location7to_turnB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!180 = distinct !{!180, !"_ZN5pages14event_location7to_turnB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!181 = distinct !{!181, !180, !"_ZN5pages14event_location7to_turnB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!182 = !{!183, !66, !68}
!183 = distinct !{!183, !184, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!184 = distinct !{!184, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!185 = !{!186, !188, !66, !68}
!186 = distinct !{!186, !187, !"_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!187 = distinct !{!187, !"_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!188 = distinct !{!188, !187, !"_ZN5pages12event_checks8may_hideB3v48B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!189 = !{!190, !192, !186, !188, !66, !68}
!190 = distinct !{!190, !191, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!191 = distinct !{!191, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!192 = distinct !{!192, !191, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!193 = !{!194, !66, !68}
!194 = distinct !{!194, !195, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!195 = distinct !{!195, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!196 = !{!197, !199, !66, !68}
!197 = distinct !{!197, !198, !"_ZN5pages12event_checks12first_passedB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!198 = distinct !{!198, !"_ZN5pages12event_checks12first_passedB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE"}
!199 = distinct !{!199, !198, !"_ZN5pages12event_checks12first_passedB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!200 = !{!201, !203, !66, !68}
!201 = distinct !{!201, !202, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!202 = distinct !{!202, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!203 = distinct !{!203, !202, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!204 = !{!205, !207, !201, !203, !66, !68}
!205 = distinct !{!205, !206, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!206 = distinct !{!206, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!207 = distinct !{!207, !206, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!208 = !{!209, !211}
!209 = distinct !{!209, !210, !"_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!210 = distinct !{!210, !"_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!211 = distinct !{!211, !210, !"_ZN5pages12event_checks12watch_guardsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!212 = !{!213, !215, !209, !211}
!213 = distinct !{!213, !214, !"_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!214 = distinct !{!214, !"_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!215 = distinct !{!215, !214, !"_ZN5pages12event_checks11mark_passedB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi8EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!216 = !{!217, !219, !213, !215, !209, !211}
!217 = distinct !{!217, !218, !"_ZN5pages12event_checks12first_passedB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!218 = distinct !{!218, !"_ZN5pages12event_checks12first_passedB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE"}
!219 = distinct !{!219, !218, !"_ZN5pages12event_checks12first_passedB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!220 = !{!221, !223, !213, !215, !209, !211}
!221 = distinct !{!221, !222, !"_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!222 = distinct !{!222, !"_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!223 = distinct !{!223, !222, !"_ZN5pages12event_checks8may_hideB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!224 = !{!225, !227, !221, !223, !213, !215, !209, !211}
!225 = distinct !{!225, !226, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!226 = distinct !{!226, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!227 = distinct !{!227, !226, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!228 = !{!229, !213, !215, !209, !211}
!229 = distinct !{!229, !230, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!230 = distinct !{!230, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!231 = !{!232, !234, !213, !215, !209, !211}
!232 = distinct !{!232, !233, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!233 = distinct !{!233, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!234 = distinct !{!234, !233, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!235 = !{!236, !238, !232, !234, !213, !215, !209, !211}
!236 = distinct !{!236, !237, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!237 = distinct !{!237, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!238 = distinct !{!238, !237, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!239 = !{!"branch_weights", i32 101, i32 99}
!240 = !{!"branch_weights", i32 301, i32 99}
!241 = !{!242, !209, !211}
!242 = distinct !{!242, !243, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!243 = distinct !{!243, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!244 = !{!245, !247}
!245 = distinct !{!245, !246, !"_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!246 = distinct !{!246, !"_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!247 = distinct !{!247, !246, !"_ZN5pages10rate_jumps11locate_jumpB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!248 = !{!249, !251, !245, !247}
!249 = distinct !{!249, !250, !"_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!250 = distinct !{!250, !"_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!251 = distinct !{!251, !250, !"_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!252 = !{!253, !245, !247}
!253 = distinct !{!253, !254, !"_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!254 = distinct !{!254, !"_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!255 = !{!256, !258, !253, !245, !247}
!256 = distinct !{!256, !257, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!257 = distinct !{!257, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!258 = distinct !{!258, !257, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!259 = !{!260, !262, !256, !258, !253, !245, !247}
!260 = distinct !{!260, !261, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %retptr"}
!261 = distinct !{!261, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd"}
!262 = distinct !{!262, !261, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %excinfo"}
!263 = !{!264, !266, !245, !247}
!264 = distinct !{!264, !265, !"_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!265 = distinct !{!265, !"_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE"}
!266 = distinct !{!266, !265, !"_ZN5pages10rate_jumps10next_placeB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!267 = !{!268, !245, !247}
!268 = distinct !{!268, !269, !"_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!269 = distinct !{!269, !"_ZN5pages10rate_jumps9put_ratesB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_282_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!270 = !{!271, !273, !268, !245, !247}
!271 = distinct !{!271, !272, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!272 = distinct !{!272, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!273 = distinct !{!273, !272, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!274 = !{!275, !277, !271, !273, !268, !245, !247}
!275 = distinct !{!275, !276, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %retptr"}
!276 = distinct !{!276, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd"}
!277 = distinct !{!277, !276, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %excinfo"}
!278 = !{!279, !245, !247}
!279 = distinct !{!279, !280, !"_ZN5pages13solver_layout9try_againB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE23Literal_5bint_5d_280_29d5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!280 = distinct !{!280, !"_ZN5pages13solver_layout9try_againB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE23Literal_5bint_5d_280_29d5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!281 = !{!282, !245, !247}
!282 = distinct !{!282, !283, !"_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!283 = distinct !{!283, !"_ZN5pages10rate_jumps5halveB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdd5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!284 = !{!285, !287, !282, !245, !247}
!285 = distinct !{!285, !286, !"_ZN5pages10rate_jumps8copy_rowB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_286_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!286 = distinct !{!286, !"_ZN5pages10rate_jumps8copy_rowB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_286_295ArrayIdLi1E1C7mutable7alignedE"}
!287 = distinct !{!287, !286, !"_ZN5pages10rate_jumps8copy_rowB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_286_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!288 = !{!289, !291, !282, !245, !247}
!289 = distinct !{!289, !290, !"_ZN5pages10rate_jumps8copy_rowB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_282_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!290 = distinct !{!290, !"_ZN5pages10rate_jumps8copy_rowB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_282_295ArrayIdLi1E1C7mutable7alignedE"}
!291 = distinct !{!291, !290, !"_ZN5pages10rate_jumps8copy_rowB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_282_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!292 = !{!293, !245, !247}
!293 = distinct !{!293, !294, !"_ZN5pages13solver_layout9try_againB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE23Literal_5bint_5d_280_29d5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!294 = distinct !{!294, !"_ZN5pages13solver_layout9try_againB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE23Literal_5bint_5d_280_29d5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!295 = !{!296, !245, !247}
!296 = distinct !{!296, !297, !"_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!297 = distinct !{!297, !"_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!298 = !{!299, !301, !302, !245, !247}
!299 = distinct !{!299, !300, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!300 = distinct !{!300, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!301 = distinct !{!301, !300, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!302 = distinct !{!302, !303, !"_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!303 = distinct !{!303, !"_ZN5pages10rate_jumps9put_ratesB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEd23Literal_5bint_5d_286_295ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!304 = !{!305, !307, !299, !301, !302, !245, !247}
!305 = distinct !{!305, !306, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %retptr"}
!306 = distinct !{!306, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd"}
!307 = distinct !{!307, !306, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %excinfo"}
!308 = !{!302, !245, !247}
!309 = !{!310}
!310 = distinct !{!310, !311, !"_ZN5pages12time_stepper6sampleB3v73B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!311 = distinct !{!311, !"_ZN5pages12time_stepper6sampleB3v73B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!312 = !{!313, !315, !310}
!313 = distinct !{!313, !314, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!314 = distinct !{!314, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!315 = distinct !{!315, !314, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!316 = !{!317, !319}
!317 = distinct !{!317, !318, !"_ZN5pages14event_location11decide_anewB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!318 = distinct !{!318, !"_ZN5pages14event_location11decide_anewB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!319 = distinct !{!319, !318, !"_ZN5pages14event_location11decide_anewB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!320 = !{!321, !317, !319}
!321 = distinct !{!321, !322, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!322 = distinct !{!322, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!323 = !{!324}
!324 = distinct !{!324, !325, !"_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!325 = distinct !{!325, !"_ZN5pages10rate_jumps9pass_jumpB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!326 = !{!327, !329}
!327 = distinct !{!327, !328, !"_ZN5pages8segments6at_endB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!328 = distinct !{!328, !"_ZN5pages8segments6at_endB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!329 = distinct !{!329, !330, !"_ZN5pages8segments4jumpB3v75B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!330 = distinct !{!330, !"_ZN5pages8segments4jumpB3v75B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi8EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!331 = !{!329}
!332 = !{!333, !335, !329}
!333 = distinct !{!333, !334, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!334 = distinct !{!334, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!335 = distinct !{!335, !334, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!336 = !{!337, !329}
!337 = distinct !{!337, !338, !"_ZN5pages8segments6at_endB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!338 = distinct !{!338, !"_ZN5pages8segments6at_endB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!339 = !{!340, !329}
!340 = distinct !{!340, !341, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!341 = distinct !{!341, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!342 = !{!343, !329}
!343 = distinct !{!343, !344, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!344 = distinct !{!344, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!345 = !{!346}
!346 = distinct !{!346, !347, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!347 = distinct !{!347, !"_ZN5pages13solver_layout4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!348 = !{!349, !351}
!349 = distinct !{!349, !350, !"_ZN5pages8segments11enter_pieceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!350 = distinct !{!350, !"_ZN5pages8segments11enter_pieceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!351 = distinct !{!351, !350, !"_ZN5pages8segments11enter_pieceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!352 = !{!353, !355, !349, !351}
!353 = distinct !{!353, !354, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!354 = distinct !{!354, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!355 = distinct !{!355, !354, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!356 = !{!357}
!357 = distinct !{!357, !358, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!358 = distinct !{!358, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi8EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!359 = !{!360, !362, !357}
!360 = distinct !{!360, !361, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!361 = distinct !{!361, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!362 = distinct !{!362, !361, !"_ZN5pages8segments9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!363 = !{!364, !366}
!364 = distinct !{!364, !365, !"_ZN5pages8segments10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!365 = distinct !{!365, !"_ZN5pages8segments10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!366 = distinct !{!366, !365, !"_ZN5pages8segments10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!367 = !{!368, !370}
!368 = distinct !{!368, !369, !"_ZN5pages12time_stepper11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!369 = distinct !{!369, !"_ZN5pages12time_stepper11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!370 = distinct !{!370, !369, !"_ZN5pages12time_stepper11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi8EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!371 = !{!372, !374}
!372 = distinct !{!372, !373, !"_ZN5pages12event_checks12first_passedB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!373 = distinct !{!373, !"_ZN5pages12event_checks12first_passedB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!374 = distinct !{!374, !373, !"_ZN5pages12event_checks12first_passedB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!375 = !{!376, !378}
!376 = distinct !{!376, !377, !"_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!377 = distinct !{!377, !"_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!378 = distinct !{!378, !377, !"_ZN5pages12event_checks8may_hideB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!379 = !{!380, !382, !376, !378}
!380 = distinct !{!380, !381, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!381 = distinct !{!381, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!382 = distinct !{!382, !381, !"_ZN5pages12event_checks13error_betweenB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!383 = !{!384}
!384 = distinct !{!384, !385, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!385 = distinct !{!385, !"_ZN5pages13solver_layout9try_againB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!386 = !{!387, !389}
!387 = distinct !{!387, !388, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!388 = distinct !{!388, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!389 = distinct !{!389, !388, !"_ZN5pages13solver_layout12state_withinB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!390 = !{!391, !393, !387, !389}
!391 = distinct !{!391, !392, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!392 = distinct !{!392, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!393 = distinct !{!393, !392, !"_ZN5pages13solver_layout11interpolateB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!394 = !{!395, !397}
!395 = distinct !{!395, !396, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!396 = distinct !{!396, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!397 = distinct !{!397, !396, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!398 = !{!399, !401, !395, !397}
!399 = distinct !{!399, !400, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %retptr"}
!400 = distinct !{!400, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd"}
!401 = distinct !{!401, !400, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %excinfo"}
!402 = !{!403, !405}
!403 = distinct !{!403, !404, !"_ZN5pages13solver_layout12slope_withinB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxd: %retptr"}
!404 = distinct !{!404, !"_ZN5pages13solver_layout12slope_withinB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxd"}
!405 = distinct !{!405, !404, !"_ZN5pages13solver_layout12slope_withinB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxd: %excinfo"}
!406 = !{!407, !409}
!407 = distinct !{!407, !408, !"_ZN5pages10rate_jumps11odd_quarterB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!408 = distinct !{!408, !"_ZN5pages10rate_jumps11odd_quarterB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE"}
!409 = distinct !{!409, !408, !"_ZN5pages10rate_jumps11odd_quarterB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!410 = !{!411}
!411 = distinct !{!411, !412, !"_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!412 = distinct !{!412, !"_ZN5pages10rate_jumps9put_ratesB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEdx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!413 = !{!414, !416, !411}
!414 = distinct !{!414, !415, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!415 = distinct !{!415, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!416 = distinct !{!416, !415, !"_ZN5pages13solver_layout12state_withinB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!417 = !{!418, !420, !414, !416, !411}
!418 = distinct !{!418, !419, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %retptr"}
!419 = distinct !{!419, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd"}
!420 = distinct !{!420, !419, !"_ZN5pages13solver_layout11interpolateB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_2923Literal_5bint_5d_280_29xd: %excinfo"}
!421 = !{!422, !424}
!422 = distinct !{!422, !423, !"_ZN5pages10rate_jumps8copy_rowB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_287_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!423 = distinct !{!423, !"_ZN5pages10rate_jumps8copy_rowB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_287_295ArrayIdLi1E1C7mutable7alignedE"}
!424 = distinct !{!424, !423, !"_ZN5pages10rate_jumps8copy_rowB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_287_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!425 = !{!426, !428}
!426 = distinct !{!426, !427, !"_ZN5pages10rate_jumps8copy_rowB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_282_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!427 = distinct !{!427, !"_ZN5pages10rate_jumps8copy_rowB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_282_295ArrayIdLi1E1C7mutable7alignedE"}
!428 = distinct !{!428, !427, !"_ZN5pages10rate_jumps8copy_rowB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_282_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!429 = !{!430, !432}
!430 = distinct !{!430, !431, !"_ZN5pages10rate_jumps8copy_rowB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_286_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!431 = distinct !{!431, !"_ZN5pages10rate_jumps8copy_rowB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_286_295ArrayIdLi1E1C7mutable7alignedE"}
!432 = distinct !{!432, !431, !"_ZN5pages10rate_jumps8copy_rowB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx23Literal_5bint_5d_287_2923Literal_5bint_5d_286_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}

define i64 @advance(ptr %numbers) {
  %result = alloca i64
  %error = alloca ptr
  %at.0 = getelementptr i64, ptr %numbers, i64 0
  %number.0 = load ptr, ptr %at.0
  %at.1 = getelementptr i64, ptr %numbers, i64 1
  %number.1 = load ptr, ptr %at.1
  %at.2 = getelementptr i64, ptr %numbers, i64 2
  %number.2 = load i64, ptr %at.2
  %at.3 = getelementptr i64, ptr %numbers, i64 3
  %number.3 = load i64, ptr %at.3
  %at.4 = getelementptr i64, ptr %numbers, i64 4
  %number.4 = load ptr, ptr %at.4
  %at.5 = getelementptr i64, ptr %numbers, i64 5
  %number.5 = load i64, ptr %at.5
  %at.6 = getelementptr i64, ptr %numbers, i64 6
  %number.6 = load i64, ptr %at.6
  %at.7 = getelementptr i64, ptr %numbers, i64 7
  %number.7 = load i64, ptr %at.7
  %at.8 = getelementptr i64, ptr %numbers, i64 8
  %number.8 = load i64, ptr %at.8
  %at.9 = getelementptr i64, ptr %numbers, i64 9
  %number.9 = load i64, ptr %at.9
  %at.10 = getelementptr i64, ptr %numbers, i64 10
  %number.10 = load i64, ptr %at.10
  %at.11 = getelementptr i64, ptr %numbers, i64 11
  %number.11 = load i64, ptr %at.11
  %at.12 = getelementptr i64, ptr %numbers, i64 12
  %number.12 = load i64, ptr %at.12
  %at.13 = getelementptr i64, ptr %numbers, i64 13
  %number.13 = load i64, ptr %at.13
  %at.14 = getelementptr i64, ptr %numbers, i64 14
  %number.14 = load i64, ptr %at.14
  %at.15 = getelementptr i64, ptr %numbers, i64 15
  %number.15 = load ptr, ptr %at.15
  %at.16 = getelementptr i64, ptr %numbers, i64 16
  %number.16 = load ptr, ptr %at.16
  %at.17 = getelementptr i64, ptr %numbers, i64 17
  %number.17 = load i64, ptr %at.17
  %at.18 = getelementptr i64, ptr %numbers, i64 18
  %number.18 = load i64, ptr %at.18
  %at.19 = getelementptr i64, ptr %numbers, i64 19
  %number.19 = load ptr, ptr %at.19
  %at.20 = getelementptr i64, ptr %numbers, i64 20
  %number.20 = load i64, ptr %at.20
  %at.21 = getelementptr i64, ptr %numbers, i64 21
  %number.21 = load i64, ptr %at.21
  %at.22 = getelementptr i64, ptr %numbers, i64 22
  %number.22 = load ptr, ptr %at.22
  %at.23 = getelementptr i64, ptr %numbers, i64 23
  %number.23 = load ptr, ptr %at.23
  %at.24 = getelementptr i64, ptr %numbers, i64 24
  %number.24 = load i64, ptr %at.24
  %at.25 = getelementptr i64, ptr %numbers, i64 25
  %number.25 = load i64, ptr %at.25
  %at.26 = getelementptr i64, ptr %numbers, i64 26
  %number.26 = load ptr, ptr %at.26
  %at.27 = getelementptr i64, ptr %numbers, i64 27
  %number.27 = load i64, ptr %at.27
  %at.28 = getelementptr i64, ptr %numbers, i64 28
  %number.28 = load i64, ptr %at.28
  %at.29 = getelementptr i64, ptr %numbers, i64 29
  %number.29 = load i64, ptr %at.29
  %at.30 = getelementptr i64, ptr %numbers, i64 30
  %number.30 = load i64, ptr %at.30
  %at.31 = getelementptr i64, ptr %numbers, i64 31
  %number.31 = load ptr, ptr %at.31
  %at.32 = getelementptr i64, ptr %numbers, i64 32
  %number.32 = load ptr, ptr %at.32
  %at.33 = getelementptr i64, ptr %numbers, i64 33
  %number.33 = load i64, ptr %at.33
  %at.34 = getelementptr i64, ptr %numbers, i64 34
  %number.34 = load i64, ptr %at.34
  %at.35 = getelementptr i64, ptr %numbers, i64 35
  %number.35 = load ptr, ptr %at.35
  %at.36 = getelementptr i64, ptr %numbers, i64 36
  %number.36 = load i64, ptr %at.36
  %at.37 = getelementptr i64, ptr %numbers, i64 37
  %number.37 = load i64, ptr %at.37
  %at.38 = getelementptr i64, ptr %numbers, i64 38
  %number.38 = load i64, ptr %at.38
  %at.39 = getelementptr i64, ptr %numbers, i64 39
  %number.39 = load i64, ptr %at.39
  %at.40 = getelementptr i64, ptr %numbers, i64 40
  %number.40 = load ptr, ptr %at.40
  %at.41 = getelementptr i64, ptr %numbers, i64 41
  %number.41 = load ptr, ptr %at.41
  %at.42 = getelementptr i64, ptr %numbers, i64 42
  %number.42 = load i64, ptr %at.42
  %at.43 = getelementptr i64, ptr %numbers, i64 43
  %number.43 = load i64, ptr %at.43
  %at.44 = getelementptr i64, ptr %numbers, i64 44
  %number.44 = load ptr, ptr %at.44
  %at.45 = getelementptr i64, ptr %numbers, i64 45
  %number.45 = load i64, ptr %at.45
  %at.46 = getelementptr i64, ptr %numbers, i64 46
  %number.46 = load i64, ptr %at.46
  %at.47 = getelementptr i64, ptr %numbers, i64 47
  %number.47 = load ptr, ptr %at.47
  %at.48 = getelementptr i64, ptr %numbers, i64 48
  %number.48 = load ptr, ptr %at.48
  %at.49 = getelementptr i64, ptr %numbers, i64 49
  %number.49 = load i64, ptr %at.49
  %at.50 = getelementptr i64, ptr %numbers, i64 50
  %number.50 = load i64, ptr %at.50
  %at.51 = getelementptr i64, ptr %numbers, i64 51
  %number.51 = load ptr, ptr %at.51
  %at.52 = getelementptr i64, ptr %numbers, i64 52
  %number.52 = load i64, ptr %at.52
  %at.53 = getelementptr i64, ptr %numbers, i64 53
  %number.53 = load i64, ptr %at.53
  %at.54 = getelementptr i64, ptr %numbers, i64 54
  %number.54 = load ptr, ptr %at.54
  %at.55 = getelementptr i64, ptr %numbers, i64 55
  %number.55 = load ptr, ptr %at.55
  %at.56 = getelementptr i64, ptr %numbers, i64 56
  %number.56 = load i64, ptr %at.56
  %at.57 = getelementptr i64, ptr %numbers, i64 57
  %number.57 = load i64, ptr %at.57
  %at.58 = getelementptr i64, ptr %numbers, i64 58
  %number.58 = load ptr, ptr %at.58
  %at.59 = getelementptr i64, ptr %numbers, i64 59
  %number.59 = load i64, ptr %at.59
  %at.60 = getelementptr i64, ptr %numbers, i64 60
  %number.60 = load i64, ptr %at.60
  %at.61 = getelementptr i64, ptr %numbers, i64 61
  %number.61 = load ptr, ptr %at.61
  %at.62 = getelementptr i64, ptr %numbers, i64 62
  %number.62 = load ptr, ptr %at.62
  %at.63 = getelementptr i64, ptr %numbers, i64 63
  %number.63 = load i64, ptr %at.63
  %at.64 = getelementptr i64, ptr %numbers, i64 64
  %number.64 = load i64, ptr %at.64
  %at.65 = getelementptr i64, ptr %numbers, i64 65
  %number.65 = load ptr, ptr %at.65
  %at.66 = getelementptr i64, ptr %numbers, i64 66
  %number.66 = load i64, ptr %at.66
  %at.67 = getelementptr i64, ptr %numbers, i64 67
  %number.67 = load i64, ptr %at.67
  %at.68 = getelementptr i64, ptr %numbers, i64 68
  %number.68 = load ptr, ptr %at.68
  %at.69 = getelementptr i64, ptr %numbers, i64 69
  %number.69 = load ptr, ptr %at.69
  %at.70 = getelementptr i64, ptr %numbers, i64 70
  %number.70 = load i64, ptr %at.70
  %at.71 = getelementptr i64, ptr %numbers, i64 71
  %number.71 = load i64, ptr %at.71
  %at.72 = getelementptr i64, ptr %numbers, i64 72
  %number.72 = load ptr, ptr %at.72
  %at.73 = getelementptr i64, ptr %numbers, i64 73
  %number.73 = load i64, ptr %at.73
  %at.74 = getelementptr i64, ptr %numbers, i64 74
  %number.74 = load i64, ptr %at.74
  %at.75 = getelementptr i64, ptr %numbers, i64 75
  %number.75 = load i64, ptr %at.75
  %at.76 = getelementptr i64, ptr %numbers, i64 76
  %number.76 = load i64, ptr %at.76
  %at.77 = getelementptr i64, ptr %numbers, i64 77
  %number.77 = load ptr, ptr %at.77
  %at.78 = getelementptr i64, ptr %numbers, i64 78
  %number.78 = load ptr, ptr %at.78
  %at.79 = getelementptr i64, ptr %numbers, i64 79
  %number.79 = load i64, ptr %at.79
  %at.80 = getelementptr i64, ptr %numbers, i64 80
  %number.80 = load i64, ptr %at.80
  %at.81 = getelementptr i64, ptr %numbers, i64 81
  %number.81 = load ptr, ptr %at.81
  %at.82 = getelementptr i64, ptr %numbers, i64 82
  %number.82 = load i64, ptr %at.82
  %at.83 = getelementptr i64, ptr %numbers, i64 83
  %number.83 = load i64, ptr %at.83
  %at.84 = getelementptr i64, ptr %numbers, i64 84
  %number.84 = load ptr, ptr %at.84
  %at.85 = getelementptr i64, ptr %numbers, i64 85
  %number.85 = load ptr, ptr %at.85
  %at.86 = getelementptr i64, ptr %numbers, i64 86
  %number.86 = load i64, ptr %at.86
  %at.87 = getelementptr i64, ptr %numbers, i64 87
  %number.87 = load i64, ptr %at.87
  %at.88 = getelementptr i64, ptr %numbers, i64 88
  %number.88 = load ptr, ptr %at.88
  %at.89 = getelementptr i64, ptr %numbers, i64 89
  %number.89 = load i64, ptr %at.89
  %at.90 = getelementptr i64, ptr %numbers, i64 90
  %number.90 = load i64, ptr %at.90
  %at.91 = getelementptr i64, ptr %numbers, i64 91
  %number.91 = load ptr, ptr %at.91
  %at.92 = getelementptr i64, ptr %numbers, i64 92
  %number.92 = load ptr, ptr %at.92
  %at.93 = getelementptr i64, ptr %numbers, i64 93
  %number.93 = load i64, ptr %at.93
  %at.94 = getelementptr i64, ptr %numbers, i64 94
  %number.94 = load i64, ptr %at.94
  %at.95 = getelementptr i64, ptr %numbers, i64 95
  %number.95 = load ptr, ptr %at.95
  %at.96 = getelementptr i64, ptr %numbers, i64 96
  %number.96 = load i64, ptr %at.96
  %at.97 = getelementptr i64, ptr %numbers, i64 97
  %number.97 = load i64, ptr %at.97
  %at.98 = getelementptr i64, ptr %numbers, i64 98
  %number.98 = load i64, ptr %at.98
  %at.99 = getelementptr i64, ptr %numbers, i64 99
  %number.99 = load i64, ptr %at.99
  %at.100 = getelementptr i64, ptr %numbers, i64 100
  %number.100 = load i64, ptr %at.100
  %at.101 = getelementptr i64, ptr %numbers, i64 101
  %number.101 = load i64, ptr %at.101
  %at.102 = getelementptr i64, ptr %numbers, i64 102
  %number.102 = load ptr, ptr %at.102
  %at.103 = getelementptr i64, ptr %numbers, i64 103
  %number.103 = load ptr, ptr %at.103
  %at.104 = getelementptr i64, ptr %numbers, i64 104
  %number.104 = load i64, ptr %at.104
  %at.105 = getelementptr i64, ptr %numbers, i64 105
  %number.105 = load i64, ptr %at.105
  %at.106 = getelementptr i64, ptr %numbers, i64 106
  %number.106 = load ptr, ptr %at.106
  %at.107 = getelementptr i64, ptr %numbers, i64 107
  %number.107 = load i64, ptr %at.107
  %at.108 = getelementptr i64, ptr %numbers, i64 108
  %number.108 = load i64, ptr %at.108
  %at.109 = getelementptr i64, ptr %numbers, i64 109
  %number.109 = load ptr, ptr %at.109
  %at.110 = getelementptr i64, ptr %numbers, i64 110
  %number.110 = load ptr, ptr %at.110
  %at.111 = getelementptr i64, ptr %numbers, i64 111
  %number.111 = load i64, ptr %at.111
  %at.112 = getelementptr i64, ptr %numbers, i64 112
  %number.112 = load i64, ptr %at.112
  %at.113 = getelementptr i64, ptr %numbers, i64 113
  %number.113 = load ptr, ptr %at.113
  %at.114 = getelementptr i64, ptr %numbers, i64 114
  %number.114 = load i64, ptr %at.114
  %at.115 = getelementptr i64, ptr %numbers, i64 115
  %number.115 = load i64, ptr %at.115
  %at.116 = getelementptr i64, ptr %numbers, i64 116
  %number.116 = load ptr, ptr %at.116
  %at.117 = getelementptr i64, ptr %numbers, i64 117
  %number.117 = load ptr, ptr %at.117
  %at.118 = getelementptr i64, ptr %numbers, i64 118
  %number.118 = load i64, ptr %at.118
  %at.119 = getelementptr i64, ptr %numbers, i64 119
  %number.119 = load i64, ptr %at.119
  %at.120 = getelementptr i64, ptr %numbers, i64 120
  %number.120 = load ptr, ptr %at.120
  %at.121 = getelementptr i64, ptr %numbers, i64 121
  %number.121 = load i64, ptr %at.121
  %at.122 = getelementptr i64, ptr %numbers, i64 122
  %number.122 = load i64, ptr %at.122
  %at.123 = getelementptr i64, ptr %numbers, i64 123
  %number.123 = load i64, ptr %at.123
  %at.124 = getelementptr i64, ptr %numbers, i64 124
  %number.124 = load i64, ptr %at.124
  %at.125 = getelementptr i64, ptr %numbers, i64 125
  %number.125 = load ptr, ptr %at.125
  %at.126 = getelementptr i64, ptr %numbers, i64 126
  %number.126 = load ptr, ptr %at.126
  %at.127 = getelementptr i64, ptr %numbers, i64 127
  %number.127 = load i64, ptr %at.127
  %at.128 = getelementptr i64, ptr %numbers, i64 128
  %number.128 = load i64, ptr %at.128
  %at.129 = getelementptr i64, ptr %numbers, i64 129
  %number.129 = load ptr, ptr %at.129
  %at.130 = getelementptr i64, ptr %numbers, i64 130
  %number.130 = load i64, ptr %at.130
  %at.131 = getelementptr i64, ptr %numbers, i64 131
  %number.131 = load i64, ptr %at.131
  %at.132 = getelementptr i64, ptr %numbers, i64 132
  %number.132 = load i64, ptr %at.132
  %at.133 = getelementptr i64, ptr %numbers, i64 133
  %number.133 = load i64, ptr %at.133
  %at.134 = getelementptr i64, ptr %numbers, i64 134
  %number.134 = load ptr, ptr %at.134
  %at.135 = getelementptr i64, ptr %numbers, i64 135
  %number.135 = load ptr, ptr %at.135
  %at.136 = getelementptr i64, ptr %numbers, i64 136
  %number.136 = load i64, ptr %at.136
  %at.137 = getelementptr i64, ptr %numbers, i64 137
  %number.137 = load i64, ptr %at.137
  %at.138 = getelementptr i64, ptr %numbers, i64 138
  %number.138 = load ptr, ptr %at.138
  %at.139 = getelementptr i64, ptr %numbers, i64 139
  %number.139 = load i64, ptr %at.139
  %at.140 = getelementptr i64, ptr %numbers, i64 140
  %number.140 = load i64, ptr %at.140
  %at.141 = getelementptr i64, ptr %numbers, i64 141
  %number.141 = load i64, ptr %at.141
  %at.142 = getelementptr i64, ptr %numbers, i64 142
  %number.142 = load i64, ptr %at.142
  %at.143 = getelementptr i64, ptr %numbers, i64 143
  %number.143 = load ptr, ptr %at.143
  %at.144 = getelementptr i64, ptr %numbers, i64 144
  %number.144 = load ptr, ptr %at.144
  %at.145 = getelementptr i64, ptr %numbers, i64 145
  %number.145 = load i64, ptr %at.145
  %at.146 = getelementptr i64, ptr %numbers, i64 146
  %number.146 = load i64, ptr %at.146
  %at.147 = getelementptr i64, ptr %numbers, i64 147
  %number.147 = load ptr, ptr %at.147
  %at.148 = getelementptr i64, ptr %numbers, i64 148
  %number.148 = load i64, ptr %at.148
  %at.149 = getelementptr i64, ptr %numbers, i64 149
  %number.149 = load i64, ptr %at.149
  %at.150 = getelementptr i64, ptr %numbers, i64 150
  %number.150 = load ptr, ptr %at.150
  %at.151 = getelementptr i64, ptr %numbers, i64 151
  %number.151 = load ptr, ptr %at.151
  %at.152 = getelementptr i64, ptr %numbers, i64 152
  %number.152 = load i64, ptr %at.152
  %at.153 = getelementptr i64, ptr %numbers, i64 153
  %number.153 = load i64, ptr %at.153
  %at.154 = getelementptr i64, ptr %numbers, i64 154
  %number.154 = load ptr, ptr %at.154
  %at.155 = getelementptr i64, ptr %numbers, i64 155
  %number.155 = load i64, ptr %at.155
  %at.156 = getelementptr i64, ptr %numbers, i64 156
  %number.156 = load i64, ptr %at.156
  %at.157 = getelementptr i64, ptr %numbers, i64 157
  %number.157 = load ptr, ptr %at.157
  %at.158 = getelementptr i64, ptr %numbers, i64 158
  %number.158 = load ptr, ptr %at.158
  %at.159 = getelementptr i64, ptr %numbers, i64 159
  %number.159 = load i64, ptr %at.159
  %at.160 = getelementptr i64, ptr %numbers, i64 160
  %number.160 = load i64, ptr %at.160
  %at.161 = getelementptr i64, ptr %numbers, i64 161
  %number.161 = load ptr, ptr %at.161
  %at.162 = getelementptr i64, ptr %numbers, i64 162
  %number.162 = load i64, ptr %at.162
  %at.163 = getelementptr i64, ptr %numbers, i64 163
  %number.163 = load i64, ptr %at.163
  %at.164 = getelementptr i64, ptr %numbers, i64 164
  %number.164 = load ptr, ptr %at.164
  %at.165 = getelementptr i64, ptr %numbers, i64 165
  %number.165 = load ptr, ptr %at.165
  %at.166 = getelementptr i64, ptr %numbers, i64 166
  %number.166 = load i64, ptr %at.166
  %at.167 = getelementptr i64, ptr %numbers, i64 167
  %number.167 = load i64, ptr %at.167
  %at.168 = getelementptr i64, ptr %numbers, i64 168
  %number.168 = load ptr, ptr %at.168
  %at.169 = getelementptr i64, ptr %numbers, i64 169
  %number.169 = load i64, ptr %at.169
  %at.170 = getelementptr i64, ptr %numbers, i64 170
  %number.170 = load i64, ptr %at.170
  %at.171 = getelementptr i64, ptr %numbers, i64 171
  %number.171 = load ptr, ptr %at.171
  %at.172 = getelementptr i64, ptr %numbers, i64 172
  %number.172 = load ptr, ptr %at.172
  %at.173 = getelementptr i64, ptr %numbers, i64 173
  %number.173 = load i64, ptr %at.173
  %at.174 = getelementptr i64, ptr %numbers, i64 174
  %number.174 = load i64, ptr %at.174
  %at.175 = getelementptr i64, ptr %numbers, i64 175
  %number.175 = load ptr, ptr %at.175
  %at.176 = getelementptr i64, ptr %numbers, i64 176
  %number.176 = load i64, ptr %at.176
  %at.177 = getelementptr i64, ptr %numbers, i64 177
  %number.177 = load i64, ptr %at.177
  %at.178 = getelementptr i64, ptr %numbers, i64 178
  %number.178 = load ptr, ptr %at.178
  %at.179 = getelementptr i64, ptr %numbers, i64 179
  %number.179 = load ptr, ptr %at.179
  %at.180 = getelementptr i64, ptr %numbers, i64 180
  %number.180 = load i64, ptr %at.180
  %at.181 = getelementptr i64, ptr %numbers, i64 181
  %number.181 = load i64, ptr %at.181
  %at.182 = getelementptr i64, ptr %numbers, i64 182
  %number.182 = load ptr, ptr %at.182
  %at.183 = getelementptr i64, ptr %numbers, i64 183
  %number.183 = load i64, ptr %at.183
  %at.184 = getelementptr i64, ptr %numbers, i64 184
  %number.184 = load i64, ptr %at.184
  %at.185 = getelementptr i64, ptr %numbers, i64 185
  %number.185 = load ptr, ptr %at.185
  %at.186 = getelementptr i64, ptr %numbers, i64 186
  %number.186 = load ptr, ptr %at.186
  %at.187 = getelementptr i64, ptr %numbers, i64 187
  %number.187 = load i64, ptr %at.187
  %at.188 = getelementptr i64, ptr %numbers, i64 188
  %number.188 = load i64, ptr %at.188
  %at.189 = getelementptr i64, ptr %numbers, i64 189
  %number.189 = load ptr, ptr %at.189
  %at.190 = getelementptr i64, ptr %numbers, i64 190
  %number.190 = load i64, ptr %at.190
  %at.191 = getelementptr i64, ptr %numbers, i64 191
  %number.191 = load i64, ptr %at.191
  %at.192 = getelementptr i64, ptr %numbers, i64 192
  %number.192 = load ptr, ptr %at.192
  %at.193 = getelementptr i64, ptr %numbers, i64 193
  %number.193 = load ptr, ptr %at.193
  %at.194 = getelementptr i64, ptr %numbers, i64 194
  %number.194 = load i64, ptr %at.194
  %at.195 = getelementptr i64, ptr %numbers, i64 195
  %number.195 = load i64, ptr %at.195
  %at.196 = getelementptr i64, ptr %numbers, i64 196
  %number.196 = load ptr, ptr %at.196
  %at.197 = getelementptr i64, ptr %numbers, i64 197
  %number.197 = load i64, ptr %at.197
  %at.198 = getelementptr i64, ptr %numbers, i64 198
  %number.198 = load i64, ptr %at.198
  %at.199 = getelementptr i64, ptr %numbers, i64 199
  %number.199 = load ptr, ptr %at.199
  %at.200 = getelementptr i64, ptr %numbers, i64 200
  %number.200 = load ptr, ptr %at.200
  %at.201 = getelementptr i64, ptr %numbers, i64 201
  %number.201 = load i64, ptr %at.201
  %at.202 = getelementptr i64, ptr %numbers, i64 202
  %number.202 = load i64, ptr %at.202
  %at.203 = getelementptr i64, ptr %numbers, i64 203
  %number.203 = load ptr, ptr %at.203
  %at.204 = getelementptr i64, ptr %numbers, i64 204
  %number.204 = load i64, ptr %at.204
  %at.205 = getelementptr i64, ptr %numbers, i64 205
  %number.205 = load i64, ptr %at.205
  %at.206 = getelementptr i64, ptr %numbers, i64 206
  %number.206 = load i64, ptr %at.206
  %at.207 = getelementptr i64, ptr %numbers, i64 207
  %number.207 = load i64, ptr %at.207
  %at.208 = getelementptr i64, ptr %numbers, i64 208
  %number.208 = load i64, ptr %at.208
  %at.209 = getelementptr i64, ptr %numbers, i64 209
  %number.209 = load ptr, ptr %at.209
  %at.210 = getelementptr i64, ptr %numbers, i64 210
  %number.210 = load ptr, ptr %at.210
  %at.211 = getelementptr i64, ptr %numbers, i64 211
  %number.211 = load i64, ptr %at.211
  %at.212 = getelementptr i64, ptr %numbers, i64 212
  %number.212 = load i64, ptr %at.212
  %at.213 = getelementptr i64, ptr %numbers, i64 213
  %number.213 = load ptr, ptr %at.213
  %at.214 = getelementptr i64, ptr %numbers, i64 214
  %number.214 = load i64, ptr %at.214
  %at.215 = getelementptr i64, ptr %numbers, i64 215
  %number.215 = load i64, ptr %at.215
  %at.216 = getelementptr i64, ptr %numbers, i64 216
  %number.216 = load ptr, ptr %at.216
  %at.217 = getelementptr i64, ptr %numbers, i64 217
  %number.217 = load ptr, ptr %at.217
  %at.218 = getelementptr i64, ptr %numbers, i64 218
  %number.218 = load i64, ptr %at.218
  %at.219 = getelementptr i64, ptr %numbers, i64 219
  %number.219 = load i64, ptr %at.219
  %at.220 = getelementptr i64, ptr %numbers, i64 220
  %number.220 = load ptr, ptr %at.220
  %at.221 = getelementptr i64, ptr %numbers, i64 221
  %number.221 = load i64, ptr %at.221
  %at.222 = getelementptr i64, ptr %numbers, i64 222
  %number.222 = load i64, ptr %at.222
  %at.223 = getelementptr i64, ptr %numbers, i64 223
  %number.223 = load ptr, ptr %at.223
  %at.224 = getelementptr i64, ptr %numbers, i64 224
  %number.224 = load ptr, ptr %at.224
  %at.225 = getelementptr i64, ptr %numbers, i64 225
  %number.225 = load i64, ptr %at.225
  %at.226 = getelementptr i64, ptr %numbers, i64 226
  %number.226 = load i64, ptr %at.226
  %at.227 = getelementptr i64, ptr %numbers, i64 227
  %number.227 = load ptr, ptr %at.227
  %at.228 = getelementptr i64, ptr %numbers, i64 228
  %number.228 = load i64, ptr %at.228
  %at.229 = getelementptr i64, ptr %numbers, i64 229
  %number.229 = load i64, ptr %at.229
  %at.230 = getelementptr i64, ptr %numbers, i64 230
  %number.230 = load ptr, ptr %at.230
  %at.231 = getelementptr i64, ptr %numbers, i64 231
  %number.231 = load ptr, ptr %at.231
  %at.232 = getelementptr i64, ptr %numbers, i64 232
  %number.232 = load i64, ptr %at.232
  %at.233 = getelementptr i64, ptr %numbers, i64 233
  %number.233 = load i64, ptr %at.233
  %at.234 = getelementptr i64, ptr %numbers, i64 234
  %number.234 = load ptr, ptr %at.234
  %at.235 = getelementptr i64, ptr %numbers, i64 235
  %number.235 = load i64, ptr %at.235
  %at.236 = getelementptr i64, ptr %numbers, i64 236
  %number.236 = load i64, ptr %at.236
  %at.237 = getelementptr i64, ptr %numbers, i64 237
  %number.237 = load ptr, ptr %at.237
  %at.238 = getelementptr i64, ptr %numbers, i64 238
  %number.238 = load ptr, ptr %at.238
  %at.239 = getelementptr i64, ptr %numbers, i64 239
  %number.239 = load i64, ptr %at.239
  %at.240 = getelementptr i64, ptr %numbers, i64 240
  %number.240 = load i64, ptr %at.240
  %at.241 = getelementptr i64, ptr %numbers, i64 241
  %number.241 = load ptr, ptr %at.241
  %at.242 = getelementptr i64, ptr %numbers, i64 242
  %number.242 = load i64, ptr %at.242
  %at.243 = getelementptr i64, ptr %numbers, i64 243
  %number.243 = load i64, ptr %at.243
  %at.244 = getelementptr i64, ptr %numbers, i64 244
  %number.244 = load ptr, ptr %at.244
  %at.245 = getelementptr i64, ptr %numbers, i64 245
  %number.245 = load ptr, ptr %at.245
  %at.246 = getelementptr i64, ptr %numbers, i64 246
  %number.246 = load i64, ptr %at.246
  %at.247 = getelementptr i64, ptr %numbers, i64 247
  %number.247 = load i64, ptr %at.247
  %at.248 = getelementptr i64, ptr %numbers, i64 248
  %number.248 = load ptr, ptr %at.248
  %at.249 = getelementptr i64, ptr %numbers, i64 249
  %number.249 = load i64, ptr %at.249
  %at.250 = getelementptr i64, ptr %numbers, i64 250
  %number.250 = load i64, ptr %at.250
  %at.251 = getelementptr i64, ptr %numbers, i64 251
  %number.251 = load i64, ptr %at.251
  %at.252 = getelementptr i64, ptr %numbers, i64 252
  %number.252 = load i64, ptr %at.252
  %status = call i32 @advance_of_many(ptr %result, ptr %error, ptr %number.0, ptr %number.1, i64 %number.2, i64 %number.3, ptr %number.4, i64 %number.5, i64 %number.6, i64 %number.7, i64 %number.8, i64 %number.9, i64 %number.10, i64 %number.11, i64 %number.12, i64 %number.13, i64 %number.14, ptr %number.15, ptr %number.16, i64 %number.17, i64 %number.18, ptr %number.19, i64 %number.20, i64 %number.21, ptr %number.22, ptr %number.23, i64 %number.24, i64 %number.25, ptr %number.26, i64 %number.27, i64 %number.28, i64 %number.29, i64 %number.30, ptr %number.31, ptr %number.32, i64 %number.33, i64 %number.34, ptr %number.35, i64 %number.36, i64 %number.37, i64 %number.38, i64 %number.39, ptr %number.40, ptr %number.41, i64 %number.42, i64 %number.43, ptr %number.44, i64 %number.45, i64 %number.46, ptr %number.47, ptr %number.48, i64 %number.49, i64 %number.50, ptr %number.51, i64 %number.52, i64 %number.53, ptr %number.54, ptr %number.55, i64 %number.56, i64 %number.57, ptr %number.58, i64 %number.59, i64 %number.60, ptr %number.61, ptr %number.62, i64 %number.63, i64 %number.64, ptr %number.65, i64 %number.66, i64 %number.67, ptr %number.68, ptr %number.69, i64 %number.70, i64 %number.71, ptr %number.72, i64 %number.73, i64 %number.74, i64 %number.75, i64 %number.76, ptr %number.77, ptr %number.78, i64 %number.79, i64 %number.80, ptr %number.81, i64 %number.82, i64 %number.83, ptr %number.84, ptr %number.85, i64 %number.86, i64 %number.87, ptr %number.88, i64 %number.89, i64 %number.90, ptr %number.91, ptr %number.92, i64 %number.93, i64 %number.94, ptr %number.95, i64 %number.96, i64 %number.97, i64 %number.98, i64 %number.99, i64 %number.100, i64 %number.101, ptr %number.102, ptr %number.103, i64 %number.104, i64 %number.105, ptr %number.106, i64 %number.107, i64 %number.108, ptr %number.109, ptr %number.110, i64 %number.111, i64 %number.112, ptr %number.113, i64 %number.114, i64 %number.115, ptr %number.116, ptr %number.117, i64 %number.118, i64 %number.119, ptr %number.120, i64 %number.121, i64 %number.122, i64 %number.123, i64 %number.124, ptr %number.125, ptr %number.126, i64 %number.127, i64 %number.128, ptr %number.129, i64 %number.130, i64 %number.131, i64 %number.132, i64 %number.133, ptr %number.134, ptr %number.135, i64 %number.136, i64 %number.137, ptr %number.138, i64 %number.139, i64 %number.140, i64 %number.141, i64 %number.142, ptr %number.143, ptr %number.144, i64 %number.145, i64 %number.146, ptr %number.147, i64 %number.148, i64 %number.149, ptr %number.150, ptr %number.151, i64 %number.152, i64 %number.153, ptr %number.154, i64 %number.155, i64 %number.156, ptr %number.157, ptr %number.158, i64 %number.159, i64 %number.160, ptr %number.161, i64 %number.162, i64 %number.163, ptr %number.164, ptr %number.165, i64 %number.166, i64 %number.167, ptr %number.168, i64 %number.169, i64 %number.170, ptr %number.171, ptr %number.172, i64 %number.173, i64 %number.174, ptr %number.175, i64 %number.176, i64 %number.177, ptr %number.178, ptr %number.179, i64 %number.180, i64 %number.181, ptr %number.182, i64 %number.183, i64 %number.184, ptr %number.185, ptr %number.186, i64 %number.187, i64 %number.188, ptr %number.189, i64 %number.190, i64 %number.191, ptr %number.192, ptr %number.193, i64 %number.194, i64 %number.195, ptr %number.196, i64 %number.197, i64 %number.198, ptr %number.199, ptr %number.200, i64 %number.201, i64 %number.202, ptr %number.203, i64 %number.204, i64 %number.205, i64 %number.206, i64 %number.207, i64 %number.208, ptr %number.209, ptr %number.210, i64 %number.211, i64 %number.212, ptr %number.213, i64 %number.214, i64 %number.215, ptr %number.216, ptr %number.217, i64 %number.218, i64 %number.219, ptr %number.220, i64 %number.221, i64 %number.222, ptr %number.223, ptr %number.224, i64 %number.225, i64 %number.226, ptr %number.227, i64 %number.228, i64 %number.229, ptr %number.230, ptr %number.231, i64 %number.232, i64 %number.233, ptr %number.234, i64 %number.235, i64 %number.236, ptr %number.237, ptr %number.238, i64 %number.239, i64 %number.240, ptr %number.241, i64 %number.242, i64 %number.243, ptr %number.244, ptr %number.245, i64 %number.246, i64 %number.247, ptr %number.248, i64 %number.249, i64 %number.250, i64 %number.251, i64 %number.252)
  %value = load i64, ptr %result
  ret i64 %value
}

define i64 @evaluate(ptr %numbers) {
  %result = alloca i64
  %error = alloca ptr
  %at.0 = getelementptr i64, ptr %numbers, i64 0
  %number.0 = load ptr, ptr %at.0
  %at.1 = getelementptr i64, ptr %numbers, i64 1
  %number.1 = load ptr, ptr %at.1
  %at.2 = getelementptr i64, ptr %numbers, i64 2
  %number.2 = load i64, ptr %at.2
  %at.3 = getelementptr i64, ptr %numbers, i64 3
  %number.3 = load i64, ptr %at.3
  %at.4 = getelementptr i64, ptr %numbers, i64 4
  %number.4 = load ptr, ptr %at.4
  %at.5 = getelementptr i64, ptr %numbers, i64 5
  %number.5 = load i64, ptr %at.5
  %at.6 = getelementptr i64, ptr %numbers, i64 6
  %number.6 = load i64, ptr %at.6
  %at.7 = getelementptr i64, ptr %numbers, i64 7
  %number.7 = load i64, ptr %at.7
  %at.8 = getelementptr i64, ptr %numbers, i64 8
  %number.8 = load i64, ptr %at.8
  %at.9 = getelementptr i64, ptr %numbers, i64 9
  %number.9 = load i64, ptr %at.9
  %at.10 = getelementptr i64, ptr %numbers, i64 10
  %number.10 = load i64, ptr %at.10
  %at.11 = getelementptr i64, ptr %numbers, i64 11
  %number.11 = load ptr, ptr %at.11
  %at.12 = getelementptr i64, ptr %numbers, i64 12
  %number.12 = load ptr, ptr %at.12
  %at.13 = getelementptr i64, ptr %numbers, i64 13
  %number.13 = load i64, ptr %at.13
  %at.14 = getelementptr i64, ptr %numbers, i64 14
  %number.14 = load i64, ptr %at.14
  %at.15 = getelementptr i64, ptr %numbers, i64 15
  %number.15 = load ptr, ptr %at.15
  %at.16 = getelementptr i64, ptr %numbers, i64 16
  %number.16 = load i64, ptr %at.16
  %at.17 = getelementptr i64, ptr %numbers, i64 17
  %number.17 = load i64, ptr %at.17
  %at.18 = getelementptr i64, ptr %numbers, i64 18
  %number.18 = load ptr, ptr %at.18
  %at.19 = getelementptr i64, ptr %numbers, i64 19
  %number.19 = load ptr, ptr %at.19
  %at.20 = getelementptr i64, ptr %numbers, i64 20
  %number.20 = load i64, ptr %at.20
  %at.21 = getelementptr i64, ptr %numbers, i64 21
  %number.21 = load i64, ptr %at.21
  %at.22 = getelementptr i64, ptr %numbers, i64 22
  %number.22 = load ptr, ptr %at.22
  %at.23 = getelementptr i64, ptr %numbers, i64 23
  %number.23 = load i64, ptr %at.23
  %at.24 = getelementptr i64, ptr %numbers, i64 24
  %number.24 = load i64, ptr %at.24
  %at.25 = getelementptr i64, ptr %numbers, i64 25
  %number.25 = load ptr, ptr %at.25
  %at.26 = getelementptr i64, ptr %numbers, i64 26
  %number.26 = load ptr, ptr %at.26
  %at.27 = getelementptr i64, ptr %numbers, i64 27
  %number.27 = load i64, ptr %at.27
  %at.28 = getelementptr i64, ptr %numbers, i64 28
  %number.28 = load i64, ptr %at.28
  %at.29 = getelementptr i64, ptr %numbers, i64 29
  %number.29 = load ptr, ptr %at.29
  %at.30 = getelementptr i64, ptr %numbers, i64 30
  %number.30 = load i64, ptr %at.30
  %at.31 = getelementptr i64, ptr %numbers, i64 31
  %number.31 = load i64, ptr %at.31
  %at.32 = getelementptr i64, ptr %numbers, i64 32
  %number.32 = load ptr, ptr %at.32
  %at.33 = getelementptr i64, ptr %numbers, i64 33
  %number.33 = load ptr, ptr %at.33
  %at.34 = getelementptr i64, ptr %numbers, i64 34
  %number.34 = load i64, ptr %at.34
  %at.35 = getelementptr i64, ptr %numbers, i64 35
  %number.35 = load i64, ptr %at.35
  %at.36 = getelementptr i64, ptr %numbers, i64 36
  %number.36 = load ptr, ptr %at.36
  %at.37 = getelementptr i64, ptr %numbers, i64 37
  %number.37 = load i64, ptr %at.37
  %at.38 = getelementptr i64, ptr %numbers, i64 38
  %number.38 = load i64, ptr %at.38
  %at.39 = getelementptr i64, ptr %numbers, i64 39
  %number.39 = load ptr, ptr %at.39
  %at.40 = getelementptr i64, ptr %numbers, i64 40
  %number.40 = load ptr, ptr %at.40
  %at.41 = getelementptr i64, ptr %numbers, i64 41
  %number.41 = load i64, ptr %at.41
  %at.42 = getelementptr i64, ptr %numbers, i64 42
  %number.42 = load i64, ptr %at.42
  %at.43 = getelementptr i64, ptr %numbers, i64 43
  %number.43 = load ptr, ptr %at.43
  %at.44 = getelementptr i64, ptr %numbers, i64 44
  %number.44 = load i64, ptr %at.44
  %at.45 = getelementptr i64, ptr %numbers, i64 45
  %number.45 = load i64, ptr %at.45
  %at.46 = getelementptr i64, ptr %numbers, i64 46
  %number.46 = load ptr, ptr %at.46
  %at.47 = getelementptr i64, ptr %numbers, i64 47
  %number.47 = load ptr, ptr %at.47
  %at.48 = getelementptr i64, ptr %numbers, i64 48
  %number.48 = load i64, ptr %at.48
  %at.49 = getelementptr i64, ptr %numbers, i64 49
  %number.49 = load i64, ptr %at.49
  %at.50 = getelementptr i64, ptr %numbers, i64 50
  %number.50 = load ptr, ptr %at.50
  %at.51 = getelementptr i64, ptr %numbers, i64 51
  %number.51 = load i64, ptr %at.51
  %at.52 = getelementptr i64, ptr %numbers, i64 52
  %number.52 = load i64, ptr %at.52
  %at.53 = getelementptr i64, ptr %numbers, i64 53
  %number.53 = load i64, ptr %at.53
  %at.54 = getelementptr i64, ptr %numbers, i64 54
  %number.54 = load i64, ptr %at.54
  %at.55 = getelementptr i64, ptr %numbers, i64 55
  %number.55 = load ptr, ptr %at.55
  %at.56 = getelementptr i64, ptr %numbers, i64 56
  %number.56 = load ptr, ptr %at.56
  %at.57 = getelementptr i64, ptr %numbers, i64 57
  %number.57 = load i64, ptr %at.57
  %at.58 = getelementptr i64, ptr %numbers, i64 58
  %number.58 = load i64, ptr %at.58
  %at.59 = getelementptr i64, ptr %numbers, i64 59
  %number.59 = load ptr, ptr %at.59
  %at.60 = getelementptr i64, ptr %numbers, i64 60
  %number.60 = load i64, ptr %at.60
  %at.61 = getelementptr i64, ptr %numbers, i64 61
  %number.61 = load i64, ptr %at.61
  %at.62 = getelementptr i64, ptr %numbers, i64 62
  %number.62 = load ptr, ptr %at.62
  %at.63 = getelementptr i64, ptr %numbers, i64 63
  %number.63 = load ptr, ptr %at.63
  %at.64 = getelementptr i64, ptr %numbers, i64 64
  %number.64 = load i64, ptr %at.64
  %at.65 = getelementptr i64, ptr %numbers, i64 65
  %number.65 = load i64, ptr %at.65
  %at.66 = getelementptr i64, ptr %numbers, i64 66
  %number.66 = load ptr, ptr %at.66
  %at.67 = getelementptr i64, ptr %numbers, i64 67
  %number.67 = load i64, ptr %at.67
  %at.68 = getelementptr i64, ptr %numbers, i64 68
  %number.68 = load i64, ptr %at.68
  %at.69 = getelementptr i64, ptr %numbers, i64 69
  %number.69 = load ptr, ptr %at.69
  %at.70 = getelementptr i64, ptr %numbers, i64 70
  %number.70 = load ptr, ptr %at.70
  %at.71 = getelementptr i64, ptr %numbers, i64 71
  %number.71 = load i64, ptr %at.71
  %at.72 = getelementptr i64, ptr %numbers, i64 72
  %number.72 = load i64, ptr %at.72
  %at.73 = getelementptr i64, ptr %numbers, i64 73
  %number.73 = load ptr, ptr %at.73
  %at.74 = getelementptr i64, ptr %numbers, i64 74
  %number.74 = load i64, ptr %at.74
  %at.75 = getelementptr i64, ptr %numbers, i64 75
  %number.75 = load i64, ptr %at.75
  %at.76 = getelementptr i64, ptr %numbers, i64 76
  %number.76 = load ptr, ptr %at.76
  %at.77 = getelementptr i64, ptr %numbers, i64 77
  %number.77 = load ptr, ptr %at.77
  %at.78 = getelementptr i64, ptr %numbers, i64 78
  %number.78 = load i64, ptr %at.78
  %at.79 = getelementptr i64, ptr %numbers, i64 79
  %number.79 = load i64, ptr %at.79
  %at.80 = getelementptr i64, ptr %numbers, i64 80
  %number.80 = load ptr, ptr %at.80
  %at.81 = getelementptr i64, ptr %numbers, i64 81
  %number.81 = load i64, ptr %at.81
  %at.82 = getelementptr i64, ptr %numbers, i64 82
  %number.82 = load i64, ptr %at.82
  %at.83 = getelementptr i64, ptr %numbers, i64 83
  %number.83 = load ptr, ptr %at.83
  %at.84 = getelementptr i64, ptr %numbers, i64 84
  %number.84 = load ptr, ptr %at.84
  %at.85 = getelementptr i64, ptr %numbers, i64 85
  %number.85 = load i64, ptr %at.85
  %at.86 = getelementptr i64, ptr %numbers, i64 86
  %number.86 = load i64, ptr %at.86
  %at.87 = getelementptr i64, ptr %numbers, i64 87
  %number.87 = load ptr, ptr %at.87
  %at.88 = getelementptr i64, ptr %numbers, i64 88
  %number.88 = load i64, ptr %at.88
  %at.89 = getelementptr i64, ptr %numbers, i64 89
  %number.89 = load i64, ptr %at.89
  %at.90 = getelementptr i64, ptr %numbers, i64 90
  %number.90 = load i64, ptr %at.90
  %at.91 = getelementptr i64, ptr %numbers, i64 91
  %number.91 = load i64, ptr %at.91
  %status = call i32 @evaluate_of_many(ptr %result, ptr %error, ptr %number.0, ptr %number.1, i64 %number.2, i64 %number.3, ptr %number.4, i64 %number.5, i64 %number.6, i64 %number.7, i64 %number.8, i64 %number.9, i64 %number.10, ptr %number.11, ptr %number.12, i64 %number.13, i64 %number.14, ptr %number.15, i64 %number.16, i64 %number.17, ptr %number.18, ptr %number.19, i64 %number.20, i64 %number.21, ptr %number.22, i64 %number.23, i64 %number.24, ptr %number.25, ptr %number.26, i64 %number.27, i64 %number.28, ptr %number.29, i64 %number.30, i64 %number.31, ptr %number.32, ptr %number.33, i64 %number.34, i64 %number.35, ptr %number.36, i64 %number.37, i64 %number.38, ptr %number.39, ptr %number.40, i64 %number.41, i64 %number.42, ptr %number.43, i64 %number.44, i64 %number.45, ptr %number.46, ptr %number.47, i64 %number.48, i64 %number.49, ptr %number.50, i64 %number.51, i64 %number.52, i64 %number.53, i64 %number.54, ptr %number.55, ptr %number.56, i64 %number.57, i64 %number.58, ptr %number.59, i64 %number.60, i64 %number.61, ptr %number.62, ptr %number.63, i64 %number.64, i64 %number.65, ptr %number.66, i64 %number.67, i64 %number.68, ptr %number.69, ptr %number.70, i64 %number.71, i64 %number.72, ptr %number.73, i64 %number.74, i64 %number.75, ptr %number.76, ptr %number.77, i64 %number.78, i64 %number.79, ptr %number.80, i64 %number.81, i64 %number.82, ptr %number.83, ptr %number.84, i64 %number.85, i64 %number.86, ptr %number.87, i64 %number.88, i64 %number.89, i64 %number.90, i64 %number.91)
  %value = load i64, ptr %result
  ret i64 %value
}
