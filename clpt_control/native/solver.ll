; sha256 3e9f7b28bb737fb05dd653c6c80dd1eb1b1432e53e94ab5f8bd20d0f51a831a3

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
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17.107 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18.108 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17.107, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18.108, ptr null, i32 0 }
@switch.table.advance_of_many.3 = private unnamed_addr constant [9 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table.advance_of_many.8 = private unnamed_addr constant [17 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8
@switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.21 = private unnamed_addr constant [8 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, i64 %arg.linear.3.0, i64 %arg.linear.3.1, i64 %arg.linear.3.2, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.4014 = alloca i8, align 1
  store i8 0, ptr %.4014, align 1
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.4591 = alloca i8, align 1
  store i8 0, ptr %.4591, align 1
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.463 = mul i64 %arg.shape.1, %arg.shape.0
  %.571.idx = shl i64 %arg.batch.4.0.5.1, 6
  %.571 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.571.idx
  %.610 = icmp eq i64 %arg.shape.2, 9
  %.612 = icmp slt i64 %arg.shape.2, 5
  %.614 = icmp eq i64 %arg.shape.2, 12
  %.625 = icmp eq i64 %arg.shape.2, 7
  %. = select i1 %.625, i64 7, i64 1
  %.655 = mul nsw i64 %.463, 17
  %.685 = load i64, ptr %arg.code.4, align 8
  %.720 = getelementptr i8, ptr %arg.code.4, i64 56
  %.721 = load i64, ptr %.720, align 8
  %.722.not = icmp eq i64 %.721, 0
  %"$phi514.0.2.0" = select i1 %.722.not, i64 %.685, i64 %.721
  %.809 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.809, i64 0, i64 %arg.shape.0
  br i1 %.809, label %B710, label %B550.if.lr.ph

B550.if.lr.ph:                                    ; preds = %entry
  %.idx.i = mul i64 %arg.batch.4.0.5.1, 24
  %0 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i
  %.319.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %.414.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %1 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1123.i = shl i64 %arg.batch.4.1.5.1, 4
  %2 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1123.i
  %.idx1124.i = mul i64 %arg.batch.4.1.5.1, 24
  %3 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i
  %.7851131.not.i = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.10931137.not.i = icmp slt i64 %arg.shape.1, 1
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
  br label %B550.if

B602:                                             ; preds = %B550.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.289.i8870 = getelementptr double, ptr %0, i64 %.795.09243
  store double 0.000000e+00, ptr %.289.i8870, align 8, !noalias !0
  %.320.i = load i64, ptr %.319.i, align 8, !noalias !0
  %.322.i = icmp eq i64 %.236.i, %.320.i
  br i1 %.322.i, label %B646, label %B142.i

B142.i:                                           ; preds = %B602
  %.355.i = add nsw i64 %.236.i, 1
  store i64 %.355.i, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.414.i, align 8, !noalias !0
  %.434.i = icmp slt i64 %.236.i, 0
  %.435.i = select i1 %.434.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.449.i8871 = getelementptr i64, ptr %8, i64 %.435.i
  %.450.i8872 = load i64, ptr %.449.i8871, align 8, !noalias !0
  %.465.i = icmp slt i64 %.450.i8872, 0
  %.466.i = select i1 %.465.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.450.i8872
  %.480.i8873 = getelementptr i64, ptr %9, i64 %.466.i
  %.481.i = load i64, ptr %.480.i8873, align 8, !noalias !0
  %.532.i8874 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.795.09243
  store i64 %.236.i, ptr %.532.i8874, align 8, !noalias !0
  %.583.i = getelementptr i64, ptr %1, i64 %.795.09243
  store i64 %.481.i, ptr %.583.i, align 8, !noalias !0
  %.638.i = getelementptr i64, ptr %2, i64 %.795.09243
  store i64 1, ptr %.638.i, align 8, !noalias !0
  %.689.i = getelementptr i64, ptr %3, i64 %.795.09243
  store i64 0, ptr %.689.i, align 8, !noalias !0
  br i1 %.7851131.not.i, label %B462.i, label %B418.if.lr.ph.i

B418.if.lr.ph.i:                                  ; preds = %B142.i
  %.847.i = select i1 %.434.i, i64 %arg.batch.0.1.5.0, i64 0
  %.848.i = add i64 %.847.i, %.236.i
  %.868.i = mul i64 %.848.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.868.i
  %invariant.gep9546 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.795.09243
  br label %B418.if.i

B462.i:                                           ; preds = %B418.if.i, %B142.i
  br i1 %.175.i1134.not.i, label %B462.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B462.i
  %.966.i = load i64, ptr %.583.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.966.i, 0
  %.237.i.i = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i, %.966.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i8875

B76.if.i.i8875:                                   ; preds = %B76.if.i.i8875, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i8875 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i, %.795.09243
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i8876 = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i8876
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B462.endif.i, label %B76.if.i.i8875

B1038.i:                                          ; preds = %B660.if.i
  store double 0.000000e+00, ptr %.1825.i, align 8, !noalias !0
  br label %B646

B418.if.i:                                        ; preds = %B418.if.i, %B418.if.lr.ph.i
  %.727.01132.i = phi i64 [ 0, %B418.if.lr.ph.i ], [ %.798.i, %B418.if.i ]
  %.798.i = add nsw i64 %.727.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.727.01132.i
  %.873.i = load double, ptr %15, align 8, !noalias !0
  %.875.i = mul nsw i64 %.727.01132.i, %arg.shape.0
  %gep9547 = getelementptr double, ptr %invariant.gep9546, i64 %.875.i
  store double %.873.i, ptr %gep9547, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.798.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B462.i, label %B418.if.i

B462.endif.i:                                     ; preds = %B76.if.i.i8875, %B462.i
  br i1 %.10931137.not.i, label %B660.if.i, label %B566.if.lr.ph.i

B566.if.lr.ph.i:                                  ; preds = %B462.endif.i
  %.1155.i = select i1 %.434.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1156.i = add i64 %.1155.i, %.236.i
  %.1176.i = mul i64 %.1156.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1176.i
  %invariant.gep9548 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.795.09243
  br label %B566.if.i

B566.if.i:                                        ; preds = %B566.if.i, %B566.if.lr.ph.i
  %.1037.01138.i = phi i64 [ 0, %B566.if.lr.ph.i ], [ %.1106.i, %B566.if.i ]
  %.1106.i = add nsw i64 %.1037.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1037.01138.i
  %.1181.i = load double, ptr %17, align 8, !noalias !0
  %.1183.i8877 = mul nsw i64 %.1037.01138.i, %arg.shape.0
  %gep9549 = getelementptr double, ptr %invariant.gep9548, i64 %.1183.i8877
  store double %.1181.i, ptr %gep9549, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1106.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B660.if.i, label %B566.if.i

B660.if.i:                                        ; preds = %B566.if.i, %B462.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.795.09243
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
  %gep.8.i = getelementptr i8, ptr %invariant.gep.i, i64 %.571.idx
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
  %.1431.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1488.i = load i64, ptr %.583.i, align 8, !noalias !0
  %.1503.i = icmp slt i64 %.1488.i, 0
  %.1504.i = select i1 %.1503.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1488.i
  %.1518.i = getelementptr double, ptr %18, i64 %.1504.i
  %.1519.i = load double, ptr %.1518.i, align 8, !noalias !0
  store double %.1431.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1620.i = getelementptr double, ptr %4, i64 %.795.09243
  store double %.1519.i, ptr %.1620.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.289.i8870, align 8, !noalias !0
  %.1723.i = getelementptr double, ptr %5, i64 %.795.09243
  store double 0xFFF0000000000000, ptr %.1723.i, align 8, !noalias !0
  %.1774.i = getelementptr double, ptr %6, i64 %.795.09243
  store double 0x7FF0000000000000, ptr %.1774.i, align 8, !noalias !0
  %.1825.i = getelementptr double, ptr %7, i64 %.795.09243
  %.1826.i = load double, ptr %.1825.i, align 8, !noalias !0
  %.1828.i = fcmp ueq double %.1826.i, 0xFFF0000000000000
  br i1 %.1828.i, label %B646, label %B1038.i

B646:                                             ; preds = %B1038.i, %B602, %B660.if.i, %B550.if
  %.1078 = load i64, ptr %375, align 8
  %.1079 = icmp sgt i64 %.1078, -1
  %.8849 = zext i1 %.1079 to i64
  %.1096 = add nsw i64 %active.4.09245, %.8849
  %.853 = icmp sgt i64 %.798.09244, 1
  br i1 %.853, label %B550.if, label %B710

B710:                                             ; preds = %B646, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.1096, %B646 ]
  %.1113.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1129 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1113.not, i1 %.1129, i1 false
  br i1 %or.cond, label %B738.preheader, label %B5292

B738.preheader:                                   ; preds = %B710
  %.1173 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.6, 3
  %factor.op.mul9422 = mul i64 %arg.shape.1, 14
  %factor.op.mul9423 = mul i64 %arg.shape.1, 15
  %factor.op.mul9424 = mul i64 %arg.shape.6, 27
  %.1269 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1321 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8848 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8848
  %.533.i9246 = icmp slt i64 %arg.shape.6, 1
  %.687.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1382.not = icmp eq i64 %arg.shape.3, 0
  %.1412 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1510.idx = shl i64 %.463, 4
  %.1510 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1510.idx
  %.1511 = inttoptr i64 %.685 to ptr
  %.1541 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1617 = getelementptr i8, ptr %arg.code.4, i64 88
  %.1688 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.655
  %.1713.idx = mul i64 %.463, 24
  %.1713 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1713.idx
  %.1744 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8840 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8840
  %.idx8841 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8841
  %.idx8842 = mul i64 %arg.batch.4.0.5.1, 264
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8842
  %.8850 = select i1 %.612, i64 0, i64 2
  %.754.i349 = icmp ne i64 %arg.shape.2, 1
  %"$phi466.4.2.i.2" = zext i1 %.754.i349 to i64
  %.idx8843 = mul i64 %arg.batch.4.0.5.1, 96
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8843
  %.idx8844 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8844
  %.idx8845 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8845
  %.idx8846 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8846
  %.idx8847 = mul i64 %arg.batch.4.0.5.1, 184
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8847
  %.1882 = getelementptr i8, ptr %arg.code.4, i64 64
  %.1978 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.463
  %.1979 = inttoptr i64 %.685 to ptr
  %.266.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %.266.i8878 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.266.idx.i
  %.317.i2117.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2159.i = mul i64 %arg.shape.1, 136
  %.idx2160.i = mul i64 %arg.shape.1, 88
  %.547.i2141.i = icmp sgt i64 %arg.linear.6.5.0, 1
  %.493.i.12144.i = add nsw i64 %arg.linear.6.5.0, -2
  %.589.i.i = icmp sgt i64 %arg.linear.3.2, 0
  %28 = tail call i64 @llvm.smax.i64(i64 %arg.shape.1, i64 -1)
  %storemerge2107.i = add nsw i64 %28, 1
  %.682.i2120.i = icmp sgt i64 %arg.shape.1, -1
  %.842.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.915.i.i = mul nsw i64 %arg.shape.1, 12
  %.933.i.idx.i = mul i64 %arg.shape.1, 136
  %.933.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.933.i.idx.i
  %.958.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.915.i.i
  %.150.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.510.i.i.i = icmp slt i64 %arg.shape.1, 0
  %.511.i.i.i = select i1 %.510.i.i.i, i64 %arg.linear.5.5.0, i64 0
  %29 = getelementptr i64, ptr %arg.linear.5.4, i64 %arg.shape.1
  %.525.i.i.i = getelementptr i64, ptr %29, i64 %.511.i.i.i
  %.586.i.i.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %.586.i.i.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.586.i.i.idx.i
  %.597.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.615.i.i.i = select i1 %.510.i.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %.idx.i8888 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8888
  %.629.i.i.i = getelementptr double, ptr %30, i64 %.615.i.i.i
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
  %.520.i8881 = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 176
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2097 = add i64 %arg.shape.2, -1
  %storemerge8794 = tail call i64 @llvm.smax.i64(i64 %.2097, i64 0)
  %.21409259.not = icmp slt i64 %.2097, 1
  %.2284 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.655
  %.2310 = inttoptr i64 %"$phi514.0.2.0" to ptr
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond9227.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i8891 = mul i64 %arg.shape.1, 80
  %invariant.gep9255 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8891
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep9257 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2404 = getelementptr i8, ptr %arg.code.4, i64 72
  %.2481 = icmp sgt i64 %arg.shape.3, 0
  %.2486 = icmp sgt i64 %arg.shape.6, 0
  %.idx8838 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8838
  %.idx8839 = mul i64 %arg.batch.4.0.5.1, 200
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8839
  %.idx8835 = mul i64 %arg.batch.4.0.5.1, 208
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8835
  %.idx8836 = mul i64 %arg.batch.4.0.5.1, 216
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8836
  %.idx8837 = mul i64 %arg.batch.4.0.5.1, 192
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8837
  %.idx8829 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8829
  %.idx8830 = mul i64 %arg.batch.4.0.5.1, 224
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8830
  %.idx8831 = mul i64 %arg.batch.4.0.5.1, 80
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8831
  %.idx8832 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8832
  %.idx8833 = mul i64 %arg.batch.4.0.5.1, 248
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8833
  %.idx8834 = mul i64 %arg.batch.4.0.5.1, 56
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8834
  %44 = or i1 %.612, %.625
  %.3799 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.655
  %.3824.idx = mul i64 %.463, 104
  %.3824 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3824.idx
  %.3825 = inttoptr i64 %.685 to ptr
  %.3864 = getelementptr i8, ptr %arg.code.4, i64 128
  %.3958 = getelementptr i8, ptr %arg.code.4, i64 120
  %.4469.c = getelementptr i8, ptr %arg.code.4, i64 112
  %.4329 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.655
  %.4355 = inttoptr i64 %.685 to ptr
  %.4392 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4469 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx8822 = shl i64 %arg.batch.4.1.5.1, 4
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8822
  %.idx8823 = mul i64 %arg.batch.4.0.5.1, 40
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8823
  %.idx8824 = mul i64 %arg.batch.4.0.5.1, 56
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8824
  %.idx8825 = mul i64 %arg.batch.4.0.5.1, 232
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8825
  %.idx8826 = mul i64 %arg.batch.4.0.5.1, 48
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8826
  %.idx8827 = shl i64 %arg.batch.4.0.5.1, 5
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8827
  %51 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8828 = mul i64 %arg.batch.4.0.5.1, 240
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8828
  %53 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.230.i = getelementptr i8, ptr %53, i64 -8
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx7998.i = mul i64 %arg.batch.4.0.5.1, 152
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7998.i
  %.idx7995.i = mul i64 %arg.batch.4.0.5.1, 48
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7995.i
  %.287.i2218170.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i355.i = shl i64 %arg.shape.1, 4
  %.idx7988.i = shl i64 %arg.batch.4.1.5.1, 5
  %56 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx7988.i
  %.idx7989.i = mul i64 %arg.batch.4.0.5.1, 152
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7989.i
  %.idx7990.i = mul i64 %arg.batch.4.0.5.1, 112
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7990.i
  %.idx7991.i = mul i64 %arg.batch.4.0.5.1, 120
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7991.i
  %storemerge7992.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.194.i.i739.i = mul i64 %arg.shape.6, %arg.shape.0
  %.idx7994.i = mul i64 %arg.batch.4.0.5.1, 160
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7994.i
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %factor.op.mul8196.i.reass = mul i64 %factor.op.mul9422, %arg.shape.0
  %.872.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul8196.i.reass
  %.878.i.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.114.i40.i8180.not.i = icmp slt i64 %.194.i.i739.i, 1
  %.937.i.i = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul8197.i.reass = mul i64 %factor.op.mul9423, %arg.shape.0
  %.1196.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul8197.i.reass
  %.1886.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.155.i.i392.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i392.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i392.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i392.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i392.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i392.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i392.6.i = mul nsw i64 %arg.shape.1, 18
  %.190.i9488214.i = icmp sgt i64 %arg.shape.0, 0
  %.203.i16108215.i = zext i1 %.190.i9488214.i to i64
  %.199.i16078216.i = sext i1 %.190.i9488214.i to i64
  %.134.i.18217.i = add nsw i64 %storemerge.i, %.199.i16078216.i
  %.428.i10648201.not.i = icmp slt i64 %arg.shape.6, 1
  %.578.i.i = mul nsw i64 %arg.shape.6, 30
  %.idx7889.i = mul i64 %arg.batch.4.0.5.1, 136
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7889.i
  %.idx7890.i = mul i64 %arg.batch.4.0.5.1, 144
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7890.i
  %.646.i1935.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.737.i.idx.i = shl i64 %.463, 7
  %.737.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.737.i.idx.i
  %.762.i.idx.i = mul i64 %.194.i.i739.i, 216
  %.762.i.i = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.762.i.idx.i
  %.155.i571.i.i = mul nsw i64 %arg.shape.6, 28
  %factor.op.mul8291.i.reass = mul i64 %factor.op.mul9424, %arg.shape.0
  %.1445.reass.i = mul i64 %.358.i355.i, %arg.shape.0
  %.1465.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1445.reass.i
  %.1490.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %factor.op.mul8291.i.reass
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
  %.134.i7217.18315.i = add nsw i64 %storemerge.i, -1
  %.155.i.i.i4987.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i4987.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i4987.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i4987.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i4987.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i4987.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i4987.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx7924.i = mul i64 %arg.batch.4.0.5.1, 56
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7924.i
  %.183.1450.i.i = add nsw i64 %arg.shape.6, -1
  %.454.i.i.i = shl i64 %factor.op.mul.i.reass, 1
  %.320.i.i8915 = shl nsw i64 %arg.shape.6, 1
  %.456.i.2.i.i = shl i64 %factor.op.mul.i.reass, 2
  %.456.i.3.i.i = mul i64 %factor.op.mul.i.reass, 6
  %.456.i.4.i.i = shl i64 %factor.op.mul.i.reass, 3
  %.190.i.1.i.i = mul nsw i64 %factor.op.mul.i.reass, 3
  %.190.i.2.i.i = mul nsw i64 %factor.op.mul.i.reass, 5
  %.190.i.3.i.i = mul nsw i64 %factor.op.mul.i.reass, 7
  %.155.i9387.i = mul nsw i64 %arg.shape.6, 25
  %.idx7932.i = mul i64 %arg.batch.4.0.5.1, 104
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7932.i
  %.idx7933.i = mul i64 %arg.batch.4.0.5.1, 40
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7933.i
  %.idx7934.i = shl i64 %arg.batch.4.0.5.1, 5
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7934.i
  %67 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4767.not = icmp eq i64 %arg.shape.3, 0
  %.idx628.i = shl i64 %arg.shape.0, 4
  %invariant.gep9364 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx628.i
  %.idx629.i = mul i64 %arg.shape.0, 40
  %invariant.gep9366 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx629.i
  %.idx630.i = shl i64 %arg.shape.0, 6
  %invariant.gep9368 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx630.i
  %.idx631.i = mul i64 %arg.shape.0, 88
  %invariant.gep9370 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx631.i
  %.idx632.i = mul i64 %arg.shape.0, 112
  %invariant.gep9372 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx632.i
  %.idx633.i = mul i64 %arg.shape.0, 136
  %invariant.gep9374 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx633.i
  %.idx634.i = mul i64 %arg.shape.0, 160
  %invariant.gep9376 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx634.i
  %.idx635.i = mul i64 %arg.shape.0, 184
  %invariant.gep9378 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx635.i
  %.idx636.i = mul i64 %arg.shape.0, 208
  %invariant.gep9380 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx636.i
  %68 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.226.i.i = getelementptr i8, ptr %68, i64 -8
  %.296.i.i = icmp sgt i64 %arg.shape.2, 4
  %..i.i = select i1 %.296.i.i, i64 0, i64 8
  %.354.i.i8946 = sub nsw i64 9, %..i.i
  %.5201298.not.i.i = icmp slt i64 %arg.shape.0, 1
  %.idx1284.i.i = mul i64 %arg.batch.4.0.5.1, 48
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1284.i.i
  %.287.i1295.not.i.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i8947 = shl nsw i64 %arg.shape.1, 4
  %.707.i.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.155.i.i.i.i8948 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i.i = mul nsw i64 %arg.shape.1, 18
  %.881.11306.i.i = add nsw i64 %arg.shape.0, -1
  %.idx.i.i = mul i64 %arg.batch.4.0.5.1, 56
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i.i
  %.idx1274.i.i = shl i64 %arg.batch.4.1.5.1, 5
  %71 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1274.i.i
  %.idx1276.i.i = mul i64 %arg.batch.4.0.5.1, 40
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1276.i.i
  %.1288.i.i8965 = select i1 %.296.i.i, i64 0, i64 7
  %.idx1277.i.i = mul i64 %arg.batch.4.0.5.1, 112
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1277.i.i
  %.idx1278.i.i = mul i64 %arg.batch.4.0.5.1, 120
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1278.i.i
  %.43.i.i.i = mul nsw i64 %arg.shape.0, 3
  %.454.i.i.i.i = mul i64 %arg.shape.0, 6
  %.456.i.2.i.i.i = mul i64 %arg.shape.0, 12
  %.456.i.3.i.i.i = mul i64 %arg.shape.0, 18
  %.456.i.4.i.i.i = mul i64 %arg.shape.0, 24
  %.190.i.1.i.i.i = mul nsw i64 %arg.shape.0, 9
  %.190.i.2.i.i.i = mul nsw i64 %arg.shape.0, 15
  %.190.i.3.i.i.i = mul nsw i64 %arg.shape.0, 21
  %.323.i.i.i = shl nsw i64 %arg.shape.0, 1
  %.idx1281.i.i = shl i64 %arg.batch.4.0.5.1, 5
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1281.i.i
  %76 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx.i8954 = shl i64 %arg.batch.4.1.5.1, 5
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8954
  %.idx600.i = mul i64 %arg.batch.4.0.5.1, 40
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx600.i
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i9028 = shl i64 %arg.batch.4.1.5.1, 4
  %79 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i9028
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %82 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.892649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 240
  %83 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.968.i = mul nsw i64 %arg.shape.1, 17
  %84 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.4977 = icmp sgt i64 %arg.shape.0, 1
  %.5031.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5031 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5031.idx
  %.5063 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx8815 = mul i64 %arg.batch.4.0.5.1, 104
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8815
  %.idx8816 = mul i64 %arg.batch.4.0.5.1, 40
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8816
  %.idx8817 = shl i64 %arg.batch.4.0.5.1, 7
  %87 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8817
  %.536.i35739400.not = icmp slt i64 %arg.shape.1, 1
  %.657.i4069 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %88 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.795.i3612 = getelementptr i8, ptr %88, i64 -8
  %.idx8819 = mul i64 %arg.batch.4.1.5.1, 24
  %89 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8819
  %.idx8820 = mul i64 %arg.batch.4.1.5.1, 24
  %90 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8820
  %.idx8821 = mul i64 %arg.batch.4.0.5.1, 24
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8821
  %.5179.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i9037 = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %94 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i1635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.632.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.775.i9041 = getelementptr i8, ptr %arg.code.4, i64 32
  %.846.i = mul nsw i64 %arg.shape.1, 17
  %.848.i9042 = mul nsw i64 %.846.i, %arg.shape.0
  %.891.i9043 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.848.i9042
  %.896.not.i = icmp eq i64 %arg.shape.3, 0
  %.926.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %95 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15291642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1724.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx8804 = mul i64 %arg.batch.4.0.5.1, 40
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8804
  %.idx8805 = shl i64 %arg.batch.4.0.5.1, 4
  %97 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8805
  %98 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8806 = mul i64 %arg.batch.4.0.5.1, 24
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8806
  %.175.i.i47979412.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8809 = shl i64 %arg.batch.4.1.5.1, 4
  %100 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8809
  %.idx.i9067 = mul i64 %arg.batch.4.0.5.1, 24
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i9067
  %.319.i9069 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %102 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i9089 = mul i64 %arg.batch.4.1.5.1, 24
  %103 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i9089
  %.7851131.not.i9091 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i9107 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.10931137.not.i9126 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i9144 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i9148 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i9152 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i9154 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i9158 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i9160 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i9162 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9164 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9166 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9168 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9170 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9172 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9174 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9176 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9178 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9180 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9182 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9184 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9186 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9188 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9190 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9192 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9194 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i9196 = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i9198 = mul i64 %arg.batch.4.0.5.1, 232
  %gep.30.idx.i9200 = mul i64 %arg.batch.4.0.5.1, 240
  %104 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i9144
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i9172
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.30.idx.i9200
  %.idx1130.i9215 = mul i64 %arg.batch.4.0.5.1, 248
  %107 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9215
  %.idx8808 = mul i64 %arg.batch.4.0.5.1, 248
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8808
  %.6211 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %109 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %110 = getelementptr i8, ptr %109, i64 -8
  %.6225 = getelementptr double, ptr %110, i64 %.6211
  %111 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8810 = mul i64 %arg.batch.4.0.5.1, 248
  %112 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8810
  %.idx8811 = mul i64 %arg.batch.4.0.5.1, 192
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8811
  %.idx8812 = shl i64 %arg.batch.4.1.5.1, 4
  %114 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8812
  %.idx8813 = shl i64 %arg.batch.4.0.5.1, 4
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8813
  %.idx8814 = mul i64 %arg.batch.4.0.5.1, 184
  %116 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8814
  %117 = shl i64 %arg.shape.0, 3
  %118 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4354.idx = mul i64 %.463, 112
  %.4354 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4354.idx
  %119 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4354.1.idx = mul i64 %.463, 120
  %.4354.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4354.1.idx
  %120 = getelementptr i8, ptr %arg.code.4, i64 248
  %.4354.2.idx = shl i64 %.463, 7
  %.4354.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4354.2.idx
  br label %B738

B738:                                             ; preds = %B738.preheader, %B5266
  %excinfo.12.0 = phi ptr [ %excinfo.12.1, %B5266 ], [ null, %B738.preheader ]
  %excinfo.13.0 = phi ptr [ %excinfo.13.1, %B5266 ], [ null, %B738.preheader ]
  %budget.3.1 = phi i64 [ %budget.4.2, %B5266 ], [ %arg.budget, %B738.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B5266 ], [ %active.4.0.lcssa, %B738.preheader ]
  %.1139 = add nsw i64 %budget.3.1, -1
  %.1174 = load i64, ptr %.1173, align 8
  %.1175 = icmp eq i64 %.1174, 1
  %.1209 = icmp sgt i64 %.1174, 0
  br i1 %.1209, label %B816, label %B904

B816:                                             ; preds = %B738
  store i64 0, ptr %.1173, align 8
  %.1270 = load i64, ptr %.1269, align 8
  %.1315 = inttoptr i64 %.1270 to ptr
  tail call void %.1315(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B904

B904:                                             ; preds = %B816, %B738
  br i1 %.1175, label %B910, label %B1476

B910:                                             ; preds = %B904
  br i1 %.1321, label %B922, label %B958

B922:                                             ; preds = %B910
  %.163.i = load i64, ptr %.162.i, align 8, !noalias !7
  %.275.i = inttoptr i64 %.163.i to ptr
  tail call void %.275.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.809, label %B356.i, label %B214.if.i

B354.i:                                           ; preds = %B296.if.i, %B214.if.i
  %.359.i = icmp sgt i64 %.304.i.09251, 1
  br i1 %.359.i, label %B214.if.i, label %B356.i

B356.i:                                           ; preds = %B354.i, %B922
  %.688.i = load i64, ptr %.687.i, align 8, !noalias !7
  %.804.i = inttoptr i64 %.688.i to ptr
  tail call void %.804.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B958

B214.if.i:                                        ; preds = %B922, %B354.i
  %.304.i.09251 = phi i64 [ %.368.i, %B354.i ], [ %storemerge, %B922 ]
  %.301.i.09250 = phi i64 [ %.372.i, %B354.i ], [ 0, %B922 ]
  %.368.i = add nsw i64 %.304.i.09251, -1
  %.372.i = add nsw i64 %.301.i.09250, 1
  %121 = getelementptr double, ptr %19, i64 %.301.i.09250
  %.450.i = load double, ptr %121, align 8, !noalias !7
  %.451.i = fcmp ule double %.450.i, 5.000000e-01
  %brmerge9428 = select i1 %.451.i, i1 true, i1 %.533.i9246
  br i1 %brmerge9428, label %B354.i, label %B296.if.i.preheader

B296.if.i.preheader:                              ; preds = %B214.if.i
  %invariant.gep9550 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.09250
  br label %B296.if.i

B296.if.i:                                        ; preds = %B296.if.i.preheader, %B296.if.i
  %.477.i.09247 = phi i64 [ %.546.i, %B296.if.i ], [ 0, %B296.if.i.preheader ]
  %.546.i = add nsw i64 %.477.i.09247, 1
  %.572.i = mul nsw i64 %.477.i.09247, %arg.shape.0
  %gep9551 = getelementptr double, ptr %invariant.gep9550, i64 %.572.i
  %.604.i = load double, ptr %gep9551, align 8, !noalias !7
  %.606.i = add nsw i64 %.477.i.09247, %arg.shape.5
  %.608.i = mul nsw i64 %.606.i, %arg.shape.0
  %.610.i = add nsw i64 %.608.i, %.301.i.09250
  %.624.i = icmp slt i64 %.610.i, 0
  %.625.i = select i1 %.624.i, i64 %arg.batch.5.1.5.0, i64 0
  %122 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.610.i
  %.639.i = getelementptr double, ptr %122, i64 %.625.i
  store double %.604.i, ptr %.639.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.546.i, %arg.shape.6
  br i1 %exitcond.not, label %B354.i, label %B296.if.i

B958:                                             ; preds = %B356.i, %B910
  br i1 %.1382.not, label %B1040, label %B962

B962:                                             ; preds = %B958
  %.1413 = load i64, ptr %.1412, align 8
  %.1458 = inttoptr i64 %.1413 to ptr
  tail call void %.1458(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1040

B1040:                                            ; preds = %B962, %B958
  br i1 %.612, label %B1434, label %B1044

B1044:                                            ; preds = %B1040
  tail call void %.1511(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1510)
  %.1542 = load i64, ptr %.1541, align 8
  %.1587 = inttoptr i64 %.1542 to ptr
  tail call void %.1587(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1618 = load i64, ptr %.1617, align 8
  %.1663 = inttoptr i64 %.1618 to ptr
  tail call void %.1663(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.1511(ptr %.571, ptr %.1688, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1713)
  %.1745 = load i64, ptr %.1744, align 8
  %.1790 = inttoptr i64 %.1745 to ptr
  tail call void %.1790(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1434

B1434:                                            ; preds = %B1044, %B1040
  br i1 %.809, label %B1476, label %B64.if.i

B118.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.310.i130, align 8, !noalias !11
  %.418.i = getelementptr double, ptr %21, i64 %.161.i.09253
  store double 0.000000e+00, ptr %.418.i, align 8, !noalias !11
  %.469.i = getelementptr double, ptr %22, i64 %.161.i.09253
  store double 0.000000e+00, ptr %.469.i, align 8, !noalias !11
  %.520.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09253
  %.521.i = load i64, ptr %.520.i, align 8, !noalias !11
  %.544.i244 = icmp slt i64 %.521.i, 0
  %.545.i245 = select i1 %.544.i244, i64 %arg.batch.3.3.5.0, i64 0
  %.546.i246 = add i64 %.545.i245, %.521.i
  %.566.i = mul i64 %.546.i246, %arg.batch.3.3.5.1
  %123 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.566.i
  %.570.i = getelementptr i8, ptr %123, i64 8
  %.571.i257 = load i64, ptr %.570.i, align 8, !noalias !11
  %.594.i265 = add nsw i64 %.571.i257, %.8850
  store i64 %.594.i265, ptr %.570.i, align 8, !noalias !11
  %.702.i323 = load i64, ptr %.520.i, align 8, !noalias !11
  %.725.i335 = icmp slt i64 %.702.i323, 0
  %.726.i336 = select i1 %.725.i335, i64 %arg.batch.3.3.5.0, i64 0
  %.727.i = add i64 %.726.i336, %.702.i323
  %.747.i = mul i64 %.727.i, %arg.batch.3.3.5.1
  %124 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.747.i
  %.751.i = getelementptr i8, ptr %124, i64 16
  %.752.i = load i64, ptr %.751.i, align 8, !noalias !11
  %.775.i = add nsw i64 %.752.i, %"$phi466.4.2.i.2"
  store i64 %.775.i, ptr %.751.i, align 8, !noalias !11
  %.882.i = getelementptr double, ptr %23, i64 %.161.i.09253
  %.883.i = load double, ptr %.882.i, align 8, !noalias !11
  %.884.i = fcmp une double %.883.i, 0.000000e+00
  br i1 %.884.i, label %B526.i, label %B582.i

B526.i:                                           ; preds = %B118.i
  %125 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09253
  %.84.i.i = load i64, ptr %125, align 8, !noalias !15
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B582.i

B46.i.i:                                          ; preds = %B526.i
  %.120.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !15
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B582.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !15
  br label %B582.i

B582.i:                                           ; preds = %B80.i.i, %B526.i, %B46.i.i, %B118.i
  br i1 %.1382.not, label %B758.i, label %B586.i

B586.i:                                           ; preds = %B582.i
  %126 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.09253
  %.954.i = load double, ptr %126, align 8, !noalias !11
  %.956.i = fcmp olt double %.954.i, -1.000000e-09
  br i1 %.956.i, label %B632.i, label %B758.i

B632.i:                                           ; preds = %B586.i
  %127 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09253
  %.84.i63.i = load i64, ptr %127, align 8, !noalias !18
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i

B46.i71.i:                                        ; preds = %B632.i
  %.120.i91.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !18
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !18
  br label %_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i

_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i: ; preds = %B46.i71.i, %B632.i, %B80.i98.i
  %.1041.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i.09253
  %.1042.i = load double, ptr %.1041.i, align 8, !noalias !11
  %.1092.i = getelementptr double, ptr %24, i64 %.161.i.09253
  store double %.1042.i, ptr %.1092.i, align 8, !noalias !11
  br label %B758.i

B758.i:                                           ; preds = %_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx.exit123.i, %B586.i, %B582.i
  %.107.i182.i = getelementptr i64, ptr %25, i64 %.161.i.09253
  %.108.i183.i = load i64, ptr %.107.i182.i, align 8, !noalias !21
  %.161.i.i = getelementptr double, ptr %26, i64 %.161.i.09253
  %.162.i.i = load double, ptr %.161.i.i, align 8, !noalias !21
  %.212.i.i = getelementptr double, ptr %27, i64 %.161.i.09253
  store double %.162.i.i, ptr %.212.i.i, align 8, !noalias !21
  %.225.i.i = icmp slt i64 %.108.i183.i, %arg.batch.2.5.0
  br i1 %.225.i.i, label %B164.i.i, label %B792.i

B164.i.i:                                         ; preds = %B758.i
  %.241.i.i = icmp slt i64 %.108.i183.i, 0
  %.242.i.i = select i1 %.241.i.i, i64 %arg.batch.2.5.0, i64 0
  %128 = getelementptr double, ptr %arg.batch.2.4, i64 %.108.i183.i
  %.256.i.i = getelementptr double, ptr %128, i64 %.242.i.i
  %.257.i.i = load double, ptr %.256.i.i, align 8, !noalias !21
  %.312.i.i = load double, ptr %.161.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.312.i.i, %.257.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.312.i.i, double %.257.i.i
  store double %.11.i.i.i, ptr %.212.i.i, align 8, !noalias !21
  br label %B792.i

B792.i:                                           ; preds = %B164.i.i, %B758.i, %B64.if.i
  %.220.i = icmp sgt i64 %.164.i70.09254, 1
  br i1 %.220.i, label %B64.if.i, label %B1476

B64.if.i:                                         ; preds = %B1434, %B792.i
  %.164.i70.09254 = phi i64 [ %.229.i370, %B792.i ], [ %storemerge, %B1434 ]
  %.161.i.09253 = phi i64 [ %.233.i373, %B792.i ], [ 0, %B1434 ]
  %.229.i370 = add nsw i64 %.164.i70.09254, -1
  %.233.i373 = add nsw i64 %.161.i.09253, 1
  %.310.i130 = getelementptr double, ptr %20, i64 %.161.i.09253
  %.311.i = load double, ptr %.310.i130, align 8, !noalias !11
  %.312.i131 = fcmp ogt double %.311.i, 5.000000e-01
  br i1 %.312.i131, label %B118.i, label %B792.i

B1476:                                            ; preds = %B792.i, %B1434, %B904
  %.1883 = load i64, ptr %.1882, align 8
  %.1928 = inttoptr i64 %.1883 to ptr
  tail call void %.1928(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.612, label %B1558, label %B1630

B1558:                                            ; preds = %B1476
  tail call void %.1979(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1978)
  br label %B1630

B1630:                                            ; preds = %B1558, %B1476
  br i1 %.610, label %B1634, label %B1674

B1634:                                            ; preds = %B1630
  %.267.i8879 = load double, ptr %.266.i8878, align 8, !noalias !25
  %.268.i8880 = fcmp olt double %.267.i8879, 5.000000e-01
  br i1 %.268.i8880, label %B86.i, label %B126.i

B86.i:                                            ; preds = %B1634
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
  %.843.i.i = load i64, ptr %.842.i.i, align 8, !noalias !28
  %.959.i.i = inttoptr i64 %.843.i.i to ptr
  tail call void %.959.i.i(ptr %arg.batch.4.0.4, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.958.i.i), !noalias !28
  %.975.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.976.i.i = select i1 %.975.i.i, i64 %arg.linear.6.5.0, i64 0
  %129 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.990.i.i = getelementptr i64, ptr %129, i64 %.976.i.i
  %.991.i.i = load i64, ptr %.990.i.i, align 8, !noalias !28
  %.1007.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1008.i.i = select i1 %.1007.i.i, i64 %arg.linear.6.5.0, i64 0
  %130 = getelementptr i8, ptr %129, i64 8
  %.1022.i.i = getelementptr i64, ptr %130, i64 %.1008.i.i
  %.1023.i.i = load i64, ptr %.1022.i.i, align 8, !noalias !28
  %.1060.i.i = sub i64 %.1023.i.i, %.991.i.i
  %.1106.i2123.not.i = icmp slt i64 %.1060.i.i, 1
  br i1 %.1106.i2123.not.i, label %B792.i.i, label %B606.if.i.i

B614.i.i:                                         ; preds = %B606.if.i.i
  %.1173.i.i = icmp slt i64 %.1047.i.02124.i, 0
  %.1174.i.i = select i1 %.1173.i.i, i64 %arg.linear.7.5.0, i64 0
  %131 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1047.i.02124.i
  %.1188.i.i = getelementptr i64, ptr %131, i64 %.1174.i.i
  %.1189.i.i = load i64, ptr %.1188.i.i, align 8, !noalias !28
  %.1190.i.i = add nsw i64 %.1189.i.i, %.915.i.i
  %.1204.i.i = icmp slt i64 %.1190.i.i, 0
  %.1205.i.i = select i1 %.1204.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %132 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1190.i.i
  %.1219.i.i = getelementptr double, ptr %132, i64 %.1205.i.i
  %.1220.i.i = load double, ptr %.1219.i.i, align 8, !noalias !28
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
  %.151.i.i.i = load double, ptr %.150.i.i.i, align 8, !noalias !32
  %.180.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !32
  %.184.i.i.i = fdiv double %.151.i.i.i, %.180.i.i.i
  br i1 %.317.i2117.not.i, label %B272.i.i.i, label %B84.if.i.i.i

B272.i.i.i:                                       ; preds = %B84.if.i.i.i, %B750.i.i
  %.526.i.i.i = load i64, ptr %.525.i.i.i, align 8, !noalias !32
  %.530.i.i.i = icmp eq i64 %.526.i.i.i, %.537.i.sroa.0.02147.i
  br i1 %.530.i.i.i, label %B296.i.i.i, label %B344.i.i.i

B296.i.i.i:                                       ; preds = %B272.i.i.i
  %.587.i.i.i = load double, ptr %.586.i.i.i, align 8, !noalias !32
  %.588.i.i.i = fmul double %.587.i.i.i, 1.000000e-03
  br label %B344.i.i.i

B344.i.i.i:                                       ; preds = %B296.i.i.i, %B272.i.i.i
  %"$phi344.0.2.i.i.0.i" = phi double [ %.588.i.i.i, %B296.i.i.i ], [ 0.000000e+00, %B272.i.i.i ]
  store double %"$phi344.0.2.i.i.0.i", ptr %.629.i.i.i, align 8, !noalias !32
  br i1 %.317.i2117.not.i, label %B574.i.i.1.critedge.i, label %B458.if.i.i.i

B574.i.i.i:                                       ; preds = %B458.if.i.i.i
  %.1034.i.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1068.i.i.i = load double, ptr %.629.i.i.i, align 8, !noalias !32
  %.1070.i.i.i = fmul double %.1068.i.i.i, 5.000000e-01
  %.1073.i.i.i = fadd double %.1034.i.i.i, %.1070.i.i.i
  store double %.1073.i.i.i, ptr %.571, align 8, !noalias !32
  %.1163.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.i = inttoptr i64 %.1163.i.i.i to ptr
  tail call void %.1277.i.i.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.i), !noalias !32
  br label %B458.if.i.i.1.i

B458.if.i.i.1.i:                                  ; preds = %B458.if.i.i.1.i, %B574.i.i.i
  %.783.i.i.02131.1.i = phi i64 [ %.852.i.i.1.i, %B458.if.i.i.1.i ], [ 0, %B574.i.i.i ]
  %.852.i.i.1.i = add nsw i64 %.783.i.i.02131.1.i, 1
  %133 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.1.i
  %.906.i.i.1.i = load double, ptr %133, align 8, !noalias !32
  %134 = getelementptr double, ptr %133, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %134, align 8, !noalias !32
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %135 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %136 = getelementptr double, ptr %133, i64 %.944.i.i.i
  store double %135, ptr %136, align 8, !noalias !32
  %exitcond2155.1.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.1.i
  br i1 %exitcond2155.1.not.i, label %B574.i.i.1.i, label %B458.if.i.i.1.i

B574.i.i.1.critedge.i:                            ; preds = %B344.i.i.i
  %.1034.i.i.c.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1070.i.i.c.i = fmul double %"$phi344.0.2.i.i.0.i", 5.000000e-01
  %.1073.i.i.c.i = fadd double %.1070.i.i.c.i, %.1034.i.i.c.i
  store double %.1073.i.i.c.i, ptr %.571, align 8, !noalias !32
  %.1163.i.i.c.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.c.i = inttoptr i64 %.1163.i.i.c.i to ptr
  tail call void %.1277.i.i.c.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.c.i), !noalias !32
  br label %B574.i.i.1.i

B574.i.i.1.i:                                     ; preds = %B458.if.i.i.1.i, %B574.i.i.1.critedge.i
  %.1034.i.i.1.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1068.i.i.1.i = load double, ptr %.629.i.i.i, align 8, !noalias !32
  %.1070.i.i.1.i = fmul double %.1068.i.i.1.i, 5.000000e-01
  %137 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %137, ptr %.571, align 8, !noalias !32
  %.1163.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.1.i = inttoptr i64 %.1163.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !32
  br i1 %.317.i2117.not.i, label %B792.i.i, label %B904.if.i.i.i

B1130.i.i.i:                                      ; preds = %B904.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1237.i.i.i

B1180.i.i.i:                                      ; preds = %B904.if.i.i.i
  %138 = getelementptr double, ptr %146, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %138, align 8, !noalias !32
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1237.i.i.i

B1237.i.i.i:                                      ; preds = %B1180.i.i.i, %B1130.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1180.i.i.i ], [ %.1601.i.i.i, %B1130.i.i.i ]
  store double %storemerge2111.i, ptr %148, align 8, !noalias !32
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B792.i.i, label %B904.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B750.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B750.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02129.i, 1
  %139 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02129.i
  %.341.i.i.i = load double, ptr %139, align 8, !noalias !32
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %140 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %140, double 1.200000e-05
  %141 = getelementptr i64, ptr %arg.linear.5.4, i64 %.212.i.i.02129.i
  %.434.i.i.i = load i64, ptr %141, align 8, !noalias !32
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.537.i.sroa.0.02147.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %142 = getelementptr i8, ptr %139, i64 %.idx2162.i
  store double %"$phi230.1.2.i.i.1.i", ptr %142, align 8, !noalias !32
  %exitcond2154.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2154.not.i, label %B272.i.i.i, label %B84.if.i.i.i

B458.if.i.i.i:                                    ; preds = %B344.i.i.i, %B458.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B458.if.i.i.i ], [ 0, %B344.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02131.i, 1
  %143 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.i
  %.906.i.i.i = load double, ptr %143, align 8, !noalias !32
  %144 = getelementptr double, ptr %143, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %144, align 8, !noalias !32
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %145 = getelementptr double, ptr %143, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %145, align 8, !noalias !32
  %exitcond2155.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2155.not.i, label %B574.i.i.i, label %B458.if.i.i.i

B904.if.i.i.i:                                    ; preds = %B574.i.i.1.i, %B1237.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1237.i.i.i ], [ 0, %B574.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02136.i, 1
  %146 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02136.i
  %.1445.i.i.i = load double, ptr %146, align 8, !noalias !32
  %147 = getelementptr i8, ptr %146, i64 %.933.i.idx.i
  store double %.1445.i.i.i, ptr %147, align 8, !noalias !32
  %148 = getelementptr i8, ptr %146, i64 %.idx2164.i
  %.1513.i.i.i = load double, ptr %148, align 8, !noalias !32
  %149 = getelementptr i8, ptr %146, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %149, align 8, !noalias !32
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B1130.i.i.i, label %B1180.i.i.i

B792.i.i:                                         ; preds = %B1237.i.i.i, %B574.i.i.1.i, %B746.i.i, %B382.i.i
  %.1384.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.1385.i.i = select i1 %.1384.i.i, i64 %arg.linear.6.5.0, i64 0
  %150 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.1399.i.i = getelementptr i64, ptr %150, i64 %.1385.i.i
  %.1400.i.i = load i64, ptr %.1399.i.i, align 8, !noalias !28
  %.1418.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1419.i.i = select i1 %.1418.i.i, i64 %arg.linear.6.5.0, i64 0
  %151 = getelementptr i8, ptr %150, i64 8
  %.1433.i.i = getelementptr i64, ptr %151, i64 %.1419.i.i
  %.1434.i.i = load i64, ptr %.1433.i.i, align 8, !noalias !28
  %.1471.i.i = sub i64 %.1434.i.i, %.1400.i.i
  %.1514.i2138.not.i = icmp slt i64 %.1471.i.i, 1
  br i1 %.1514.i2138.not.i, label %B248.i.loopexit.i, label %B854.if.i.i

B1030.i.i:                                        ; preds = %B854.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %152 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %152, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !28
  br label %B1115.i.i

B1086.i.i:                                        ; preds = %B854.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %153 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %153, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !28
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %154 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %154, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !28
  br label %B1115.i.i

B1115.i.i:                                        ; preds = %B1086.i.i, %B1030.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B854.if.i.i, label %B248.i.loopexit.i

B84.if.i.i:                                       ; preds = %B86.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B86.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %155, align 8, !noalias !28
  %156 = getelementptr i8, ptr %155, i64 %.idx2159.i
  store double %.384.i.i, ptr %156, align 8, !noalias !28
  %157 = getelementptr i8, ptr %155, i64 %.idx2160.i
  store double 0.000000e+00, ptr %157, align 8, !noalias !28
  %exitcond.not.i8887 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i8887, label %B186.i.i, label %B84.if.i.i

B306.if.i.i:                                      ; preds = %B270.i.i, %B306.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B306.if.i.i ], [ %storemerge2107.i, %B270.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B306.if.i.i ], [ 0, %B270.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %158 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %158, align 8, !noalias !28
  %.755.i.i = icmp eq i64 %.753.i.i, %.537.i.sroa.0.02147.i
  %..i = select i1 %.755.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.626.i.02121.i
  store double %..i, ptr %gep, align 8, !noalias !28
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
  %159 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1458.i.02139.i
  %.1586.i.i = getelementptr i64, ptr %159, i64 %.1572.i.i
  %.1587.i.i = load i64, ptr %.1586.i.i, align 8, !noalias !28
  %.1588.i.i = add nsw i64 %.1587.i.i, %.915.i.i
  %.1602.i.i = icmp slt i64 %.1588.i.i, 0
  %.1603.i.i = select i1 %.1602.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %160 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1588.i.i
  %.1617.i.i = getelementptr double, ptr %160, i64 %.1603.i.i
  %.1618.i.i = load double, ptr %.1617.i.i, align 8, !noalias !28
  %.1636.i.i = select i1 %.1571.i.i, i64 %arg.linear.8.5.0, i64 0
  %161 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1458.i.02139.i
  %.1650.i.i = getelementptr i64, ptr %161, i64 %.1636.i.i
  %.1651.i.i = load i64, ptr %.1650.i.i, align 8, !noalias !28
  %.1652.i.i = add nsw i64 %.1651.i.i, %.597.i.i.i
  %.1666.i.i = icmp slt i64 %.1652.i.i, 0
  %.1667.i.i = select i1 %.1666.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %162 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1652.i.i
  %.1681.i.i = getelementptr double, ptr %162, i64 %.1667.i.i
  %.1682.i.i = load double, ptr %.1681.i.i, align 8, !noalias !28
  %.1686.i.i = fdiv double %.1618.i.i, %.1682.i.i
  %.1692.i.i = fsub double %.1686.i.i, %.1686.i.i
  %.1693.i.i = fcmp oeq double %.1692.i.i, 0.000000e+00
  %.1686.i..i = select i1 %.1693.i.i, double %.1686.i.i, double 0.000000e+00
  %.1745.i.i = icmp eq i64 %.1651.i.i, %arg.shape.1
  br i1 %.1745.i.i, label %B1030.i.i, label %B1086.i.i

B126.i:                                           ; preds = %B248.i.loopexit.i, %B186.i.i, %B1634
  br i1 %.402.i, label %B156.if.i, label %B1674

B326.i:                                           ; preds = %B272.if.i, %B156.if.i
  %.746.i = mul i64 %.388.02152.i, %.434.sroa.0.02106.i
  %.762.i = icmp slt i64 %.746.i, 0
  %.763.i = select i1 %.762.i, i64 %arg.linear.1.5.0, i64 0
  %163 = getelementptr double, ptr %arg.linear.1.4, i64 %.746.i
  %.777.i = getelementptr double, ptr %163, i64 %.763.i
  %.778.i = load double, ptr %.777.i, align 8, !noalias !25
  %.832.i = load double, ptr %.831.i, align 8, !noalias !25
  %.833.i = fadd double %.778.i, %.832.i
  store double %.833.i, ptr %.777.i, align 8, !noalias !25
  %exitcond2158.not.i = icmp eq i64 %.457.i, %arg.shape.1
  br i1 %exitcond2158.not.i, label %B36.if.i.i, label %B156.if.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1674, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %164 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %164, align 8, !noalias !36
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i8885
  %.561.i.i = icmp slt i64 %.547.i2114.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %165 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i2114.i
  %.576.i.i = getelementptr double, ptr %165, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !36
  %.610.i.i = load double, ptr %167, align 8, !noalias !36
  store double %.577.i.i, ptr %167, align 8, !noalias !36
  store double %.610.i.i, ptr %.576.i.i, align 8, !noalias !36
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
  %.161.i.i8885 = mul nsw i64 %.59.0509.i.i, %arg.shape.1
  %.164.i.i = add nsw i64 %.59.0509.i.i, %arg.linear.3.0
  %.165.i.i = add nsw i64 %.164.i.i, 1
  %.11.i.i.i8886 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %166 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i8885
  %167 = getelementptr double, ptr %166, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8886, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %167, align 8, !noalias !36
  %.272.i.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.preheader.i.i
  %p.2.1497.i.i = phi i64 [ %p.3.2.i.i, %B234.if.i.i ], [ %.59.0509.i.i, %B234.if.preheader.i.i ]
  %largest.2.1496.i.i = phi double [ %largest.3.2.i.i, %B234.if.i.i ], [ %.272.i.i, %B234.if.preheader.i.i ]
  %.309.0495.i.i = phi i64 [ %.371.i.i, %B234.if.i.i ], [ %storemerge488.i.i, %B234.if.preheader.i.i ]
  %.306.0494.i.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.preheader.i.i ]
  %.371.i.i = add nsw i64 %.309.0495.i.i, -1
  %.375.i.i = add i64 %.306.0494.i.i, 1
  %.415.i.i = add nsw i64 %.306.0494.i.i, %.161.i.i8885
  %.429.i.i = icmp slt i64 %.415.i.i, 0
  %.430.i.i = select i1 %.429.i.i, i64 %arg.linear.1.5.0, i64 0
  %168 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %168, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !36
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
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i8885
  %.812.i.i = icmp slt i64 %.798.i.i, 0
  %.813.i.i = select i1 %.812.i.i, i64 %arg.linear.1.5.0, i64 0
  %169 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %169, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i.i, align 8, !noalias !36
  %.861.i.i = load double, ptr %167, align 8, !noalias !36
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i.i, align 8, !noalias !36
  %.759.i.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %170 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i.i = add nsw i64 %170, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %arg.linear.1.5.0, i64 0
  %171 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i.i
  %.1059.i.i = getelementptr double, ptr %171, i64 %.1045.i.i
  %.1060.i2115.i = load double, ptr %.1059.i.i, align 8, !noalias !36
  %.1068.i.i = add nsw i64 %170, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %172 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %172, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !36
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !36
  store double %.1060.i2115.i, ptr %.1097.i.i, align 8, !noalias !36
  %.1171.i.i = fcmp oeq double %.1060.i2115.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %170
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i.i = select i1 %.1310.i.i, i64 %arg.linear.1.5.0, i64 0
  %173 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %173, i64 %.1311.i.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !36
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i8885
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %arg.linear.1.5.0, i64 0
  %174 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %174, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !36
  %.1360.i.i = fmul double %.1060.i2115.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !36
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B156.if.i:                                        ; preds = %B126.i, %B326.i
  %.388.02152.i = phi i64 [ %.457.i, %B326.i ], [ 0, %B126.i ]
  %.457.i = add nsw i64 %.388.02152.i, 1
  %.489.i = sub i64 %.388.02152.i, %31
  %.11.i.i8882 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i8883 = add i64 %.520.i8881, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i8883, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i8882
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B326.i, label %B272.if.lr.ph.i

B272.if.lr.ph.i:                                  ; preds = %B156.if.i
  %.670.i = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B272.if.i

B272.if.i:                                        ; preds = %B272.if.i, %B272.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B272.if.lr.ph.i ], [ %.639.i8884, %B272.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i8882, %B272.if.lr.ph.i ], [ %.643.i, %B272.if.i ]
  %.639.i8884 = add nsw i64 %.577.02150.i, -1
  %.643.i = add i64 %.574.02149.i, 1
  %.671.i = add nsw i64 %.574.02149.i, %.670.i
  %.685.i = icmp slt i64 %.671.i, 0
  %.686.i = select i1 %.685.i, i64 %arg.linear.0.5.0, i64 0
  %175 = getelementptr double, ptr %arg.linear.0.4, i64 %.671.i
  %.700.i = getelementptr double, ptr %175, i64 %.686.i
  %.701.i = load double, ptr %.700.i, align 8, !noalias !25
  %.702.i = fneg double %.701.i
  %.721.i = select i1 %.685.i, i64 %arg.linear.1.5.0, i64 0
  %176 = getelementptr double, ptr %arg.linear.1.4, i64 %.671.i
  %.735.i = getelementptr double, ptr %176, i64 %.721.i
  store double %.702.i, ptr %.735.i, align 8, !noalias !25
  %.630.i = icmp sgt i64 %.577.02150.i, 1
  br i1 %.630.i, label %B272.if.i, label %B326.i

B1674:                                            ; preds = %B34.loopexit.i.i, %B126.i, %B1630
  br i1 %.21409259.not, label %B1894, label %B1706.if

B68.if.lr.ph.i:                                   ; preds = %B1706.if
  %.259.i = mul nsw i64 %.2153, %arg.shape.1
  br label %B68.if.i

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i
  %exitcond633.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond633.not.i, label %B314.if.i.i, label %B34.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0629.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B326.if.lr.ph.i

B326.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.624.i8900 = mul nsw i64 %.2153, %arg.shape.1
  br label %B326.if.i

B34.if.i.i:                                       ; preds = %B68.if.i, %B34.i.loopexit.i
  %.73.i.0621.i = phi i64 [ %.144.i.i, %B34.i.loopexit.i ], [ 0, %B68.if.i ]
  %.144.i.i = add nsw i64 %.73.i.0621.i, 1
  %177 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0621.i
  %.202.i.i = load i64, ptr %177, align 8, !noalias !39
  %.204.i.i = add nsw i64 %.202.i.i, %.395.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %178 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %178, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !39
  %gep9258 = getelementptr double, ptr %invariant.gep9257, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep9258, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep9258, align 8, !noalias !39
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i8895 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8895, %.144.i.i
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
  %179 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %179, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !39
  %.522.i.i = add nsw i64 %.393.i.0618.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %180 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %180, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !39
  %.554.i.i = fmul double %.234.i.i, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !39
  %.449.i.i = icmp sgt i64 %.396.i.0619.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i

B314.if.i.i:                                      ; preds = %B34.i.loopexit.i, %B314.i.loopexit.i
  %.627.i.0629.in.i = phi i64 [ %.627.i.0629.i, %B314.i.loopexit.i ], [ %arg.shape.1, %B34.i.loopexit.i ]
  %.627.i.0629.i = add nsw i64 %.627.i.0629.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0629.i, %.395.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %181 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i8896 = getelementptr double, ptr %181, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i8896, align 8, !noalias !39
  %.759.i.i8897 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8897, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %182 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %182, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !39
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i8896, align 8, !noalias !39
  %.866.i.i = sub i64 %.627.i.0629.i, %32
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
  %183 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %183, i64 %.1029.i.i
  %.1044.i.i8898 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i8897
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %184 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %184, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !39
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8898, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !39
  %.975.i.i8899 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i8899, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i8889 = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %185 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i8890 = getelementptr double, ptr %185, i64 %.275.i8889
  %.290.i = load double, ptr %.289.i8890, align 8, !noalias !45
  %gep9256 = getelementptr double, ptr %invariant.gep9255, i64 %.160.0615.i
  %.323.i = load double, ptr %gep9256, align 8, !noalias !45
  %.324.i = fadd double %.290.i, %.323.i
  %186 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %186, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i8892 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i8893 = getelementptr double, ptr %187, i64 %.372.i8892
  store double %.324.i, ptr %.386.i8893, align 8, !noalias !45
  %exitcond.not.i8894 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i8894, label %B34.if.i.i, label %B68.if.i

B326.if.i:                                        ; preds = %B326.if.i, %B326.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B326.if.lr.ph.i ], [ %.533.i8901, %B326.if.i ]
  %.533.i8901 = add nsw i64 %.464.0631.i, 1
  %188 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i8902 = load i64, ptr %188, align 8, !noalias !45
  %.590.i = add nsw i64 %.589.i8902, %.395.i
  %.604.i8903 = icmp slt i64 %.590.i, 0
  %.605.i = select i1 %.604.i8903, i64 %arg.batch.5.0.5.0, i64 0
  %189 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %189, i64 %.605.i
  %.620.i = load double, ptr %.619.i, align 8, !noalias !45
  %.625.i8904 = add nsw i64 %.464.0631.i, %.624.i8900
  %.639.i8905 = icmp slt i64 %.625.i8904, 0
  %.640.i = select i1 %.639.i8905, i64 %arg.batch.5.0.5.0, i64 0
  %190 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i8904
  %.654.i = getelementptr double, ptr %190, i64 %.640.i
  store double %.620.i, ptr %.654.i, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i8901
  br i1 %exitcond634.not.i, label %B1892, label %B326.if.i

B1892:                                            ; preds = %B326.if.i, %B1706.if
  %exitcond9452.not = icmp eq i64 %.2084.09260, %storemerge8794
  br i1 %exitcond9452.not, label %B1894, label %B1706.if

B1894:                                            ; preds = %B1892, %B1674
  %.2405 = load i64, ptr %.2404, align 8
  %.2450 = inttoptr i64 %.2405 to ptr
  tail call void %.2450(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1175, i1 true, i1 %.610
  %or.cond8851 = select i1 %brmerge, i1 true, i1 %.2481
  %spec.select8869 = select i1 %or.cond8851, i1 true, i1 %.2486
  br i1 %.809, label %B2156, label %B2046.if

B2054:                                            ; preds = %B2046.if
  %191 = getelementptr double, ptr %33, i64 %.2526.09263
  %.2681 = load double, ptr %191, align 8
  %.2682 = fcmp ogt double %.2681, 5.000000e-01
  br label %B2100

B2100:                                            ; preds = %B2054, %B2046.if
  %"$phi2100.1.2.2" = phi i1 [ true, %B2046.if ], [ %.2682, %B2054 ]
  br i1 %looked.2.19266, label %B2152, label %B2106

B2106:                                            ; preds = %B2100
  %192 = getelementptr double, ptr %34, i64 %.2526.09263
  %.2752 = load double, ptr %192, align 8
  %.2753 = fcmp ogt double %.2752, 5.000000e-01
  br label %B2152

B2152:                                            ; preds = %B2106, %B2100
  %"$phi2152.1.2.2" = phi i1 [ true, %B2100 ], [ %.2753, %B2106 ]
  %.2582 = icmp sgt i64 %.2529.09264, 1
  br i1 %.2582, label %B2046.if, label %B2156

B2156:                                            ; preds = %B2152, %B1894
  %good.2.1.lcssa = phi i1 [ false, %B1894 ], [ %"$phi2100.1.2.2", %B2152 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select8869, %B1894 ], [ %"$phi2152.1.2.2", %B2152 ]
  %looked.2.1.lcssa.not9456 = xor i1 %looked.2.1.lcssa, true
  %brmerge9457 = or i1 %.809, %looked.2.1.lcssa.not9456
  br i1 %brmerge9457, label %B2838, label %B82.if.i

B2226.preheader:                                  ; preds = %B682.i
  br i1 %.809, label %B2838, label %B2228.if

B140.i:                                           ; preds = %B82.if.i
  %.311.i573 = getelementptr double, ptr %35, i64 %.105.i424.09270
  %.312.i574 = load double, ptr %.311.i573, align 8, !noalias !46
  %.5.i.i = fptosi double %.312.i574 to i64
  %.386.i = getelementptr double, ptr %36, i64 %.105.i424.09270
  %.387.i = load double, ptr %.386.i, align 8, !noalias !46
  %.5.i1.i = fptosi double %.387.i to i64
  %.463.i658 = mul i64 %.255.i529, %arg.batch.3.3.5.1
  %.467.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.463.i658
  %.468.i661 = load i64, ptr %.467.i, align 8, !noalias !46
  %.470.i = add nsw i64 %.468.i661, %.5.i.i
  store i64 %.470.i, ptr %.467.i, align 8, !noalias !46
  %.568.i740 = getelementptr i8, ptr %.467.i, i64 24
  %.569.i741 = load i64, ptr %.568.i740, align 8, !noalias !46
  %.571.i743 = add nsw i64 %.569.i741, %.5.i1.i
  store i64 %.571.i743, ptr %.568.i740, align 8, !noalias !46
  %.669.i822 = getelementptr i8, ptr %.467.i, i64 8
  %.670.i823 = load i64, ptr %.669.i822, align 8, !noalias !46
  %.675.i828 = add nsw i64 %.5.i1.i, %.5.i.i
  %.676.i829 = mul nsw i64 %.675.i828, %.2097
  %..5.i.i = select i1 %.625, i64 0, i64 %.5.i.i
  %.677.i830 = add i64 %.676.i829, %..5.i.i
  %.802.i921 = add i64 %.677.i830, %.670.i823
  store i64 %.802.i921, ptr %.669.i822, align 8, !noalias !46
  store double 0.000000e+00, ptr %.311.i573, align 8, !noalias !46
  store double 0.000000e+00, ptr %.386.i, align 8, !noalias !46
  %.1017.i1029 = getelementptr double, ptr %37, i64 %.105.i424.09270
  %.1018.i1030 = load double, ptr %.1017.i1029, align 8, !noalias !46
  %.1026.i1035 = sitofp i64 %.675.i828 to double
  %.1027.i1036 = fsub double %.1018.i1030, %.1026.i1035
  store double %.1027.i1036, ptr %.1017.i1029, align 8, !noalias !46
  br label %B682.i

B682.i:                                           ; preds = %B140.i, %B82.if.i
  %.164.i480 = icmp sgt i64 %.108.i.09271, 1
  br i1 %.164.i480, label %B82.if.i, label %B2226.preheader

B82.if.i:                                         ; preds = %B2156, %B682.i
  %.108.i.09271 = phi i64 [ %.173.i1071, %B682.i ], [ %storemerge, %B2156 ]
  %.105.i424.09270 = phi i64 [ %.177.i1074, %B682.i ], [ 0, %B2156 ]
  %.173.i1071 = add nsw i64 %.108.i.09271, -1
  %.177.i1074 = add nsw i64 %.105.i424.09270, 1
  %193 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i424.09270
  %.255.i529 = load i64, ptr %193, align 8, !noalias !46
  %.260.i532 = icmp sgt i64 %.255.i529, -1
  br i1 %.260.i532, label %B140.i, label %B682.i

B2358:                                            ; preds = %B2228.if
  %.3192 = getelementptr double, ptr %40, i64 %.2873.09273
  %.3193 = load double, ptr %.3192, align 8
  %.3194 = fcmp ogt double %.3193, 5.000000e-01
  br i1 %.3194, label %B2406, label %B2516

B2406:                                            ; preds = %B2358
  %.5.i = fptosi double %.3193 to i64
  %194 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2873.09273
  %.84.i2152 = load i64, ptr %194, align 8, !noalias !50
  %.89.i2155 = icmp sgt i64 %.84.i2152, -1
  br i1 %.89.i2155, label %B46.i2160, label %B2516

B2516:                                            ; preds = %B2358, %B46.i2160, %B2406, %B80.i2193
  %.3372 = getelementptr double, ptr %41, i64 %.2873.09273
  %.3373 = load double, ptr %.3372, align 8
  %.3374 = fcmp ogt double %.3373, 5.000000e-01
  br i1 %.3374, label %B2564, label %B2834

B2564:                                            ; preds = %B2516
  %spec.select = select i1 %within.3.29275, i1 true, i1 %.2481
  %.3446 = mul i64 %.3031, %arg.batch.3.3.5.1
  %.3450 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3446
  %.3451 = load i64, ptr %.3450, align 8
  %.3462.0 = and i64 %.3451, 127
  %.3492 = icmp eq i64 %.3462.0, 0
  br i1 %.3492, label %B2692, label %B2644

B2644:                                            ; preds = %B2564
  %.3549 = getelementptr double, ptr %42, i64 %.2873.09273
  %.3550 = load double, ptr %.3549, align 8
  %.3552 = fcmp ogt double %.3550, 0.000000e+00
  br i1 %.3552, label %B2692, label %B2732

B2692:                                            ; preds = %B2564, %B2644
  store double 1.000000e+00, ptr %.3138, align 8
  br label %B2732

B2732:                                            ; preds = %B2692, %B2644
  %checked.5.5 = phi i1 [ true, %B2692 ], [ %checked.3.29276, %B2644 ]
  %.3631 = icmp slt i64 %.3082, %arg.batch.2.5.0
  br i1 %.3631, label %B2770, label %B2834

B2770:                                            ; preds = %B2732
  %.3655 = icmp slt i64 %.3082, 0
  %.3656 = select i1 %.3655, i64 %arg.batch.2.5.0, i64 0
  %195 = getelementptr double, ptr %arg.batch.2.4, i64 %.3082
  %.3670 = getelementptr double, ptr %195, i64 %.3656
  %.3671 = load double, ptr %.3670, align 8
  %.3725 = getelementptr double, ptr %43, i64 %.2873.09273
  %.3726 = load double, ptr %.3725, align 8
  %.3727 = fcmp olt double %.3671, %.3726
  br i1 %.3727, label %B2830, label %B2834

B2830:                                            ; preds = %B2770
  br label %B2834

B2834:                                            ; preds = %B2228.if, %B2830, %B2770, %B2732, %B2516
  %within.4.3 = phi i1 [ true, %B2830 ], [ %spec.select, %B2770 ], [ %spec.select, %B2732 ], [ %within.3.29275, %B2516 ], [ %within.3.29275, %B2228.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2830 ], [ %checked.5.5, %B2770 ], [ %checked.5.5, %B2732 ], [ %checked.3.29276, %B2516 ], [ %checked.3.29276, %B2228.if ]
  %.2936 = icmp sgt i64 %.2876.09274, 1
  br i1 %.2936, label %B2228.if, label %B2838

B2838:                                            ; preds = %B2834, %B2156, %B2226.preheader
  %within.5.1 = phi i1 [ false, %B2156 ], [ false, %B2226.preheader ], [ %within.4.3, %B2834 ]
  %checked.2.1 = phi i1 [ false, %B2156 ], [ false, %B2226.preheader ], [ %checked.4.3, %B2834 ]
  %good.2.1.not = xor i1 %good.2.1.lcssa, true
  %brmerge8853 = select i1 %good.2.1.not, i1 true, i1 %44
  br i1 %brmerge8853, label %B2948, label %B2850

B2850:                                            ; preds = %B2838
  tail call void %.3825(ptr %.571, ptr %.3799, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3824)
  br label %B2948

B2948:                                            ; preds = %B2838, %B2850
  br i1 %checked.2.1, label %B2952, label %B3038

B2952:                                            ; preds = %B2948
  switch i64 %arg.shape.2, label %B3038 [
    i64 12, label %B2960
    i64 7, label %B2960
  ]

B2960:                                            ; preds = %B2952, %B2952
  %.3865 = load i64, ptr %.3864, align 8
  %.3910 = inttoptr i64 %.3865 to ptr
  tail call void %.3910(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3038

B3038:                                            ; preds = %B2952, %B2960, %B2948
  %brmerge8856.not = and i1 %.2486, %good.2.1.lcssa
  br i1 %brmerge8856.not, label %B3058, label %B3200

B3058:                                            ; preds = %B3038
  %.3959 = load i64, ptr %.3958, align 8
  %.4004 = inttoptr i64 %.3959 to ptr
  tail call void %.4004(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  store i8 0, ptr %.4014, align 1
  %.4068 = call fastcc i32 @_ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4014, ptr %excinfo.9, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4070.not = icmp eq i32 %.4068, 0
  %.4078 = load i8, ptr %.4014, align 1
  %.4081 = icmp ne i8 %.4078, 0
  br i1 %.4070.not, label %B3200, label %B3058.endif.if, !prof !53

B3200:                                            ; preds = %B3058, %B3038
  %beyond.3.1 = phi i1 [ false, %B3038 ], [ %.4081, %B3058 ]
  %brmerge8857 = select i1 %within.5.1, i1 true, i1 %beyond.3.1
  br i1 %brmerge8857, label %B3210, label %B3786

B3210:                                            ; preds = %B3200
  br i1 %.614, label %B3258.if, label %B3628.critedge

B160.i:                                           ; preds = %B64.if.i3146
  %.397.i2551 = getelementptr double, ptr %46, i64 %.138.i2327.09283
  %.398.i2552 = load double, ptr %.397.i2551, align 8, !noalias !54
  %.399.i = fcmp uge double %.398.i2552, 5.000000e-01
  %.412.i2559.not = icmp slt i64 %.338.i2502, %arg.batch.2.5.0
  %or.cond8858 = select i1 %.399.i, i1 %.412.i2559.not, i1 false
  br i1 %or.cond8858, label %B248.i, label %B533.i

B248.i:                                           ; preds = %B160.i
  %.435.i2570 = icmp slt i64 %.338.i2502, 0
  %.436.i2571 = select i1 %.435.i2570, i64 %arg.batch.2.5.0, i64 0
  %196 = getelementptr double, ptr %arg.batch.2.4, i64 %.338.i2502
  %.450.i2585 = getelementptr double, ptr %196, i64 %.436.i2571
  %.451.i2586 = load double, ptr %.450.i2585, align 8, !noalias !54
  %.501.i2630 = getelementptr double, ptr %47, i64 %.138.i2327.09283
  %.502.i2631 = load double, ptr %.501.i2630, align 8, !noalias !54
  %.503.i2632 = fcmp olt double %.451.i2586, %.502.i2631
  br i1 %.503.i2632, label %B308.i, label %B533.i

B308.i:                                           ; preds = %B248.i
  %.554.i2673 = getelementptr double, ptr %48, i64 %.138.i2327.09283
  %.555.i2674 = load double, ptr %.554.i2673, align 8, !noalias !54
  %.556.i2675 = fcmp ogt double %.555.i2674, 1.000000e+00
  br i1 %.556.i2675, label %B356.i2676, label %B533.i

B356.i2676:                                       ; preds = %B308.i
  %.608.i2720 = getelementptr double, ptr %49, i64 %.138.i2327.09283
  %.609.i2721 = load double, ptr %.608.i2720, align 8, !noalias !54
  store double 0.000000e+00, ptr %.397.i2551, align 8, !noalias !58
  %.161.i.i2881 = getelementptr double, ptr %50, i64 %.138.i2327.09283
  store double 0.000000e+00, ptr %.161.i.i2881, align 8, !noalias !58
  %.214.i.i2908 = getelementptr double, ptr %51, i64 %.138.i2327.09283
  store double %.609.i2721, ptr %.214.i.i2908, align 8, !noalias !58
  %.268.i.i = load i64, ptr %.286.i2457, align 8, !noalias !58
  %.294.i.i2942 = icmp slt i64 %.268.i.i, 0
  %.295.i.i2943 = select i1 %.294.i.i2942, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i2944 = add i64 %.295.i.i2943, %.268.i.i
  %.316.i.i = mul i64 %.296.i.i2944, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i
  %.321.i.i = load i64, ptr %.320.i.i, align 8, !noalias !58
  %.322.i.i2955 = add nsw i64 %.321.i.i, -1
  store i64 %.322.i.i2955, ptr %.320.i.i, align 8, !noalias !58
  %.426.i.i = load i64, ptr %.286.i2457, align 8, !noalias !58
  %.452.i.i = icmp slt i64 %.426.i.i, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %197 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %197, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !58
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !58
  %.681.i3008 = load double, ptr %.450.i2585, align 8, !noalias !54
  %.735.i3052 = getelementptr double, ptr %52, i64 %.138.i2327.09283
  store double %.681.i3008, ptr %.735.i3052, align 8, !noalias !54
  %.784.i3095 = mul i64 %.287.i2458, %arg.batch.3.3.5.1
  %198 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.784.i3095
  %.788.i3098 = getelementptr i8, ptr %198, i64 8
  %.789.i3099 = load i64, ptr %.788.i3098, align 8, !noalias !54
  %.790.i3100 = add nsw i64 %.789.i3099, 3
  store i64 %.790.i3100, ptr %.788.i3098, align 8, !noalias !54
  br label %B533.i

B533.i:                                           ; preds = %B248.i, %B308.i, %B356.i2676, %B64.if.i3146, %B160.i
  %.196.i2396 = icmp sgt i64 %.141.i2328.09282, 1
  br i1 %.196.i2396, label %B64.if.i3146, label %B3628

B64.if.i3146:                                     ; preds = %B3258.if, %B533.i
  %.138.i2327.09283 = phi i64 [ %.209.i3153, %B533.i ], [ 0, %B3258.if ]
  %.141.i2328.09282 = phi i64 [ %.205.i3150, %B533.i ], [ %storemerge, %B3258.if ]
  %.205.i3150 = add nsw i64 %.141.i2328.09282, -1
  %.209.i3153 = add nsw i64 %.138.i2327.09283, 1
  %.286.i2457 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2327.09283
  %.287.i2458 = load i64, ptr %.286.i2457, align 8, !noalias !54
  %.337.i2501 = getelementptr i64, ptr %45, i64 %.138.i2327.09283
  %.338.i2502 = load i64, ptr %.337.i2501, align 8, !noalias !54
  %.346.i2506 = icmp slt i64 %.287.i2458, 0
  br i1 %.346.i2506, label %B533.i, label %B160.i

B3628.critedge:                                   ; preds = %B3210
  %.4470.c = load i64, ptr %.4469.c, align 8
  %.4515.c = inttoptr i64 %.4470.c to ptr
  tail call void %.4515.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3628

B3628:                                            ; preds = %B533.i, %B3258.if, %B3628.critedge
  br i1 %beyond.3.1, label %B3632, label %B3742

B3632:                                            ; preds = %B3628
  store i8 0, ptr %.4591, align 1
  %.4645 = call fastcc i32 @_ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4591, ptr %excinfo.11, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4647.not = icmp eq i32 %.4645, 0
  br i1 %.4647.not, label %B3632.endif.endif, label %B3632.endif.if, !prof !53

B3700:                                            ; preds = %B3632.endif.endif
  %.231.i8906 = load double, ptr %.230.i, align 8, !noalias !61
  %.260.i8907 = load double, ptr %arg.batch.2.4, align 8, !noalias !61
  %.261.i = fsub double %.231.i8906, %.260.i8907
  %.262.i = fmul double %.261.i, 1.000000e-13
  br i1 %.809, label %B296.preheader.i.preheader, label %B178.if.i.preheader

B178.if.i.preheader:                              ; preds = %B3700
  tail call void @llvm.memset.p0.i64(ptr align 8 %54, i8 0, i64 %117, i1 false), !noalias !61
  br label %B296.preheader.i.preheader

B296.preheader.i.preheader:                       ; preds = %B178.if.i.preheader, %B3700
  br label %B296.preheader.i

B296.preheader.i:                                 ; preds = %B296.preheader.i.preheader, %B364.endif.i
  %.545.sroa.0.08200.i = phi i64 [ %.502.18199.i, %B364.endif.i ], [ 8, %B296.preheader.i.preheader ]
  %.502.18199.i = phi i64 [ %.502.1.i, %B364.endif.i ], [ 7, %B296.preheader.i.preheader ]
  br i1 %.809, label %B364.endif.i, label %B296.if.i8910.preheader

B296.if.i8910.preheader:                          ; preds = %B296.preheader.i
  %switch.tableidx9495 = add i64 %.545.sroa.0.08200.i, 9
  %199 = icmp ult i64 %switch.tableidx9495, 17
  %switch.gep9497 = getelementptr inbounds double, ptr @switch.table.advance_of_many.8, i64 %switch.tableidx9495
  br label %B296.if.i8910

B296.loopexit.i:                                  ; preds = %B122.if.i467.i, %switch.end.i
  %exitcond8384.not.i = icmp eq i64 %arg.shape.0, %.689.i8911
  br i1 %exitcond8384.not.i, label %B88.if.i.lr.ph.i, label %B296.if.i8910

B88.if.i.lr.ph.i:                                 ; preds = %B296.loopexit.i
  %.151.i.i.i8912 = mul nsw i64 %.545.sroa.0.08200.i, 3
  %.153.i.i7087993.i = add nsw i64 %.151.i.i.i8912, 1
  %.155.i.i710.i = mul i64 %.153.i.i7087993.i, %arg.shape.6
  br label %B88.if.i.i

B140.i.i:                                         ; preds = %B88.if.i.i
  %200 = getelementptr double, ptr %57, i64 %.203.i538.08177.i
  %.408.i.i = load double, ptr %200, align 8, !noalias !65
  %.409.i.i = fcmp ugt double %.408.i.i, 1.000000e-01
  br i1 %.409.i.i, label %B334.i.i, label %B202.i.i

B202.i.i:                                         ; preds = %B140.i.i
  %.469.i.i = getelementptr double, ptr %58, i64 %.203.i538.08177.i
  %.470.i.i = load double, ptr %.469.i.i, align 8, !noalias !65
  %.520.i.i = getelementptr double, ptr %59, i64 %.203.i538.08177.i
  %.521.i.i8942 = load double, ptr %.520.i.i, align 8, !noalias !65
  %.522.i.i8943 = fcmp olt double %.470.i.i, %.521.i.i8942
  br i1 %.522.i.i8943, label %B34.i.i.i, label %B334.i.i

B34.i.i.i:                                        ; preds = %B202.i.i, %B34.if.i.i.i
  %.51.i.i492.0.i = phi i64 [ %.122.i.i.i, %B34.if.i.i.i ], [ 0, %B202.i.i ]
  %exitcond8385.not.i = icmp eq i64 %.51.i.i492.0.i, %storemerge7992.i
  br i1 %exitcond8385.not.i, label %B334.i.i, label %B34.if.i.i.i

B128.i.i.i:                                       ; preds = %B34.if.i.i.i
  %201 = icmp sgt i64 %.51.i.i492.0.i, -1
  br label %B334.i.i

B34.if.i.i.i:                                     ; preds = %B34.i.i.i
  %.122.i.i.i = add i64 %.51.i.i492.0.i, 1
  %.157.i.i712.i = add nsw i64 %.51.i.i492.0.i, %.155.i.i710.i
  %.159.i.i714.i = mul nsw i64 %.157.i.i712.i, %arg.shape.0
  %.161.i.i716.i = add nsw i64 %.159.i.i714.i, %.203.i538.08177.i
  %.175.i.i724.i = icmp slt i64 %.161.i.i716.i, 0
  %.176.i.i725.i = select i1 %.175.i.i724.i, i64 %arg.batch.5.4.5.0, i64 0
  %202 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i716.i
  %.190.i.i735.i = getelementptr double, ptr %202, i64 %.176.i.i725.i
  %.191.i.i736.i = load double, ptr %.190.i.i735.i, align 8, !noalias !69
  %.195.i.i.i = add nsw i64 %.161.i.i716.i, %.194.i.i739.i
  %.209.i.i742.i = icmp slt i64 %.195.i.i.i, 0
  %.210.i.i.i = select i1 %.209.i.i742.i, i64 %arg.batch.5.4.5.0, i64 0
  %203 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i.i.i
  %.224.i.i747.i = getelementptr double, ptr %203, i64 %.210.i.i.i
  %.225.i.i.i = load double, ptr %.224.i.i747.i, align 8, !noalias !69
  %.226.i.i748.i = fneg double %.225.i.i.i
  %.227.i.i.i = fcmp olt double %.191.i.i736.i, %.226.i.i748.i
  br i1 %.227.i.i.i, label %B128.i.i.i, label %B34.i.i.i

B334.i.i:                                         ; preds = %B34.i.i.i, %B88.if.i.i, %B128.i.i.i, %B202.i.i, %B140.i.i
  %"$phi334.1.2.i.1.i" = phi i1 [ false, %B140.i.i ], [ false, %B202.i.i ], [ false, %B88.if.i.i ], [ %201, %B128.i.i.i ], [ false, %B34.i.i.i ]
  %spec.select.i = or i1 %some.2.i.08179.i, %"$phi334.1.2.i.1.i"
  %"$phi352.2.2.i.1.i" = select i1 %"$phi334.1.2.i.1.i", double 1.000000e+00, double 0.000000e+00
  %204 = getelementptr double, ptr %60, i64 %.203.i538.08177.i
  store double %"$phi352.2.2.i.1.i", ptr %204, align 8, !noalias !65
  %exitcond8386.not.i = icmp eq i64 %arg.shape.0, %.274.i.i
  br i1 %exitcond8386.not.i, label %B390.i.i, label %B88.if.i.i

B390.i.i:                                         ; preds = %B334.i.i
  br i1 %spec.select.i, label %B398.i.i, label %B364.endif.i

B398.i.i:                                         ; preds = %B390.i.i
  %.699.i.not.i = icmp eq i64 %.545.sroa.0.08200.i, 8
  %..i8937 = select i1 %.699.i.not.i, i64 17, i64 16
  %.714.i.i = mul i64 %..i8937, %.463
  %.722.i.i = mul i64 %.545.sroa.0.08200.i, %factor.op.mul.i.reass
  %.757.i.i = load i64, ptr %arg.code.4, align 8, !noalias !65
  %.847.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.714.i.i
  %.873.i.i = inttoptr i64 %.757.i.i to ptr
  tail call void %.873.i.i(ptr %.571, ptr %.847.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.872.i.i), !noalias !65
  br i1 %.114.i40.i8180.not.i, label %B466.endif.endif.i.i.critedge, label %B34.if.i111.i.i

B34.if.i111.i.i:                                  ; preds = %B398.i.i, %B34.if.i111.i.i
  %.56.i.i485.08181.i = phi i64 [ %.127.i115.i.i, %B34.if.i111.i.i ], [ 0, %B398.i.i ]
  %.127.i115.i.i = add nsw i64 %.56.i.i485.08181.i, 1
  %.153.i49.i.i = add nsw i64 %.56.i.i485.08181.i, %.722.i.i
  %.167.i56.i.i = icmp slt i64 %.153.i49.i.i, 0
  %.168.i.i.i = select i1 %.167.i56.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %205 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i49.i.i
  %.182.i.i.i = getelementptr double, ptr %205, i64 %.168.i.i.i
  %.183.i68.i.i = load double, ptr %.182.i.i.i, align 8, !noalias !73
  %.185.i70.i.i = add nsw i64 %.56.i.i485.08181.i, %.878.i.i
  %.199.i.i.i = icmp slt i64 %.185.i70.i.i, 0
  %.200.i.i.i = select i1 %.199.i.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i70.i.i
  %.214.i89.i.i = getelementptr double, ptr %206, i64 %.200.i.i.i
  %.215.i90.i.i = load double, ptr %.214.i89.i.i, align 8, !noalias !73
  store double %.183.i68.i.i, ptr %.214.i89.i.i, align 8, !noalias !73
  store double %.215.i90.i.i, ptr %.182.i.i.i, align 8, !noalias !73
  %exitcond8387.not.i = icmp eq i64 %.194.i.i739.i, %.127.i115.i.i
  br i1 %exitcond8387.not.i, label %B466.endif.i.i, label %B34.if.i111.i.i

B1134.i.loopexit.i:                               ; preds = %B1222.if.i.i, %B1136.if.i.i
  %exitcond8390.not.i = icmp eq i64 %arg.shape.0, %.1482.i.i
  br i1 %exitcond8390.not.i, label %B364.endif.i, label %B1136.if.i.i

B88.if.i.i:                                       ; preds = %B334.i.i, %B88.if.i.lr.ph.i
  %some.2.i.08179.i = phi i1 [ false, %B88.if.i.lr.ph.i ], [ %spec.select.i, %B334.i.i ]
  %.203.i538.08177.i = phi i64 [ 0, %B88.if.i.lr.ph.i ], [ %.274.i.i, %B334.i.i ]
  %.274.i.i = add nsw i64 %.203.i538.08177.i, 1
  %207 = getelementptr i64, ptr %56, i64 %.203.i538.08177.i
  %.352.i.i = load i64, ptr %207, align 8, !noalias !65
  %.353.i665.i = icmp sgt i64 %.352.i.i, -1
  br i1 %.353.i665.i, label %B140.i.i, label %B334.i.i

B466.endif.i.i:                                   ; preds = %B34.if.i111.i.i
  %.938.i.i = load i64, ptr %.937.i.i, align 8, !noalias !65
  %.1050.i.i = inttoptr i64 %.938.i.i to ptr
  tail call void %.1050.i.i(ptr %.571, ptr %.847.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !65
  %.1081.i.i8938 = load i64, ptr %arg.code.4, align 8, !noalias !65
  %.1197.i.i = inttoptr i64 %.1081.i.i8938 to ptr
  tail call void %.1197.i.i(ptr %.571, ptr %.847.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1196.i.i), !noalias !65
  br label %B34.if.i316.i.i

B34.if.i316.i.i:                                  ; preds = %B466.endif.i.i, %B34.if.i316.i.i
  %.56.i149.i.08184.i = phi i64 [ %.127.i324.i.i, %B34.if.i316.i.i ], [ 0, %B466.endif.i.i ]
  %.127.i324.i.i = add nsw i64 %.56.i149.i.08184.i, 1
  %.153.i217.i.i = add nsw i64 %.56.i149.i.08184.i, %.722.i.i
  %.167.i227.i.i = icmp slt i64 %.153.i217.i.i, 0
  %.168.i228.i.i = select i1 %.167.i227.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %208 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i217.i.i
  %.182.i241.i.i = getelementptr double, ptr %208, i64 %.168.i228.i.i
  %.183.i242.i.i = load double, ptr %.182.i241.i.i, align 8, !noalias !77
  %.185.i244.i.i = add nsw i64 %.56.i149.i.08184.i, %.878.i.i
  %.199.i254.i.i = icmp slt i64 %.185.i244.i.i, 0
  %.200.i255.i.i = select i1 %.199.i254.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %209 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i244.i.i
  %.214.i268.i.i = getelementptr double, ptr %209, i64 %.200.i255.i.i
  %.215.i269.i.i = load double, ptr %.214.i268.i.i, align 8, !noalias !77
  store double %.183.i242.i.i, ptr %.214.i268.i.i, align 8, !noalias !77
  store double %.215.i269.i.i, ptr %.182.i241.i.i, align 8, !noalias !77
  %exitcond8388.not.i = icmp eq i64 %.194.i.i739.i, %.127.i324.i.i
  br i1 %exitcond8388.not.i, label %B466.endif.endif.i.i, label %B34.if.i316.i.i

B466.endif.endif.i.i.critedge:                    ; preds = %B398.i.i
  %.938.i.i.c = load i64, ptr %.937.i.i, align 8, !noalias !65
  %.1050.i.i.c = inttoptr i64 %.938.i.i.c to ptr
  tail call void %.1050.i.i.c(ptr %.571, ptr %.847.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !65
  %.1081.i.i8938.c = load i64, ptr %arg.code.4, align 8, !noalias !65
  %.1197.i.i.c = inttoptr i64 %.1081.i.i8938.c to ptr
  tail call void %.1197.i.i.c(ptr %.571, ptr %.847.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1196.i.i), !noalias !65
  br label %B466.endif.endif.i.i

B466.endif.endif.i.i:                             ; preds = %B34.if.i316.i.i, %B466.endif.endif.i.i.critedge
  %.1264.i.i8939 = load i64, ptr %.937.i.i, align 8, !noalias !65
  %.1378.i.i = inttoptr i64 %.1264.i.i8939 to ptr
  tail call void %.1378.i.i(ptr %.571, ptr %.847.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !65
  br label %B1136.if.i.i

B1136.if.i.i:                                     ; preds = %B466.endif.endif.i.i, %B1134.i.loopexit.i
  %.1412.i.08192.i = phi i64 [ %.1482.i.i, %B1134.i.loopexit.i ], [ 0, %B466.endif.endif.i.i ]
  %.1482.i.i = add nsw i64 %.1412.i.08192.i, 1
  %.1559.i.i = getelementptr double, ptr %60, i64 %.1412.i.08192.i
  %.1560.i.i = load double, ptr %.1559.i.i, align 8, !noalias !65
  %.1561.i.i = fcmp ule double %.1560.i.i, 5.000000e-01
  %.1658.i8188.not.i = select i1 %.1561.i.i, i1 true, i1 %.287.i2218170.not.i
  br i1 %.1658.i8188.not.i, label %B1134.i.loopexit.i, label %B1222.if.i.lr.ph.i

B1222.if.i.lr.ph.i:                               ; preds = %B1136.if.i.i
  %gep8195.i = getelementptr double, ptr %55, i64 %.1412.i.08192.i
  %gep.i = getelementptr double, ptr %57, i64 %.1412.i.08192.i
  br label %B1222.if.i.i

B1222.if.i.i:                                     ; preds = %B1222.if.i.i, %B1222.if.i.lr.ph.i
  %.1602.i.08189.i = phi i64 [ 0, %B1222.if.i.lr.ph.i ], [ %.1671.i.i, %B1222.if.i.i ]
  %.1671.i.i = add nsw i64 %.1602.i.08189.i, 1
  %210 = mul nsw i64 %.1602.i.08189.i, %arg.shape.0
  %.1699.i.i = add nsw i64 %210, %.1412.i.08192.i
  %211 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1699.i.i
  %.1729.i.i = load double, ptr %211, align 8, !noalias !65
  %.1738.i.i = add nsw i64 %.1699.i.i, %factor.op.mul8197.i.reass
  %.1752.i.i = icmp slt i64 %.1738.i.i, 0
  %.1753.i.i = select i1 %.1752.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %212 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1738.i.i
  %.1767.i.i = getelementptr double, ptr %212, i64 %.1753.i.i
  %.1768.i.i = load double, ptr %.1767.i.i, align 8, !noalias !65
  %.1773.i.i = add nsw i64 %.1699.i.i, %factor.op.mul8196.i.reass
  %.1787.i.i = icmp slt i64 %.1773.i.i, 0
  %.1788.i.i = select i1 %.1787.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %213 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1773.i.i
  %.1802.i.i = getelementptr double, ptr %213, i64 %.1788.i.i
  %.1803.i.i = load double, ptr %.1802.i.i, align 8, !noalias !65
  %.1804.i.i = fsub double %.1768.i.i, %.1803.i.i
  %.1805.i.i = tail call double @llvm.fabs.f64(double %.1804.i.i)
  %.1856.i.i = load double, ptr %gep8195.i, align 8, !noalias !65
  %.1857.i.i = fmul double %.1856.i.i, %.1805.i.i
  %.1887.i.i = load double, ptr %.1886.i.i, align 8, !noalias !65
  %.1917.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !65
  %.1918.i.i = tail call double @llvm.fabs.f64(double %.1729.i.i)
  %.1919.i.i = fmul double %.1918.i.i, %.1917.i.i
  %.1920.i.i = fadd double %.1887.i.i, %.1919.i.i
  %.1924.i.i = fdiv double %.1857.i.i, %.1920.i.i
  %.1930.i.i = fsub double %.1924.i.i, %.1924.i.i
  %.1931.i.i = fcmp oeq double %.1930.i.i, 0.000000e+00
  %.1924.i..i = select i1 %.1931.i.i, double %.1924.i.i, double 0x7FF0000000000000
  %.1998.i.i = load double, ptr %gep.i, align 8, !noalias !65
  %.10.i.i.i8940 = fcmp ogt double %.1924.i..i, %.1998.i.i
  %.11.i.i.i8941 = select i1 %.10.i.i.i8940, double %.1924.i..i, double %.1998.i.i
  store double %.11.i.i.i8941, ptr %gep.i, align 8, !noalias !65
  %exitcond8389.not.i = icmp eq i64 %arg.shape.1, %.1671.i.i
  br i1 %exitcond8389.not.i, label %B1134.i.loopexit.i, label %B1222.if.i.i

B448.i:                                           ; preds = %B364.endif.i, %B678.endif.i
  %.932.sroa.0.08298.i = phi i1 [ true, %B678.endif.i ], [ false, %B364.endif.i ]
  %.889.18297.i = phi i64 [ %.889.1.i, %B678.endif.i ], [ 31, %B364.endif.i ]
  br i1 %.190.i9488214.i, label %B92.i.lr.ph.i, label %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B92.i.lr.ph.i:                                    ; preds = %B448.i
  %.472.i7978.i = select i1 %.932.sroa.0.08298.i, i64 28, i64 1
  %.474.i1514.i = mul i64 %.472.i7978.i, %arg.shape.6
  br label %B92.i.i

B92.i.i:                                          ; preds = %B925.i.i, %B92.i.lr.ph.i
  %.180.i826.sroa.0.08222.i = phi i64 [ 0, %B92.i.lr.ph.i ], [ %.180.i826.sroa.0.0.i, %B925.i.i ]
  %.134.i.18221.i = phi i64 [ %.134.i.18217.i, %B92.i.lr.ph.i ], [ %.134.i.1.i, %B925.i.i ]
  %.131.i824.18220.i = phi i64 [ %.203.i16108215.i, %B92.i.lr.ph.i ], [ %.131.i824.1.i, %B925.i.i ]
  %some.2.i818.08218.i = phi i1 [ false, %B92.i.lr.ph.i ], [ %some.3.i.1.i, %B925.i.i ]
  %.257.i980.i = icmp slt i64 %.180.i826.sroa.0.08222.i, 0
  %.258.i981.i = select i1 %.257.i980.i, i64 %arg.batch.4.1.5.1, i64 0
  %214 = getelementptr i64, ptr %56, i64 %.180.i826.sroa.0.08222.i
  %.280.i1000.i = getelementptr i64, ptr %214, i64 %.258.i981.i
  %.281.i.i = load i64, ptr %.280.i1000.i, align 8, !noalias !81
  %.282.i.i = icmp slt i64 %.281.i.i, 0
  br i1 %.282.i.i, label %B925.i.i, label %B142.i.i

B142.i.i:                                         ; preds = %B92.i.i
  %.311.i1015.i = select i1 %.257.i980.i, i64 %arg.batch.4.0.5.1, i64 0
  %.312.i1016.i = add i64 %.311.i1015.i, %.180.i826.sroa.0.08222.i
  %.333.i1034.i = getelementptr double, ptr %57, i64 %.312.i1016.i
  %.334.i1035.i = load double, ptr %.333.i1034.i, align 8, !noalias !81
  %.335.i1036.i = fcmp ogt double %.334.i1035.i, 1.000000e-01
  br i1 %.335.i1036.i, label %B925.i.i, label %B210.i.i

B210.i.i:                                         ; preds = %B142.i.i
  br i1 %.428.i10648201.not.i, label %B416.i.i, label %B240.if.i.i

B306.i.i:                                         ; preds = %B240.if.i.i
  %.476.i.i = add nsw i64 %.372.i835.08202.i, %.474.i1514.i
  %.478.i.i8934 = mul nsw i64 %.476.i.i, %arg.shape.0
  %.480.i.i8935 = add nsw i64 %.478.i.i8934, %.180.i826.sroa.0.08222.i
  %.504.i1551.i = icmp slt i64 %.480.i.i8935, 0
  %.505.i1552.i = select i1 %.504.i1551.i, i64 %arg.batch.5.4.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.480.i.i8935
  %.519.i1561.i = getelementptr double, ptr %215, i64 %.505.i1552.i
  %.520.i1562.i = load double, ptr %.519.i1561.i, align 8, !noalias !81
  %.525.i.i = add nsw i64 %.480.i.i8935, %.194.i.i739.i
  %.541.i.i = icmp slt i64 %.525.i.i, 0
  %.542.i.i = select i1 %.541.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %216 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.525.i.i
  %.556.i.i8936 = getelementptr double, ptr %216, i64 %.542.i.i
  %.557.i1582.i = load double, ptr %.556.i.i8936, align 8, !noalias !81
  %.558.i1583.i = fneg double %.557.i1582.i
  %.559.i1584.i = fcmp olt double %.520.i1562.i, %.558.i1583.i
  %217 = select i1 %.559.i1584.i, double -1.000000e+00, double 1.000000e+00
  br label %B354.i.i

B354.i.i:                                         ; preds = %B240.if.i.i, %B306.i.i
  %"$phi354.2.2.i.3.i" = phi double [ %217, %B306.i.i ], [ 1.000000e+00, %B240.if.i.i ]
  %.580.i1524.i = add nsw i64 %.372.i835.08202.i, %.578.i.i
  %.584.i1526.i = mul nsw i64 %.580.i1524.i, %arg.shape.0
  %.586.i.i = add nsw i64 %.584.i1526.i, %.180.i826.sroa.0.08222.i
  %.601.i1532.i = icmp slt i64 %.586.i.i, 0
  %.602.i.i = select i1 %.601.i1532.i, i64 %arg.batch.5.4.5.0, i64 0
  %218 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.586.i.i
  %.616.i1540.i = getelementptr double, ptr %218, i64 %.602.i.i
  store double %"$phi354.2.2.i.3.i", ptr %.616.i1540.i, align 8, !noalias !81
  %exitcond8391.not.i = icmp eq i64 %arg.shape.6, %.441.i1591.i
  br i1 %exitcond8391.not.i, label %B416.i.i, label %B240.if.i.i

B416.i.i:                                         ; preds = %B354.i.i, %B210.i.i
  br i1 %.932.sroa.0.08298.i, label %B438.i.i, label %B480.i.i

B438.i.i:                                         ; preds = %B416.i.i
  %.677.i.i = getelementptr double, ptr %59, i64 %.312.i1016.i
  %.678.i1506.i = load double, ptr %.677.i.i, align 8, !noalias !81
  br label %B480.i.i

B480.i.i:                                         ; preds = %B438.i.i, %B416.i.i
  %"$phi480.1.2.i.2.i" = phi double [ %.678.i1506.i, %B438.i.i ], [ 0.000000e+00, %B416.i.i ]
  br i1 %.428.i10648201.not.i, label %B562.i.i.preheader, label %B58.if.i.i.i

B58.if.i.i.i:                                     ; preds = %B480.i.i, %B58.if.i.i.i
  %least.2.i.i.08207.i = phi double [ %.11.i.i.i.i8932, %B58.if.i.i.i ], [ 0x7FF0000000000000, %B480.i.i ]
  %.54.i.i807.08205.i = phi i64 [ %.125.i.i1473.i, %B58.if.i.i.i ], [ 0, %B480.i.i ]
  %.125.i.i1473.i = add nsw i64 %.54.i.i807.08205.i, 1
  %.156.i.i1391.i = add nsw i64 %.54.i.i807.08205.i, %.474.i1514.i
  %.158.i.i1393.i = mul nsw i64 %.156.i.i1391.i, %arg.shape.0
  %.160.i.i1395.i = add nsw i64 %.158.i.i1393.i, %.180.i826.sroa.0.08222.i
  %.164.i.i1398.i = add nsw i64 %.54.i.i807.08205.i, %.578.i.i
  %.166.i.i1400.i = mul nsw i64 %.164.i.i1398.i, %arg.shape.0
  %.168.i.i1402.i = add nsw i64 %.166.i.i1400.i, %.180.i826.sroa.0.08222.i
  %.182.i.i1410.i = icmp slt i64 %.168.i.i1402.i, 0
  %.183.i.i1411.i = select i1 %.182.i.i1410.i, i64 %arg.batch.5.4.5.0, i64 0
  %219 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i.i1402.i
  %.197.i.i1420.i = getelementptr double, ptr %219, i64 %.183.i.i1411.i
  %.198.i.i1421.i = load double, ptr %.197.i.i1420.i, align 8, !noalias !85
  %.212.i.i1429.i = icmp slt i64 %.160.i.i1395.i, 0
  %.213.i.i.i = select i1 %.212.i.i1429.i, i64 %arg.batch.5.4.5.0, i64 0
  %220 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i1395.i
  %.227.i.i1438.i = getelementptr double, ptr %220, i64 %.213.i.i.i
  %.228.i.i1439.i = load double, ptr %.227.i.i1438.i, align 8, !noalias !85
  %.229.i.i1440.i = fmul double %.198.i.i1421.i, %.228.i.i1439.i
  %.233.i.i1444.i = add nsw i64 %.160.i.i1395.i, %.194.i.i739.i
  %.247.i.i1450.i = icmp slt i64 %.233.i.i1444.i, 0
  %.248.i.i1451.i = select i1 %.247.i.i1450.i, i64 %arg.batch.5.4.5.0, i64 0
  %221 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i.i1444.i
  %.262.i.i1461.i = getelementptr double, ptr %221, i64 %.248.i.i1451.i
  %.263.i.i1462.i = load double, ptr %.262.i.i1461.i, align 8, !noalias !85
  %.264.i.i1463.i = fadd double %.229.i.i1440.i, %.263.i.i1462.i
  %.10.i.i.i.i8931 = fcmp olt double %.264.i.i1463.i, %least.2.i.i.08207.i
  %.11.i.i.i.i8932 = select i1 %.10.i.i.i.i8931, double %.264.i.i1463.i, double %least.2.i.i.08207.i
  %exitcond8392.not.i = icmp eq i64 %arg.shape.6, %.125.i.i1473.i
  br i1 %exitcond8392.not.i, label %B562.i.i.preheader, label %B58.if.i.i.i

B562.i.i.preheader:                               ; preds = %B58.if.i.i.i, %B480.i.i
  %here.4.i.2.i.ph = phi double [ 0x7FF0000000000000, %B480.i.i ], [ %.11.i.i.i.i8932, %B58.if.i.i.i ]
  br label %B562.i.i

B562.i.i:                                         ; preds = %B562.i.i.preheader, %B676.i.i
  %look.2.i.2.i = phi i64 [ %.979.i1178.i, %B676.i.i ], [ 1, %B562.i.i.preheader ]
  %low.2.i.2.i = phi double [ %low.3.i.3.i, %B676.i.i ], [ %"$phi480.1.2.i.2.i", %B562.i.i.preheader ]
  %ahead.3.i.2.i = phi double [ %ahead.2.i.3.i, %B676.i.i ], [ 0.000000e+00, %B562.i.i.preheader ]
  %here.4.i.2.i = phi double [ %here.3.i.3.i, %B676.i.i ], [ %here.4.i.2.i.ph, %B562.i.i.preheader ]
  %222 = icmp ult i64 %look.2.i.2.i, 9
  br i1 %222, label %switch.lookup, label %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B58.if.i186.i.i:                                  ; preds = %B58.if.i186.i.lr.ph.i, %B58.if.i186.i.i
  %least.2.i16.i.08212.i = phi double [ 0x7FF0000000000000, %B58.if.i186.i.lr.ph.i ], [ %.11.i.i182.i.i, %B58.if.i186.i.i ]
  %.54.i20.i.08210.i = phi i64 [ 0, %B58.if.i186.i.lr.ph.i ], [ %.125.i192.i.i, %B58.if.i186.i.i ]
  %.125.i192.i.i = add nsw i64 %.54.i20.i.08210.i, 1
  %.156.i98.i.i = add nsw i64 %.54.i20.i.08210.i, %.155.i97.i.i
  %.158.i100.i.i = mul nsw i64 %.156.i98.i.i, %arg.shape.0
  %.160.i102.i.i = add nsw i64 %.158.i100.i.i, %.180.i826.sroa.0.08222.i
  %.164.i105.i.i = add nsw i64 %.54.i20.i.08210.i, %.578.i.i
  %.166.i107.i.i = mul nsw i64 %.164.i105.i.i, %arg.shape.0
  %.168.i109.i.i = add nsw i64 %.166.i107.i.i, %.180.i826.sroa.0.08222.i
  %.182.i117.i.i = icmp slt i64 %.168.i109.i.i, 0
  %.183.i118.i.i = select i1 %.182.i117.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %223 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i109.i.i
  %.197.i128.i.i = getelementptr double, ptr %223, i64 %.183.i118.i.i
  %.198.i129.i.i = load double, ptr %.197.i128.i.i, align 8, !noalias !89
  %.212.i137.i.i = icmp slt i64 %.160.i102.i.i, 0
  %.213.i138.i.i = select i1 %.212.i137.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %224 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i102.i.i
  %.227.i148.i.i = getelementptr double, ptr %224, i64 %.213.i138.i.i
  %.228.i149.i.i = load double, ptr %.227.i148.i.i, align 8, !noalias !89
  %.229.i150.i.i = fmul double %.198.i129.i.i, %.228.i149.i.i
  %.233.i154.i.i = add nsw i64 %.160.i102.i.i, %.194.i.i739.i
  %.247.i162.i.i = icmp slt i64 %.233.i154.i.i, 0
  %.248.i163.i.i = select i1 %.247.i162.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i154.i.i
  %.262.i173.i.i = getelementptr double, ptr %225, i64 %.248.i163.i.i
  %.263.i174.i.i = load double, ptr %.262.i173.i.i, align 8, !noalias !89
  %.264.i175.i.i = fadd double %.229.i150.i.i, %.263.i174.i.i
  %.10.i.i181.i.i = fcmp olt double %.264.i175.i.i, %least.2.i16.i.08212.i
  %.11.i.i182.i.i = select i1 %.10.i.i181.i.i, double %.264.i175.i.i, double %least.2.i16.i.08212.i
  %exitcond8393.not.i = icmp eq i64 %arg.shape.6, %.125.i192.i.i
  br i1 %exitcond8393.not.i, label %B596.endif.i.i, label %B58.if.i186.i.i

B646.i.i:                                         ; preds = %B596.endif.i.i
  switch i64 %look.2.i.2.i, label %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i [
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
  %.989.i1183.i = icmp eq i64 %look.2.i.2.i, 8
  %.979.i1178.i = add nsw i64 %look.2.i.2.i, 1
  %.1022.i1337.i = fcmp ult double %ahead.2.i.3.i, 0.000000e+00
  %or.cond.i = select i1 %.989.i1183.i, i1 true, i1 %.1022.i1337.i
  br i1 %or.cond.i, label %B720.i.i, label %B562.i.i

B720.i.i:                                         ; preds = %B676.i.i
  br i1 %.1022.i1337.i, label %switch.lookup9471, label %B768.i.i

switch.lookup9471:                                ; preds = %B720.i.i
  %switch.gep9472 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i.2.i
  %switch.load9473 = load double, ptr %switch.gep9472, align 8
  br label %B768.i.i

B768.i.i:                                         ; preds = %switch.lookup9471, %B720.i.i
  %"$phi768.2.2.i.2.i" = phi double [ %low.3.i.3.i, %B720.i.i ], [ %switch.load9473, %switch.lookup9471 ]
  %.1156.i1225.i = getelementptr double, ptr %58, i64 %.312.i1016.i
  store double %low.3.i.3.i, ptr %.1156.i1225.i, align 8, !noalias !81
  %.1210.i.i = getelementptr double, ptr %59, i64 %.312.i1016.i
  store double %"$phi768.2.2.i.2.i", ptr %.1210.i.i, align 8, !noalias !81
  %.1264.i1280.i = getelementptr double, ptr %61, i64 %.312.i1016.i
  store double %here.3.i.3.i, ptr %.1264.i1280.i, align 8, !noalias !81
  %.1320.i1312.i = getelementptr double, ptr %62, i64 %.312.i1016.i
  store double %ahead.2.i.3.i, ptr %.1320.i1312.i, align 8, !noalias !81
  %.1331.i.i = fcmp olt double %ahead.2.i.3.i, 0.000000e+00
  %spec.select8001.i = select i1 %some.2.i818.08218.i, i1 true, i1 %.1331.i.i
  br label %B925.i.i

B924.i.loopexit.i:                                ; preds = %B925.i.i
  %226 = xor i1 %some.3.i.1.i, true
  br label %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B925.i.i:                                         ; preds = %B768.i.i, %B142.i.i, %B92.i.i
  %some.3.i.1.i = phi i1 [ %spec.select8001.i, %B768.i.i ], [ %some.2.i818.08218.i, %B142.i.i ], [ %some.2.i818.08218.i, %B92.i.i ]
  %.190.i948.i = icmp sgt i64 %.134.i.18221.i, 0
  %.203.i1610.i = zext i1 %.190.i948.i to i64
  %.131.i824.1.i = add i64 %.131.i824.18220.i, %.203.i1610.i
  %.199.i1607.i = sext i1 %.190.i948.i to i64
  %.134.i.1.i = add nsw i64 %.134.i.18221.i, %.199.i1607.i
  %.180.i826.sroa.0.0.i = select i1 %.190.i948.i, i64 %.131.i824.18220.i, i64 0
  br i1 %.190.i948.i, label %B92.i.i, label %B924.i.loopexit.i

B240.if.i.i:                                      ; preds = %B210.i.i, %B354.i.i
  %.372.i835.08202.i = phi i64 [ %.441.i1591.i, %B354.i.i ], [ 0, %B210.i.i ]
  %.441.i1591.i = add nsw i64 %.372.i835.08202.i, 1
  br i1 %.932.sroa.0.08298.i, label %B306.i.i, label %B354.i.i

switch.lookup:                                    ; preds = %B562.i.i
  %switch.gep = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i.2.i
  %switch.load = load double, ptr %switch.gep, align 8
  %.864.i1169.i = fcmp ogt double %switch.load, %low.2.i.2.i
  br i1 %.864.i1169.i, label %B58.i66.i.preheader.i, label %B676.i.i

B58.i66.i.preheader.i:                            ; preds = %switch.lookup
  br i1 %.428.i10648201.not.i, label %B596.endif.i.i, label %B58.if.i186.i.lr.ph.i

B58.if.i186.i.lr.ph.i:                            ; preds = %B58.i66.i.preheader.i
  %.151.i93.i.i = mul nsw i64 %look.2.i.2.i, 3
  %.153.i95.i7891.i = add nsw i64 %.151.i93.i.i, 1
  %.155.i97.i.i = mul i64 %.153.i95.i7891.i, %arg.shape.6
  br label %B58.if.i186.i.i

B596.endif.i.i:                                   ; preds = %B58.if.i186.i.i, %B58.i66.i.preheader.i
  %least.2.i16.i.0.lcssa.i = phi double [ 0x7FF0000000000000, %B58.i66.i.preheader.i ], [ %.11.i.i182.i.i, %B58.if.i186.i.i ]
  %.915.i.i8933 = fcmp ult double %least.2.i16.i.0.lcssa.i, 0.000000e+00
  br i1 %.915.i.i8933, label %B676.i.i, label %B646.i.i

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

_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B646.i.i, %B562.i.i, %B924.i.loopexit.i, %B448.i
  %.190.i9488155.i = phi i1 [ false, %B924.i.loopexit.i ], [ false, %B448.i ], [ true, %B562.i.i ], [ true, %B646.i.i ]
  %.1001.0.i = phi i1 [ %226, %B924.i.loopexit.i ], [ true, %B448.i ], [ true, %B562.i.i ], [ true, %B646.i.i ]
  %.10251617.i = phi i32 [ 0, %B924.i.loopexit.i ], [ 0, %B448.i ], [ 1, %B562.i.i ], [ 1, %B646.i.i ]
  br i1 %.190.i9488155.i, label %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B492.endif.endif.i, !prof !93

B114.i.loopexit.i:                                ; preds = %B879.i.i
  %.219.i1836.i = icmp ne i64 %.163.i1730.18253.i, 0
  %227 = sub nsw i64 45, %.160.i1729.18252.i
  %.232.i2798.i = zext i1 %.219.i1836.i to i64
  %.160.i1729.1.i = add i64 %.160.i1729.18252.i, %.232.i2798.i
  %.228.i2795.i = sext i1 %.219.i1836.i to i64
  %.163.i1730.1.i = add nsw i64 %.163.i1730.18253.i, %.228.i2795.i
  %.209.i1732.sroa.0.0.i = select i1 %.219.i1836.i, i64 %227, i64 45
  br i1 %.219.i1836.i, label %B154.i.preheader.i, label %B596.if.i.preheader

B596.if.i.preheader:                              ; preds = %B326.i.i, %B114.i.loopexit.i
  br label %B596.if.i

B154.i.preheader.i:                               ; preds = %B154.i.preheader.i.preheader, %B114.i.loopexit.i
  %.209.i1732.sroa.0.08254.i = phi i64 [ %.209.i1732.sroa.0.0.i, %B114.i.loopexit.i ], [ 45, %B154.i.preheader.i.preheader ]
  %.163.i1730.18253.i = phi i64 [ %.163.i1730.1.i, %B114.i.loopexit.i ], [ 44, %B154.i.preheader.i.preheader ]
  %.160.i1729.18252.i = phi i64 [ %.160.i1729.1.i, %B114.i.loopexit.i ], [ 1, %B154.i.preheader.i.preheader ]
  %.108.not.i.i = icmp eq i64 %.209.i1732.sroa.0.08254.i, 0
  br label %B154.if.i.i

B154.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %B250.endif.i.i
  %exitcond8396.not.i = icmp eq i64 %arg.shape.0, %.356.i2784.i
  br i1 %exitcond8396.not.i, label %B326.i.i, label %B154.if.i.i

B162.i.i:                                         ; preds = %B154.if.i.i
  %.441.i2409.i = getelementptr double, ptr %59, i64 %.287.i1738.08232.i
  %.442.i2410.i = load double, ptr %.441.i2409.i, align 8, !noalias !94
  %.492.i2450.i = getelementptr double, ptr %58, i64 %.287.i1738.08232.i
  %.493.i2451.i = load double, ptr %.492.i2450.i, align 8, !noalias !94
  %.494.i2452.i = fsub double %.442.i2410.i, %.493.i2451.i
  %.496.i2454.i = fcmp ogt double %.494.i2452.i, 1.000000e-05
  br label %B250.i.i

B250.i.i:                                         ; preds = %B154.if.i.i, %B162.i.i
  %"$phi250.2.2.i.2.i" = phi i1 [ true, %B154.if.i.i ], [ %.496.i2454.i, %B162.i.i ]
  %.67.i.i2509.i = getelementptr double, ptr %58, i64 %.287.i1738.08232.i
  %.68.i.i2510.i = load double, ptr %.67.i.i2509.i, align 8, !noalias !98
  %.116.i.i.i = getelementptr double, ptr %59, i64 %.287.i1738.08232.i
  %.117.i.i2543.i = load double, ptr %.116.i.i.i, align 8, !noalias !98
  %.171.i.i.i = getelementptr double, ptr %61, i64 %.287.i1738.08232.i
  %.172.i.i2576.i = load double, ptr %.171.i.i.i, align 8, !noalias !98
  %.220.i.i2609.i = getelementptr double, ptr %62, i64 %.287.i1738.08232.i
  %.221.i.i2610.i = load double, ptr %.220.i.i2609.i, align 8, !noalias !98
  %.224.i.i2613.i = fadd double %.68.i.i2510.i, %.117.i.i2543.i
  %.225.i.i2614.i = fmul double %.224.i.i2613.i, 5.000000e-01
  br i1 %.108.not.i.i, label %B0.endif.i.i2628.i, label %B282.i.i

B282.i.i:                                         ; preds = %B250.i.i, %B282.i.i
  %r.2.0.i.i = phi double [ %r.3.1.i.i, %B282.i.i ], [ 1.000000e+00, %B250.i.i ]
  %a.1.2.0.i.i = phi double [ %.147.i8010.i, %B282.i.i ], [ 2.000000e+00, %B250.i.i ]
  %exp.4.0.i.i = phi i64 [ %.142.i.i, %B282.i.i ], [ %.209.i1732.sroa.0.08254.i, %B250.i.i ]
  %.122.i.i8914 = and i64 %exp.4.0.i.i, 1
  %.123.not.i.i = icmp eq i64 %.122.i.i8914, 0
  %.127.i.i = fmul double %r.2.0.i.i, %a.1.2.0.i.i
  %r.3.1.i.i = select i1 %.123.not.i.i, double %r.2.0.i.i, double %.127.i.i
  %.142.i.i = lshr i64 %exp.4.0.i.i, 1
  %.147.i8010.i = fmul double %a.1.2.0.i.i, %a.1.2.0.i.i
  %.150.not.i.i = icmp eq i64 %.142.i.i, 0
  br i1 %.150.not.i.i, label %B334.i8011.loopexit.i, label %B282.i.i

B334.i8011.loopexit.i:                            ; preds = %B282.i.i
  %228 = fmul double %r.3.1.i.i, 1.000000e-05
  br label %B0.endif.i.i2628.i

B494.i.i.i:                                       ; preds = %B0.endif.i.i2628.i
  %.10.i3.i.i.i = fcmp olt double %.261.i.i2634.i, 0.000000e+00
  %.11.i4.i.i.i = select i1 %.10.i3.i.i.i, double 0.000000e+00, double %.261.i.i2634.i
  %.420.i.i.i = fmul double %.316.i.i.i, %.11.i4.i.i.i
  %.424.i.i.i = fsub double %.225.i.i2614.i, %.420.i.i.i
  br label %B250.endif.i.i

B0.endif.i.i2628.i:                               ; preds = %B334.i8011.loopexit.i, %B250.i.i
  %r.4.1.i.i = phi double [ 1.000000e-05, %B250.i.i ], [ %228, %B334.i8011.loopexit.i ]
  %.259.i.i2632.i = fsub double %.117.i.i2543.i, %.68.i.i2510.i
  %.260.i.i2633.i = fsub double %r.4.1.i.i, %.259.i.i2632.i
  %.261.i.i2634.i = fmul double %.260.i.i2633.i, 5.000000e-01
  %.266.i.i2637.i = fmul double %.68.i.i2510.i, %.221.i.i2610.i
  %.268.i.i2639.i = fmul double %.117.i.i2543.i, %.172.i.i2576.i
  %.269.i.i2640.i = fsub double %.266.i.i2637.i, %.268.i.i2639.i
  %.270.i.i2641.i = fsub double %.221.i.i2610.i, %.172.i.i2576.i
  %.274.i.i2644.i = fdiv double %.269.i.i2640.i, %.270.i.i2641.i
  %.280.i.i2647.i = fcmp olt double %.68.i.i2510.i, %.274.i.i2644.i
  %.288.i.i2766.i = fcmp olt double %.274.i.i2644.i, %.117.i.i2543.i
  %or.cond8006.i = select i1 %.280.i.i2647.i, i1 %.288.i.i2766.i, i1 false
  %"$phi302.0.2.i.i.0.i" = select i1 %or.cond8006.i, double %.274.i.i2644.i, double %.225.i.i2614.i
  %.315.i.i.i = fsub double %.225.i.i2614.i, %"$phi302.0.2.i.i.0.i"
  %.316.i.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i.i.i)
  %.330.i.i.i = fmul double %.259.i.i2632.i, %.259.i.i2632.i
  %.333.i.i.i = tail call double @llvm.fabs.f64(double %.315.i.i.i)
  %.10.i.i.i2660.i = fcmp olt double %.333.i.i.i, %.330.i.i.i
  %.11.i.i.i2661.i = select i1 %.10.i.i.i2660.i, double %.333.i.i.i, double %.330.i.i.i
  %.363.i.i.i = fmul double %.316.i.i.i, %.11.i.i.i2661.i
  %.364.i.i.i = fadd double %"$phi302.0.2.i.i.0.i", %.363.i.i.i
  %.370.i.i.i = fsub double %.364.i.i.i, %.225.i.i2614.i
  %.371.i.i.i = tail call double @llvm.fabs.f64(double %.370.i.i.i)
  %.373.i.i.i = fcmp ugt double %.371.i.i.i, %.261.i.i2634.i
  br i1 %.373.i.i.i, label %B494.i.i.i, label %B250.endif.i.i

B326.i.i:                                         ; preds = %B154.i.loopexit.i
  br i1 %"$phi250.2.2.i.2.i", label %B336.i.i, label %B596.if.i.preheader

B336.i.i:                                         ; preds = %B326.i.i
  %.647.i1936.i = load i64, ptr %.646.i1935.i, align 8, !noalias !94
  %.763.i1998.i = inttoptr i64 %.647.i1936.i to ptr
  tail call void %.763.i1998.i(ptr %.571, ptr %.737.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.762.i.i), !noalias !94
  br label %B540.if.i.i

B634.i.i:                                         ; preds = %B540.if.i.i
  %.171.i135.i.i = getelementptr double, ptr %61, i64 %.789.i1762.08244.i
  %.172.i136.i.i = load double, ptr %.171.i135.i.i, align 8, !noalias !102
  %.220.i169.i.i = getelementptr double, ptr %62, i64 %.789.i1762.08244.i
  %.221.i170.i.i = load double, ptr %.220.i169.i.i, align 8, !noalias !102
  %.224.i173.i.i = fadd double %.936.i2079.i, %.987.i2115.i
  %.225.i174.i.i = fmul double %.224.i173.i.i, 5.000000e-01
  br i1 %.108.not.i.i, label %B0.endif.i188.i.i, label %B282.i8018.i

B282.i8018.i:                                     ; preds = %B634.i.i, %B282.i8018.i
  %r.2.0.i8019.i = phi double [ %r.3.1.i8025.i, %B282.i8018.i ], [ 1.000000e+00, %B634.i.i ]
  %a.1.2.0.i8020.i = phi double [ %.147.i8027.i, %B282.i8018.i ], [ 2.000000e+00, %B634.i.i ]
  %exp.4.0.i8021.i = phi i64 [ %.142.i8026.i, %B282.i8018.i ], [ %.209.i1732.sroa.0.08254.i, %B634.i.i ]
  %.122.i8022.i = and i64 %exp.4.0.i8021.i, 1
  %.123.not.i8023.i = icmp eq i64 %.122.i8022.i, 0
  %.127.i8024.i = fmul double %r.2.0.i8019.i, %a.1.2.0.i8020.i
  %r.3.1.i8025.i = select i1 %.123.not.i8023.i, double %r.2.0.i8019.i, double %.127.i8024.i
  %.142.i8026.i = lshr i64 %exp.4.0.i8021.i, 1
  %.147.i8027.i = fmul double %a.1.2.0.i8020.i, %a.1.2.0.i8020.i
  %.150.not.i8028.i = icmp eq i64 %.142.i8026.i, 0
  br i1 %.150.not.i8028.i, label %B334.i8029.loopexit.i, label %B282.i8018.i

B334.i8029.loopexit.i:                            ; preds = %B282.i8018.i
  %229 = fmul double %r.3.1.i8025.i, 1.000000e-05
  br label %B0.endif.i188.i.i

B494.i255.i.i:                                    ; preds = %B0.endif.i188.i.i
  %.10.i3.i262.i.i = fcmp olt double %.261.i194.i.i, 0.000000e+00
  %.11.i4.i263.i.i = select i1 %.10.i3.i262.i.i, double 0.000000e+00, double %.261.i194.i.i
  %.420.i268.i.i = fmul double %.316.i223.i.i, %.11.i4.i263.i.i
  %.424.i271.i.i = fsub double %.225.i174.i.i, %.420.i268.i.i
  br label %B634.endif.i.i

B0.endif.i188.i.i:                                ; preds = %B334.i8029.loopexit.i, %B634.i.i
  %r.4.1.i8030.i = phi double [ 1.000000e-05, %B634.i.i ], [ %229, %B334.i8029.loopexit.i ]
  %.260.i193.i.i = fsub double %r.4.1.i8030.i, %.988.i2116.i
  %.261.i194.i.i = fmul double %.260.i193.i.i, 5.000000e-01
  %.266.i197.i.i = fmul double %.987.i2115.i, %.221.i170.i.i
  %.268.i199.i.i = fmul double %.936.i2079.i, %.172.i136.i.i
  %.269.i200.i.i = fsub double %.266.i197.i.i, %.268.i199.i.i
  %.270.i201.i.i = fsub double %.221.i170.i.i, %.172.i136.i.i
  %.274.i204.i.i = fdiv double %.269.i200.i.i, %.270.i201.i.i
  %.280.i208.i.i = fcmp olt double %.987.i2115.i, %.274.i204.i.i
  %.288.i282.i.i = fcmp olt double %.274.i204.i.i, %.936.i2079.i
  %or.cond8007.i = and i1 %.280.i208.i.i, %.288.i282.i.i
  %"$phi302.0.2.i26.i.0.i" = select i1 %or.cond8007.i, double %.274.i204.i.i, double %.225.i174.i.i
  %.315.i222.i.i = fsub double %.225.i174.i.i, %"$phi302.0.2.i26.i.0.i"
  %.316.i223.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i222.i.i)
  %.330.i233.i.i = fmul double %.988.i2116.i, %.988.i2116.i
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
  store double %.997.i1769.0.i, ptr %.935.i.i, align 8, !noalias !94
  store double %least.2.i.i1621.0.lcssa.i, ptr %.220.i169.i.i, align 8, !noalias !94
  br label %B879.i.i

B802.i.i:                                         ; preds = %B634.endif.endif.i.i
  store double %.997.i1769.0.i, ptr %.986.i2114.i, align 8, !noalias !94
  store double %least.2.i.i1621.0.lcssa.i, ptr %.171.i135.i.i, align 8, !noalias !94
  br label %B879.i.i

B879.i.i:                                         ; preds = %B540.if.i.i, %B802.i.i, %B730.i.i
  %exitcond8398.not.i = icmp eq i64 %arg.shape.0, %.858.i2357.i
  br i1 %exitcond8398.not.i, label %B114.i.loopexit.i, label %B540.if.i.i

B154.if.i.i:                                      ; preds = %B154.i.loopexit.i, %B154.i.preheader.i
  %wide.2.i.18234.i = phi i1 [ false, %B154.i.preheader.i ], [ %"$phi250.2.2.i.2.i", %B154.i.loopexit.i ]
  %.287.i1738.08232.i = phi i64 [ 0, %B154.i.preheader.i ], [ %.356.i2784.i, %B154.i.loopexit.i ]
  %.356.i2784.i = add nsw i64 %.287.i1738.08232.i, 1
  br i1 %wide.2.i.18234.i, label %B250.i.i, label %B162.i.i

B250.endif.i.i:                                   ; preds = %B0.endif.i.i2628.i, %B494.i.i.i
  %.511.i1747.0.i = phi double [ %.364.i.i.i, %B0.endif.i.i2628.i ], [ %.424.i.i.i, %B494.i.i.i ]
  %.92.i352.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.287.i1738.08232.i
  %.93.i353.i.i = load double, ptr %.92.i352.i.i, align 8, !noalias !106
  %.146.i384.i.i = getelementptr double, ptr %55, i64 %.287.i1738.08232.i
  %.147.i385.i.i = load double, ptr %.146.i384.i.i, align 8, !noalias !106
  %.149.i387.i.i = fmul double %.511.i1747.0.i, %.147.i385.i.i
  %.150.i388.i.i = fadd double %.93.i353.i.i, %.149.i387.i.i
  %.203.i421.i.i = getelementptr double, ptr %.571, i64 %.287.i1738.08232.i
  store double %.150.i388.i.i, ptr %.203.i421.i.i, align 8, !noalias !106
  br i1 %.287.i2218170.not.i, label %B154.i.loopexit.i, label %B122.if.i.i.lr.ph.i

B122.if.i.i.lr.ph.i:                              ; preds = %B250.endif.i.i
  %.247.i.i.i.i = fsub double 1.000000e+00, %.511.i1747.0.i
  %invariant.gep9302 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9304 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9306 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9308 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9310 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9312 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9314 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9316 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  %invariant.gep9318 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1738.08232.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.lr.ph.i
  %.229.i313.i.08229.i = phi i64 [ 0, %B122.if.i.i.lr.ph.i ], [ %.300.i.i.i, %B122.if.i.i.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep9303 = getelementptr double, ptr %invariant.gep9302, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep9303, align 8, !noalias !110
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.511.i1747.0.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep9305 = getelementptr double, ptr %invariant.gep9304, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep9305, align 8, !noalias !110
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep9307 = getelementptr double, ptr %invariant.gep9306, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep9307, align 8, !noalias !110
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.511.i1747.0.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep9309 = getelementptr double, ptr %invariant.gep9308, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep9309, align 8, !noalias !110
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep9311 = getelementptr double, ptr %invariant.gep9310, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep9311, align 8, !noalias !110
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.511.i1747.0.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep9313 = getelementptr double, ptr %invariant.gep9312, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep9313, align 8, !noalias !110
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i313.i.08229.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep9315 = getelementptr double, ptr %invariant.gep9314, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep9315, align 8, !noalias !110
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.511.i1747.0.i, %.193.i.i.i.6.i
  %.300.i.i.i = add nsw i64 %.229.i313.i.08229.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i313.i.08229.i, %arg.shape.0
  %gep9317 = getelementptr double, ptr %invariant.gep9316, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep9317, align 8, !noalias !110
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i.i.i = add nsw i64 %.229.i313.i.08229.i, %.358.i355.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep9319 = getelementptr double, ptr %invariant.gep9318, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep9319, align 8, !noalias !106
  %exitcond8395.not.i = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond8395.not.i, label %B154.i.loopexit.i, label %B122.if.i.i.i

B540.if.i.i:                                      ; preds = %B879.i.i, %B336.i.i
  %.789.i1762.08244.i = phi i64 [ 0, %B336.i.i ], [ %.858.i2357.i, %B879.i.i ]
  %.858.i2357.i = add nsw i64 %.789.i1762.08244.i, 1
  %.935.i.i = getelementptr double, ptr %59, i64 %.789.i1762.08244.i
  %.936.i2079.i = load double, ptr %.935.i.i, align 8, !noalias !94
  %.986.i2114.i = getelementptr double, ptr %58, i64 %.789.i1762.08244.i
  %.987.i2115.i = load double, ptr %.986.i2114.i, align 8, !noalias !94
  %.988.i2116.i = fsub double %.936.i2079.i, %.987.i2115.i
  %.990.i.i8930 = fcmp ogt double %.988.i2116.i, 1.000000e-05
  br i1 %.990.i.i8930, label %B634.i.i, label %B879.i.i

B634.endif.i.i:                                   ; preds = %B0.endif.i188.i.i, %B494.i255.i.i
  %.997.i1769.0.i = phi double [ %.364.i247.i.i, %B0.endif.i188.i.i ], [ %.424.i271.i.i, %B494.i255.i.i ]
  br i1 %.428.i10648201.not.i, label %B634.endif.endif.i.i, label %B58.if.i.i2349.i.preheader

B58.if.i.i2349.i.preheader:                       ; preds = %B634.endif.i.i
  %invariant.gep9320 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.789.i1762.08244.i
  %invariant.gep9322 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.789.i1762.08244.i
  br label %B58.if.i.i2349.i

B58.if.i.i2349.i:                                 ; preds = %B58.if.i.i2349.i.preheader, %B58.if.i.i2349.i
  %least.2.i.i1621.08241.i = phi double [ %.11.i.i665.i.i, %B58.if.i.i2349.i ], [ 0x7FF0000000000000, %B58.if.i.i2349.i.preheader ]
  %.54.i.i1622.08239.i = phi i64 [ %.125.i675.i.i, %B58.if.i.i2349.i ], [ 0, %B58.if.i.i2349.i.preheader ]
  %.125.i675.i.i = add nsw i64 %.54.i.i1622.08239.i, 1
  %.156.i572.i.i = add nsw i64 %.54.i.i1622.08239.i, %.155.i571.i.i
  %.158.i574.i.i = mul nsw i64 %.156.i572.i.i, %arg.shape.0
  %.164.i578.i.i = add nsw i64 %.54.i.i1622.08239.i, %.578.i.i
  %.166.i580.i.i = mul nsw i64 %.164.i578.i.i, %arg.shape.0
  %gep9321 = getelementptr double, ptr %invariant.gep9320, i64 %.166.i580.i.i
  %.198.i608.i.i = load double, ptr %gep9321, align 8, !noalias !114
  %gep9323 = getelementptr double, ptr %invariant.gep9322, i64 %.158.i574.i.i
  %.228.i630.i.i = load double, ptr %gep9323, align 8, !noalias !114
  %.229.i631.i.i = fmul double %.198.i608.i.i, %.228.i630.i.i
  %230 = getelementptr double, ptr %gep9323, i64 %.194.i.i739.i
  %.263.i656.i.i = load double, ptr %230, align 8, !noalias !114
  %.264.i657.i.i = fadd double %.229.i631.i.i, %.263.i656.i.i
  %.10.i.i664.i.i = fcmp olt double %.264.i657.i.i, %least.2.i.i1621.08241.i
  %.11.i.i665.i.i = select i1 %.10.i.i664.i.i, double %.264.i657.i.i, double %least.2.i.i1621.08241.i
  %exitcond8397.not.i = icmp eq i64 %arg.shape.6, %.125.i675.i.i
  br i1 %exitcond8397.not.i, label %B634.endif.endif.i.i, label %B58.if.i.i2349.i

B634.endif.endif.i.i:                             ; preds = %B58.if.i.i2349.i, %B634.endif.i.i
  %least.2.i.i1621.0.lcssa.i = phi double [ 0x7FF0000000000000, %B634.endif.i.i ], [ %.11.i.i665.i.i, %B58.if.i.i2349.i ]
  %.1063.i2177.i = fcmp olt double %least.2.i.i1621.0.lcssa.i, 0.000000e+00
  br i1 %.1063.i2177.i, label %B730.i.i, label %B802.i.i

B596.loopexit.i:                                  ; preds = %B122.if.i.i, %B596.if.i
  %exitcond8401.not.i = icmp eq i64 %arg.shape.0, %.1226.i
  br i1 %exitcond8401.not.i, label %B678.i, label %B596.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.08259.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.08259.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9325 = getelementptr double, ptr %invariant.gep9324, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9325, align 8, !noalias !118
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.1301.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.08259.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9327 = getelementptr double, ptr %invariant.gep9326, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9327, align 8, !noalias !118
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.08259.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9329 = getelementptr double, ptr %invariant.gep9328, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9329, align 8, !noalias !118
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.1301.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.08259.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9331 = getelementptr double, ptr %invariant.gep9330, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9331, align 8, !noalias !118
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.08259.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9333 = getelementptr double, ptr %invariant.gep9332, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9333, align 8, !noalias !118
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.1301.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.08259.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9335 = getelementptr double, ptr %invariant.gep9334, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9335, align 8, !noalias !118
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.08259.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9337 = getelementptr double, ptr %invariant.gep9336, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9337, align 8, !noalias !118
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.1301.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.08259.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.08259.i, %arg.shape.0
  %gep9339 = getelementptr double, ptr %invariant.gep9338, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep9339, align 8, !noalias !118
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.359.i.i = add nsw i64 %.229.i.08259.i, %.358.i355.i
  %.361.i.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep9341 = getelementptr double, ptr %invariant.gep9340, i64 %.361.i.i
  store double %.313.i.i.i, ptr %gep9341, align 8, !noalias !125
  %exitcond8400.not.i = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond8400.not.i, label %B596.loopexit.i, label %B122.if.i.i

B678.i:                                           ; preds = %B596.loopexit.i
  %.1375.i = load i64, ptr %.646.i1935.i, align 8, !noalias !61
  %.1491.i = inttoptr i64 %.1375.i to ptr
  tail call void %.1491.i(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1490.i), !noalias !61
  br label %B88.if.i7139.i

B140.i7090.i:                                     ; preds = %B88.if.i7139.i
  %231 = getelementptr double, ptr %57, i64 %.203.i5331.08265.i
  %.408.i7136.i = load double, ptr %231, align 8, !noalias !126
  %.409.i7137.i = fcmp ugt double %.408.i7136.i, 1.000000e-01
  br i1 %.409.i7137.i, label %B334.i6744.i, label %B202.i6998.i

B202.i6998.i:                                     ; preds = %B140.i7090.i
  %.469.i7041.i = getelementptr double, ptr %58, i64 %.203.i5331.08265.i
  %.470.i7042.i = load double, ptr %.469.i7041.i, align 8, !noalias !126
  %.520.i7086.i = getelementptr double, ptr %59, i64 %.203.i5331.08265.i
  %.521.i7087.i = load double, ptr %.520.i7086.i, align 8, !noalias !126
  %.522.i7088.i = fcmp olt double %.470.i7042.i, %.521.i7087.i
  br i1 %.522.i7088.i, label %B34.i.i6869.i, label %B334.i6744.i

B34.i.i6869.i:                                    ; preds = %B202.i6998.i, %B34.if.i.i6983.i
  %.51.i.i5192.0.i = phi i64 [ %.122.i.i6989.i, %B34.if.i.i6983.i ], [ 0, %B202.i6998.i ]
  %exitcond8402.not.i = icmp eq i64 %.51.i.i5192.0.i, %storemerge7992.i
  br i1 %exitcond8402.not.i, label %B334.i6744.i, label %B34.if.i.i6983.i

B128.i.i6974.i:                                   ; preds = %B34.if.i.i6983.i
  %232 = icmp sgt i64 %.51.i.i5192.0.i, -1
  br label %B334.i6744.i

B34.if.i.i6983.i:                                 ; preds = %B34.i.i6869.i
  %.122.i.i6989.i = add i64 %.51.i.i5192.0.i, 1
  %.157.i.i6921.i = add nsw i64 %.51.i.i5192.0.i, %.155.i571.i.i
  %.159.i.i6923.i = mul nsw i64 %.157.i.i6921.i, %arg.shape.0
  %.161.i.i6925.i = add nsw i64 %.159.i.i6923.i, %.203.i5331.08265.i
  %.175.i.i6933.i = icmp slt i64 %.161.i.i6925.i, 0
  %.176.i.i6934.i = select i1 %.175.i.i6933.i, i64 %arg.batch.5.4.5.0, i64 0
  %233 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i6925.i
  %.190.i.i6944.i = getelementptr double, ptr %233, i64 %.176.i.i6934.i
  %.191.i.i6945.i = load double, ptr %.190.i.i6944.i, align 8, !noalias !130
  %.195.i.i6949.i = add nsw i64 %.161.i.i6925.i, %.194.i.i739.i
  %.209.i.i6957.i = icmp slt i64 %.195.i.i6949.i, 0
  %.210.i.i6958.i = select i1 %.209.i.i6957.i, i64 %arg.batch.5.4.5.0, i64 0
  %234 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i.i6949.i
  %.224.i.i6968.i = getelementptr double, ptr %234, i64 %.210.i.i6958.i
  %.225.i.i6969.i = load double, ptr %.224.i.i6968.i, align 8, !noalias !130
  %.226.i.i6970.i = fneg double %.225.i.i6969.i
  %.227.i.i6971.i = fcmp olt double %.191.i.i6945.i, %.226.i.i6970.i
  br i1 %.227.i.i6971.i, label %B128.i.i6974.i, label %B34.i.i6869.i

B334.i6744.i:                                     ; preds = %B34.i.i6869.i, %B88.if.i7139.i, %B128.i.i6974.i, %B202.i6998.i, %B140.i7090.i
  %"$phi334.1.2.i5347.1.i" = phi i1 [ false, %B140.i7090.i ], [ false, %B202.i6998.i ], [ false, %B88.if.i7139.i ], [ %232, %B128.i.i6974.i ], [ false, %B34.i.i6869.i ]
  %spec.select8002.i = or i1 %some.2.i5327.08267.i, %"$phi334.1.2.i5347.1.i"
  %"$phi352.2.2.i5352.1.i" = select i1 %"$phi334.1.2.i5347.1.i", double 1.000000e+00, double 0.000000e+00
  %235 = getelementptr double, ptr %60, i64 %.203.i5331.08265.i
  store double %"$phi352.2.2.i5352.1.i", ptr %235, align 8, !noalias !126
  %exitcond8403.not.i = icmp eq i64 %arg.shape.0, %.274.i7147.i
  br i1 %exitcond8403.not.i, label %B390.i5499.i, label %B88.if.i7139.i

B390.i5499.i:                                     ; preds = %B334.i6744.i
  br i1 %spec.select8002.i, label %B398.i5519.i, label %B678.endif.i

B398.i5519.i:                                     ; preds = %B390.i5499.i
  %.756.i5561.i = load i64, ptr %arg.code.4, align 8, !noalias !126
  %.872.i5637.i = inttoptr i64 %.756.i5561.i to ptr
  tail call void %.872.i5637.i(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.872.i.i), !noalias !126
  br i1 %.114.i40.i8180.not.i, label %B466.endif.endif.i6031.i.critedge, label %B34.if.i111.i6669.i

B34.if.i111.i6669.i:                              ; preds = %B398.i5519.i, %B34.if.i111.i6669.i
  %.56.i.i5171.08270.i = phi i64 [ %.127.i115.i6675.i, %B34.if.i111.i6669.i ], [ 0, %B398.i5519.i ]
  %.127.i115.i6675.i = add nsw i64 %.56.i.i5171.08270.i, 1
  %.153.i49.i6584.i = add nsw i64 %.56.i.i5171.08270.i, %factor.op.mul8291.i.reass
  %.167.i56.i6592.i = icmp slt i64 %.153.i49.i6584.i, 0
  %.168.i.i6593.i = select i1 %.167.i56.i6592.i, i64 %arg.batch.5.4.5.0, i64 0
  %236 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i49.i6584.i
  %.182.i.i6603.i = getelementptr double, ptr %236, i64 %.168.i.i6593.i
  %.183.i68.i6604.i = load double, ptr %.182.i.i6603.i, align 8, !noalias !134
  %.185.i70.i6606.i = add nsw i64 %.56.i.i5171.08270.i, %.878.i.i
  %.199.i.i6614.i = icmp slt i64 %.185.i70.i6606.i, 0
  %.200.i.i6615.i = select i1 %.199.i.i6614.i, i64 %arg.batch.5.1.5.0, i64 0
  %237 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i70.i6606.i
  %.214.i89.i6625.i = getelementptr double, ptr %237, i64 %.200.i.i6615.i
  %.215.i90.i6626.i = load double, ptr %.214.i89.i6625.i, align 8, !noalias !134
  store double %.183.i68.i6604.i, ptr %.214.i89.i6625.i, align 8, !noalias !134
  store double %.215.i90.i6626.i, ptr %.182.i.i6603.i, align 8, !noalias !134
  %exitcond8404.not.i = icmp eq i64 %.194.i.i739.i, %.127.i115.i6675.i
  br i1 %exitcond8404.not.i, label %B466.endif.i5739.i, label %B34.if.i111.i6669.i

B1134.i6137.loopexit.i:                           ; preds = %B1222.if.i6439.i, %B1136.if.i6451.i
  %exitcond8407.not.i = icmp eq i64 %arg.shape.0, %.1481.i6455.i
  br i1 %exitcond8407.not.i, label %B678.endif.i, label %B1136.if.i6451.i

B88.if.i7139.i:                                   ; preds = %B678.i, %B334.i6744.i
  %some.2.i5327.08267.i = phi i1 [ %spec.select8002.i, %B334.i6744.i ], [ false, %B678.i ]
  %.203.i5331.08265.i = phi i64 [ %.274.i7147.i, %B334.i6744.i ], [ 0, %B678.i ]
  %.274.i7147.i = add nsw i64 %.203.i5331.08265.i, 1
  %238 = getelementptr i64, ptr %56, i64 %.203.i5331.08265.i
  %.352.i6733.i = load i64, ptr %238, align 8, !noalias !126
  %.353.i6734.i = icmp sgt i64 %.352.i6733.i, -1
  br i1 %.353.i6734.i, label %B140.i7090.i, label %B334.i6744.i

B466.endif.i5739.i:                               ; preds = %B34.if.i111.i6669.i
  %.937.i5763.i = load i64, ptr %.937.i.i, align 8, !noalias !126
  %.1049.i5830.i = inttoptr i64 %.937.i5763.i to ptr
  tail call void %.1049.i5830.i(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  %.1080.i5852.i = load i64, ptr %arg.code.4, align 8, !noalias !126
  %.1196.i5926.i = inttoptr i64 %.1080.i5852.i to ptr
  tail call void %.1196.i5926.i(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1196.i.i), !noalias !126
  br label %B34.if.i316.i6558.i

B34.if.i316.i6558.i:                              ; preds = %B466.endif.i5739.i, %B34.if.i316.i6558.i
  %.56.i149.i5151.08273.i = phi i64 [ %.127.i324.i6564.i, %B34.if.i316.i6558.i ], [ 0, %B466.endif.i5739.i ]
  %.127.i324.i6564.i = add nsw i64 %.56.i149.i5151.08273.i, 1
  %.153.i217.i6473.i = add nsw i64 %.56.i149.i5151.08273.i, %factor.op.mul8291.i.reass
  %.167.i227.i6481.i = icmp slt i64 %.153.i217.i6473.i, 0
  %.168.i228.i6482.i = select i1 %.167.i227.i6481.i, i64 %arg.batch.5.4.5.0, i64 0
  %239 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i217.i6473.i
  %.182.i241.i6492.i = getelementptr double, ptr %239, i64 %.168.i228.i6482.i
  %.183.i242.i6493.i = load double, ptr %.182.i241.i6492.i, align 8, !noalias !138
  %.185.i244.i6495.i = add nsw i64 %.56.i149.i5151.08273.i, %.878.i.i
  %.199.i254.i6503.i = icmp slt i64 %.185.i244.i6495.i, 0
  %.200.i255.i6504.i = select i1 %.199.i254.i6503.i, i64 %arg.batch.5.1.5.0, i64 0
  %240 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i244.i6495.i
  %.214.i268.i6514.i = getelementptr double, ptr %240, i64 %.200.i255.i6504.i
  %.215.i269.i6515.i = load double, ptr %.214.i268.i6514.i, align 8, !noalias !138
  store double %.183.i242.i6493.i, ptr %.214.i268.i6514.i, align 8, !noalias !138
  store double %.215.i269.i6515.i, ptr %.182.i241.i6492.i, align 8, !noalias !138
  %exitcond8405.not.i = icmp eq i64 %.194.i.i739.i, %.127.i324.i6564.i
  br i1 %exitcond8405.not.i, label %B466.endif.endif.i6031.i, label %B34.if.i316.i6558.i

B466.endif.endif.i6031.i.critedge:                ; preds = %B398.i5519.i
  %.937.i5763.i.c = load i64, ptr %.937.i.i, align 8, !noalias !126
  %.1049.i5830.i.c = inttoptr i64 %.937.i5763.i.c to ptr
  tail call void %.1049.i5830.i.c(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  %.1080.i5852.i.c = load i64, ptr %arg.code.4, align 8, !noalias !126
  %.1196.i5926.i.c = inttoptr i64 %.1080.i5852.i.c to ptr
  tail call void %.1196.i5926.i.c(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1196.i.i), !noalias !126
  br label %B466.endif.endif.i6031.i

B466.endif.endif.i6031.i:                         ; preds = %B34.if.i316.i6558.i, %B466.endif.endif.i6031.i.critedge
  %.1263.i6056.i = load i64, ptr %.937.i.i, align 8, !noalias !126
  %.1377.i.i = inttoptr i64 %.1263.i6056.i to ptr
  tail call void %.1377.i.i(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  br label %B1136.if.i6451.i

B1136.if.i6451.i:                                 ; preds = %B466.endif.endif.i6031.i, %B1134.i6137.loopexit.i
  %.1411.i5397.08283.i = phi i64 [ %.1481.i6455.i, %B1134.i6137.loopexit.i ], [ 0, %B466.endif.endif.i6031.i ]
  %.1481.i6455.i = add nsw i64 %.1411.i5397.08283.i, 1
  %.1558.i6177.i = getelementptr double, ptr %60, i64 %.1411.i5397.08283.i
  %.1559.i6178.i = load double, ptr %.1558.i6177.i, align 8, !noalias !126
  %.1560.i6179.i = fcmp ule double %.1559.i6178.i, 5.000000e-01
  %.1657.i62058279.not.i = select i1 %.1560.i6179.i, i1 true, i1 %.287.i2218170.not.i
  br i1 %.1657.i62058279.not.i, label %B1134.i6137.loopexit.i, label %B1222.if.i6439.lr.ph.i

B1222.if.i6439.lr.ph.i:                           ; preds = %B1136.if.i6451.i
  %gep8286.i = getelementptr double, ptr %55, i64 %.1411.i5397.08283.i
  %gep8288.i = getelementptr double, ptr %57, i64 %.1411.i5397.08283.i
  br label %B1222.if.i6439.i

B1222.if.i6439.i:                                 ; preds = %B1222.if.i6439.i, %B1222.if.i6439.lr.ph.i
  %.1601.i5408.08280.i = phi i64 [ 0, %B1222.if.i6439.lr.ph.i ], [ %.1670.i6443.i, %B1222.if.i6439.i ]
  %.1670.i6443.i = add nsw i64 %.1601.i5408.08280.i, 1
  %241 = mul nsw i64 %.1601.i5408.08280.i, %arg.shape.0
  %.1698.i6214.i = add nsw i64 %241, %.1411.i5397.08283.i
  %242 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1698.i6214.i
  %.1728.i6233.i = load double, ptr %242, align 8, !noalias !126
  %.1737.i6242.i = add nsw i64 %.1698.i6214.i, %factor.op.mul8197.i.reass
  %.1751.i6249.i = icmp slt i64 %.1737.i6242.i, 0
  %.1752.i6250.i = select i1 %.1751.i6249.i, i64 %arg.batch.5.0.5.0, i64 0
  %243 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1737.i6242.i
  %.1766.i.i = getelementptr double, ptr %243, i64 %.1752.i6250.i
  %.1767.i6261.i = load double, ptr %.1766.i.i, align 8, !noalias !126
  %.1772.i6266.i = add nsw i64 %.1698.i6214.i, %factor.op.mul8196.i.reass
  %.1786.i6273.i = icmp slt i64 %.1772.i6266.i, 0
  %.1787.i6274.i = select i1 %.1786.i6273.i, i64 %arg.batch.5.0.5.0, i64 0
  %244 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1772.i6266.i
  %.1801.i.i = getelementptr double, ptr %244, i64 %.1787.i6274.i
  %.1802.i6285.i = load double, ptr %.1801.i.i, align 8, !noalias !126
  %.1803.i6286.i = fsub double %.1767.i6261.i, %.1802.i6285.i
  %.1804.i6287.i = tail call double @llvm.fabs.f64(double %.1803.i6286.i)
  %.1855.i6321.i = load double, ptr %gep8286.i, align 8, !noalias !126
  %.1856.i6322.i = fmul double %.1855.i6321.i, %.1804.i6287.i
  %.1886.i6338.i = load double, ptr %.1886.i.i, align 8, !noalias !126
  %.1916.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !126
  %.1917.i6353.i = tail call double @llvm.fabs.f64(double %.1728.i6233.i)
  %.1918.i6354.i = fmul double %.1917.i6353.i, %.1916.i.i
  %.1919.i6355.i = fadd double %.1886.i6338.i, %.1918.i6354.i
  %.1923.i.i = fdiv double %.1856.i6322.i, %.1919.i6355.i
  %.1929.i6359.i = fsub double %.1923.i.i, %.1923.i.i
  %.1930.i6360.i = fcmp oeq double %.1929.i6359.i, 0.000000e+00
  %.1923.i..i = select i1 %.1930.i6360.i, double %.1923.i.i, double 0x7FF0000000000000
  %.1997.i6396.i = load double, ptr %gep8288.i, align 8, !noalias !126
  %.10.i.i6401.i = fcmp ogt double %.1923.i..i, %.1997.i6396.i
  %.11.i.i6402.i = select i1 %.10.i.i6401.i, double %.1923.i..i, double %.1997.i6396.i
  store double %.11.i.i6402.i, ptr %gep8288.i, align 8, !noalias !126
  %exitcond8406.not.i = icmp eq i64 %arg.shape.1, %.1670.i6443.i
  br i1 %exitcond8406.not.i, label %B1134.i6137.loopexit.i, label %B1222.if.i6439.i

B904.i:                                           ; preds = %B678.endif.i, %B492.endif.endif.i
  br i1 %.190.i9488214.i, label %B92.i7411.i, label %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B92.i7411.i:                                      ; preds = %B904.i, %B925.i7952.i
  %.180.i7220.sroa.0.08320.i = phi i64 [ %.180.i7220.sroa.0.0.i, %B925.i7952.i ], [ 0, %B904.i ]
  %.134.i7217.18319.i = phi i64 [ %.134.i7217.1.i, %B925.i7952.i ], [ %.134.i7217.18315.i, %B904.i ]
  %.131.i7216.18318.i = phi i64 [ %.131.i7216.1.i, %B925.i7952.i ], [ 1, %B904.i ]
  %some.2.i7210.08316.i = phi i1 [ %some.3.i7228.1.i, %B925.i7952.i ], [ false, %B904.i ]
  %.257.i7436.i = icmp slt i64 %.180.i7220.sroa.0.08320.i, 0
  %.258.i7437.i = select i1 %.257.i7436.i, i64 %arg.batch.4.1.5.1, i64 0
  %245 = getelementptr i64, ptr %56, i64 %.180.i7220.sroa.0.08320.i
  %.280.i7458.i = getelementptr i64, ptr %245, i64 %.258.i7437.i
  %.281.i7459.i = load i64, ptr %.280.i7458.i, align 8, !noalias !142
  %.282.i7460.i = icmp slt i64 %.281.i7459.i, 0
  br i1 %.282.i7460.i, label %B925.i7952.i, label %B142.i7461.i

B142.i7461.i:                                     ; preds = %B92.i7411.i
  %.311.i7483.i = select i1 %.257.i7436.i, i64 %arg.batch.4.0.5.1, i64 0
  %.312.i7484.i = add i64 %.311.i7483.i, %.180.i7220.sroa.0.08320.i
  %.333.i7505.i = getelementptr double, ptr %57, i64 %.312.i7484.i
  %.334.i7506.i = load double, ptr %.333.i7505.i, align 8, !noalias !142
  %.335.i7507.i = fcmp ule double %.334.i7506.i, 1.000000e-01
  br i1 %.335.i7507.i, label %B925.i7952.i, label %B210.i7510.i

B210.i7510.i:                                     ; preds = %B142.i7461.i
  br i1 %.428.i10648201.not.i, label %B562.i7696.i.preheader, label %B240.if.i8322.i

B58.if.i.i8246.i:                                 ; preds = %B240.if.i8322.i, %B58.if.i.i8246.i
  %least.2.i.i7185.08305.i = phi double [ %.11.i.i.i8242.i, %B58.if.i.i8246.i ], [ 0x7FF0000000000000, %B240.if.i8322.i ]
  %.54.i.i7189.08303.i = phi i64 [ %.125.i.i8252.i, %B58.if.i.i8246.i ], [ 0, %B240.if.i8322.i ]
  %.125.i.i8252.i = add nsw i64 %.54.i.i7189.08303.i, 1
  %.156.i.i8158.i = add nsw i64 %.54.i.i7189.08303.i, %arg.shape.6
  %.158.i.i8160.i = mul nsw i64 %.156.i.i8158.i, %arg.shape.0
  %.160.i.i8162.i = add nsw i64 %.158.i.i8160.i, %.180.i7220.sroa.0.08320.i
  %.164.i.i8165.i = add nsw i64 %.54.i.i7189.08303.i, %.578.i.i
  %.166.i.i8167.i = mul nsw i64 %.164.i.i8165.i, %arg.shape.0
  %.168.i.i8169.i = add nsw i64 %.166.i.i8167.i, %.180.i7220.sroa.0.08320.i
  %.182.i.i8177.i = icmp slt i64 %.168.i.i8169.i, 0
  %.183.i.i8178.i = select i1 %.182.i.i8177.i, i64 %arg.batch.5.4.5.0, i64 0
  %246 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i.i8169.i
  %.197.i.i8188.i = getelementptr double, ptr %246, i64 %.183.i.i8178.i
  %.198.i.i8189.i = load double, ptr %.197.i.i8188.i, align 8, !noalias !146
  %.212.i.i8197.i = icmp slt i64 %.160.i.i8162.i, 0
  %.213.i.i8198.i = select i1 %.212.i.i8197.i, i64 %arg.batch.5.4.5.0, i64 0
  %247 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i8162.i
  %.227.i.i8208.i = getelementptr double, ptr %247, i64 %.213.i.i8198.i
  %.228.i.i8209.i = load double, ptr %.227.i.i8208.i, align 8, !noalias !146
  %.229.i.i8210.i = fmul double %.198.i.i8189.i, %.228.i.i8209.i
  %.233.i.i8214.i = add nsw i64 %.160.i.i8162.i, %.194.i.i739.i
  %.247.i.i8222.i = icmp slt i64 %.233.i.i8214.i, 0
  %.248.i.i8223.i = select i1 %.247.i.i8222.i, i64 %arg.batch.5.4.5.0, i64 0
  %248 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i.i8214.i
  %.262.i.i8233.i = getelementptr double, ptr %248, i64 %.248.i.i8223.i
  %.263.i.i8234.i = load double, ptr %.262.i.i8233.i, align 8, !noalias !146
  %.264.i.i8235.i = fadd double %.229.i.i8210.i, %.263.i.i8234.i
  %.10.i.i.i8241.i = fcmp olt double %.264.i.i8235.i, %least.2.i.i7185.08305.i
  %.11.i.i.i8242.i = select i1 %.10.i.i.i8241.i, double %.264.i.i8235.i, double %least.2.i.i7185.08305.i
  %exitcond8409.not.i = icmp eq i64 %arg.shape.6, %.125.i.i8252.i
  br i1 %exitcond8409.not.i, label %B562.i7696.i.preheader, label %B58.if.i.i8246.i

B562.i7696.i.preheader:                           ; preds = %B58.if.i.i8246.i, %B210.i7510.i
  %here.4.i7262.2.i.ph = phi double [ 0x7FF0000000000000, %B210.i7510.i ], [ %.11.i.i.i8242.i, %B58.if.i.i8246.i ]
  br label %B562.i7696.i

B562.i7696.i:                                     ; preds = %B562.i7696.i.preheader, %B676.i7713.i
  %here.4.i7262.2.i = phi double [ %here.3.i7266.3.i, %B676.i7713.i ], [ %here.4.i7262.2.i.ph, %B562.i7696.i.preheader ]
  %ahead.3.i7261.2.i = phi double [ %ahead.2.i7265.3.i, %B676.i7713.i ], [ 0.000000e+00, %B562.i7696.i.preheader ]
  %low.2.i7260.2.i = phi double [ %low.3.i7264.3.i, %B676.i7713.i ], [ 0.000000e+00, %B562.i7696.i.preheader ]
  %look.2.i7259.2.i = phi i64 [ %.977.i7724.i, %B676.i7713.i ], [ 1, %B562.i7696.i.preheader ]
  %249 = icmp ult i64 %look.2.i7259.2.i, 9
  br i1 %249, label %switch.lookup9474, label %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B58.if.i183.i.i:                                  ; preds = %B58.if.i183.i.lr.ph.i, %B58.if.i183.i.i
  %least.2.i16.i7162.08310.i = phi double [ 0x7FF0000000000000, %B58.if.i183.i.lr.ph.i ], [ %.11.i.i179.i.i, %B58.if.i183.i.i ]
  %.54.i20.i7166.08308.i = phi i64 [ 0, %B58.if.i183.i.lr.ph.i ], [ %.125.i189.i.i, %B58.if.i183.i.i ]
  %.125.i189.i.i = add nsw i64 %.54.i20.i7166.08308.i, 1
  %.156.i95.i.i = add nsw i64 %.54.i20.i7166.08308.i, %.155.i.i8132.i
  %.158.i97.i.i = mul nsw i64 %.156.i95.i.i, %arg.shape.0
  %.160.i99.i.i = add nsw i64 %.158.i97.i.i, %.180.i7220.sroa.0.08320.i
  %.164.i102.i.i = add nsw i64 %.54.i20.i7166.08308.i, %.578.i.i
  %.166.i104.i.i = mul nsw i64 %.164.i102.i.i, %arg.shape.0
  %.168.i106.i.i = add nsw i64 %.166.i104.i.i, %.180.i7220.sroa.0.08320.i
  %.182.i114.i.i = icmp slt i64 %.168.i106.i.i, 0
  %.183.i115.i.i = select i1 %.182.i114.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %250 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i106.i.i
  %.197.i125.i.i = getelementptr double, ptr %250, i64 %.183.i115.i.i
  %.198.i126.i.i = load double, ptr %.197.i125.i.i, align 8, !noalias !150
  %.212.i134.i.i = icmp slt i64 %.160.i99.i.i, 0
  %.213.i135.i.i = select i1 %.212.i134.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %251 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i99.i.i
  %.227.i145.i.i = getelementptr double, ptr %251, i64 %.213.i135.i.i
  %.228.i146.i.i = load double, ptr %.227.i145.i.i, align 8, !noalias !150
  %.229.i147.i.i = fmul double %.198.i126.i.i, %.228.i146.i.i
  %.233.i151.i.i = add nsw i64 %.160.i99.i.i, %.194.i.i739.i
  %.247.i159.i.i = icmp slt i64 %.233.i151.i.i, 0
  %.248.i160.i.i = select i1 %.247.i159.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %252 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i151.i.i
  %.262.i170.i.i = getelementptr double, ptr %252, i64 %.248.i160.i.i
  %.263.i171.i.i = load double, ptr %.262.i170.i.i, align 8, !noalias !150
  %.264.i172.i.i = fadd double %.229.i147.i.i, %.263.i171.i.i
  %.10.i.i178.i.i = fcmp olt double %.264.i172.i.i, %least.2.i16.i7162.08310.i
  %.11.i.i179.i.i = select i1 %.10.i.i178.i.i, double %.264.i172.i.i, double %least.2.i16.i7162.08310.i
  %exitcond8410.not.i = icmp eq i64 %arg.shape.6, %.125.i189.i.i
  br i1 %exitcond8410.not.i, label %B596.endif.i8090.i, label %B58.if.i183.i.i

B646.i8096.i:                                     ; preds = %B596.endif.i8090.i
  switch i64 %look.2.i7259.2.i, label %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i [
    i64 0, label %B676.i7713.i
    i64 6, label %switch.6.1.i8108.i
    i64 1, label %switch.1.1.i8113.i
    i64 8, label %switch.8.1.i8100.i
    i64 2, label %switch.2.1.i8112.i
    i64 5, label %switch.5.1.i8109.i
    i64 3, label %switch.3.1.i8111.i
    i64 7, label %switch.7.1.i8107.i
    i64 4, label %switch.4.1.i8110.i
  ]

B676.i7713.i:                                     ; preds = %switch.8.1.i8100.i, %switch.7.1.i8107.i, %switch.6.1.i8108.i, %switch.5.1.i8109.i, %switch.4.1.i8110.i, %switch.3.1.i8111.i, %switch.2.1.i8112.i, %switch.1.1.i8113.i, %B596.endif.i8090.i, %switch.lookup9474, %B646.i8096.i
  %here.3.i7266.3.i = phi double [ %here.4.i7262.2.i, %switch.lookup9474 ], [ %here.4.i7262.2.i, %B596.endif.i8090.i ], [ %least.2.i16.i7162.0.lcssa.i, %B646.i8096.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.8.1.i8100.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.7.1.i8107.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.6.1.i8108.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.5.1.i8109.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.4.1.i8110.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.3.1.i8111.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.2.1.i8112.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.1.1.i8113.i ]
  %ahead.2.i7265.3.i = phi double [ %ahead.3.i7261.2.i, %switch.lookup9474 ], [ %least.2.i16.i7162.0.lcssa.i, %B596.endif.i8090.i ], [ %least.2.i16.i7162.0.lcssa.i, %B646.i8096.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.8.1.i8100.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.7.1.i8107.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.6.1.i8108.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.5.1.i8109.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.4.1.i8110.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.3.1.i8111.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.2.1.i8112.i ], [ %least.2.i16.i7162.0.lcssa.i, %switch.1.1.i8113.i ]
  %low.3.i7264.3.i = phi double [ %low.2.i7260.2.i, %switch.lookup9474 ], [ %low.2.i7260.2.i, %B596.endif.i8090.i ], [ 0.000000e+00, %B646.i8096.i ], [ 1.000000e+00, %switch.8.1.i8100.i ], [ 8.889000e-01, %switch.7.1.i8107.i ], [ 7.500000e-01, %switch.6.1.i8108.i ], [ 0x3FE50A3D70A3D70A, %switch.5.1.i8109.i ], [ 5.000000e-01, %switch.4.1.i8110.i ], [ 3.333000e-01, %switch.3.1.i8111.i ], [ 2.500000e-01, %switch.2.1.i8112.i ], [ 0x3FB48E8A71DE69AD, %switch.1.1.i8113.i ]
  %.987.i7730.i = icmp eq i64 %look.2.i7259.2.i, 8
  %.977.i7724.i = add nsw i64 %look.2.i7259.2.i, 1
  %.1020.i.i = fcmp ult double %ahead.2.i7265.3.i, 0.000000e+00
  %or.cond8004.i = select i1 %.987.i7730.i, i1 true, i1 %.1020.i.i
  br i1 %or.cond8004.i, label %B720.i7731.i, label %B562.i7696.i

B720.i7731.i:                                     ; preds = %B676.i7713.i
  br i1 %.1020.i.i, label %switch.lookup9477, label %B768.i7754.i

switch.lookup9477:                                ; preds = %B720.i7731.i
  %switch.gep9478 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i7259.2.i
  %switch.load9479 = load double, ptr %switch.gep9478, align 8
  br label %B768.i7754.i

B768.i7754.i:                                     ; preds = %switch.lookup9477, %B720.i7731.i
  %"$phi768.2.2.i7272.2.i" = phi double [ %low.3.i7264.3.i, %B720.i7731.i ], [ %switch.load9479, %switch.lookup9477 ]
  %.1154.i7800.i = getelementptr double, ptr %58, i64 %.312.i7484.i
  store double %low.3.i7264.3.i, ptr %.1154.i7800.i, align 8, !noalias !142
  %.1208.i7847.i = getelementptr double, ptr %59, i64 %.312.i7484.i
  store double %"$phi768.2.2.i7272.2.i", ptr %.1208.i7847.i, align 8, !noalias !142
  %.1262.i7894.i = getelementptr double, ptr %61, i64 %.312.i7484.i
  store double %here.3.i7266.3.i, ptr %.1262.i7894.i, align 8, !noalias !142
  %.1318.i.i = getelementptr double, ptr %62, i64 %.312.i7484.i
  store double %ahead.2.i7265.3.i, ptr %.1318.i.i, align 8, !noalias !142
  %.1329.i7944.i = fcmp olt double %ahead.2.i7265.3.i, 0.000000e+00
  %spec.select8005.i = select i1 %some.2.i7210.08316.i, i1 true, i1 %.1329.i7944.i
  br label %B925.i7952.i

B924.i7398.loopexit.i:                            ; preds = %B925.i7952.i
  %253 = xor i1 %some.3.i7228.1.i, true
  br label %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B925.i7952.i:                                     ; preds = %B768.i7754.i, %B142.i7461.i, %B92.i7411.i
  %some.3.i7228.1.i = phi i1 [ %spec.select8005.i, %B768.i7754.i ], [ %some.2.i7210.08316.i, %B142.i7461.i ], [ %some.2.i7210.08316.i, %B92.i7411.i ]
  %.190.i7389.i = icmp sgt i64 %.134.i7217.18319.i, 0
  %.203.i8353.i = zext i1 %.190.i7389.i to i64
  %.131.i7216.1.i = add i64 %.131.i7216.18318.i, %.203.i8353.i
  %.199.i8350.i = sext i1 %.190.i7389.i to i64
  %.134.i7217.1.i = add nsw i64 %.134.i7217.18319.i, %.199.i8350.i
  %.180.i7220.sroa.0.0.i = select i1 %.190.i7389.i, i64 %.131.i7216.18318.i, i64 0
  br i1 %.190.i7389.i, label %B92.i7411.i, label %B924.i7398.loopexit.i

B240.if.i8322.i:                                  ; preds = %B210.i7510.i, %B240.if.i8322.i
  %.372.i7232.08300.i = phi i64 [ %.441.i8330.i, %B240.if.i8322.i ], [ 0, %B210.i7510.i ]
  %.441.i8330.i = add nsw i64 %.372.i7232.08300.i, 1
  %.579.i8288.i = add nsw i64 %.372.i7232.08300.i, %.578.i.i
  %.583.i8291.i = mul nsw i64 %.579.i8288.i, %arg.shape.0
  %.585.i8293.i = add nsw i64 %.583.i8291.i, %.180.i7220.sroa.0.08320.i
  %.600.i8303.i = icmp slt i64 %.585.i8293.i, 0
  %.601.i8304.i = select i1 %.600.i8303.i, i64 %arg.batch.5.4.5.0, i64 0
  %254 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.585.i8293.i
  %.615.i8318.i = getelementptr double, ptr %254, i64 %.601.i8304.i
  store double 1.000000e+00, ptr %.615.i8318.i, align 8, !noalias !142
  %exitcond8408.not.i = icmp eq i64 %arg.shape.6, %.441.i8330.i
  br i1 %exitcond8408.not.i, label %B58.if.i.i8246.i, label %B240.if.i8322.i

switch.lookup9474:                                ; preds = %B562.i7696.i
  %switch.gep9475 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i7259.2.i
  %switch.load9476 = load double, ptr %switch.gep9475, align 8
  %.862.i.i = fcmp ogt double %switch.load9476, %low.2.i7260.2.i
  br i1 %.862.i.i, label %B58.i66.i8058.preheader.i, label %B676.i7713.i

B58.i66.i8058.preheader.i:                        ; preds = %switch.lookup9474
  br i1 %.428.i10648201.not.i, label %B596.endif.i8090.i, label %B58.if.i183.i.lr.ph.i

B58.if.i183.i.lr.ph.i:                            ; preds = %B58.i66.i8058.preheader.i
  %.151.i.i8130.i = mul nsw i64 %look.2.i7259.2.i, 3
  %.153.i.i81317902.i = add nsw i64 %.151.i.i8130.i, 1
  %.155.i.i8132.i = mul i64 %.153.i.i81317902.i, %arg.shape.6
  br label %B58.if.i183.i.i

B596.endif.i8090.i:                               ; preds = %B58.if.i183.i.i, %B58.i66.i8058.preheader.i
  %least.2.i16.i7162.0.lcssa.i = phi double [ 0x7FF0000000000000, %B58.i66.i8058.preheader.i ], [ %.11.i.i179.i.i, %B58.if.i183.i.i ]
  %.913.i8095.i = fcmp ult double %least.2.i16.i7162.0.lcssa.i, 0.000000e+00
  br i1 %.913.i8095.i, label %B676.i7713.i, label %B646.i8096.i

switch.1.1.i8113.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.2.1.i8112.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.3.1.i8111.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.4.1.i8110.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.5.1.i8109.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.6.1.i8108.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.7.1.i8107.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

switch.8.1.i8100.i:                               ; preds = %B646.i8096.i
  br label %B676.i7713.i

_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B646.i8096.i, %B562.i7696.i, %B924.i7398.loopexit.i, %B904.i
  %.190.i73898149.i = phi i1 [ false, %B924.i7398.loopexit.i ], [ false, %B904.i ], [ true, %B562.i7696.i ], [ true, %B646.i8096.i ]
  %.1580.0.i = phi i1 [ %253, %B924.i7398.loopexit.i ], [ true, %B904.i ], [ true, %B562.i7696.i ], [ true, %B646.i8096.i ]
  %excinfo.7.6.i = phi ptr [ null, %B924.i7398.loopexit.i ], [ null, %B904.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53, %B562.i7696.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53, %B646.i8096.i ]
  %.16048364.i = phi i32 [ 0, %B924.i7398.loopexit.i ], [ 0, %B904.i ], [ 1, %B562.i7696.i ], [ 1, %B646.i8096.i ]
  br i1 %.190.i73898149.i, label %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B904.endif.endif.i, !prof !93

B114.i3132.loopexit.i:                            ; preds = %B879.i3486.i
  %.219.i3137.i = icmp ne i64 %.163.i3013.18351.i, 0
  %255 = sub nsw i64 45, %.160.i3012.18350.i
  %.232.i5132.i = zext i1 %.219.i3137.i to i64
  %.160.i3012.1.i = add i64 %.160.i3012.18350.i, %.232.i5132.i
  %.228.i5129.i = sext i1 %.219.i3137.i to i64
  %.163.i3013.1.i = add nsw i64 %.163.i3013.18351.i, %.228.i5129.i
  %.209.i3016.sroa.0.0.i = select i1 %.219.i3137.i, i64 %255, i64 45
  br i1 %.219.i3137.i, label %B154.i3199.preheader.i, label %B996.i

B154.i3199.preheader.i:                           ; preds = %B154.i3199.preheader.i.preheader, %B114.i3132.loopexit.i
  %.209.i3016.sroa.0.08352.i = phi i64 [ %.209.i3016.sroa.0.0.i, %B114.i3132.loopexit.i ], [ 45, %B154.i3199.preheader.i.preheader ]
  %.163.i3013.18351.i = phi i64 [ %.163.i3013.1.i, %B114.i3132.loopexit.i ], [ 44, %B154.i3199.preheader.i.preheader ]
  %.160.i3012.18350.i = phi i64 [ %.160.i3012.1.i, %B114.i3132.loopexit.i ], [ 1, %B154.i3199.preheader.i.preheader ]
  %.108.not.i8046.i = icmp eq i64 %.209.i3016.sroa.0.08352.i, 0
  br label %B154.if.i5107.i

B154.i3199.loopexit.i:                            ; preds = %B122.if.i.i5062.i, %B250.endif.i4600.i
  %exitcond8413.not.i = icmp eq i64 %arg.shape.0, %.356.i5115.i
  br i1 %exitcond8413.not.i, label %B326.i3213.i, label %B154.if.i5107.i

B162.i4221.i:                                     ; preds = %B154.if.i5107.i
  %.441.i4265.i = getelementptr double, ptr %59, i64 %.287.i3026.08330.i
  %.442.i4266.i = load double, ptr %.441.i4265.i, align 8, !noalias !154
  %.492.i4310.i = getelementptr double, ptr %58, i64 %.287.i3026.08330.i
  %.493.i4311.i = load double, ptr %.492.i4310.i, align 8, !noalias !154
  %.494.i4312.i = fsub double %.442.i4266.i, %.493.i4311.i
  %.496.i4314.i = fcmp ogt double %.494.i4312.i, 1.000000e-13
  br label %B250.i4316.i

B250.i4316.i:                                     ; preds = %B154.if.i5107.i, %B162.i4221.i
  %"$phi250.2.2.i3035.2.i" = phi i1 [ true, %B154.if.i5107.i ], [ %.496.i4314.i, %B162.i4221.i ]
  %.67.i.i4380.i = getelementptr double, ptr %58, i64 %.287.i3026.08330.i
  %.68.i.i4381.i = load double, ptr %.67.i.i4380.i, align 8, !noalias !158
  %.116.i.i4414.i = getelementptr double, ptr %59, i64 %.287.i3026.08330.i
  %.117.i.i4415.i = load double, ptr %.116.i.i4414.i, align 8, !noalias !158
  %.171.i.i4450.i = getelementptr double, ptr %61, i64 %.287.i3026.08330.i
  %.172.i.i4451.i = load double, ptr %.171.i.i4450.i, align 8, !noalias !158
  %.220.i.i4484.i = getelementptr double, ptr %62, i64 %.287.i3026.08330.i
  %.221.i.i4485.i = load double, ptr %.220.i.i4484.i, align 8, !noalias !158
  %.224.i.i4488.i = fadd double %.68.i.i4381.i, %.117.i.i4415.i
  %.225.i.i4489.i = fmul double %.224.i.i4488.i, 5.000000e-01
  br i1 %.108.not.i8046.i, label %B0.endif.i.i4503.i, label %B282.i8047.i

B282.i8047.i:                                     ; preds = %B250.i4316.i, %B282.i8047.i
  %r.2.0.i8048.i = phi double [ %r.3.1.i8054.i, %B282.i8047.i ], [ 1.000000e+00, %B250.i4316.i ]
  %a.1.2.0.i8049.i = phi double [ %.147.i8056.i, %B282.i8047.i ], [ 2.000000e+00, %B250.i4316.i ]
  %exp.4.0.i8050.i = phi i64 [ %.142.i8055.i, %B282.i8047.i ], [ %.209.i3016.sroa.0.08352.i, %B250.i4316.i ]
  %.122.i8051.i = and i64 %exp.4.0.i8050.i, 1
  %.123.not.i8052.i = icmp eq i64 %.122.i8051.i, 0
  %.127.i8053.i = fmul double %r.2.0.i8048.i, %a.1.2.0.i8049.i
  %r.3.1.i8054.i = select i1 %.123.not.i8052.i, double %r.2.0.i8048.i, double %.127.i8053.i
  %.142.i8055.i = lshr i64 %exp.4.0.i8050.i, 1
  %.147.i8056.i = fmul double %a.1.2.0.i8049.i, %a.1.2.0.i8049.i
  %.150.not.i8057.i = icmp eq i64 %.142.i8055.i, 0
  br i1 %.150.not.i8057.i, label %B334.i8058.loopexit.i, label %B282.i8047.i

B334.i8058.loopexit.i:                            ; preds = %B282.i8047.i
  %256 = fmul double %r.3.1.i8054.i, 1.000000e-13
  br label %B0.endif.i.i4503.i

B494.i.i4570.i:                                   ; preds = %B0.endif.i.i4503.i
  %.10.i3.i.i4577.i = fcmp olt double %.261.i.i4509.i, 0.000000e+00
  %.11.i4.i.i4578.i = select i1 %.10.i3.i.i4577.i, double 0.000000e+00, double %.261.i.i4509.i
  %.420.i.i4583.i = fmul double %.316.i.i4538.i, %.11.i4.i.i4578.i
  %.424.i.i4586.i = fsub double %.225.i.i4489.i, %.420.i.i4583.i
  br label %B250.endif.i4600.i

B0.endif.i.i4503.i:                               ; preds = %B334.i8058.loopexit.i, %B250.i4316.i
  %r.4.1.i8059.i = phi double [ 1.000000e-13, %B250.i4316.i ], [ %256, %B334.i8058.loopexit.i ]
  %.259.i.i4507.i = fsub double %.117.i.i4415.i, %.68.i.i4381.i
  %.260.i.i4508.i = fsub double %r.4.1.i8059.i, %.259.i.i4507.i
  %.261.i.i4509.i = fmul double %.260.i.i4508.i, 5.000000e-01
  %.266.i.i4512.i = fmul double %.68.i.i4381.i, %.221.i.i4485.i
  %.268.i.i4514.i = fmul double %.117.i.i4415.i, %.172.i.i4451.i
  %.269.i.i4515.i = fsub double %.266.i.i4512.i, %.268.i.i4514.i
  %.270.i.i4516.i = fsub double %.221.i.i4485.i, %.172.i.i4451.i
  %.274.i.i4519.i = fdiv double %.269.i.i4515.i, %.270.i.i4516.i
  %.280.i.i4523.i = fcmp olt double %.68.i.i4381.i, %.274.i.i4519.i
  %.288.i.i5093.i = fcmp olt double %.274.i.i4519.i, %.117.i.i4415.i
  %or.cond8008.i = select i1 %.280.i.i4523.i, i1 %.288.i.i5093.i, i1 false
  %"$phi302.0.2.i.i2914.0.i" = select i1 %or.cond8008.i, double %.274.i.i4519.i, double %.225.i.i4489.i
  %.315.i.i4537.i = fsub double %.225.i.i4489.i, %"$phi302.0.2.i.i2914.0.i"
  %.316.i.i4538.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i.i4537.i)
  %.330.i.i4548.i = fmul double %.259.i.i4507.i, %.259.i.i4507.i
  %.333.i.i4551.i = tail call double @llvm.fabs.f64(double %.315.i.i4537.i)
  %.10.i.i.i4556.i = fcmp olt double %.333.i.i4551.i, %.330.i.i4548.i
  %.11.i.i.i4557.i = select i1 %.10.i.i.i4556.i, double %.333.i.i4551.i, double %.330.i.i4548.i
  %.363.i.i4561.i = fmul double %.316.i.i4538.i, %.11.i.i.i4557.i
  %.364.i.i4562.i = fadd double %"$phi302.0.2.i.i2914.0.i", %.363.i.i4561.i
  %.370.i.i4566.i = fsub double %.364.i.i4562.i, %.225.i.i4489.i
  %.371.i.i4567.i = tail call double @llvm.fabs.f64(double %.370.i.i4566.i)
  %.373.i.i4569.i = fcmp ugt double %.371.i.i4567.i, %.261.i.i4509.i
  br i1 %.373.i.i4569.i, label %B494.i.i4570.i, label %B250.endif.i4600.i

B326.i3213.i:                                     ; preds = %B154.i3199.loopexit.i
  br i1 %"$phi250.2.2.i3035.2.i", label %B336.i3232.i, label %B996.i

B336.i3232.i:                                     ; preds = %B326.i3213.i
  %.647.i3260.i = load i64, ptr %.646.i1935.i, align 8, !noalias !154
  %.763.i3336.i = inttoptr i64 %.647.i3260.i to ptr
  tail call void %.763.i3336.i(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1490.i), !noalias !154
  br label %B540.if.i4196.i

B634.i3487.i:                                     ; preds = %B540.if.i4196.i
  %.171.i135.i3617.i = getelementptr double, ptr %61, i64 %.789.i3054.08342.i
  %.172.i136.i3618.i = load double, ptr %.171.i135.i3617.i, align 8, !noalias !162
  %.220.i169.i3651.i = getelementptr double, ptr %62, i64 %.789.i3054.08342.i
  %.221.i170.i3652.i = load double, ptr %.220.i169.i3651.i, align 8, !noalias !162
  %.224.i173.i3655.i = fadd double %.936.i3436.i, %.987.i3480.i
  %.225.i174.i3656.i = fmul double %.224.i173.i3655.i, 5.000000e-01
  br i1 %.108.not.i8046.i, label %B0.endif.i188.i3670.i, label %B282.i8076.i

B282.i8076.i:                                     ; preds = %B634.i3487.i, %B282.i8076.i
  %r.2.0.i8077.i = phi double [ %r.3.1.i8083.i, %B282.i8076.i ], [ 1.000000e+00, %B634.i3487.i ]
  %a.1.2.0.i8078.i = phi double [ %.147.i8085.i, %B282.i8076.i ], [ 2.000000e+00, %B634.i3487.i ]
  %exp.4.0.i8079.i = phi i64 [ %.142.i8084.i, %B282.i8076.i ], [ %.209.i3016.sroa.0.08352.i, %B634.i3487.i ]
  %.122.i8080.i = and i64 %exp.4.0.i8079.i, 1
  %.123.not.i8081.i = icmp eq i64 %.122.i8080.i, 0
  %.127.i8082.i = fmul double %r.2.0.i8077.i, %a.1.2.0.i8078.i
  %r.3.1.i8083.i = select i1 %.123.not.i8081.i, double %r.2.0.i8077.i, double %.127.i8082.i
  %.142.i8084.i = lshr i64 %exp.4.0.i8079.i, 1
  %.147.i8085.i = fmul double %a.1.2.0.i8078.i, %a.1.2.0.i8078.i
  %.150.not.i8086.i = icmp eq i64 %.142.i8084.i, 0
  br i1 %.150.not.i8086.i, label %B334.i8087.loopexit.i, label %B282.i8076.i

B334.i8087.loopexit.i:                            ; preds = %B282.i8076.i
  %257 = fmul double %r.3.1.i8083.i, 1.000000e-13
  br label %B0.endif.i188.i3670.i

B494.i255.i3737.i:                                ; preds = %B0.endif.i188.i3670.i
  %.10.i3.i262.i3744.i = fcmp olt double %.261.i194.i3676.i, 0.000000e+00
  %.11.i4.i263.i3745.i = select i1 %.10.i3.i262.i3744.i, double 0.000000e+00, double %.261.i194.i3676.i
  %.420.i268.i3750.i = fmul double %.316.i223.i3705.i, %.11.i4.i263.i3745.i
  %.424.i271.i3753.i = fsub double %.225.i174.i3656.i, %.420.i268.i3750.i
  br label %B634.endif.i3767.i

B0.endif.i188.i3670.i:                            ; preds = %B334.i8087.loopexit.i, %B634.i3487.i
  %r.4.1.i8088.i = phi double [ 1.000000e-13, %B634.i3487.i ], [ %257, %B334.i8087.loopexit.i ]
  %.260.i193.i3675.i = fsub double %r.4.1.i8088.i, %.988.i3481.i
  %.261.i194.i3676.i = fmul double %.260.i193.i3675.i, 5.000000e-01
  %.266.i197.i3679.i = fmul double %.987.i3480.i, %.221.i170.i3652.i
  %.268.i199.i3681.i = fmul double %.936.i3436.i, %.172.i136.i3618.i
  %.269.i200.i3682.i = fsub double %.266.i197.i3679.i, %.268.i199.i3681.i
  %.270.i201.i3683.i = fsub double %.221.i170.i3652.i, %.172.i136.i3618.i
  %.274.i204.i3686.i = fdiv double %.269.i200.i3682.i, %.270.i201.i3683.i
  %.280.i208.i3690.i = fcmp olt double %.987.i3480.i, %.274.i204.i3686.i
  %.288.i282.i4182.i = fcmp olt double %.274.i204.i3686.i, %.936.i3436.i
  %or.cond8009.i = and i1 %.280.i208.i3690.i, %.288.i282.i4182.i
  %"$phi302.0.2.i26.i2894.0.i" = select i1 %or.cond8009.i, double %.274.i204.i3686.i, double %.225.i174.i3656.i
  %.315.i222.i3704.i = fsub double %.225.i174.i3656.i, %"$phi302.0.2.i26.i2894.0.i"
  %.316.i223.i3705.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.315.i222.i3704.i)
  %.330.i233.i3715.i = fmul double %.988.i3481.i, %.988.i3481.i
  %.333.i236.i3718.i = tail call double @llvm.fabs.f64(double %.315.i222.i3704.i)
  %.10.i.i241.i3723.i = fcmp olt double %.333.i236.i3718.i, %.330.i233.i3715.i
  %.11.i.i242.i3724.i = select i1 %.10.i.i241.i3723.i, double %.333.i236.i3718.i, double %.330.i233.i3715.i
  %.363.i246.i3728.i = fmul double %.316.i223.i3705.i, %.11.i.i242.i3724.i
  %.364.i247.i3729.i = fadd double %"$phi302.0.2.i26.i2894.0.i", %.363.i246.i3728.i
  %.370.i251.i3733.i = fsub double %.364.i247.i3729.i, %.225.i174.i3656.i
  %.371.i252.i3734.i = tail call double @llvm.fabs.f64(double %.370.i251.i3733.i)
  %.373.i254.i3736.i = fcmp ugt double %.371.i252.i3734.i, %.261.i194.i3676.i
  br i1 %.373.i254.i3736.i, label %B494.i255.i3737.i, label %B634.endif.i3767.i

B730.i3955.i:                                     ; preds = %B634.endif.endif.i3858.i
  store double %.997.i3065.0.i, ptr %.935.i3435.i, align 8, !noalias !154
  store double %least.2.i.i2813.0.lcssa.i, ptr %.220.i169.i3651.i, align 8, !noalias !154
  br label %B879.i3486.i

B802.i3862.i:                                     ; preds = %B634.endif.endif.i3858.i
  store double %.997.i3065.0.i, ptr %.986.i3479.i, align 8, !noalias !154
  store double %least.2.i.i2813.0.lcssa.i, ptr %.171.i135.i3617.i, align 8, !noalias !154
  br label %B879.i3486.i

B879.i3486.i:                                     ; preds = %B540.if.i4196.i, %B802.i3862.i, %B730.i3955.i
  %exitcond8415.not.i = icmp eq i64 %arg.shape.0, %.858.i4203.i
  br i1 %exitcond8415.not.i, label %B114.i3132.loopexit.i, label %B540.if.i4196.i

B154.if.i5107.i:                                  ; preds = %B154.i3199.loopexit.i, %B154.i3199.preheader.i
  %wide.2.i3022.18332.i = phi i1 [ false, %B154.i3199.preheader.i ], [ %"$phi250.2.2.i3035.2.i", %B154.i3199.loopexit.i ]
  %.287.i3026.08330.i = phi i64 [ 0, %B154.i3199.preheader.i ], [ %.356.i5115.i, %B154.i3199.loopexit.i ]
  %.356.i5115.i = add nsw i64 %.287.i3026.08330.i, 1
  br i1 %wide.2.i3022.18332.i, label %B250.i4316.i, label %B162.i4221.i

B250.endif.i4600.i:                               ; preds = %B0.endif.i.i4503.i, %B494.i.i4570.i
  %.511.i3038.0.i = phi double [ %.364.i.i4562.i, %B0.endif.i.i4503.i ], [ %.424.i.i4586.i, %B494.i.i4570.i ]
  %.92.i352.i4681.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.287.i3026.08330.i
  %.93.i353.i4682.i = load double, ptr %.92.i352.i4681.i, align 8, !noalias !166
  %.146.i384.i4718.i = getelementptr double, ptr %55, i64 %.287.i3026.08330.i
  %.147.i385.i4719.i = load double, ptr %.146.i384.i4718.i, align 8, !noalias !166
  %.149.i387.i4721.i = fmul double %.511.i3038.0.i, %.147.i385.i4719.i
  %.150.i388.i4722.i = fadd double %.93.i353.i4682.i, %.149.i387.i4721.i
  %.203.i421.i4758.i = getelementptr double, ptr %.571, i64 %.287.i3026.08330.i
  store double %.150.i388.i4722.i, ptr %.203.i421.i4758.i, align 8, !noalias !166
  br i1 %.287.i2218170.not.i, label %B154.i3199.loopexit.i, label %B122.if.i.i5062.lr.ph.i

B122.if.i.i5062.lr.ph.i:                          ; preds = %B250.endif.i4600.i
  %.247.i.i.i5032.i = fsub double 1.000000e+00, %.511.i3038.0.i
  %invariant.gep9342 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9344 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9346 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9348 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9350 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9352 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9354 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9356 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  %invariant.gep9358 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3026.08330.i
  br label %B122.if.i.i5062.i

B122.if.i.i5062.i:                                ; preds = %B122.if.i.i5062.i, %B122.if.i.i5062.lr.ph.i
  %.229.i313.i2869.08327.i = phi i64 [ 0, %B122.if.i.i5062.lr.ph.i ], [ %.300.i.i5068.i, %B122.if.i.i5062.i ]
  %.157.i.i.i4989.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.i
  %.159.i.i.i4991.i = mul nsw i64 %.157.i.i.i4989.i, %arg.shape.0
  %gep9343 = getelementptr double, ptr %invariant.gep9342, i64 %.159.i.i.i4991.i
  %.191.i.i.i5013.i = load double, ptr %gep9343, align 8, !noalias !170
  %.193.i.i.i5015.i = fadd double %.191.i.i.i5013.i, 0.000000e+00
  %.253.i.i.i5037.i = fmul double %.511.i3038.0.i, %.193.i.i.i5015.i
  %.157.i.i.i4989.1.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.1.i
  %.159.i.i.i4991.1.i = mul nsw i64 %.157.i.i.i4989.1.i, %arg.shape.0
  %gep9345 = getelementptr double, ptr %invariant.gep9344, i64 %.159.i.i.i4991.1.i
  %.191.i.i.i5013.1.i = load double, ptr %gep9345, align 8, !noalias !170
  %.193.i.i.i5015.1.i = fadd double %.191.i.i.i5013.1.i, %.253.i.i.i5037.i
  %.253.i.i.i5037.1.i = fmul double %.247.i.i.i5032.i, %.193.i.i.i5015.1.i
  %.157.i.i.i4989.2.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.2.i
  %.159.i.i.i4991.2.i = mul nsw i64 %.157.i.i.i4989.2.i, %arg.shape.0
  %gep9347 = getelementptr double, ptr %invariant.gep9346, i64 %.159.i.i.i4991.2.i
  %.191.i.i.i5013.2.i = load double, ptr %gep9347, align 8, !noalias !170
  %.193.i.i.i5015.2.i = fadd double %.191.i.i.i5013.2.i, %.253.i.i.i5037.1.i
  %.253.i.i.i5037.2.i = fmul double %.511.i3038.0.i, %.193.i.i.i5015.2.i
  %.157.i.i.i4989.3.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.3.i
  %.159.i.i.i4991.3.i = mul nsw i64 %.157.i.i.i4989.3.i, %arg.shape.0
  %gep9349 = getelementptr double, ptr %invariant.gep9348, i64 %.159.i.i.i4991.3.i
  %.191.i.i.i5013.3.i = load double, ptr %gep9349, align 8, !noalias !170
  %.193.i.i.i5015.3.i = fadd double %.191.i.i.i5013.3.i, %.253.i.i.i5037.2.i
  %.253.i.i.i5037.3.i = fmul double %.247.i.i.i5032.i, %.193.i.i.i5015.3.i
  %.157.i.i.i4989.4.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.4.i
  %.159.i.i.i4991.4.i = mul nsw i64 %.157.i.i.i4989.4.i, %arg.shape.0
  %gep9351 = getelementptr double, ptr %invariant.gep9350, i64 %.159.i.i.i4991.4.i
  %.191.i.i.i5013.4.i = load double, ptr %gep9351, align 8, !noalias !170
  %.193.i.i.i5015.4.i = fadd double %.191.i.i.i5013.4.i, %.253.i.i.i5037.3.i
  %.253.i.i.i5037.4.i = fmul double %.511.i3038.0.i, %.193.i.i.i5015.4.i
  %.157.i.i.i4989.5.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.5.i
  %.159.i.i.i4991.5.i = mul nsw i64 %.157.i.i.i4989.5.i, %arg.shape.0
  %gep9353 = getelementptr double, ptr %invariant.gep9352, i64 %.159.i.i.i4991.5.i
  %.191.i.i.i5013.5.i = load double, ptr %gep9353, align 8, !noalias !170
  %.193.i.i.i5015.5.i = fadd double %.191.i.i.i5013.5.i, %.253.i.i.i5037.4.i
  %.253.i.i.i5037.5.i = fmul double %.247.i.i.i5032.i, %.193.i.i.i5015.5.i
  %.157.i.i.i4989.6.i = add nsw i64 %.229.i313.i2869.08327.i, %.155.i.i.i4987.6.i
  %.159.i.i.i4991.6.i = mul nsw i64 %.157.i.i.i4989.6.i, %arg.shape.0
  %gep9355 = getelementptr double, ptr %invariant.gep9354, i64 %.159.i.i.i4991.6.i
  %.191.i.i.i5013.6.i = load double, ptr %gep9355, align 8, !noalias !170
  %.193.i.i.i5015.6.i = fadd double %.191.i.i.i5013.6.i, %.253.i.i.i5037.5.i
  %.253.i.i.i5037.6.i = fmul double %.511.i3038.0.i, %.193.i.i.i5015.6.i
  %.300.i.i5068.i = add nsw i64 %.229.i313.i2869.08327.i, 1
  %.271.i.i.i4910.i = mul nsw i64 %.229.i313.i2869.08327.i, %arg.shape.0
  %gep9357 = getelementptr double, ptr %invariant.gep9356, i64 %.271.i.i.i4910.i
  %.309.i.i.i4935.i = load double, ptr %gep9357, align 8, !noalias !170
  %.313.i.i.i4938.i = fadd double %.309.i.i.i4935.i, %.253.i.i.i5037.6.i
  %.359.i.i4951.i = add nsw i64 %.229.i313.i2869.08327.i, %.358.i355.i
  %.361.i.i4953.i = mul nsw i64 %.359.i.i4951.i, %arg.shape.0
  %gep9359 = getelementptr double, ptr %invariant.gep9358, i64 %.361.i.i4953.i
  store double %.313.i.i.i4938.i, ptr %gep9359, align 8, !noalias !166
  %exitcond8412.not.i = icmp eq i64 %arg.shape.1, %.300.i.i5068.i
  br i1 %exitcond8412.not.i, label %B154.i3199.loopexit.i, label %B122.if.i.i5062.i

B540.if.i4196.i:                                  ; preds = %B879.i3486.i, %B336.i3232.i
  %.789.i3054.08342.i = phi i64 [ 0, %B336.i3232.i ], [ %.858.i4203.i, %B879.i3486.i ]
  %.858.i4203.i = add nsw i64 %.789.i3054.08342.i, 1
  %.935.i3435.i = getelementptr double, ptr %59, i64 %.789.i3054.08342.i
  %.936.i3436.i = load double, ptr %.935.i3435.i, align 8, !noalias !154
  %.986.i3479.i = getelementptr double, ptr %58, i64 %.789.i3054.08342.i
  %.987.i3480.i = load double, ptr %.986.i3479.i, align 8, !noalias !154
  %.988.i3481.i = fsub double %.936.i3436.i, %.987.i3480.i
  %.990.i3483.i = fcmp ogt double %.988.i3481.i, 1.000000e-13
  br i1 %.990.i3483.i, label %B634.i3487.i, label %B879.i3486.i

B634.endif.i3767.i:                               ; preds = %B0.endif.i188.i3670.i, %B494.i255.i3737.i
  %.997.i3065.0.i = phi double [ %.364.i247.i3729.i, %B0.endif.i188.i3670.i ], [ %.424.i271.i3753.i, %B494.i255.i3737.i ]
  br i1 %.428.i10648201.not.i, label %B634.endif.endif.i3858.i, label %B58.if.i.i4151.i.preheader

B58.if.i.i4151.i.preheader:                       ; preds = %B634.endif.i3767.i
  %invariant.gep9360 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.789.i3054.08342.i
  %invariant.gep9362 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.789.i3054.08342.i
  br label %B58.if.i.i4151.i

B58.if.i.i4151.i:                                 ; preds = %B58.if.i.i4151.i.preheader, %B58.if.i.i4151.i
  %least.2.i.i2813.08339.i = phi double [ %.11.i.i665.i4147.i, %B58.if.i.i4151.i ], [ 0x7FF0000000000000, %B58.if.i.i4151.i.preheader ]
  %.54.i.i2817.08337.i = phi i64 [ %.125.i675.i4157.i, %B58.if.i.i4151.i ], [ 0, %B58.if.i.i4151.i.preheader ]
  %.125.i675.i4157.i = add nsw i64 %.54.i.i2817.08337.i, 1
  %.156.i572.i4063.i = add nsw i64 %.54.i.i2817.08337.i, %.155.i571.i.i
  %.158.i574.i4065.i = mul nsw i64 %.156.i572.i4063.i, %arg.shape.0
  %.164.i578.i4070.i = add nsw i64 %.54.i.i2817.08337.i, %.578.i.i
  %.166.i580.i4072.i = mul nsw i64 %.164.i578.i4070.i, %arg.shape.0
  %gep9361 = getelementptr double, ptr %invariant.gep9360, i64 %.166.i580.i4072.i
  %.198.i608.i4094.i = load double, ptr %gep9361, align 8, !noalias !174
  %gep9363 = getelementptr double, ptr %invariant.gep9362, i64 %.158.i574.i4065.i
  %.228.i630.i4114.i = load double, ptr %gep9363, align 8, !noalias !174
  %.229.i631.i4115.i = fmul double %.198.i608.i4094.i, %.228.i630.i4114.i
  %258 = getelementptr double, ptr %gep9363, i64 %.194.i.i739.i
  %.263.i656.i4139.i = load double, ptr %258, align 8, !noalias !174
  %.264.i657.i4140.i = fadd double %.229.i631.i4115.i, %.263.i656.i4139.i
  %.10.i.i664.i4146.i = fcmp olt double %.264.i657.i4140.i, %least.2.i.i2813.08339.i
  %.11.i.i665.i4147.i = select i1 %.10.i.i664.i4146.i, double %.264.i657.i4140.i, double %least.2.i.i2813.08339.i
  %exitcond8414.not.i = icmp eq i64 %arg.shape.6, %.125.i675.i4157.i
  br i1 %exitcond8414.not.i, label %B634.endif.endif.i3858.i, label %B58.if.i.i4151.i

B634.endif.endif.i3858.i:                         ; preds = %B58.if.i.i4151.i, %B634.endif.i3767.i
  %least.2.i.i2813.0.lcssa.i = phi double [ 0x7FF0000000000000, %B634.endif.i3767.i ], [ %.11.i.i665.i4147.i, %B58.if.i.i4151.i ]
  %.1063.i3861.i = fcmp olt double %least.2.i.i2813.0.lcssa.i, 0.000000e+00
  br i1 %.1063.i3861.i, label %B730.i3955.i, label %B802.i3862.i

B996.i:                                           ; preds = %B326.i3213.i, %B114.i3132.loopexit.i, %B904.endif.endif.i
  br i1 %.809, label %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B1028.if.lr.ph.i

B1028.if.lr.ph.i:                                 ; preds = %B996.i
  %.2097.i = fmul double %.262.i, 2.000000e+00
  br label %B1028.if.i

B1152.i:                                          ; preds = %B1028.if.i
  %.2034.i = getelementptr double, ptr %55, i64 %.1729.08355.i
  %.2035.i = load double, ptr %.2034.i, align 8, !noalias !61
  %.2099.i = fcmp ogt double %.2035.i, %.2097.i
  %.2149.i = getelementptr double, ptr %58, i64 %.1729.08355.i
  %.2150.i = load double, ptr %.2149.i, align 8, !noalias !61
  %.2200.i = getelementptr double, ptr %59, i64 %.1729.08355.i
  %.2201.i = load double, ptr %.2200.i, align 8, !noalias !61
  %.2202.i = fcmp olt double %.2150.i, %.2201.i
  %.2258.i = getelementptr double, ptr %57, i64 %.1729.08355.i
  %.2259.i = load double, ptr %.2258.i, align 8, !noalias !61
  %.2260.i = fcmp ogt double %.2259.i, 1.000000e-01
  br i1 %.2260.i, label %B1440.i, label %B1710.i

B1440.i:                                          ; preds = %B1152.i
  br i1 %.2099.i, label %B1548.i, label %B1662.i

B1548.i:                                          ; preds = %B1440.i
  %.2087.i = load double, ptr %.1876.i, align 8, !noalias !61
  %.2088.i = tail call double @llvm.fabs.f64(double %.2087.i)
  %.2089.i = fmul double %.2088.i, 4.000000e-15
  %.2319.i = fmul double %.2035.i, 0x3D719799812DEA11
  %.10.i.i8928 = fcmp ogt double %.2089.i, %.2319.i
  %.11.i.i8929 = select i1 %.10.i.i8928, double %.2089.i, double %.2319.i
  %.2315.i = fsub double 1.000000e+00, %.2150.i
  %.2317.i = fmul double %.2035.i, %.2315.i
  %.2351.i = fcmp ugt double %.2317.i, %.11.i.i8929
  br i1 %.2351.i, label %B1552.i, label %B1662.i

B1552.i:                                          ; preds = %B1548.i
  %.2416.i = fmul double %.2035.i, %.2201.i
  %.10.i8100.i = fcmp ogt double %.262.i, %.2416.i
  %.11.i8101.i = select i1 %.10.i8100.i, double %.262.i, double %.2416.i
  %.108.i8930.i = getelementptr double, ptr %65, i64 %.1729.08355.i
  store double 0.000000e+00, ptr %.108.i8930.i, align 8, !noalias !178
  %.161.i8976.i = getelementptr double, ptr %66, i64 %.1729.08355.i
  store double 0.000000e+00, ptr %.161.i8976.i, align 8, !noalias !178
  %.214.i9022.i = getelementptr double, ptr %67, i64 %.1729.08355.i
  store double %.11.i8101.i, ptr %.214.i9022.i, align 8, !noalias !178
  %.267.i9068.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1729.08355.i
  %.268.i9069.i = load i64, ptr %.267.i9068.i, align 8, !noalias !178
  %.294.i9090.i = icmp slt i64 %.268.i9069.i, 0
  %.295.i9091.i = select i1 %.294.i9090.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i9092.i = add i64 %.295.i9091.i, %.268.i9069.i
  %.316.i9112.i = mul i64 %.296.i9092.i, %arg.batch.3.3.5.1
  %.320.i9116.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i9112.i
  %.321.i9117.i = load i64, ptr %.320.i9116.i, align 8, !noalias !178
  %.322.i9118.i = add nsw i64 %.321.i9117.i, -1
  store i64 %.322.i9118.i, ptr %.320.i9116.i, align 8, !noalias !178
  %.426.i9211.i = load i64, ptr %.267.i9068.i, align 8, !noalias !178
  %.452.i9232.i = icmp slt i64 %.426.i9211.i, 0
  %.453.i9233.i = select i1 %.452.i9232.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i9234.i = add i64 %.453.i9233.i, %.426.i9211.i
  %.474.i9254.i = mul i64 %.454.i9234.i, %arg.batch.3.3.5.1
  %259 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i9254.i
  %.478.i9258.i = getelementptr i8, ptr %259, i64 24
  %.479.i9259.i = load i64, ptr %.478.i9258.i, align 8, !noalias !178
  %.480.i9260.i = add nsw i64 %.479.i9259.i, 1
  store i64 %.480.i9260.i, ptr %.478.i9258.i, align 8, !noalias !178
  br label %B1919.i

B1662.i:                                          ; preds = %B1548.i, %B1440.i
  %.2547.i = getelementptr double, ptr %64, i64 %.1729.08355.i
  store double 1.000000e+00, ptr %.2547.i, align 8, !noalias !61
  br label %B1919.i

B1710.i:                                          ; preds = %B1152.i
  br i1 %.2099.i, label %B1714.i, label %B1814.i

B1714.i:                                          ; preds = %B1710.i
  br i1 %.2202.i, label %B1768.i, label %B1718.i

B1718.i:                                          ; preds = %B1714.i
  %.96.i.i = load double, ptr %.1876.i, align 8, !noalias !181
  %.97.i.i = tail call double @llvm.fabs.f64(double %.96.i.i)
  %.98.i.i = fmul double %.97.i.i, 1.000000e-15
  %.152.i.i = fdiv double %.98.i.i, %.2035.i
  br i1 %.2486, label %B178.i.i, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B178.i.i:                                         ; preds = %B1718.i, %B1225.i.i
  %.229.sroa.0.0454.i.i = phi i64 [ %.229.sroa.0.0.i.i, %B1225.i.i ], [ 0, %B1718.i ]
  %.183.1453.i.i = phi i64 [ %.183.1.i.i, %B1225.i.i ], [ %.183.1450.i.i, %B1718.i ]
  %.180.1452.i.i = phi i64 [ %.180.1.i.i, %B1225.i.i ], [ 1, %B1718.i ]
  %.278.i.i = add nsw i64 %.229.sroa.0.0454.i.i, %arg.shape.6
  %.280.i.i = mul nsw i64 %.278.i.i, %arg.shape.0
  %.282.i8104.i = add nsw i64 %.280.i.i, %.1729.08355.i
  %.192.i.i.i = add nsw i64 %.282.i8104.i, %factor.op.mul.i.reass
  %.206.i.i.i = icmp slt i64 %.192.i.i.i, 0
  %.207.i.i.i = select i1 %.206.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i
  %.221.i.i.i = getelementptr double, ptr %260, i64 %.207.i.i.i
  %.222.i.i.i = load double, ptr %.221.i.i.i, align 8, !noalias !185
  %.472.i.i.i = icmp slt i64 %.282.i8104.i, 0
  %.473.i.i.i = select i1 %.472.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %261 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.282.i8104.i
  %.487.i.i.i = getelementptr double, ptr %261, i64 %.473.i.i.i
  %.488.i.i.i = load double, ptr %.487.i.i.i, align 8, !noalias !185
  %.489.i.i.i = fmul double %.488.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i = fsub double %.222.i.i.i, %.489.i.i.i
  %.458.i.1.i.i = add nsw i64 %.282.i8104.i, %.454.i.i.i
  %.472.i.1.i.i = icmp slt i64 %.458.i.1.i.i, 0
  %.473.i.1.i.i = select i1 %.472.i.1.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %262 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i
  %.487.i.1.i.i = getelementptr double, ptr %262, i64 %.473.i.1.i.i
  %.488.i.1.i.i = load double, ptr %.487.i.1.i.i, align 8, !noalias !185
  %.489.i.1.i.i = fmul double %.488.i.1.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i = fsub double %.491.i.i.i, %.489.i.1.i.i
  %.458.i.2.i.i = add nsw i64 %.282.i8104.i, %.456.i.2.i.i
  %.472.i.2.i.i = icmp slt i64 %.458.i.2.i.i, 0
  %.473.i.2.i.i = select i1 %.472.i.2.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %263 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i
  %.487.i.2.i.i = getelementptr double, ptr %263, i64 %.473.i.2.i.i
  %.488.i.2.i.i = load double, ptr %.487.i.2.i.i, align 8, !noalias !185
  %.489.i.2.i.i = fmul double %.488.i.2.i.i, 0x3FE1306AA3D795F4
  %264 = fadd double %.491.i.1.i.i, %.489.i.2.i.i
  %.458.i.3.i.i = add nsw i64 %.282.i8104.i, %.456.i.3.i.i
  %.472.i.3.i.i = icmp slt i64 %.458.i.3.i.i, 0
  %.473.i.3.i.i = select i1 %.472.i.3.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %265 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i
  %.487.i.3.i.i = getelementptr double, ptr %265, i64 %.473.i.3.i.i
  %.488.i.3.i.i = load double, ptr %.487.i.3.i.i, align 8, !noalias !185
  %.489.i.3.i.i = fmul double %.488.i.3.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i = fsub double %264, %.489.i.3.i.i
  %.458.i.4.i.i = add nsw i64 %.282.i8104.i, %.456.i.4.i.i
  %.472.i.4.i.i = icmp slt i64 %.458.i.4.i.i, 0
  %.473.i.4.i.i = select i1 %.472.i.4.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %266 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i
  %.487.i.4.i.i = getelementptr double, ptr %266, i64 %.473.i.4.i.i
  %.488.i.4.i.i = load double, ptr %.487.i.4.i.i, align 8, !noalias !185
  %.489.i.4.i.i = fmul double %.488.i.4.i.i, 0x3FA4EAF2D6B11E79
  %267 = fadd double %.491.i.3.i.i, %.489.i.4.i.i
  %.502.i.i.i = tail call double @llvm.fabs.f64(double %267)
  %.10.i.i.i8105.i = fcmp ogt double %.502.i.i.i, 0.000000e+00
  %.11.i.i.i8106.i = select i1 %.10.i.i.i8105.i, double %.502.i.i.i, double 0.000000e+00
  %.192.i.1.i.i = add nsw i64 %.282.i8104.i, %.190.i.1.i.i
  %.206.i.1.i.i = icmp slt i64 %.192.i.1.i.i, 0
  %.207.i.1.i.i = select i1 %.206.i.1.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %268 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i
  %.221.i.1.i.i = getelementptr double, ptr %268, i64 %.207.i.1.i.i
  %.222.i.1.i.i = load double, ptr %.221.i.1.i.i, align 8, !noalias !185
  %.489.i.1492.i.i = fmul double %.488.i.i.i, 0x3FA5118805F8B876
  %269 = fadd double %.489.i.1492.i.i, %.222.i.1.i.i
  %.489.i.1.1.i.i = fmul double %.488.i.1.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i = fsub double %269, %.489.i.1.1.i.i
  %.489.i.2.1.i.i = fmul double %.488.i.2.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i = fsub double %.491.i.1.1.i.i, %.489.i.2.1.i.i
  %.489.i.3.1.i.i = fmul double %.488.i.3.i.i, 0x3FC0DA0C684D1D67
  %270 = fadd double %.489.i.3.1.i.i, %.491.i.2.1.i.i
  %.489.i.4.1.i.i = fmul double %.488.i.4.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i = fsub double %270, %.489.i.4.1.i.i
  %.502.i.1.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i)
  %.10.i.i.1.i.i = fcmp ogt double %.502.i.1.i.i, %.11.i.i.i8106.i
  %.11.i.i.1.i.i = select i1 %.10.i.i.1.i.i, double %.502.i.1.i.i, double %.11.i.i.i8106.i
  %.192.i.2.i.i = add nsw i64 %.282.i8104.i, %.190.i.2.i.i
  %.206.i.2.i.i = icmp slt i64 %.192.i.2.i.i, 0
  %.207.i.2.i.i = select i1 %.206.i.2.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %271 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i
  %.221.i.2.i.i = getelementptr double, ptr %271, i64 %.207.i.2.i.i
  %.222.i.2.i.i = load double, ptr %.221.i.2.i.i, align 8, !noalias !185
  %.489.i.2519.i.i = fmul double %.488.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2520.i.i = fsub double %.222.i.2.i.i, %.489.i.2519.i.i
  %.489.i.1.2.i.i = fmul double %.488.i.1.i.i, 0x3FC1EAE0FF33D241
  %272 = fadd double %.489.i.1.2.i.i, %.491.i.2520.i.i
  %.489.i.2.2.i.i = fmul double %.488.i.2.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i = fsub double %272, %.489.i.2.2.i.i
  %.489.i.3.2.i.i = fmul double %.488.i.3.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i = fsub double %.491.i.2.2.i.i, %.489.i.3.2.i.i
  %.489.i.4.2.i.i = fmul double %.488.i.4.i.i, 0x3FA55161A739EB34
  %273 = fadd double %.489.i.4.2.i.i, %.491.i.3.2.i.i
  %.502.i.2.i.i = tail call double @llvm.fabs.f64(double %273)
  %.10.i.i.2.i.i = fcmp ogt double %.502.i.2.i.i, %.11.i.i.1.i.i
  %.11.i.i.2.i.i = select i1 %.10.i.i.2.i.i, double %.502.i.2.i.i, double %.11.i.i.1.i.i
  %.192.i.3.i.i = add nsw i64 %.282.i8104.i, %.190.i.3.i.i
  %.206.i.3.i.i = icmp slt i64 %.192.i.3.i.i, 0
  %.207.i.3.i.i = select i1 %.206.i.3.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %274 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i
  %.221.i.3.i.i = getelementptr double, ptr %274, i64 %.207.i.3.i.i
  %.222.i.3.i.i = load double, ptr %.221.i.3.i.i, align 8, !noalias !185
  %.489.i.3546.i.i = fmul double %.488.i.i.i, 0x3FA4F0C0BB579409
  %275 = fadd double %.489.i.3546.i.i, %.222.i.3.i.i
  %.489.i.1.3.i.i = fmul double %.488.i.1.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i = fsub double %275, %.489.i.1.3.i.i
  %.489.i.2.3.i.i = fmul double %.488.i.2.i.i, 0x3FE1F2DB6FEE3151
  %276 = fadd double %.489.i.2.3.i.i, %.491.i.1.3.i.i
  %.489.i.3.3.i.i = fmul double %.488.i.3.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i = fsub double %276, %.489.i.3.3.i.i
  %.489.i.4.3.i.i = fmul double %.488.i.4.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i = fsub double %.491.i.3.3.i.i, %.489.i.4.3.i.i
  %.502.i.3.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i)
  %.10.i.i.3.i.i = fcmp ogt double %.502.i.3.i.i, %.11.i.i.2.i.i
  %.11.i.i.3.i.i = select i1 %.10.i.i.3.i.i, double %.502.i.3.i.i, double %.11.i.i.2.i.i
  %.321.i.i8919 = add nsw i64 %.229.sroa.0.0454.i.i, %.320.i.i8915
  %.323.i.i = mul nsw i64 %.321.i.i8919, %arg.shape.0
  %.325.i.i = add nsw i64 %.323.i.i, %.1729.08355.i
  %277 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.325.i.i
  %.339.i.i8920 = icmp slt i64 %.325.i.i, 0
  %.340.i.i8921 = select i1 %.339.i.i8920, i64 %arg.batch.5.4.5.0, i64 0
  %.354.i.i = getelementptr double, ptr %277, i64 %.340.i.i8921
  %.355.i.i = load double, ptr %.354.i.i, align 8, !noalias !181
  %.548.i.i = fsub double %.222.i.i.i, %.488.i.i.i
  %.549.i.i = tail call double @llvm.fabs.f64(double %.548.i.i)
  %.551.i.i8922 = fmul double %.152.i.i, %.549.i.i
  %.553.i.i = fadd double %.551.i.i8922, %.355.i.i
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
  %.958.i.i8923 = fmul double %.11.i.i.3.i.i, 1.000000e+01
  br label %B542.i.i

B542.i.i:                                         ; preds = %B1226.i.i, %B538.preheader.i.i
  %.680.sroa.0.0446.i.i = phi i64 [ 1, %B538.preheader.i.i ], [ %.680.sroa.0.0.i.i, %B1226.i.i ]
  %.636.1445.i.i = phi i64 [ 6, %B538.preheader.i.i ], [ %.636.1.i.i, %B1226.i.i ]
  %.633.1444.i.i = phi i64 [ 2, %B538.preheader.i.i ], [ %.633.1.i.i, %B1226.i.i ]
  %nearest.3.2443.i.i = phi double [ 0x7FF0000000000000, %B538.preheader.i.i ], [ %nearest.4.3.i.i, %B1226.i.i ]
  %.732.i.i = add nsw i64 %.680.sroa.0.0446.i.i, -1
  %.734.i.i = mul nsw i64 %.732.i.i, %factor.op.mul.i.reass
  %.736.i.i = add nsw i64 %.734.i.i, %.282.i8104.i
  %.750.i.i = icmp slt i64 %.736.i.i, 0
  %.751.i.i = select i1 %.750.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %278 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.736.i.i
  %.765.i.i = getelementptr double, ptr %278, i64 %.751.i.i
  %.766.i.i = load double, ptr %.765.i.i, align 8, !noalias !181
  %.769.i.i = mul nsw i64 %.680.sroa.0.0446.i.i, %factor.op.mul.i.reass
  %.771.i.i = add nsw i64 %.769.i.i, %.282.i8104.i
  %.785.i.i = icmp slt i64 %.771.i.i, 0
  %.786.i.i = select i1 %.785.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %279 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.771.i.i
  %.800.i.i = getelementptr double, ptr %279, i64 %.786.i.i
  %.801.i.i = load double, ptr %.800.i.i, align 8, !noalias !181
  %.803.i.i = add nsw i64 %.680.sroa.0.0446.i.i, 1
  %.805.i.i = mul nsw i64 %.803.i.i, %factor.op.mul.i.reass
  %.807.i.i = add nsw i64 %.805.i.i, %.282.i8104.i
  %.821.i.i = icmp slt i64 %.807.i.i, 0
  %.822.i.i = select i1 %.821.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %280 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.807.i.i
  %.836.i.i = getelementptr double, ptr %280, i64 %.822.i.i
  %.837.i.i = load double, ptr %.836.i.i, align 8, !noalias !181
  %.860.i.i = fcmp olt double %.801.i.i, 0.000000e+00
  %.863.i.i = fneg double %.766.i.i
  %.867.i.i = fneg double %.801.i.i
  %.871.i.i = fneg double %.837.i.i
  %c.2.3.i.i = select i1 %.860.i.i, double %.871.i.i, double %.837.i.i
  %b.2.3.i.i = select i1 %.860.i.i, double %.867.i.i, double %.801.i.i
  %a.2.3.i.i = select i1 %.860.i.i, double %.863.i.i, double %.766.i.i
  %.888.i.i = icmp eq i64 %.680.sroa.0.0446.i.i, 1
  %.895.i.i = fcmp ogt double %a.2.3.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.888.i.i, i1 true, i1 %.895.i.i
  br i1 %or.cond.i.i, label %B694.i.i, label %B750.i.i8924

B694.i.i:                                         ; preds = %B542.i.i
  %.901.i.i = icmp eq i64 %.680.sroa.0.0446.i.i, 8
  %.907.i.i = fcmp ogt double %c.2.3.i.i, 0.000000e+00
  %or.cond410.i.i = select i1 %.901.i.i, i1 true, i1 %.907.i.i
  br i1 %or.cond410.i.i, label %B718.i.i, label %B750.i.i8924

B718.i.i:                                         ; preds = %B694.i.i
  %.10.i.i8133.i = fcmp olt double %b.2.3.i.i, %nearest.3.2443.i.i
  %.11.i.i8134.i = select i1 %.10.i.i8133.i, double %b.2.3.i.i, double %nearest.3.2443.i.i
  br label %B750.i.i8924

B750.i.i8924:                                     ; preds = %B718.i.i, %B694.i.i, %B542.i.i
  %nearest.5.4.i.i = phi double [ %.11.i.i8134.i, %B718.i.i ], [ %nearest.3.2443.i.i, %B694.i.i ], [ %nearest.3.2443.i.i, %B542.i.i ]
  %.952.i.i = icmp slt i64 %.680.sroa.0.0446.i.i, 8
  br i1 %.952.i.i, label %B762.i.i, label %B1226.i.i

B762.i.i:                                         ; preds = %B750.i.i8924
  %.961.i.i = fsub double %a.2.3.i.i, %b.2.3.i.i
  %.962.i.i = tail call double @llvm.fabs.f64(double %.961.i.i)
  %.965.i.i = fsub double %c.2.3.i.i, %b.2.3.i.i
  %.966.i.i = tail call double @llvm.fabs.f64(double %.965.i.i)
  %.967.i.i = fadd double %.962.i.i, %.966.i.i
  %.968.i.i = fmul double %.967.i.i, 3.000000e+00
  %.969.i.i = fadd double %.958.i.i8923, %.968.i.i
  %.971.i.i = fcmp olt double %b.2.3.i.i, %.969.i.i
  br i1 %.971.i.i, label %B872.i.i, label %B1226.i.i

B872.i.i:                                         ; preds = %B762.i.i
  %switch.tableidx = add i64 %.680.sroa.0.0446.i.i, 9
  %281 = icmp ult i64 %switch.tableidx, 18
  br i1 %281, label %switch.lookup9480, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B1078.i.i:                                        ; preds = %switch.lookup9492
  %.1180.i.i = fneg double %.1121.i.i
  %.1184.i.i = fmul double %.1170.i.i, 5.000000e-01
  %.1189.i.i8926 = fdiv double %.1184.i.i, %.1153.i8111.i
  %.1190.i.i8927 = fcmp ogt double %.1189.i.i8926, %.1180.i.i
  %.1200.i.i = fcmp olt double %.1189.i.i8926, %.1047.i.i
  %or.cond411.i.i = and i1 %.1190.i.i8927, %.1200.i.i
  br i1 %or.cond411.i.i, label %B1118.i.i, label %B1226.i.i

B1118.i.i:                                        ; preds = %B1078.i.i
  %.1227.i.i = fmul double %.1170.i.i, 2.500000e-01
  %.1229.i.i = fmul double %.1170.i.i, %.1227.i.i
  %.1236.i.i = fdiv double %.1229.i.i, %.1153.i8111.i
  %.1240.i.i = fsub double %b.2.3.i.i, %.1236.i.i
  %.10.i412.i.i = fcmp olt double %.1240.i.i, %nearest.5.4.i.i
  %.11.i413.i.i = select i1 %.10.i412.i.i, double %.1240.i.i, double %nearest.5.4.i.i
  br label %B1226.i.i

B1186.i.i:                                        ; preds = %B1226.i.i
  %.1312.i.i = fcmp ugt double %nearest.4.3.i.i, %.958.i.i8923
  br i1 %.1312.i.i, label %B1225.i.i, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B1225.i.i:                                        ; preds = %B1186.i.i, %B178.i.i
  %.239.i.i = icmp sgt i64 %.183.1453.i.i, 0
  %.252.i.i = zext i1 %.239.i.i to i64
  %.180.1.i.i = add i64 %.180.1452.i.i, %.252.i.i
  %.248.i.i = sext i1 %.239.i.i to i64
  %.183.1.i.i = add nsw i64 %.183.1453.i.i, %.248.i.i
  %.229.sroa.0.0.i.i = select i1 %.239.i.i, i64 %.180.1452.i.i, i64 0
  br i1 %.239.i.i, label %B178.i.i, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B1226.i.i:                                        ; preds = %switch.lookup9492, %B1118.i.i, %B1078.i.i, %B762.i.i, %B750.i.i8924
  %nearest.4.3.i.i = phi double [ %nearest.5.4.i.i, %B1078.i.i ], [ %.11.i413.i.i, %B1118.i.i ], [ %nearest.5.4.i.i, %B750.i.i8924 ], [ %nearest.5.4.i.i, %switch.lookup9492 ], [ %nearest.5.4.i.i, %B762.i.i ]
  %.690.i.i = icmp ne i64 %.636.1445.i.i, 0
  %.703.i.i = zext i1 %.690.i.i to i64
  %.633.1.i.i = add i64 %.633.1444.i.i, %.703.i.i
  %.699.i.i = sext i1 %.690.i.i to i64
  %.636.1.i.i = add nsw i64 %.636.1445.i.i, %.699.i.i
  %.680.sroa.0.0.i.i = select i1 %.690.i.i, i64 %.633.1444.i.i, i64 0
  br i1 %.690.i.i, label %B542.i.i, label %B1186.i.i

switch.lookup9480:                                ; preds = %B872.i.i
  %switch.tableidx9483 = add i64 %.680.sroa.0.0446.i.i, 8
  %282 = icmp ult i64 %switch.tableidx9483, 18
  br i1 %282, label %switch.lookup9484, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup9484:                                ; preds = %switch.lookup9480
  %switch.gep9481 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx
  %switch.load9482 = load double, ptr %switch.gep9481, align 8
  %switch.gep9485 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9483
  %switch.load9486 = load double, ptr %switch.gep9485, align 8
  %.1047.i.i = fsub double %switch.load9482, %switch.load9486
  %switch.tableidx9487 = add i64 %.680.sroa.0.0446.i.i, 10
  %283 = icmp ult i64 %switch.tableidx9487, 18
  br i1 %283, label %switch.lookup9488, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup9488:                                ; preds = %switch.lookup9484
  %switch.tableidx9491 = add i64 %.680.sroa.0.0446.i.i, 9
  %284 = icmp ult i64 %switch.tableidx9491, 18
  br i1 %284, label %switch.lookup9492, label %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup9492:                                ; preds = %switch.lookup9488
  %switch.gep9489 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9487
  %switch.load9490 = load double, ptr %switch.gep9489, align 8
  %switch.gep9493 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9491
  %switch.load9494 = load double, ptr %switch.gep9493, align 8
  %.1121.i.i = fsub double %switch.load9490, %switch.load9494
  %.1137.i.i = fdiv double %.965.i.i, %.1121.i.i
  %.1140.i.i = fsub double %b.2.3.i.i, %a.2.3.i.i
  %.1145.i.i = fdiv double %.1140.i.i, %.1047.i.i
  %.1146.i.i = fsub double %.1137.i.i, %.1145.i.i
  %.1149.i.i = fadd double %.1047.i.i, %.1121.i.i
  %.1153.i8111.i = fdiv double %.1146.i.i, %.1149.i.i
  %.1169.i.i = fmul double %.1047.i.i, %.1153.i8111.i
  %.1170.i.i = fadd double %.1145.i.i, %.1169.i.i
  %.1175.i.i = fcmp ogt double %.1153.i8111.i, 0.000000e+00
  br i1 %.1175.i.i, label %B1078.i.i, label %B1226.i.i

_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1225.i.i, %B1186.i.i, %B872.i.i, %switch.lookup9480, %switch.lookup9484, %switch.lookup9488, %B1718.i
  %.2589.not.i = phi i1 [ true, %B1718.i ], [ true, %B872.i.i ], [ true, %switch.lookup9488 ], [ true, %switch.lookup9484 ], [ true, %switch.lookup9480 ], [ true, %B1225.i.i ], [ false, %B1186.i.i ]
  %excinfo.12.4.i = phi ptr [ %excinfo.12.08359.i, %B1718.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %B872.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup9488 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup9484 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup9480 ], [ %excinfo.12.08359.i, %B1186.i.i ], [ %excinfo.12.08359.i, %B1225.i.i ]
  %.2578.not.i = phi i1 [ true, %B1718.i ], [ false, %B872.i.i ], [ false, %switch.lookup9488 ], [ false, %switch.lookup9484 ], [ false, %switch.lookup9480 ], [ true, %B1186.i.i ], [ true, %B1225.i.i ]
  %common.ret.op.i8103.i = phi i32 [ 0, %B1718.i ], [ 1, %B872.i.i ], [ 1, %switch.lookup9488 ], [ 1, %switch.lookup9484 ], [ 1, %switch.lookup9480 ], [ 0, %B1186.i.i ], [ 0, %B1225.i.i ]
  br i1 %.2578.not.i, label %B1718.endif.endif.i, label %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, !prof !53

B1768.i:                                          ; preds = %B1718.endif.endif.i, %B1714.i
  %excinfo.12.3.i = phi ptr [ %excinfo.12.08359.i, %B1714.i ], [ %excinfo.12.4.i, %B1718.endif.endif.i ]
  %.2608.i = fmul double %.2035.i, 5.000000e-01
  %.108.i8460.i = getelementptr double, ptr %65, i64 %.1729.08355.i
  store double 0.000000e+00, ptr %.108.i8460.i, align 8, !noalias !189
  %.161.i.i8917 = getelementptr double, ptr %66, i64 %.1729.08355.i
  store double 0.000000e+00, ptr %.161.i.i8917, align 8, !noalias !189
  %.214.i8546.i = getelementptr double, ptr %67, i64 %.1729.08355.i
  store double %.2608.i, ptr %.214.i8546.i, align 8, !noalias !189
  %.267.i8591.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1729.08355.i
  %.268.i8592.i = load i64, ptr %.267.i8591.i, align 8, !noalias !189
  %.294.i8613.i = icmp slt i64 %.268.i8592.i, 0
  %.295.i.i8918 = select i1 %.294.i8613.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i8614.i = add i64 %.295.i.i8918, %.268.i8592.i
  %.316.i8634.i = mul i64 %.296.i8614.i, %arg.batch.3.3.5.1
  %.320.i8638.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i8634.i
  %.321.i8639.i = load i64, ptr %.320.i8638.i, align 8, !noalias !189
  %.322.i8640.i = add nsw i64 %.321.i8639.i, -1
  store i64 %.322.i8640.i, ptr %.320.i8638.i, align 8, !noalias !189
  %.426.i8733.i = load i64, ptr %.267.i8591.i, align 8, !noalias !189
  %.452.i8753.i = icmp slt i64 %.426.i8733.i, 0
  %.453.i8754.i = select i1 %.452.i8753.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i8755.i = add i64 %.453.i8754.i, %.426.i8733.i
  %.474.i8775.i = mul i64 %.454.i8755.i, %arg.batch.3.3.5.1
  %285 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i8775.i
  %.478.i8779.i = getelementptr i8, ptr %285, i64 24
  %.479.i8780.i = load i64, ptr %.478.i8779.i, align 8, !noalias !189
  %.480.i8781.i = add nsw i64 %.479.i8780.i, 1
  store i64 %.480.i8781.i, ptr %.478.i8779.i, align 8, !noalias !189
  br label %B1919.i

B1814.i:                                          ; preds = %B1718.endif.endif.i, %B1710.i
  %excinfo.12.2.i = phi ptr [ %excinfo.12.4.i, %B1718.endif.endif.i ], [ %excinfo.12.08359.i, %B1710.i ]
  br label %B34.i.i

B34.i.i:                                          ; preds = %B34.if.i.i8916, %B1814.i
  %.51.i9321.0.i = phi i64 [ 0, %B1814.i ], [ %.122.i9466.i, %B34.if.i.i8916 ]
  %exitcond8416.not.i = icmp eq i64 %.51.i9321.0.i, %storemerge7992.i
  br i1 %exitcond8416.not.i, label %B1919.i, label %B34.if.i.i8916

B128.i.i:                                         ; preds = %B34.if.i.i8916
  %286 = icmp sgt i64 %.51.i9321.0.i, -1
  br i1 %286, label %B1870.i, label %B1919.i

B34.if.i.i8916:                                   ; preds = %B34.i.i
  %.122.i9466.i = add i64 %.51.i9321.0.i, 1
  %.157.i9389.i = add nsw i64 %.51.i9321.0.i, %.155.i9387.i
  %.159.i9391.i = mul nsw i64 %.157.i9389.i, %arg.shape.0
  %.161.i9393.i = add nsw i64 %.159.i9391.i, %.1729.08355.i
  %.175.i9402.i = icmp slt i64 %.161.i9393.i, 0
  %.176.i9403.i = select i1 %.175.i9402.i, i64 %arg.batch.5.4.5.0, i64 0
  %287 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i9393.i
  %.190.i9417.i = getelementptr double, ptr %287, i64 %.176.i9403.i
  %.191.i9418.i = load double, ptr %.190.i9417.i, align 8, !noalias !192
  %.195.i9422.i = add nsw i64 %.161.i9393.i, %.194.i.i739.i
  %.209.i9432.i = icmp slt i64 %.195.i9422.i, 0
  %.210.i9433.i = select i1 %.209.i9432.i, i64 %arg.batch.5.4.5.0, i64 0
  %288 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i9422.i
  %.224.i9446.i = getelementptr double, ptr %288, i64 %.210.i9433.i
  %.225.i9447.i = load double, ptr %.224.i9446.i, align 8, !noalias !192
  %.226.i9448.i = fneg double %.225.i9447.i
  %.227.i9449.i = fcmp olt double %.191.i9418.i, %.226.i9448.i
  br i1 %.227.i9449.i, label %B128.i.i, label %B34.i.i

B1870.i:                                          ; preds = %B128.i.i
  %.2743.i = getelementptr double, ptr %64, i64 %.1729.08355.i
  store double 1.000000e+00, ptr %.2743.i, align 8, !noalias !61
  br label %B1919.i

B1919.i:                                          ; preds = %B34.i.i, %B1028.if.i, %B1870.i, %B128.i.i, %B1768.i, %B1662.i, %B1552.i
  %excinfo.12.1.i = phi ptr [ %excinfo.12.08359.i, %B1028.if.i ], [ %excinfo.12.08359.i, %B1552.i ], [ %excinfo.12.08359.i, %B1662.i ], [ %excinfo.12.3.i, %B1768.i ], [ %excinfo.12.2.i, %B1870.i ], [ %excinfo.12.2.i, %B128.i.i ], [ %excinfo.12.2.i, %B34.i.i ]
  %exitcond8417.not.i = icmp eq i64 %arg.shape.0, %.1799.i
  br i1 %exitcond8417.not.i, label %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B1028.if.i

B296.if.i8910:                                    ; preds = %B296.if.i8910.preheader, %B296.loopexit.i
  %.620.08174.i = phi i64 [ %.689.i8911, %B296.loopexit.i ], [ 0, %B296.if.i8910.preheader ]
  %.689.i8911 = add nsw i64 %.620.08174.i, 1
  br i1 %199, label %switch.lookup9496, label %switch.end.i

switch.lookup9496:                                ; preds = %B296.if.i8910
  %switch.load9498 = load double, ptr %switch.gep9497, align 8
  br label %switch.end.i

switch.end.i:                                     ; preds = %B296.if.i8910, %switch.lookup9496
  %.731.i = phi double [ %switch.load9498, %switch.lookup9496 ], [ 1.000000e+00, %B296.if.i8910 ]
  %.92.i107.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.620.08174.i
  %.93.i108.i = load double, ptr %.92.i107.i, align 8, !noalias !196
  %.146.i144.i = getelementptr double, ptr %55, i64 %.620.08174.i
  %.147.i145.i = load double, ptr %.146.i144.i, align 8, !noalias !196
  %.149.i147.i = fmul double %.731.i, %.147.i145.i
  %.150.i148.i = fadd double %.93.i108.i, %.149.i147.i
  %.203.i184.i = getelementptr double, ptr %.571, i64 %.620.08174.i
  store double %.150.i148.i, ptr %.203.i184.i, align 8, !noalias !196
  br i1 %.287.i2218170.not.i, label %B296.loopexit.i, label %B122.if.i467.lr.ph.i

B122.if.i467.lr.ph.i:                             ; preds = %switch.end.i
  %.247.i.i437.i = fsub double 1.000000e+00, %.731.i
  %invariant.gep9284 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9286 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9288 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9290 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9292 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9294 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9296 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9298 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  %invariant.gep9300 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.620.08174.i
  br label %B122.if.i467.i

B122.if.i467.i:                                   ; preds = %B122.if.i467.i, %B122.if.i467.lr.ph.i
  %.229.i60.08171.i = phi i64 [ 0, %B122.if.i467.lr.ph.i ], [ %.300.i473.i, %B122.if.i467.i ]
  %.157.i.i394.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.i
  %.159.i.i396.i = mul nsw i64 %.157.i.i394.i, %arg.shape.0
  %gep9285 = getelementptr double, ptr %invariant.gep9284, i64 %.159.i.i396.i
  %.191.i.i418.i = load double, ptr %gep9285, align 8, !noalias !200
  %.193.i.i420.i = fadd double %.191.i.i418.i, 0.000000e+00
  %.253.i.i442.i = fmul double %.731.i, %.193.i.i420.i
  %.157.i.i394.1.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.1.i
  %.159.i.i396.1.i = mul nsw i64 %.157.i.i394.1.i, %arg.shape.0
  %gep9287 = getelementptr double, ptr %invariant.gep9286, i64 %.159.i.i396.1.i
  %.191.i.i418.1.i = load double, ptr %gep9287, align 8, !noalias !200
  %.193.i.i420.1.i = fadd double %.191.i.i418.1.i, %.253.i.i442.i
  %.253.i.i442.1.i = fmul double %.247.i.i437.i, %.193.i.i420.1.i
  %.157.i.i394.2.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.2.i
  %.159.i.i396.2.i = mul nsw i64 %.157.i.i394.2.i, %arg.shape.0
  %gep9289 = getelementptr double, ptr %invariant.gep9288, i64 %.159.i.i396.2.i
  %.191.i.i418.2.i = load double, ptr %gep9289, align 8, !noalias !200
  %.193.i.i420.2.i = fadd double %.191.i.i418.2.i, %.253.i.i442.1.i
  %.253.i.i442.2.i = fmul double %.731.i, %.193.i.i420.2.i
  %.157.i.i394.3.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.3.i
  %.159.i.i396.3.i = mul nsw i64 %.157.i.i394.3.i, %arg.shape.0
  %gep9291 = getelementptr double, ptr %invariant.gep9290, i64 %.159.i.i396.3.i
  %.191.i.i418.3.i = load double, ptr %gep9291, align 8, !noalias !200
  %.193.i.i420.3.i = fadd double %.191.i.i418.3.i, %.253.i.i442.2.i
  %.253.i.i442.3.i = fmul double %.247.i.i437.i, %.193.i.i420.3.i
  %.157.i.i394.4.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.4.i
  %.159.i.i396.4.i = mul nsw i64 %.157.i.i394.4.i, %arg.shape.0
  %gep9293 = getelementptr double, ptr %invariant.gep9292, i64 %.159.i.i396.4.i
  %.191.i.i418.4.i = load double, ptr %gep9293, align 8, !noalias !200
  %.193.i.i420.4.i = fadd double %.191.i.i418.4.i, %.253.i.i442.3.i
  %.253.i.i442.4.i = fmul double %.731.i, %.193.i.i420.4.i
  %.157.i.i394.5.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.5.i
  %.159.i.i396.5.i = mul nsw i64 %.157.i.i394.5.i, %arg.shape.0
  %gep9295 = getelementptr double, ptr %invariant.gep9294, i64 %.159.i.i396.5.i
  %.191.i.i418.5.i = load double, ptr %gep9295, align 8, !noalias !200
  %.193.i.i420.5.i = fadd double %.191.i.i418.5.i, %.253.i.i442.4.i
  %.253.i.i442.5.i = fmul double %.247.i.i437.i, %.193.i.i420.5.i
  %.157.i.i394.6.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.6.i
  %.159.i.i396.6.i = mul nsw i64 %.157.i.i394.6.i, %arg.shape.0
  %gep9297 = getelementptr double, ptr %invariant.gep9296, i64 %.159.i.i396.6.i
  %.191.i.i418.6.i = load double, ptr %gep9297, align 8, !noalias !200
  %.193.i.i420.6.i = fadd double %.191.i.i418.6.i, %.253.i.i442.5.i
  %.253.i.i442.6.i = fmul double %.731.i, %.193.i.i420.6.i
  %.300.i473.i = add nsw i64 %.229.i60.08171.i, 1
  %.271.i.i315.i = mul nsw i64 %.229.i60.08171.i, %arg.shape.0
  %gep9299 = getelementptr double, ptr %invariant.gep9298, i64 %.271.i.i315.i
  %.309.i.i340.i = load double, ptr %gep9299, align 8, !noalias !200
  %.313.i.i343.i = fadd double %.309.i.i340.i, %.253.i.i442.6.i
  %.359.i356.i = add nsw i64 %.229.i60.08171.i, %.358.i355.i
  %.361.i358.i = mul nsw i64 %.359.i356.i, %arg.shape.0
  %gep9301 = getelementptr double, ptr %invariant.gep9300, i64 %.361.i358.i
  store double %.313.i.i343.i, ptr %gep9301, align 8, !noalias !196
  %exitcond8383.not.i = icmp eq i64 %arg.shape.1, %.300.i473.i
  br i1 %exitcond8383.not.i, label %B296.loopexit.i, label %B122.if.i467.i

B364.endif.i:                                     ; preds = %B1134.i.loopexit.i, %B296.preheader.i, %B390.i.i
  %.555.i = icmp ne i64 %.502.18199.i, 0
  %.564.i = sext i1 %.555.i to i64
  %.502.1.i = add nsw i64 %.502.18199.i, %.564.i
  br i1 %.555.i, label %B296.preheader.i, label %B448.i

B492.endif.endif.i:                               ; preds = %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.1001.0.i, label %B904.i, label %B154.i.preheader.i.preheader

B154.i.preheader.i.preheader:                     ; preds = %B492.endif.endif.i
  br i1 %.809, label %B678.endif.i.critedge, label %B154.i.preheader.i

B596.if.i:                                        ; preds = %B596.if.i.preheader, %B596.loopexit.i
  %.1157.08262.i = phi i64 [ %.1226.i, %B596.loopexit.i ], [ 0, %B596.if.i.preheader ]
  %.1226.i = add nsw i64 %.1157.08262.i, 1
  %289 = getelementptr double, ptr %59, i64 %.1157.08262.i
  %.1301.i = load double, ptr %289, align 8, !noalias !61
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1157.08262.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !125
  %.146.i.i = getelementptr double, ptr %55, i64 %.1157.08262.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !125
  %.149.i.i = fmul double %.1301.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.571, i64 %.1157.08262.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !125
  br i1 %.287.i2218170.not.i, label %B596.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B596.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %.1301.i
  %invariant.gep9324 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9326 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9328 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9330 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9332 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9334 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9336 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9338 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  %invariant.gep9340 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1157.08262.i
  br label %B122.if.i.i

B678.endif.i.critedge:                            ; preds = %B154.i.preheader.i.preheader
  %.1375.i.c = load i64, ptr %.646.i1935.i, align 8, !noalias !61
  %.1491.i.c = inttoptr i64 %.1375.i.c to ptr
  tail call void %.1491.i.c(ptr %.571, ptr %.1465.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1490.i), !noalias !61
  br label %B678.endif.i

B678.endif.i:                                     ; preds = %B1134.i6137.loopexit.i, %B678.endif.i.critedge, %B390.i5499.i
  %.942.i = icmp ne i64 %.889.18297.i, 0
  %.951.i = sext i1 %.942.i to i64
  %.889.1.i = add nsw i64 %.889.18297.i, %.951.i
  br i1 %.942.i, label %B448.i, label %B904.i

B904.endif.endif.i:                               ; preds = %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.1580.0.i, label %B996.i, label %B154.i3199.preheader.i.preheader

B154.i3199.preheader.i.preheader:                 ; preds = %B904.endif.endif.i
  br i1 %.809, label %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B154.i3199.preheader.i

B1028.if.i:                                       ; preds = %B1919.i, %B1028.if.lr.ph.i
  %excinfo.12.08359.i = phi ptr [ null, %B1028.if.lr.ph.i ], [ %excinfo.12.1.i, %B1919.i ]
  %.1729.08355.i = phi i64 [ 0, %B1028.if.lr.ph.i ], [ %.1799.i, %B1919.i ]
  %.1799.i = add nsw i64 %.1729.08355.i, 1
  %.1876.i = getelementptr double, ptr %63, i64 %.1729.08355.i
  %.1877.i = load double, ptr %.1876.i, align 8, !noalias !61
  %.1927.i = getelementptr double, ptr %.571, i64 %.1729.08355.i
  store double %.1877.i, ptr %.1927.i, align 8, !noalias !61
  %.1978.i = getelementptr i64, ptr %56, i64 %.1729.08355.i
  %.1979.i = load i64, ptr %.1978.i, align 8, !noalias !61
  %.1980.i = icmp slt i64 %.1979.i, 0
  br i1 %.1980.i, label %B1919.i, label %B1152.i

B1718.endif.endif.i:                              ; preds = %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.2589.not.i, label %B1814.i, label %B1768.i

_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1919.i, %B154.i3199.preheader.i.preheader, %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B996.i
  %excinfo.12.3 = phi ptr [ %excinfo.12.0, %B996.i ], [ %excinfo.12.0, %B1919.i ], [ %excinfo.7.6.i, %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %excinfo.12.0, %B154.i3199.preheader.i.preheader ], [ %excinfo.12.4.i, %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.19, %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %common.ret.op.i = phi i32 [ 0, %B996.i ], [ 0, %B1919.i ], [ %.16048364.i, %_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B154.i3199.preheader.i.preheader ], [ %common.ret.op.i8103.i, %_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.10251617.i, %_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.4747.not = icmp eq i32 %common.ret.op.i, 0
  br i1 %.4747.not, label %B3742, label %B3700.if, !prof !53

B3742:                                            ; preds = %B3628, %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3632.endif.endif
  %excinfo.12.2 = phi ptr [ %excinfo.12.3, %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.12.0, %B3632.endif.endif ], [ %excinfo.12.0, %B3628 ]
  br i1 %.4767.not, label %B3786, label %B3746

B3746:                                            ; preds = %B3742
  br i1 %.809, label %B116.loopexit.8.i, label %B150.if.i

B150.if.1.i:                                      ; preds = %B150.if.i, %B150.if.1.i
  %.361.0603.1.i = phi i64 [ %.430.1.i, %B150.if.1.i ], [ 0, %B150.if.i ]
  %.430.1.i = add nsw i64 %.361.0603.1.i, 1
  %gep9367 = getelementptr double, ptr %invariant.gep9366, i64 %.361.0603.1.i
  store double 1.000000e-09, ptr %gep9367, align 8, !noalias !204
  %exitcond.1.not.i = icmp eq i64 %arg.shape.0, %.430.1.i
  br i1 %exitcond.1.not.i, label %B150.if.2.i, label %B150.if.1.i

B150.if.2.i:                                      ; preds = %B150.if.1.i, %B150.if.2.i
  %.361.0603.2.i = phi i64 [ %.430.2.i, %B150.if.2.i ], [ 0, %B150.if.1.i ]
  %.430.2.i = add nsw i64 %.361.0603.2.i, 1
  %gep9369 = getelementptr double, ptr %invariant.gep9368, i64 %.361.0603.2.i
  store double 1.000000e-09, ptr %gep9369, align 8, !noalias !204
  %exitcond.2.not.i = icmp eq i64 %arg.shape.0, %.430.2.i
  br i1 %exitcond.2.not.i, label %B150.if.3.i, label %B150.if.2.i

B150.if.3.i:                                      ; preds = %B150.if.2.i, %B150.if.3.i
  %.361.0603.3.i = phi i64 [ %.430.3.i, %B150.if.3.i ], [ 0, %B150.if.2.i ]
  %.430.3.i = add nsw i64 %.361.0603.3.i, 1
  %gep9371 = getelementptr double, ptr %invariant.gep9370, i64 %.361.0603.3.i
  store double 1.000000e-09, ptr %gep9371, align 8, !noalias !204
  %exitcond.3.not.i = icmp eq i64 %arg.shape.0, %.430.3.i
  br i1 %exitcond.3.not.i, label %B150.if.4.i, label %B150.if.3.i

B150.if.4.i:                                      ; preds = %B150.if.3.i, %B150.if.4.i
  %.361.0603.4.i = phi i64 [ %.430.4.i, %B150.if.4.i ], [ 0, %B150.if.3.i ]
  %.430.4.i = add nsw i64 %.361.0603.4.i, 1
  %gep9373 = getelementptr double, ptr %invariant.gep9372, i64 %.361.0603.4.i
  store double 1.000000e-09, ptr %gep9373, align 8, !noalias !204
  %exitcond.4.not.i = icmp eq i64 %arg.shape.0, %.430.4.i
  br i1 %exitcond.4.not.i, label %B150.if.5.i, label %B150.if.4.i

B150.if.5.i:                                      ; preds = %B150.if.4.i, %B150.if.5.i
  %.361.0603.5.i = phi i64 [ %.430.5.i, %B150.if.5.i ], [ 0, %B150.if.4.i ]
  %.430.5.i = add nsw i64 %.361.0603.5.i, 1
  %gep9375 = getelementptr double, ptr %invariant.gep9374, i64 %.361.0603.5.i
  store double 1.000000e-09, ptr %gep9375, align 8, !noalias !204
  %exitcond.5.not.i = icmp eq i64 %arg.shape.0, %.430.5.i
  br i1 %exitcond.5.not.i, label %B150.if.6.i, label %B150.if.5.i

B150.if.6.i:                                      ; preds = %B150.if.5.i, %B150.if.6.i
  %.361.0603.6.i = phi i64 [ %.430.6.i, %B150.if.6.i ], [ 0, %B150.if.5.i ]
  %.430.6.i = add nsw i64 %.361.0603.6.i, 1
  %gep9377 = getelementptr double, ptr %invariant.gep9376, i64 %.361.0603.6.i
  store double 1.000000e-09, ptr %gep9377, align 8, !noalias !204
  %exitcond.6.not.i = icmp eq i64 %arg.shape.0, %.430.6.i
  br i1 %exitcond.6.not.i, label %B150.if.7.i, label %B150.if.6.i

B150.if.7.i:                                      ; preds = %B150.if.6.i, %B150.if.7.i
  %.361.0603.7.i = phi i64 [ %.430.7.i, %B150.if.7.i ], [ 0, %B150.if.6.i ]
  %.430.7.i = add nsw i64 %.361.0603.7.i, 1
  %gep9379 = getelementptr double, ptr %invariant.gep9378, i64 %.361.0603.7.i
  store double 1.000000e-09, ptr %gep9379, align 8, !noalias !204
  %exitcond.7.not.i = icmp eq i64 %arg.shape.0, %.430.7.i
  br i1 %exitcond.7.not.i, label %B150.if.8.i, label %B150.if.7.i

B150.if.8.i:                                      ; preds = %B150.if.7.i, %B150.if.8.i
  %.361.0603.8.i = phi i64 [ %.430.8.i, %B150.if.8.i ], [ 0, %B150.if.7.i ]
  %.430.8.i = add nsw i64 %.361.0603.8.i, 1
  %gep9381 = getelementptr double, ptr %invariant.gep9380, i64 %.361.0603.8.i
  store double 1.000000e-09, ptr %gep9381, align 8, !noalias !204
  %exitcond.8.not.i = icmp eq i64 %arg.shape.0, %.430.8.i
  br i1 %exitcond.8.not.i, label %B116.loopexit.8.i, label %B150.if.8.i

B116.loopexit.8.i:                                ; preds = %B150.if.8.i, %B3746
  %.227.i.i = load double, ptr %.226.i.i, align 8, !noalias !208
  %.256.i.i8945 = load double, ptr %arg.batch.2.4, align 8, !noalias !208
  br label %B256.if.i.i

B290.loopexit.i.i:                                ; preds = %B122.if.i.i.i9006, %switch.end.i.i9002
  %exitcond1313.not.i.i = icmp eq i64 %arg.shape.0, %.533.i.i
  br i1 %exitcond1313.not.i.i, label %B358.i.i, label %B290.if.i.i

B358.i.i:                                         ; preds = %B290.loopexit.i.i, %B256.if.i.i
  %.634.i.i = icmp ult i64 %.341.01301.i.i, 8
  %.1287.i.i8950 = select i1 %.634.i.i, i64 16, i64 17
  %.644.i.i = mul nsw i64 %.341.01301.i.i, 3
  %.6501283.i.i = add nsw i64 %.644.i.i, 1
  %.673.i.i = mul i64 %.6501283.i.i, %arg.shape.0
  %.708.i.i = load i64, ptr %.707.i.i, align 8, !noalias !208
  %.783.i.i = mul i64 %.1287.i.i8950, %.463
  %.801.i.i8951 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i
  %.826.i.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %.673.i.i
  %.827.i.i8952 = inttoptr i64 %.708.i.i to ptr
  tail call void %.827.i.i8952(ptr %.571, ptr %.801.i.i8951, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.826.i.i), !noalias !208
  %.399.i.i = icmp sgt i64 %.344.01302.i.i, 1
  br i1 %.399.i.i, label %B256.if.i.i, label %B600.i.i

B600.i.i:                                         ; preds = %B358.i.i
  br i1 %.5201298.not.i.i, label %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B634.lr.ph.i.i

B634.lr.ph.i.i:                                   ; preds = %B600.i.i
  %.257.i.i8963 = fsub double %.227.i.i, %.256.i.i8945
  %.258.i.i8964 = fmul double %.257.i.i8963, 1.000000e-13
  %.1816.i.i = fmul double %.258.i.i8964, 2.000000e+00
  br label %B634.i.i8966

B634.i.i8966:                                     ; preds = %B1544.i.i, %B634.lr.ph.i.i
  %.925.sroa.0.01311.i.i = phi i64 [ 0, %B634.lr.ph.i.i ], [ %.925.sroa.0.0.i.i, %B1544.i.i ]
  %.881.11310.i.i = phi i64 [ %.881.11306.i.i, %B634.lr.ph.i.i ], [ %.881.1.i.i, %B1544.i.i ]
  %.878.11309.i.i = phi i64 [ 1, %B634.lr.ph.i.i ], [ %.878.1.i.i, %B1544.i.i ]
  %some.2.01308.i.i = phi i1 [ false, %B634.lr.ph.i.i ], [ %some.3.1.i.i, %B1544.i.i ]
  %excinfo.3.01307.i.i = phi ptr [ null, %B634.lr.ph.i.i ], [ %excinfo.3.1.i.i, %B1544.i.i ]
  %.1006.i.i = icmp slt i64 %.925.sroa.0.01311.i.i, 0
  %.1007.i.i8967 = select i1 %.1006.i.i, i64 %arg.batch.4.0.5.1, i64 0
  %.1008.i.i8968 = add i64 %.1007.i.i8967, %.925.sroa.0.01311.i.i
  %.1029.i.i8969 = getelementptr double, ptr %70, i64 %.1008.i.i8968
  %.1030.i.i8970 = load double, ptr %.1029.i.i8969, align 8, !noalias !208
  %.1058.i.i = select i1 %.1006.i.i, i64 %arg.batch.4.1.5.1, i64 0
  %.1059.i.i8971 = add i64 %.1058.i.i, %.925.sroa.0.01311.i.i
  %.1080.i.i8972 = getelementptr i64, ptr %71, i64 %.1059.i.i8971
  store i64 -1, ptr %.1080.i.i8972, align 8, !noalias !208
  %.1131.i.i = getelementptr double, ptr %.571, i64 %.1008.i.i8968
  store double %.1030.i.i8970, ptr %.1131.i.i, align 8, !noalias !208
  %.1182.i.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1059.i.i8971
  %.1183.i.i = load i64, ptr %.1182.i.i, align 8, !noalias !208
  %.1184.i.i8973 = icmp sgt i64 %.1183.i.i, -1
  br i1 %.1184.i.i8973, label %B792.i.i8975, label %B1544.i.i

B792.i.i8975:                                     ; preds = %B634.i.i8966
  %.1238.i.i = getelementptr double, ptr %72, i64 %.1008.i.i8968
  %.1239.i.i = load double, ptr %.1238.i.i, align 8, !noalias !208
  %.1240.i.i8976 = fcmp ogt double %.1239.i.i, 5.000000e-01
  br i1 %.1240.i.i8976, label %B842.i.i, label %B1544.i.i

B842.i.i:                                         ; preds = %B792.i.i8975
  %.1326.i.i8977 = load i64, ptr %.1080.i.i8972, align 8, !noalias !208
  %.1327.i.i = icmp slt i64 %.1326.i.i8977, 0
  br i1 %.1327.i.i, label %B940.i.i, label %B1088.i.i

B940.i.i:                                         ; preds = %B842.i.i, %B940.i.i
  %last.2.3.i.i = phi i64 [ %.1333.i.i, %B940.i.i ], [ %.1288.i.i8965, %B842.i.i ]
  %.1333.i.i = add nsw i64 %last.2.3.i.i, 1
  %.151.i51.i.i = mul nsw i64 %.1333.i.i, 3
  %.155.i.i.i8997 = add nsw i64 %.151.i51.i.i, 1
  %.159.i.i.i8998 = mul nsw i64 %.155.i.i.i8997, %arg.shape.0
  %.161.i.i.i = add nsw i64 %.159.i.i.i8998, %.925.sroa.0.01311.i.i
  %.175.i63.i.i = icmp slt i64 %.161.i.i.i, 0
  %.176.i64.i.i = select i1 %.175.i63.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %290 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i.i
  %.190.i.i.i = getelementptr double, ptr %290, i64 %.176.i64.i.i
  %.191.i.i.i8999 = load double, ptr %.190.i.i.i, align 8, !noalias !212
  %.195.i80.i.i = add nsw i64 %.161.i.i.i, %arg.shape.0
  %.209.i.i.i = icmp slt i64 %.195.i80.i.i, 0
  %.210.i.i.i9000 = select i1 %.209.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %291 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i80.i.i
  %.224.i91.i.i = getelementptr double, ptr %291, i64 %.210.i.i.i9000
  %.225.i92.i.i = load double, ptr %.224.i91.i.i, align 8, !noalias !212
  %.226.i93.i.i = fneg double %.225.i92.i.i
  %.227.i94.i.i = fcmp uge double %.191.i.i.i8999, %.226.i93.i.i
  %.1348.0.i.i = sext i1 %.227.i94.i.i to i64
  store i64 %.1348.0.i.i, ptr %.1080.i.i8972, align 8, !noalias !208
  %exitcond1315.not.i.i = icmp ne i64 %last.2.3.i.i, 7
  %brmerge.not.i.i = and i1 %exitcond1315.not.i.i, %.227.i94.i.i
  br i1 %brmerge.not.i.i, label %B940.i.i, label %B1088.i.i

B1088.i.i:                                        ; preds = %B940.i.i, %B842.i.i
  %last.3.2.i.i = phi i64 [ %.1288.i.i8965, %B842.i.i ], [ %.1333.i.i, %B940.i.i ]
  br i1 %.296.i.i, label %B1096.i.i, label %B1126.i.i

B1096.i.i:                                        ; preds = %B1088.i.i
  %292 = getelementptr double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2.i.i
  %switch.gep9501 = getelementptr i8, ptr %292, i64 64
  %switch.load9502 = load double, ptr %switch.gep9501, align 8
  br label %B1126.i.i

B1126.i.i:                                        ; preds = %B1096.i.i, %B1088.i.i
  %"$phi1126.1.2.2.i.i" = phi double [ 0.000000e+00, %B1088.i.i ], [ %switch.load9502, %B1096.i.i ]
  %.1595.i.i = getelementptr double, ptr %73, i64 %.1008.i.i8968
  store double %"$phi1126.1.2.2.i.i", ptr %.1595.i.i, align 8, !noalias !208
  %293 = getelementptr double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2.i.i
  %switch.gep9505 = getelementptr i8, ptr %293, i64 72
  %switch.load9506 = load double, ptr %switch.gep9505, align 8
  %.1683.i.i = getelementptr double, ptr %74, i64 %.1008.i.i8968
  store double %switch.load9506, ptr %.1683.i.i, align 8, !noalias !208
  %.1735.i.i = load i64, ptr %.1080.i.i8972, align 8, !noalias !208
  %.1736.i.i = icmp sgt i64 %.1735.i.i, -1
  %.1746.i.i = sext i1 %.1736.i.i to i64
  %"$phi1274.1.2.2.i.i" = add nsw i64 %last.3.2.i.i, %.1746.i.i
  br i1 %.296.i.i, label %B1282.i.i, label %B1492.i.i

B1282.i.i:                                        ; preds = %B1126.i.i
  %.1813.i.i = getelementptr double, ptr %69, i64 %.1008.i.i8968
  %.1814.i.i = load double, ptr %.1813.i.i, align 8, !noalias !208
  %.1817.i.i = fcmp ogt double %.1814.i.i, %.1816.i.i
  br i1 %.1817.i.i, label %B1340.i.i, label %B1492.i.i

B1340.i.i:                                        ; preds = %B1282.i.i
  %.96.i.i.i = load double, ptr %.1029.i.i8969, align 8, !noalias !216
  %.97.i.i.i = tail call double @llvm.fabs.f64(double %.96.i.i.i)
  %.98.i.i.i = fmul double %.97.i.i.i, 1.000000e-15
  %.152.i.i.i = fdiv double %.98.i.i.i, %.1814.i.i
  %294 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1274.1.2.2.i.i", i64 0)
  %storemerge.i.i.i = tail call i64 @llvm.smin.i64(i64 %294, i64 7)
  %.690443.i.i.i = icmp sgt i64 %"$phi1274.1.2.2.i.i", 0
  %.633.1445.i.i.i = select i1 %.690443.i.i.i, i64 2, i64 1
  %.699446.i.i.i = sext i1 %.690443.i.i.i to i64
  %.636.1447.i.i.i = add nsw i64 %storemerge.i.i.i, %.699446.i.i.i
  %.680.sroa.0.0448.i.i.i = zext i1 %.690443.i.i.i to i64
  %.282.i.i.i = add nsw i64 %.925.sroa.0.01311.i.i, %arg.shape.0
  %.192.i.i.i.i = add nsw i64 %.282.i.i.i, %.43.i.i.i
  %.206.i.i.i.i = icmp slt i64 %.192.i.i.i.i, 0
  %.207.i.i.i.i = select i1 %.206.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %295 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i.i
  %.221.i.i.i.i = getelementptr double, ptr %295, i64 %.207.i.i.i.i
  %.222.i.i.i.i = load double, ptr %.221.i.i.i.i, align 8, !noalias !220
  %.472.i.i.i.i = icmp slt i64 %.282.i.i.i, 0
  %.473.i.i.i.i = select i1 %.472.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %296 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.282.i.i.i
  %.487.i.i.i.i = getelementptr double, ptr %296, i64 %.473.i.i.i.i
  %.488.i.i.i.i = load double, ptr %.487.i.i.i.i, align 8, !noalias !220
  %.489.i.i.i.i = fmul double %.488.i.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i.i = fsub double %.222.i.i.i.i, %.489.i.i.i.i
  %.458.i.1.i.i.i = add nsw i64 %.282.i.i.i, %.454.i.i.i.i
  %.472.i.1.i.i.i = icmp slt i64 %.458.i.1.i.i.i, 0
  %.473.i.1.i.i.i = select i1 %.472.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %297 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i.i
  %.487.i.1.i.i.i = getelementptr double, ptr %297, i64 %.473.i.1.i.i.i
  %.488.i.1.i.i.i = load double, ptr %.487.i.1.i.i.i, align 8, !noalias !220
  %.489.i.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i.i = fsub double %.491.i.i.i.i, %.489.i.1.i.i.i
  %.458.i.2.i.i.i = add nsw i64 %.282.i.i.i, %.456.i.2.i.i.i
  %.472.i.2.i.i.i = icmp slt i64 %.458.i.2.i.i.i, 0
  %.473.i.2.i.i.i = select i1 %.472.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %298 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i.i
  %.487.i.2.i.i.i = getelementptr double, ptr %298, i64 %.473.i.2.i.i.i
  %.488.i.2.i.i.i = load double, ptr %.487.i.2.i.i.i, align 8, !noalias !220
  %.489.i.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1306AA3D795F4
  %299 = fadd double %.491.i.1.i.i.i, %.489.i.2.i.i.i
  %.458.i.3.i.i.i = add nsw i64 %.282.i.i.i, %.456.i.3.i.i.i
  %.472.i.3.i.i.i = icmp slt i64 %.458.i.3.i.i.i, 0
  %.473.i.3.i.i.i = select i1 %.472.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %300 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i.i
  %.487.i.3.i.i.i = getelementptr double, ptr %300, i64 %.473.i.3.i.i.i
  %.488.i.3.i.i.i = load double, ptr %.487.i.3.i.i.i, align 8, !noalias !220
  %.489.i.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i.i = fsub double %299, %.489.i.3.i.i.i
  %.458.i.4.i.i.i = add nsw i64 %.282.i.i.i, %.456.i.4.i.i.i
  %.472.i.4.i.i.i = icmp slt i64 %.458.i.4.i.i.i, 0
  %.473.i.4.i.i.i = select i1 %.472.i.4.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %301 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i.i
  %.487.i.4.i.i.i = getelementptr double, ptr %301, i64 %.473.i.4.i.i.i
  %.488.i.4.i.i.i = load double, ptr %.487.i.4.i.i.i, align 8, !noalias !220
  %.489.i.4.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA4EAF2D6B11E79
  %302 = fadd double %.491.i.3.i.i.i, %.489.i.4.i.i.i
  %.502.i.i.i.i = tail call double @llvm.fabs.f64(double %302)
  %.10.i.i.i.i.i = fcmp ogt double %.502.i.i.i.i, 0.000000e+00
  %.11.i.i.i.i.i = select i1 %.10.i.i.i.i.i, double %.502.i.i.i.i, double 0.000000e+00
  %.192.i.1.i.i.i = add nsw i64 %.282.i.i.i, %.190.i.1.i.i.i
  %.206.i.1.i.i.i = icmp slt i64 %.192.i.1.i.i.i, 0
  %.207.i.1.i.i.i = select i1 %.206.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %303 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i.i
  %.221.i.1.i.i.i = getelementptr double, ptr %303, i64 %.207.i.1.i.i.i
  %.222.i.1.i.i.i = load double, ptr %.221.i.1.i.i.i, align 8, !noalias !220
  %.489.i.1494.i.i.i = fmul double %.488.i.i.i.i, 0x3FA5118805F8B876
  %304 = fadd double %.489.i.1494.i.i.i, %.222.i.1.i.i.i
  %.489.i.1.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i.i = fsub double %304, %.489.i.1.1.i.i.i
  %.489.i.2.1.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i.i = fsub double %.491.i.1.1.i.i.i, %.489.i.2.1.i.i.i
  %.489.i.3.1.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FC0DA0C684D1D67
  %305 = fadd double %.489.i.3.1.i.i.i, %.491.i.2.1.i.i.i
  %.489.i.4.1.i.i.i = fmul double %.488.i.4.i.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i.i = fsub double %305, %.489.i.4.1.i.i.i
  %.502.i.1.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i.i)
  %.10.i.i.1.i.i.i = fcmp ogt double %.502.i.1.i.i.i, %.11.i.i.i.i.i
  %.11.i.i.1.i.i.i = select i1 %.10.i.i.1.i.i.i, double %.502.i.1.i.i.i, double %.11.i.i.i.i.i
  %.192.i.2.i.i.i = add nsw i64 %.282.i.i.i, %.190.i.2.i.i.i
  %.206.i.2.i.i.i = icmp slt i64 %.192.i.2.i.i.i, 0
  %.207.i.2.i.i.i = select i1 %.206.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %306 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i.i
  %.221.i.2.i.i.i = getelementptr double, ptr %306, i64 %.207.i.2.i.i.i
  %.222.i.2.i.i.i = load double, ptr %.221.i.2.i.i.i, align 8, !noalias !220
  %.489.i.2521.i.i.i = fmul double %.488.i.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2522.i.i.i = fsub double %.222.i.2.i.i.i, %.489.i.2521.i.i.i
  %.489.i.1.2.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FC1EAE0FF33D241
  %307 = fadd double %.489.i.1.2.i.i.i, %.491.i.2522.i.i.i
  %.489.i.2.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i.i = fsub double %307, %.489.i.2.2.i.i.i
  %.489.i.3.2.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i.i = fsub double %.491.i.2.2.i.i.i, %.489.i.3.2.i.i.i
  %.489.i.4.2.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA55161A739EB34
  %308 = fadd double %.489.i.4.2.i.i.i, %.491.i.3.2.i.i.i
  %.502.i.2.i.i.i = tail call double @llvm.fabs.f64(double %308)
  %.10.i.i.2.i.i.i = fcmp ogt double %.502.i.2.i.i.i, %.11.i.i.1.i.i.i
  %.11.i.i.2.i.i.i = select i1 %.10.i.i.2.i.i.i, double %.502.i.2.i.i.i, double %.11.i.i.1.i.i.i
  %.192.i.3.i.i.i = add nsw i64 %.282.i.i.i, %.190.i.3.i.i.i
  %.206.i.3.i.i.i = icmp slt i64 %.192.i.3.i.i.i, 0
  %.207.i.3.i.i.i = select i1 %.206.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %309 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i.i
  %.221.i.3.i.i.i = getelementptr double, ptr %309, i64 %.207.i.3.i.i.i
  %.222.i.3.i.i.i = load double, ptr %.221.i.3.i.i.i, align 8, !noalias !220
  %.489.i.3548.i.i.i = fmul double %.488.i.i.i.i, 0x3FA4F0C0BB579409
  %310 = fadd double %.489.i.3548.i.i.i, %.222.i.3.i.i.i
  %.489.i.1.3.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i.i = fsub double %310, %.489.i.1.3.i.i.i
  %.489.i.2.3.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1F2DB6FEE3151
  %311 = fadd double %.489.i.2.3.i.i.i, %.491.i.1.3.i.i.i
  %.489.i.3.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i.i = fsub double %311, %.489.i.3.3.i.i.i
  %.489.i.4.3.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i.i = fsub double %.491.i.3.3.i.i.i, %.489.i.4.3.i.i.i
  %.502.i.3.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i.i)
  %.10.i.i.3.i.i.i = fcmp ogt double %.502.i.3.i.i.i, %.11.i.i.2.i.i.i
  %.11.i.i.3.i.i.i = select i1 %.10.i.i.3.i.i.i, double %.502.i.3.i.i.i, double %.11.i.i.2.i.i.i
  %.325.i.i.i = add nsw i64 %.925.sroa.0.01311.i.i, %.323.i.i.i
  %312 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.325.i.i.i
  %.339.i.i.i = icmp slt i64 %.325.i.i.i, 0
  %.340.i.i.i = select i1 %.339.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %.354.i.i.i = getelementptr double, ptr %312, i64 %.340.i.i.i
  %.355.i.i.i = load double, ptr %.354.i.i.i, align 8, !noalias !216
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
  %313 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.736.i.i.i
  %.765.i.i.i = getelementptr double, ptr %313, i64 %.751.i.i.i
  %.766.i.i.i = load double, ptr %.765.i.i.i, align 8, !noalias !216
  %.769.i.i.i = mul nsw i64 %.680.sroa.0.0452.i.i.i, %.43.i.i.i
  %.771.i.i.i = add nsw i64 %.769.i.i.i, %.282.i.i.i
  %.785.i.i.i = icmp slt i64 %.771.i.i.i, 0
  %.786.i.i.i = select i1 %.785.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %314 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.771.i.i.i
  %.800.i.i.i = getelementptr double, ptr %314, i64 %.786.i.i.i
  %.801.i.i.i = load double, ptr %.800.i.i.i, align 8, !noalias !216
  %.803.i.i.i = add nsw i64 %.680.sroa.0.0452.i.i.i, 1
  %.805.i.i.i = mul nsw i64 %.803.i.i.i, %.43.i.i.i
  %.807.i.i.i = add nsw i64 %.805.i.i.i, %.282.i.i.i
  %.821.i.i.i = icmp slt i64 %.807.i.i.i, 0
  %.822.i.i.i = select i1 %.821.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %315 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.807.i.i.i
  %.836.i.i.i = getelementptr double, ptr %315, i64 %.822.i.i.i
  %.837.i.i.i = load double, ptr %.836.i.i.i, align 8, !noalias !216
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
  %.10.i.i.i.i8981 = fcmp olt double %b.2.3.i.i.i, %nearest.3.2449.i.i.i
  %.11.i411.i.i.i = select i1 %.10.i.i.i.i8981, double %b.2.3.i.i.i, double %nearest.3.2449.i.i.i
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
  %switch.tableidx9507 = add i64 %.680.sroa.0.0452.i.i.i, 9
  %316 = icmp ult i64 %switch.tableidx9507, 18
  br i1 %316, label %switch.lookup9508, label %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B1078.i.i.i:                                      ; preds = %switch.lookup9520
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
  br i1 %.1312.i.i.i, label %B1225.i.i.i, label %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B1225.i.i.i:                                      ; preds = %B1186.i.i.i, %B1340.i.i
  br label %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B1226.i.i.i:                                      ; preds = %switch.lookup9520, %B1118.i.i.i, %B1078.i.i.i, %B762.i.i.i, %B750.i.i.i
  %nearest.4.3.i.i.i = phi double [ %nearest.5.4.i.i.i, %B1078.i.i.i ], [ %.11.i413.i.i.i, %B1118.i.i.i ], [ %nearest.5.4.i.i.i, %B750.i.i.i ], [ %nearest.5.4.i.i.i, %switch.lookup9520 ], [ %nearest.5.4.i.i.i, %B762.i.i.i ]
  %.690.i.i.i = icmp sgt i64 %.636.1451.i.i.i, 0
  %.703.i.i.i = zext i1 %.690.i.i.i to i64
  %.633.1.i.i.i = add i64 %.633.1450.i.i.i, %.703.i.i.i
  %.699.i.i.i = sext i1 %.690.i.i.i to i64
  %.636.1.i.i.i = add nsw i64 %.636.1451.i.i.i, %.699.i.i.i
  %.680.sroa.0.0.i.i.i = select i1 %.690.i.i.i, i64 %.633.1450.i.i.i, i64 0
  br i1 %.690.i.i.i, label %B542.i.i.i, label %B1186.i.i.i

switch.lookup9508:                                ; preds = %B872.i.i.i
  %switch.tableidx9511 = add i64 %.680.sroa.0.0452.i.i.i, 8
  %317 = icmp ult i64 %switch.tableidx9511, 18
  br i1 %317, label %switch.lookup9512, label %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9512:                                ; preds = %switch.lookup9508
  %switch.gep9509 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9507
  %switch.load9510 = load double, ptr %switch.gep9509, align 8
  %switch.gep9513 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9511
  %switch.load9514 = load double, ptr %switch.gep9513, align 8
  %.1047.i.i.i = fsub double %switch.load9510, %switch.load9514
  %switch.tableidx9515 = add i64 %.680.sroa.0.0452.i.i.i, 10
  %318 = icmp ult i64 %switch.tableidx9515, 18
  br i1 %318, label %switch.lookup9516, label %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9516:                                ; preds = %switch.lookup9512
  %switch.tableidx9519 = add i64 %.680.sroa.0.0452.i.i.i, 9
  %319 = icmp ult i64 %switch.tableidx9519, 18
  br i1 %319, label %switch.lookup9520, label %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9520:                                ; preds = %switch.lookup9516
  %switch.gep9517 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9515
  %switch.load9518 = load double, ptr %switch.gep9517, align 8
  %switch.gep9521 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9519
  %switch.load9522 = load double, ptr %switch.gep9521, align 8
  %.1121.i.i.i = fsub double %switch.load9518, %switch.load9522
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

_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B872.i.i.i, %switch.lookup9508, %switch.lookup9512, %switch.lookup9516, %B1225.i.i.i, %B1186.i.i.i
  %.1855.not.i.i = phi i1 [ false, %B1186.i.i.i ], [ true, %B1225.i.i.i ], [ true, %switch.lookup9516 ], [ true, %switch.lookup9512 ], [ true, %switch.lookup9508 ], [ true, %B872.i.i.i ]
  %excinfo.3.3.i.i = phi ptr [ %excinfo.3.01307.i.i, %B1186.i.i.i ], [ %excinfo.3.01307.i.i, %B1225.i.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %switch.lookup9516 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %switch.lookup9512 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %switch.lookup9508 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %B872.i.i.i ]
  %.1844.not.i.i = phi i1 [ true, %B1186.i.i.i ], [ true, %B1225.i.i.i ], [ false, %switch.lookup9516 ], [ false, %switch.lookup9512 ], [ false, %switch.lookup9508 ], [ false, %B872.i.i.i ]
  br i1 %.1844.not.i.i, label %B1340.endif.endif.i.i, label %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, !prof !53

B1380.i.i:                                        ; preds = %B1340.endif.endif.i.i
  %.1926.i.i = fmul double %.1814.i.i, 5.000000e-01
  store double 0.000000e+00, ptr %.1238.i.i, align 8, !noalias !224
  %.161.i230.i.i = getelementptr double, ptr %75, i64 %.1008.i.i8968
  store double 0.000000e+00, ptr %.161.i230.i.i, align 8, !noalias !224
  %.214.i273.i.i = getelementptr double, ptr %76, i64 %.1008.i.i8968
  store double %.1926.i.i, ptr %.214.i273.i.i, align 8, !noalias !224
  %.268.i313.i.i = load i64, ptr %.1182.i.i, align 8, !noalias !224
  %.294.i.i.i = icmp slt i64 %.268.i313.i.i, 0
  %.295.i.i.i = select i1 %.294.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i324.i.i = add i64 %.295.i.i.i, %.268.i313.i.i
  %.316.i333.i.i = mul i64 %.296.i324.i.i, %arg.batch.3.3.5.1
  %.320.i.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i333.i.i
  %.321.i.i.i = load i64, ptr %.320.i.i.i, align 8, !noalias !224
  %.322.i336.i.i = add nsw i64 %.321.i.i.i, -1
  store i64 %.322.i336.i.i, ptr %.320.i.i.i, align 8, !noalias !224
  %.426.i.i.i = load i64, ptr %.1182.i.i, align 8, !noalias !224
  %.452.i.i.i = icmp slt i64 %.426.i.i.i, 0
  %.453.i.i.i = select i1 %.452.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i.i8980 = add i64 %.453.i.i.i, %.426.i.i.i
  %.474.i.i.i = mul i64 %.454.i.i.i8980, %arg.batch.3.3.5.1
  %320 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i.i
  %.478.i.i.i = getelementptr i8, ptr %320, i64 24
  %.479.i.i.i = load i64, ptr %.478.i.i.i, align 8, !noalias !224
  %.480.i.i.i = add nsw i64 %.479.i.i.i, 1
  store i64 %.480.i.i.i, ptr %.478.i.i.i, align 8, !noalias !224
  store i64 -1, ptr %.1080.i.i8972, align 8, !noalias !208
  br label %B1492.i.i

B1492.i.i:                                        ; preds = %B1340.endif.endif.i.i, %B1126.i.i, %B1380.i.i, %B1282.i.i
  %excinfo.3.2.i.i = phi ptr [ %excinfo.3.3.i.i, %B1340.endif.endif.i.i ], [ %excinfo.3.3.i.i, %B1380.i.i ], [ %excinfo.3.01307.i.i, %B1282.i.i ], [ %excinfo.3.01307.i.i, %B1126.i.i ]
  br i1 %some.2.01308.i.i, label %B1544.i.i, label %B1496.i.i

B1496.i.i:                                        ; preds = %B1492.i.i
  %.2082.i.i = load i64, ptr %.1080.i.i8972, align 8, !noalias !208
  %.2083.i.i = icmp sgt i64 %.2082.i.i, -1
  br label %B1544.i.i

B1544.i.i:                                        ; preds = %B1496.i.i, %B1492.i.i, %B792.i.i8975, %B634.i.i8966
  %excinfo.3.1.i.i = phi ptr [ %excinfo.3.2.i.i, %B1492.i.i ], [ %excinfo.3.2.i.i, %B1496.i.i ], [ %excinfo.3.01307.i.i, %B792.i.i8975 ], [ %excinfo.3.01307.i.i, %B634.i.i8966 ]
  %some.3.1.i.i = phi i1 [ true, %B1492.i.i ], [ %.2083.i.i, %B1496.i.i ], [ %some.2.01308.i.i, %B792.i.i8975 ], [ %some.2.01308.i.i, %B634.i.i8966 ]
  %.935.i.i8974 = icmp sgt i64 %.881.11310.i.i, 0
  %.948.i.i = zext i1 %.935.i.i8974 to i64
  %.878.1.i.i = add i64 %.878.11309.i.i, %.948.i.i
  %.944.i.i = sext i1 %.935.i.i8974 to i64
  %.881.1.i.i = add nsw i64 %.881.11310.i.i, %.944.i.i
  %.925.sroa.0.0.i.i = select i1 %.935.i.i8974, i64 %.878.11309.i.i, i64 0
  br i1 %.935.i.i8974, label %B634.i.i8966, label %B1548.loopexit.i.i

B1548.loopexit.i.i:                               ; preds = %B1544.i.i
  %321 = xor i1 %some.3.1.i.i, true
  br label %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i

B256.if.i.i:                                      ; preds = %B358.i.i, %B116.loopexit.8.i
  %.344.01302.i.i = phi i64 [ %.354.i.i8946, %B116.loopexit.8.i ], [ %.408.i.i8949, %B358.i.i ]
  %.341.01301.i.i = phi i64 [ %..i.i, %B116.loopexit.8.i ], [ %.412.i.i, %B358.i.i ]
  %.408.i.i8949 = add nsw i64 %.344.01302.i.i, -1
  %.412.i.i = add nsw i64 %.341.01301.i.i, 1
  br i1 %.5201298.not.i.i, label %B358.i.i, label %B290.if.i.i.preheader

B290.if.i.i.preheader:                            ; preds = %B256.if.i.i
  %322 = icmp ult i64 %.341.01301.i.i, 8
  %switch.gep9524 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.21, i64 %.341.01301.i.i
  br label %B290.if.i.i

B290.if.i.i:                                      ; preds = %B290.if.i.i.preheader, %B290.loopexit.i.i
  %.464.01299.i.i = phi i64 [ %.533.i.i, %B290.loopexit.i.i ], [ 0, %B290.if.i.i.preheader ]
  %.533.i.i = add nsw i64 %.464.01299.i.i, 1
  br i1 %322, label %switch.lookup9523, label %switch.end.i.i9002

switch.lookup9523:                                ; preds = %B290.if.i.i
  %switch.load9525 = load double, ptr %switch.gep9524, align 8
  br label %switch.end.i.i9002

switch.end.i.i9002:                               ; preds = %B290.if.i.i, %switch.lookup9523
  %.575.i.i = phi double [ %switch.load9525, %switch.lookup9523 ], [ 1.000000e+00, %B290.if.i.i ]
  %.92.i.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.464.01299.i.i
  %.93.i.i.i = load double, ptr %.92.i.i.i, align 8, !noalias !227
  %.146.i.i.i = getelementptr double, ptr %69, i64 %.464.01299.i.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !227
  %.149.i.i.i = fmul double %.575.i.i, %.147.i.i.i
  %.150.i.i.i9003 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.464.01299.i.i
  store double %.150.i.i.i9003, ptr %.203.i.i.i, align 8, !noalias !227
  br i1 %.287.i1295.not.i.i, label %B290.loopexit.i.i, label %B122.if.i.lr.ph.i.i

B122.if.i.lr.ph.i.i:                              ; preds = %switch.end.i.i9002
  %.247.i.i.i.i9004 = fsub double 1.000000e+00, %.575.i.i
  %invariant.gep.i9005 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.464.01299.i.i
  br label %B122.if.i.i.i9006

B122.if.i.i.i9006:                                ; preds = %B122.if.i.i.i9006, %B122.if.i.lr.ph.i.i
  %.229.i.01296.i.i = phi i64 [ 0, %B122.if.i.lr.ph.i.i ], [ %.300.i.i.i9013, %B122.if.i.i.i9006 ]
  %.157.i.i.i.i9007 = add nsw i64 %.229.i.01296.i.i, %.155.i.i.i.i8948
  %.159.i.i.i.i9008 = mul nsw i64 %.157.i.i.i.i9007, %arg.shape.0
  %gep.i9009 = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.i.i9008
  %.191.i.i.i.i9010 = load double, ptr %gep.i9009, align 8, !noalias !231
  %.193.i.i.i.i9011 = fadd double %.191.i.i.i.i9010, 0.000000e+00
  %.253.i.i.i.i9012 = fmul double %.575.i.i, %.193.i.i.i.i9011
  %.157.i.i.1.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.1.i.i
  %.159.i.i.1.i.i = mul nsw i64 %.157.i.i.1.i.i, %arg.shape.0
  %gep608.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.1.i.i
  %.191.i.i.1.i.i = load double, ptr %gep608.i, align 8, !noalias !231
  %.193.i.i.1.i.i = fadd double %.191.i.i.1.i.i, %.253.i.i.i.i9012
  %.253.i.i.1.i.i = fmul double %.247.i.i.i.i9004, %.193.i.i.1.i.i
  %.157.i.i.2.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.2.i.i
  %.159.i.i.2.i.i = mul nsw i64 %.157.i.i.2.i.i, %arg.shape.0
  %gep610.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.2.i.i
  %.191.i.i.2.i.i = load double, ptr %gep610.i, align 8, !noalias !231
  %.193.i.i.2.i.i = fadd double %.191.i.i.2.i.i, %.253.i.i.1.i.i
  %.253.i.i.2.i.i = fmul double %.575.i.i, %.193.i.i.2.i.i
  %.157.i.i.3.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.3.i.i
  %.159.i.i.3.i.i = mul nsw i64 %.157.i.i.3.i.i, %arg.shape.0
  %gep612.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.3.i.i
  %.191.i.i.3.i.i = load double, ptr %gep612.i, align 8, !noalias !231
  %.193.i.i.3.i.i = fadd double %.191.i.i.3.i.i, %.253.i.i.2.i.i
  %.253.i.i.3.i.i = fmul double %.247.i.i.i.i9004, %.193.i.i.3.i.i
  %.157.i.i.4.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.4.i.i
  %.159.i.i.4.i.i = mul nsw i64 %.157.i.i.4.i.i, %arg.shape.0
  %gep614.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.4.i.i
  %.191.i.i.4.i.i = load double, ptr %gep614.i, align 8, !noalias !231
  %.193.i.i.4.i.i = fadd double %.191.i.i.4.i.i, %.253.i.i.3.i.i
  %.253.i.i.4.i.i = fmul double %.575.i.i, %.193.i.i.4.i.i
  %.157.i.i.5.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.5.i.i
  %.159.i.i.5.i.i = mul nsw i64 %.157.i.i.5.i.i, %arg.shape.0
  %gep616.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.5.i.i
  %.191.i.i.5.i.i = load double, ptr %gep616.i, align 8, !noalias !231
  %.193.i.i.5.i.i = fadd double %.191.i.i.5.i.i, %.253.i.i.4.i.i
  %.253.i.i.5.i.i = fmul double %.247.i.i.i.i9004, %.193.i.i.5.i.i
  %.157.i.i.6.i.i = add nsw i64 %.229.i.01296.i.i, %.155.i.i.6.i.i
  %.159.i.i.6.i.i = mul nsw i64 %.157.i.i.6.i.i, %arg.shape.0
  %gep618.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.159.i.i.6.i.i
  %.191.i.i.6.i.i = load double, ptr %gep618.i, align 8, !noalias !231
  %.193.i.i.6.i.i = fadd double %.191.i.i.6.i.i, %.253.i.i.5.i.i
  %.253.i.i.6.i.i = fmul double %.575.i.i, %.193.i.i.6.i.i
  %.300.i.i.i9013 = add nsw i64 %.229.i.01296.i.i, 1
  %.271.i.i.i.i9014 = mul nsw i64 %.229.i.01296.i.i, %arg.shape.0
  %gep620.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.271.i.i.i.i9014
  %.309.i.i.i.i9015 = load double, ptr %gep620.i, align 8, !noalias !231
  %.313.i.i.i.i9016 = fadd double %.309.i.i.i.i9015, %.253.i.i.6.i.i
  %.359.i.i.i9017 = add nsw i64 %.229.i.01296.i.i, %.358.i.i.i8947
  %.361.i.i.i9018 = mul nsw i64 %.359.i.i.i9017, %arg.shape.0
  %gep622.i = getelementptr double, ptr %invariant.gep.i9005, i64 %.361.i.i.i9018
  store double %.313.i.i.i.i9016, ptr %gep622.i, align 8, !noalias !227
  %exitcond.not.i.i9019 = icmp eq i64 %arg.shape.1, %.300.i.i.i9013
  br i1 %exitcond.not.i.i9019, label %B290.loopexit.i.i, label %B122.if.i.i.i9006

B1340.endif.endif.i.i:                            ; preds = %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %.1855.not.i.i, label %B1492.i.i, label %B1380.i.i

_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1548.loopexit.i.i, %B600.i.i
  %.512.0.i = phi i1 [ %321, %B1548.loopexit.i.i ], [ true, %B600.i.i ], [ true, %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %excinfo.1.0.i = phi ptr [ null, %B1548.loopexit.i.i ], [ null, %B600.i.i ], [ %excinfo.3.3.i.i, %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %common.ret.op.i.i.not = phi i1 [ false, %B1548.loopexit.i.i ], [ false, %B600.i.i ], [ true, %_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %brmerge9223 = select i1 %common.ret.op.i.i.not, i1 true, i1 %.512.0.i, !prof !93
  %brmerge9224 = or i1 %.5201298.not.i.i, %brmerge9223
  %excinfo.1.0.i.mux.mux = select i1 %common.ret.op.i.i.not, ptr %excinfo.1.0.i, ptr %excinfo.13.0, !prof !235
  %.mux.mux = zext i1 %common.ret.op.i.i.not to i32
  br i1 %brmerge9224, label %_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B306.if.i, !prof !236

B358.i:                                           ; preds = %B306.if.i
  %323 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.634.0624.i
  %.84.i.i8956 = load i64, ptr %323, align 8, !noalias !237
  %.89.i.i8957 = icmp sgt i64 %.84.i.i8956, -1
  br i1 %.89.i.i8957, label %B46.i.i8958, label %B358.endif.i

B46.i.i8958:                                      ; preds = %B358.i
  %.120.i.i8959 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i8956
  %.121.i.i8960 = load i64, ptr %.120.i.i8959, align 8, !noalias !237
  %.122.i.i8961 = icmp eq i64 %.121.i.i8960, 0
  br i1 %.122.i.i8961, label %B80.i.i8962, label %B358.endif.i

B80.i.i8962:                                      ; preds = %B46.i.i8958
  store i64 4, ptr %.120.i.i8959, align 8, !noalias !237
  br label %B358.endif.i

B448.i8955:                                       ; preds = %B358.endif.i, %B306.if.i
  %exitcond627.not.i = icmp eq i64 %.703.i, %arg.shape.0
  br i1 %exitcond627.not.i, label %_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B306.if.i

B150.if.i:                                        ; preds = %B3746, %B150.if.i
  %.361.0603.i = phi i64 [ %.430.i, %B150.if.i ], [ 0, %B3746 ]
  %.430.i = add nsw i64 %.361.0603.i, 1
  %gep9365 = getelementptr double, ptr %invariant.gep9364, i64 %.361.0603.i
  store double 1.000000e-09, ptr %gep9365, align 8, !noalias !204
  %exitcond.not.i8944 = icmp eq i64 %arg.shape.0, %.430.i
  br i1 %exitcond.not.i8944, label %B150.if.1.i, label %B150.if.i

B306.if.i:                                        ; preds = %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, %B448.i8955
  %.634.0624.i = phi i64 [ %.703.i, %B448.i8955 ], [ 0, %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  %.703.i = add nsw i64 %.634.0624.i, 1
  %324 = getelementptr i64, ptr %77, i64 %.634.0624.i
  %.781.i = load i64, ptr %324, align 8, !noalias !204
  %.782.i = icmp sgt i64 %.781.i, -1
  br i1 %.782.i, label %B358.i, label %B448.i8955

B358.endif.i:                                     ; preds = %B80.i.i8962, %B46.i.i8958, %B358.i
  %325 = getelementptr double, ptr %78, i64 %.634.0624.i
  store double 0.000000e+00, ptr %325, align 8, !noalias !204
  br label %B448.i8955

_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %B448.i8955, %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %excinfo.13.2 = phi ptr [ %excinfo.1.0.i.mux.mux, %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %excinfo.13.0, %B448.i8955 ]
  %common.ret.op.i8953 = phi i32 [ %.mux.mux, %_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ 0, %B448.i8955 ]
  %.4832.not = icmp eq i32 %common.ret.op.i8953, 0
  br i1 %.4832.not, label %B3786, label %B3746.if, !prof !53

B3786:                                            ; preds = %B3200, %_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3742
  %excinfo.12.1 = phi ptr [ %excinfo.12.2, %B3742 ], [ %excinfo.12.2, %_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.12.0, %B3200 ]
  %excinfo.13.1 = phi ptr [ %excinfo.13.0, %B3742 ], [ %excinfo.13.2, %_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.13.0, %B3200 ]
  %brmerge8860.not = and i1 %good.2.1.lcssa, %looked.2.1.lcssa
  br i1 %brmerge8860.not, label %B3794, label %B3846

B3794:                                            ; preds = %B3786
  %brmerge8861.not = select i1 %within.5.1, i1 %.614, i1 false
  %"$phi3830.7.2.2" = select i1 %brmerge8861.not, i64 3, i64 0
  br i1 %.809, label %B3846, label %B96.if.i

B192.i:                                           ; preds = %B96.if.i
  %.440.i = getelementptr double, ptr %80, i64 %.180.0654.i
  %.441.i = load double, ptr %.440.i, align 8, !noalias !240
  %.442.i = fcmp olt double %.441.i, 5.000000e-01
  br i1 %.442.i, label %B899.i, label %B240.i

B240.i:                                           ; preds = %B192.i
  %.473.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.330.i
  %.474.i = load i64, ptr %.473.i, align 8, !noalias !240
  %.475.not.i = icmp eq i64 %.474.i, 0
  br i1 %.475.not.i, label %B286.i, label %B899.i

B286.i:                                           ; preds = %B240.i
  %.533.i9029 = mul i64 %.330.i, %arg.batch.3.3.5.1
  %326 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.533.i9029
  %.537.i = getelementptr i8, ptr %326, i64 8
  %.538.i = load i64, ptr %.537.i, align 8, !noalias !240
  %.540.i = add nsw i64 %.538.i, %"$phi3830.7.2.2"
  store i64 %.540.i, ptr %.537.i, align 8, !noalias !240
  %.638.i9030 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.639.i9031 = load double, ptr %.638.i9030, align 8, !noalias !240
  %.689.i9032 = getelementptr double, ptr %81, i64 %.180.0654.i
  %.690.i = load double, ptr %.689.i9032, align 8, !noalias !240
  %.740.i = getelementptr double, ptr %82, i64 %.180.0654.i
  %.741.i = load double, ptr %.740.i, align 8, !noalias !240
  %.762.i9033 = icmp slt i64 %.381.i, %arg.batch.2.5.0
  br i1 %.762.i9033, label %B500.i, label %B860.i

B500.i:                                           ; preds = %B286.i
  %.785.i = icmp slt i64 %.381.i, 0
  %.786.i = select i1 %.785.i, i64 %arg.batch.2.5.0, i64 0
  %327 = getelementptr double, ptr %arg.batch.2.4, i64 %.381.i
  %.800.i = getelementptr double, ptr %327, i64 %.786.i
  %.801.i = load double, ptr %.800.i, align 8, !noalias !240
  %.805.i = fcmp ugt double %.801.i, %.741.i
  br i1 %.805.i, label %B860.i, label %B524.preheader.i

B524.preheader.i:                                 ; preds = %B500.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.330.i
  %.1288.i = getelementptr double, ptr %83, i64 %.180.0654.i
  %328 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9382 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9384 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9386 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9388 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9390 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9392 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9394 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9396 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9398 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B524.i

B524.i:                                           ; preds = %B836.i, %B524.preheader.i
  %done.2.3.i = phi i64 [ %.1230.i, %B836.i ], [ %.381.i, %B524.preheader.i ]
  br i1 %.892649.not.i, label %B734.i, label %B554.if.lr.ph.i

B554.if.lr.ph.i:                                  ; preds = %B524.i
  %.947.i = icmp slt i64 %done.2.3.i, 0
  %.948.i = select i1 %.947.i, i64 %arg.batch.2.5.0, i64 0
  %329 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.962.i = getelementptr double, ptr %329, i64 %.948.i
  %.1188.i = select i1 %.947.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1189.i = add i64 %.1188.i, %done.2.3.i
  %.1218.i = mul i64 %.1189.i, %arg.batch.3.0.5.2
  %330 = getelementptr double, ptr %328, i64 %.1218.i
  br label %B554.if.i

B582.i9036:                                       ; preds = %B554.if.i
  %.970.i = add nsw i64 %.836.0650.i, %.968.i
  %.972.i = mul nsw i64 %.970.i, %arg.shape.0
  %gep9399 = getelementptr double, ptr %invariant.gep9398, i64 %.972.i
  %.1004.i = load double, ptr %gep9399, align 8, !noalias !240
  br label %B900.i

B734.i:                                           ; preds = %B900.i, %B524.i
  store double 0x7FF0000000000000, ptr %.1288.i, align 8, !noalias !240
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %84
  br i1 %exitcond656.not.i, label %B860.i, label %B836.i

B836.i:                                           ; preds = %B734.i
  %.1230.i = add i64 %done.2.3.i, 1
  %.1323.i = icmp slt i64 %done.2.3.i, -1
  %.1324.i = select i1 %.1323.i, i64 %arg.batch.2.5.0, i64 0
  %331 = getelementptr double, ptr %arg.batch.2.4, i64 %.1230.i
  %.1338.i = getelementptr double, ptr %331, i64 %.1324.i
  %.1339.i = load double, ptr %.1338.i, align 8, !noalias !240
  %.1343.i = fcmp ugt double %.1339.i, %.741.i
  br i1 %.1343.i, label %B860.i, label %B524.i

B860.i:                                           ; preds = %B836.i, %B734.i, %B500.i, %B286.i
  %done.3.2.i = phi i64 [ %.381.i, %B500.i ], [ %.381.i, %B286.i ], [ %arg.batch.2.5.0, %B734.i ], [ %.1230.i, %B836.i ]
  store i64 %done.3.2.i, ptr %.380.i, align 8, !noalias !240
  br label %B899.i

B899.i:                                           ; preds = %B96.if.i, %B860.i, %B240.i, %B192.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3846, label %B96.if.i

B900.i:                                           ; preds = %B38.if.i.i, %B582.i9036
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1004.i, %B582.i9036 ]
  %332 = getelementptr double, ptr %330, i64 %.836.0650.i
  store double %.313.i.i.sink, ptr %332, align 8, !noalias !240
  %exitcond.not.i9035 = icmp eq i64 %arg.shape.1, %.905.i
  br i1 %exitcond.not.i9035, label %B734.i, label %B554.if.i

B96.if.i:                                         ; preds = %B3794, %B899.i
  %.180.0654.i = phi i64 [ %.252.i, %B899.i ], [ 0, %B3794 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.329.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.330.i = load i64, ptr %.329.i, align 8, !noalias !240
  %.380.i = getelementptr i64, ptr %79, i64 %.180.0654.i
  %.381.i = load i64, ptr %.380.i, align 8, !noalias !240
  %.389.i = icmp slt i64 %.330.i, 0
  br i1 %.389.i, label %B899.i, label %B192.i

B554.if.i:                                        ; preds = %B900.i, %B554.if.lr.ph.i
  %.836.0650.i = phi i64 [ 0, %B554.if.lr.ph.i ], [ %.905.i, %B900.i ]
  %.905.i = add nsw i64 %.836.0650.i, 1
  %.963.i = load double, ptr %.962.i, align 8, !noalias !240
  %.965.i = fcmp oeq double %.963.i, %.741.i
  br i1 %.965.i, label %B582.i9036, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B554.if.i
  %.1113.i = fsub double %.963.i, %.639.i9031
  %.1118.i = fdiv double %.1113.i, %.690.i
  %.247.i.i = fsub double 1.000000e+00, %.1118.i
  %.157.i.i = add nsw i64 %.836.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9383 = getelementptr double, ptr %invariant.gep9382, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep9383, align 8, !noalias !243
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.1118.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.836.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9385 = getelementptr double, ptr %invariant.gep9384, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9385, align 8, !noalias !243
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.836.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9387 = getelementptr double, ptr %invariant.gep9386, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9387, align 8, !noalias !243
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1118.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.836.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9389 = getelementptr double, ptr %invariant.gep9388, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9389, align 8, !noalias !243
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.836.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9391 = getelementptr double, ptr %invariant.gep9390, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9391, align 8, !noalias !243
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1118.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.836.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9393 = getelementptr double, ptr %invariant.gep9392, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9393, align 8, !noalias !243
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.836.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9395 = getelementptr double, ptr %invariant.gep9394, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9395, align 8, !noalias !243
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1118.i, %.193.i.6.i
  %.271.i.i9034 = mul nsw i64 %.836.0650.i, %arg.shape.0
  %gep9397 = getelementptr double, ptr %invariant.gep9396, i64 %.271.i.i9034
  %.309.i.i = load double, ptr %gep9397, align 8, !noalias !243
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B900.i

B3846:                                            ; preds = %B899.i, %B3794, %B3786
  br i1 %.4977, label %B3906, label %B3858

B3858:                                            ; preds = %B3846
  %.5032 = load double, ptr %.5031, align 8
  %.5033 = fcmp ogt double %.5032, 5.000000e-01
  br i1 %.5033, label %B3906, label %B3984

B3906:                                            ; preds = %B3858, %B3846
  %.5064 = load i64, ptr %.5063, align 8
  %.5109 = inttoptr i64 %.5064 to ptr
  tail call void %.5109(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3984

B3984:                                            ; preds = %B3906, %B3858
  %brmerge8856.not.not = xor i1 %brmerge8856.not, true
  %brmerge9430 = or i1 %.809, %brmerge8856.not.not
  br i1 %brmerge9430, label %B4040, label %B80.if.i

B144.i:                                           ; preds = %B80.if.i
  %.343.i3441 = getelementptr double, ptr %86, i64 %.141.i3256.09407
  %.344.i3442 = load double, ptr %.343.i3441, align 8, !noalias !247
  %.345.i3443 = fcmp ogt double %.344.i3442, 5.000000e-01
  br i1 %.345.i3443, label %B194.i, label %B920.i

B194.i:                                           ; preds = %B144.i
  %.396.i3487 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3256.09407
  %.397.i3488 = load double, ptr %.396.i3487, align 8, !noalias !247
  %.447.i3533 = getelementptr double, ptr %87, i64 %.141.i3256.09407
  %.448.i3534 = load double, ptr %.447.i3533, align 8, !noalias !247
  %.449.i3535 = fsub double %.397.i3488, %.448.i3534
  br i1 %.536.i35739400.not, label %B510.i, label %B310.if.i.preheader

B310.if.i.preheader:                              ; preds = %B194.i
  %invariant.gep9552 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3256.09407
  %invariant.gep9554 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3256.09407
  br label %B310.if.i

B410.i:                                           ; preds = %B310.if.i
  %.580.i4008 = add nsw i64 %.480.i3271.09402, %arg.shape.1
  %.582.i4010 = mul nsw i64 %.580.i4008, %arg.shape.0
  %gep9553 = getelementptr double, ptr %invariant.gep9552, i64 %.582.i4010
  %.614.i4038 = load double, ptr %gep9553, align 8, !noalias !247
  %.615.i = tail call double @llvm.fabs.f64(double %.614.i4038)
  %.617.i4040 = fmul double %.449.i3535, %.615.i
  %.658.i4070 = load double, ptr %.657.i4069, align 8, !noalias !247
  %.688.i4095 = load double, ptr %arg.tolerances.4, align 8, !noalias !247
  %.691.i4098 = mul nsw i64 %.480.i3271.09402, %arg.shape.0
  %gep9555 = getelementptr double, ptr %invariant.gep9554, i64 %.691.i4098
  %.725.i4127 = load double, ptr %gep9555, align 8, !noalias !247
  %.726.i4128 = tail call double @llvm.fabs.f64(double %.725.i4127)
  %.727.i4129 = fmul double %.688.i4095, %.726.i4128
  %.728.i4130 = fadd double %.658.i4070, %.727.i4129
  %.730.i = fcmp ogt double %.617.i4040, %.728.i4130
  br label %B506.i

B506.i:                                           ; preds = %B410.i, %B310.if.i
  %"$phi506.2.2.i.3" = phi i1 [ true, %B310.if.i ], [ %.730.i, %B410.i ]
  %exitcond9454.not = icmp eq i64 %arg.shape.1, %.549.i
  br i1 %exitcond9454.not, label %B510.i.loopexit, label %B310.if.i

B510.i.loopexit:                                  ; preds = %B506.i
  %333 = select i1 %"$phi506.2.2.i.3", double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %B510.i

B510.i:                                           ; preds = %B510.i.loopexit, %B194.i
  %felt.2.i.2.lcssa = phi double [ 5.000000e-06, %B194.i ], [ %333, %B510.i.loopexit ]
  %.796.i3613 = load double, ptr %.795.i3612, align 8, !noalias !247
  %.826.i3638 = load double, ptr %arg.batch.2.4, align 8, !noalias !247
  %.827.i3639 = fsub double %.796.i3613, %.826.i3638
  %.829.i3641 = fmul double %felt.2.i.2.lcssa, %.827.i3639
  %.833.i3644 = fcmp olt double %.449.i3535, %.829.i3641
  br i1 %.833.i3644, label %B590.i, label %B638.i

B590.i:                                           ; preds = %B510.i
  %334 = getelementptr i64, ptr %89, i64 %.141.i3256.09407
  %.887.i3999 = load i64, ptr %334, align 8, !noalias !247
  %.888.i4000 = add nsw i64 %.887.i3999, 1
  br label %B638.i

B638.i:                                           ; preds = %B510.i, %B590.i
  %"$phi638.1.2.i.2" = phi i64 [ %.888.i4000, %B590.i ], [ 0, %B510.i ]
  %335 = getelementptr i64, ptr %90, i64 %.141.i3256.09407
  store i64 %"$phi638.1.2.i.2", ptr %335, align 8, !noalias !247
  %.1000.i3722 = load double, ptr %.396.i3487, align 8, !noalias !247
  store double %.1000.i3722, ptr %.447.i3533, align 8, !noalias !247
  %.1101.i = getelementptr double, ptr %91, i64 %.141.i3256.09407
  store double 1.000000e+00, ptr %.1101.i, align 8, !noalias !247
  store i64 1, ptr %.1173, align 8, !noalias !247
  %.1183.i = load i64, ptr %335, align 8, !noalias !247
  %.1184.i = icmp sgt i64 %.1183.i, 1000
  br i1 %.1184.i, label %B864.i, label %B920.i

B864.i:                                           ; preds = %B638.i
  %336 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3256.09407
  %.84.i.i3895 = load i64, ptr %336, align 8, !noalias !251
  %.89.i.i3898 = icmp sgt i64 %.84.i.i3895, -1
  br i1 %.89.i.i3898, label %B46.i.i3904, label %B920.i

B46.i.i3904:                                      ; preds = %B864.i
  %.120.i.i3924 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i3895
  %.121.i.i3925 = load i64, ptr %.120.i.i3924, align 8, !noalias !251
  %.122.i.i3926 = icmp eq i64 %.121.i.i3925, 0
  br i1 %.122.i.i3926, label %B80.i.i3931, label %B920.i

B80.i.i3931:                                      ; preds = %B46.i.i3904
  store i64 6, ptr %.120.i.i3924, align 8, !noalias !251
  br label %B920.i

B920.i:                                           ; preds = %B80.i.i3931, %B864.i, %B46.i.i3904, %B638.i, %B144.i, %B80.if.i
  store double 0.000000e+00, ptr %.290.i3394, align 8, !noalias !247
  %.200.i3339 = icmp sgt i64 %.144.i3257.09406, 1
  br i1 %.200.i3339, label %B80.if.i, label %B4040

B80.if.i:                                         ; preds = %B3984, %B920.i
  %.141.i3256.09407 = phi i64 [ %.213.i4159, %B920.i ], [ 0, %B3984 ]
  %.144.i3257.09406 = phi i64 [ %.209.i4156, %B920.i ], [ %storemerge, %B3984 ]
  %.209.i4156 = add nsw i64 %.144.i3257.09406, -1
  %.213.i4159 = add nsw i64 %.141.i3256.09407, 1
  %.290.i3394 = getelementptr double, ptr %85, i64 %.141.i3256.09407
  %.291.i3395 = load double, ptr %.290.i3394, align 8, !noalias !247
  %.292.i3396 = fcmp oeq double %.291.i3395, 1.000000e+00
  br i1 %.292.i3396, label %B144.i, label %B920.i

B310.if.i:                                        ; preds = %B310.if.i.preheader, %B506.i
  %felt.2.i.29403 = phi i1 [ %"$phi506.2.2.i.3", %B506.i ], [ false, %B310.if.i.preheader ]
  %.480.i3271.09402 = phi i64 [ %.549.i, %B506.i ], [ 0, %B310.if.i.preheader ]
  %.549.i = add nsw i64 %.480.i3271.09402, 1
  br i1 %felt.2.i.29403, label %B506.i, label %B410.i

B4040:                                            ; preds = %B920.i, %B3984
  %brmerge8867.not = and i1 %.5179.not, %looked.2.1.lcssa
  %brmerge8867.not.not = xor i1 %brmerge8867.not, true
  %brmerge9429 = or i1 %.809, %brmerge8867.not.not
  br i1 %brmerge9429, label %B4090, label %B114.if.i

B56.i.i:                                          ; preds = %B114.if.i
  %.131.i.i9038 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.95.i.i
  %.132.i.i = load i64, ptr %.131.i.i9038, align 8, !noalias !254
  %.137.i.not.i = icmp eq i64 %.132.i.i, 0
  br i1 %.137.i.not.i, label %B100.i.i, label %B238.i

B100.i.i:                                         ; preds = %B56.i.i
  %.188.i.i9049 = getelementptr double, ptr %92, i64 %.302.01639.i
  %.189.i.i = load double, ptr %.188.i.i9049, align 8, !noalias !254
  %.190.i.i = fcmp olt double %.189.i.i, 5.000000e-01
  br i1 %.190.i.i, label %B238.i, label %B152.i.i

B152.i.i:                                         ; preds = %B100.i.i
  %.252.i.i9050 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.253.i.i9051 = load double, ptr %.252.i.i9050, align 8, !noalias !254
  %.305.i.i = getelementptr double, ptr %93, i64 %.302.01639.i
  %.306.i.i = load double, ptr %.305.i.i, align 8, !noalias !254
  %.309.i.i9052 = fcmp une double %.253.i.i9051, %.306.i.i
  %brmerge.i = select i1 %.309.i.i9052, i1 true, i1 %.175.i1635.not.i
  %not..309.i.i = xor i1 %.309.i.i9052, true
  %some.2.01641.mux.i = select i1 %not..309.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B238.i, label %B76.if.i.lr.ph.i9053

B76.if.i.lr.ph.i9053:                             ; preds = %B152.i.i
  %337 = getelementptr i64, ptr %94, i64 %.302.01639.i
  %.509.i = load i64, ptr %337, align 8, !noalias !259
  %.510.i9054 = add nsw i64 %.509.i, 1
  %.236.i322.i = icmp slt i64 %.509.i, -1
  %.237.i323.i = select i1 %.236.i322.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i324.i = add i64 %.510.i9054, %.237.i323.i
  %.258.i.i9055 = mul i64 %.238.i324.i, %arg.batch.1.3.5.1
  %338 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9055
  br label %B76.if.i.i9056

B76.if.i.i9056:                                   ; preds = %B76.if.i.i9056, %B76.if.i.lr.ph.i9053
  %.117.i261.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i9053 ], [ %.188.i378.i, %B76.if.i.i9056 ]
  %.188.i378.i = add nsw i64 %.117.i261.01636.i, 1
  %339 = getelementptr double, ptr %338, i64 %.117.i261.01636.i
  %.263.i.i9057 = load double, ptr %339, align 8, !noalias !260
  %340 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i261.01636.i
  %.293.i.i9058 = load i64, ptr %340, align 8, !noalias !260
  %.295.i362.i = mul nsw i64 %.293.i.i9058, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i.i9059 = icmp slt i64 %.297.i364.i, 0
  %.312.i.i9060 = select i1 %.311.i.i9059, i64 %arg.batch.5.1.5.0, i64 0
  %341 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i.i9061 = getelementptr double, ptr %341, i64 %.312.i.i9060
  store double %.263.i.i9057, ptr %.326.i.i9061, align 8, !noalias !260
  %exitcond.not.i9062 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i378.i
  br i1 %exitcond.not.i9062, label %B238.i, label %B76.if.i.i9056

B238.i:                                           ; preds = %B76.if.i.i9056, %B114.if.i, %B152.i.i, %B100.i.i, %B56.i.i
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B152.i.i ], [ %some.2.01641.i, %B100.i.i ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B56.i.i ], [ true, %B76.if.i.i9056 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B240.i9039, label %B114.if.i

B240.i9039:                                       ; preds = %B238.i
  br i1 %some.3.1.i, label %B248.i9040, label %B4090

B248.i9040:                                       ; preds = %B240.i9039
  %.633.i = load i64, ptr %.632.i, align 8, !noalias !259
  %.745.i = inttoptr i64 %.633.i to ptr
  tail call void %.745.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !259
  %.776.i = load i64, ptr %.775.i9041, align 8, !noalias !259
  %.892.i9044 = inttoptr i64 %.776.i to ptr
  tail call void %.892.i9044(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.891.i9043), !noalias !259
  br i1 %.896.not.i, label %B690.if.i.preheader, label %B516.i

B516.i:                                           ; preds = %B248.i9040
  %.927.i = load i64, ptr %.926.i, align 8, !noalias !259
  %.1045.i = inttoptr i64 %.927.i to ptr
  tail call void %.1045.i(ptr %arg.batch.4.0.4, ptr %.891.i9043, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !259
  br label %B690.if.i.preheader

B690.if.i.preheader:                              ; preds = %B516.i, %B248.i9040
  br label %B690.if.i

B56.i80.i:                                        ; preds = %B690.if.i
  %.131.i100.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.95.i76.i
  %.132.i101.i = load i64, ptr %.131.i100.i, align 8, !noalias !264
  %.137.i104.not.i = icmp eq i64 %.132.i101.i, 0
  br i1 %.137.i104.not.i, label %B100.i105.i, label %B1238.i

B100.i105.i:                                      ; preds = %B56.i80.i
  %.188.i140.i = getelementptr double, ptr %92, i64 %.1086.01648.i
  %.189.i141.i = load double, ptr %.188.i140.i, align 8, !noalias !264
  %.190.i142.i = fcmp olt double %.189.i141.i, 5.000000e-01
  br i1 %.190.i142.i, label %B1238.i, label %B152.i143.i

B152.i143.i:                                      ; preds = %B100.i105.i
  %.252.i178.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1086.01648.i
  %.253.i179.i = load double, ptr %.252.i178.i, align 8, !noalias !264
  %.305.i215.i = getelementptr double, ptr %93, i64 %.1086.01648.i
  %.306.i216.i = load double, ptr %.305.i215.i, align 8, !noalias !264
  %.309.i218.i = fcmp une double %.253.i179.i, %.306.i216.i
  br i1 %.309.i218.i, label %B1238.i, label %B730.i

B730.i:                                           ; preds = %B152.i143.i
  %.1333.i = getelementptr i64, ptr %95, i64 %.1086.01648.i
  %.1334.i = load i64, ptr %.1333.i, align 8, !noalias !259
  %.1345.i = icmp sgt i64 %.1334.i, 0
  br i1 %.1345.i, label %B826.i, label %B890.i

B826.i:                                           ; preds = %B730.i
  %342 = getelementptr double, ptr %arg.batch.2.4, i64 %.1334.i
  %.1380.i = getelementptr i8, ptr %342, i64 -8
  %.1381.i = load double, ptr %.1380.i, align 8, !noalias !259
  %.1433.i = fcmp oeq double %.1381.i, %.253.i179.i
  br label %B890.i

B890.i:                                           ; preds = %B826.i, %B730.i
  %"$phi890.1.2.1.i" = phi i1 [ %.1433.i, %B826.i ], [ false, %B730.i ]
  br i1 %.15291642.not.i, label %B1120.i, label %B922.if.lr.ph.i

B922.if.lr.ph.i:                                  ; preds = %B890.i
  %.1659.i = add nsw i64 %.1334.i, -1
  %.1698.i = select i1 %.1345.i, i64 0, i64 %arg.batch.3.0.5.1
  %.1699.i = add i64 %.1659.i, %.1698.i
  %.1726.i = mul i64 %.1724.i, %.95.i76.i
  %.1728.i = mul i64 %.1699.i, %arg.batch.3.0.5.2
  %343 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1726.i
  %344 = getelementptr double, ptr %343, i64 %.1728.i
  %invariant.gep9408 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1086.01648.i
  %invariant.gep9410 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1086.01648.i
  br label %B922.if.i

B1028.i:                                          ; preds = %B922.if.i
  %345 = getelementptr double, ptr %344, i64 %.1473.01643.i
  store double %.1607.i, ptr %345, align 8, !noalias !259
  br label %B1050.i

B1050.i:                                          ; preds = %B922.if.i, %B1028.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1542.i
  br i1 %exitcond1651.not.i, label %B1052.loopexit.i, label %B922.if.i

B1052.loopexit.i:                                 ; preds = %B1050.i
  %346 = fcmp une double %.1614.i, 0.000000e+00
  br i1 %346, label %B1064.i, label %B1120.i

B1064.i:                                          ; preds = %B1052.loopexit.i
  %.84.i441.i = load i64, ptr %349, align 8, !noalias !267
  %.89.i444.i = icmp sgt i64 %.84.i441.i, -1
  br i1 %.89.i444.i, label %B46.i.i9047, label %B1120.i

B46.i.i9047:                                      ; preds = %B1064.i
  %.120.i468.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i441.i
  %.121.i469.i = load i64, ptr %.120.i468.i, align 8, !noalias !267
  %.122.i470.i = icmp eq i64 %.121.i469.i, 0
  br i1 %.122.i470.i, label %B80.i.i9048, label %B1120.i

B80.i.i9048:                                      ; preds = %B46.i.i9047
  store i64 3, ptr %.120.i468.i, align 8, !noalias !267
  br label %B1120.i

B1120.i:                                          ; preds = %B80.i.i9048, %B46.i.i9047, %B1064.i, %B1052.loopexit.i, %B890.i
  br i1 %.896.not.i, label %B1238.i, label %B1136.i

B1136.i:                                          ; preds = %B1120.i
  %347 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1086.01648.i
  %.1831.i = load double, ptr %347, align 8, !noalias !259
  %.1833.i = fcmp olt double %.1831.i, -1.000000e-09
  br i1 %.1833.i, label %B1182.i, label %B1238.i

B1182.i:                                          ; preds = %B1136.i
  %.84.i571.i = load i64, ptr %349, align 8, !noalias !270
  %.89.i574.i = icmp sgt i64 %.84.i571.i, -1
  br i1 %.89.i574.i, label %B46.i579.i, label %B1238.i

B46.i579.i:                                       ; preds = %B1182.i
  %.120.i603.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i571.i
  %.121.i604.i = load i64, ptr %.120.i603.i, align 8, !noalias !270
  %.122.i605.i = icmp eq i64 %.121.i604.i, 0
  br i1 %.122.i605.i, label %B80.i610.i, label %B1238.i

B80.i610.i:                                       ; preds = %B46.i579.i
  store i64 4, ptr %.120.i603.i, align 8, !noalias !270
  br label %B1238.i

B1238.i:                                          ; preds = %B690.if.i, %B80.i610.i, %B46.i579.i, %B1182.i, %B1136.i, %B1120.i, %B152.i143.i, %B100.i105.i, %B56.i80.i
  %.1143.i = icmp sgt i64 %.1089.01649.i, 1
  br i1 %.1143.i, label %B690.if.i, label %B4090

B114.if.i:                                        ; preds = %B4040, %B238.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B238.i ], [ false, %B4040 ]
  %.302.01639.i = phi i64 [ %.373.i, %B238.i ], [ 0, %B4040 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %348 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.95.i.i = load i64, ptr %348, align 8, !noalias !254
  %.100.i.i = icmp slt i64 %.95.i.i, 0
  br i1 %.100.i.i, label %B238.i, label %B56.i.i

B690.if.i:                                        ; preds = %B690.if.i.preheader, %B1238.i
  %.1089.01649.i = phi i64 [ %.1152.i, %B1238.i ], [ %storemerge.i9037, %B690.if.i.preheader ]
  %.1086.01648.i = phi i64 [ %.1156.i9046, %B1238.i ], [ 0, %B690.if.i.preheader ]
  %.1152.i = add nsw i64 %.1089.01649.i, -1
  %.1156.i9046 = add nsw i64 %.1086.01648.i, 1
  %349 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1086.01648.i
  %.95.i76.i = load i64, ptr %349, align 8, !noalias !264
  %.100.i79.i = icmp slt i64 %.95.i76.i, 0
  br i1 %.100.i79.i, label %B1238.i, label %B56.i80.i

B922.if.i:                                        ; preds = %B1050.i, %B922.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B922.if.lr.ph.i ], [ %.1614.i, %B1050.i ]
  %.1473.01643.i = phi i64 [ 0, %B922.if.lr.ph.i ], [ %.1542.i, %B1050.i ]
  %.1542.i = add nsw i64 %.1473.01643.i, 1
  %.1573.i = add nsw i64 %.1473.01643.i, %.846.i
  %.1575.i = mul nsw i64 %.1573.i, %arg.shape.0
  %gep9409 = getelementptr double, ptr %invariant.gep9408, i64 %.1575.i
  %.1607.i = load double, ptr %gep9409, align 8, !noalias !259
  %.1612.i = fmul double %.1607.i, 0.000000e+00
  %.1614.i = fadd double %trouble.2.11645.i, %.1612.i
  %.1622.i = mul nsw i64 %.1473.01643.i, %arg.shape.0
  %gep9411 = getelementptr double, ptr %invariant.gep9410, i64 %.1622.i
  store double %.1607.i, ptr %gep9411, align 8, !noalias !259
  br i1 %"$phi890.1.2.1.i", label %B1028.i, label %B1050.i

B4090:                                            ; preds = %B1238.i, %B4040, %B240.i9039
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge9431 = or i1 %.809, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9431, label %B5266, label %B4132.if

B4190:                                            ; preds = %B4132.if
  %.5556 = mul i64 %.5487, %arg.batch.3.3.5.1
  %.5560 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5556
  %.5561 = load i64, ptr %.5560, align 8
  %.5613 = getelementptr i8, ptr %.5560, i64 24
  %.5614 = load i64, ptr %.5613, align 8
  %350 = add i64 %.5561, %.5614
  %.5615 = sub i64 %arg.most, %350
  %.5620 = icmp slt i64 %.5615, 1
  br i1 %.5620, label %B4290, label %B4346

B4290:                                            ; preds = %B4190
  %351 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5329.09416
  %.84.i2021 = load i64, ptr %351, align 8, !noalias !273
  %.89.i2024 = icmp sgt i64 %.84.i2021, -1
  br i1 %.89.i2024, label %B46.i, label %B4346

B46.i:                                            ; preds = %B4290
  %.120.i2047 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2021
  %.121.i2048 = load i64, ptr %.120.i2047, align 8, !noalias !273
  %.122.i2049 = icmp eq i64 %.121.i2048, 0
  br i1 %.122.i2049, label %B80.i2053, label %B4346

B80.i2053:                                        ; preds = %B46.i
  store i64 5, ptr %.120.i2047, align 8, !noalias !273
  br label %B4346

B4346:                                            ; preds = %B80.i2053, %B4290, %B46.i, %B4190
  %.5706 = getelementptr double, ptr %96, i64 %.5329.09416
  %.5707 = load double, ptr %.5706, align 8
  %.5708 = fcmp ogt double %.5707, 5.000000e-01
  br i1 %.5708, label %B4394, label %B4518

B4394:                                            ; preds = %B4346
  %.5759 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5329.09416
  %.5760 = load double, ptr %.5759, align 8
  %.5810 = getelementptr double, ptr %97, i64 %.5329.09416
  %.5811 = load double, ptr %.5810, align 8
  %.5812 = fcmp oeq double %.5760, %.5811
  br i1 %.5812, label %B4478, label %B4518

B4478:                                            ; preds = %B4394
  %.188.i4360 = load i64, ptr %.5486, align 8, !noalias !276
  %.240.i4403 = getelementptr i64, ptr %98, i64 %.5329.09416
  %.241.i4404 = load i64, ptr %.240.i4403, align 8, !noalias !276
  %.242.i4405 = add nsw i64 %.241.i4404, 1
  store i64 %.242.i4405, ptr %.240.i4403, align 8, !noalias !276
  %.357.i4503 = icmp slt i64 %.241.i4404, -1
  %.358.i4504 = select i1 %.357.i4503, i64 %arg.batch.1.2.5.0, i64 0
  %352 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.242.i4405
  %.372.i4518 = getelementptr double, ptr %352, i64 %.358.i4504
  %.373.i4519 = load double, ptr %.372.i4518, align 8, !noalias !276
  %.374.i4520 = fcmp oeq double %.373.i4519, 0x7FF0000000000000
  br i1 %.374.i4520, label %B212.i, label %B290.i

B212.i:                                           ; preds = %B4478
  %.408.i5024 = icmp slt i64 %.188.i4360, 0
  %.409.i5025 = select i1 %.408.i5024, i64 %arg.batch.3.1.5.0, i64 0
  %353 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.188.i4360
  %.423.i5039 = getelementptr i64, ptr %353, i64 %.409.i5025
  %.424.i5040 = load i64, ptr %.423.i5039, align 8, !noalias !276
  %.425.i5041 = icmp eq i64 %.424.i5040, 0
  br i1 %.425.i5041, label %B256.i, label %B4518

B256.i:                                           ; preds = %B212.i
  store i64 1, ptr %.423.i5039, align 8, !noalias !276
  br label %B4518

B290.i:                                           ; preds = %B4478
  store double %.373.i4519, ptr %.5810, align 8, !noalias !276
  %.572.i4607 = select i1 %.357.i4503, i64 %arg.batch.1.4.5.0, i64 0
  %354 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.242.i4405
  %.586.i4621 = getelementptr i64, ptr %354, i64 %.572.i4607
  %.587.i4622 = load i64, ptr %.586.i4621, align 8, !noalias !276
  %.590.i4624 = icmp eq i64 %.587.i4622, 0
  br i1 %.590.i4624, label %B360.i, label %B428.i

B360.i:                                           ; preds = %B290.i
  %.641.i4979 = getelementptr double, ptr %99, i64 %.5329.09416
  store double 1.000000e+00, ptr %.641.i4979, align 8, !noalias !276
  br label %B482.i.sink.split

B428.i:                                           ; preds = %B290.i
  %.709.i4650 = load i64, ptr %.1173, align 8, !noalias !276
  %.710.i4651 = icmp eq i64 %.709.i4650, 0
  br i1 %.710.i4651, label %B482.i.sink.split, label %B482.i

B482.i.sink.split:                                ; preds = %B428.i, %B360.i
  %.sink = phi i64 [ 1, %B360.i ], [ 2, %B428.i ]
  store i64 %.sink, ptr %.1173, align 8, !noalias !276
  br label %B482.i

B482.i:                                           ; preds = %B482.i.sink.split, %B428.i
  br i1 %.175.i.i47979412.not, label %B4518, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B482.i
  %.237.i.i4845 = select i1 %.357.i4503, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i4846 = add i64 %.237.i.i4845, %.242.i4405
  %.258.i.i4859 = mul i64 %.238.i.i4846, %arg.batch.1.3.5.1
  %355 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i4859
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4175.09414 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i4903, %B76.if.i.i ]
  %.188.i.i4903 = add nsw i64 %.117.i.i4175.09414, 1
  %356 = getelementptr double, ptr %355, i64 %.117.i.i4175.09414
  %.263.i.i4862 = load double, ptr %356, align 8, !noalias !280
  %357 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4175.09414
  %.293.i.i4879 = load i64, ptr %357, align 8, !noalias !280
  %.295.i.i4881 = mul nsw i64 %.293.i.i4879, %arg.shape.0
  %.297.i.i4883 = add nsw i64 %.295.i.i4881, %.5329.09416
  %.311.i.i4889 = icmp slt i64 %.297.i.i4883, 0
  %.312.i.i4890 = select i1 %.311.i.i4889, i64 %arg.batch.5.1.5.0, i64 0
  %358 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i4883
  %.326.i.i4897 = getelementptr double, ptr %358, i64 %.312.i.i4890
  store double %.263.i.i4862, ptr %.326.i.i4897, align 8, !noalias !280
  %exitcond9455.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i4903
  br i1 %exitcond9455.not, label %B4518, label %B76.if.i.i

B4518:                                            ; preds = %B76.if.i.i, %B482.i, %B256.i, %B212.i, %B4394, %B4346
  %.5901 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5487
  %.5902 = load i64, ptr %.5901, align 8
  %.5903.not = icmp eq i64 %.5902, 0
  br i1 %.5903.not, label %B4690, label %B4562

B4562:                                            ; preds = %B4518
  %.5960 = getelementptr i64, ptr %100, i64 %.5329.09416
  %.5961 = load i64, ptr %.5960, align 8
  %.5991 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5487
  store i64 %.5961, ptr %.5991, align 8
  store i64 -1, ptr %.5486, align 8
  %.236.i9063 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !284
  %.289.i9068 = getelementptr double, ptr %101, i64 %.5329.09416
  store double 0.000000e+00, ptr %.289.i9068, align 8, !noalias !284
  %.320.i9070 = load i64, ptr %.319.i9069, align 8, !noalias !284
  %.322.i9071 = icmp eq i64 %.236.i9063, %.320.i9070
  br i1 %.322.i9071, label %B4948, label %B142.i9072

B142.i9072:                                       ; preds = %B4562
  %.355.i9073 = add nsw i64 %.236.i9063, 1
  store i64 %.355.i9073, ptr %arg.batch.4.2.4, align 8, !noalias !284
  store i64 1, ptr %.1173, align 8, !noalias !284
  %.434.i9075 = icmp slt i64 %.236.i9063, 0
  %.435.i9076 = select i1 %.434.i9075, i64 %arg.batch.0.2.5.0, i64 0
  %359 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i9063
  %.449.i9077 = getelementptr i64, ptr %359, i64 %.435.i9076
  %.450.i9078 = load i64, ptr %.449.i9077, align 8, !noalias !284
  %.465.i9079 = icmp slt i64 %.450.i9078, 0
  %.466.i9080 = select i1 %.465.i9079, i64 %arg.batch.1.0.5.0, i64 0
  %360 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.450.i9078
  %.480.i9081 = getelementptr i64, ptr %360, i64 %.466.i9080
  %.481.i9082 = load i64, ptr %.480.i9081, align 8, !noalias !284
  store i64 %.236.i9063, ptr %.5486, align 8, !noalias !284
  %.583.i9086 = getelementptr i64, ptr %102, i64 %.5329.09416
  store i64 %.481.i9082, ptr %.583.i9086, align 8, !noalias !284
  store i64 1, ptr %.5960, align 8, !noalias !284
  %.689.i9090 = getelementptr i64, ptr %103, i64 %.5329.09416
  store i64 0, ptr %.689.i9090, align 8, !noalias !284
  br i1 %.7851131.not.i9091, label %B462.i9106, label %B418.if.lr.ph.i9092

B418.if.lr.ph.i9092:                              ; preds = %B142.i9072
  %.847.i9093 = select i1 %.434.i9075, i64 %arg.batch.0.1.5.0, i64 0
  %.848.i9094 = add i64 %.847.i9093, %.236.i9063
  %.868.i9095 = mul i64 %.848.i9094, %arg.batch.0.1.5.1
  %361 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.868.i9095
  %invariant.gep9556 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5329.09416
  br label %B418.if.i9096

B462.i9106:                                       ; preds = %B418.if.i9096, %B142.i9072
  br i1 %.175.i1134.not.i9107, label %B462.endif.i9125, label %B76.if.i.lr.ph.i9108

B76.if.i.lr.ph.i9108:                             ; preds = %B462.i9106
  %.966.i9109 = load i64, ptr %.583.i9086, align 8, !noalias !284
  %.236.i.i9110 = icmp slt i64 %.966.i9109, 0
  %.237.i.i9111 = select i1 %.236.i.i9110, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i9112 = add i64 %.237.i.i9111, %.966.i9109
  %.258.i.i9113 = mul i64 %.238.i.i9112, %arg.batch.1.3.5.1
  %362 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9113
  br label %B76.if.i.i9114

B76.if.i.i9114:                                   ; preds = %B76.if.i.i9114, %B76.if.i.lr.ph.i9108
  %.117.i.01135.i9115 = phi i64 [ 0, %B76.if.i.lr.ph.i9108 ], [ %.188.i.i9116, %B76.if.i.i9114 ]
  %.188.i.i9116 = add nsw i64 %.117.i.01135.i9115, 1
  %363 = getelementptr double, ptr %362, i64 %.117.i.01135.i9115
  %.263.i.i9117 = load double, ptr %363, align 8, !noalias !287
  %364 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i9115
  %.293.i.i9118 = load i64, ptr %364, align 8, !noalias !287
  %.295.i.i9119 = mul nsw i64 %.293.i.i9118, %arg.shape.0
  %.297.i.i9120 = add nsw i64 %.295.i.i9119, %.5329.09416
  %.311.i.i9121 = icmp slt i64 %.297.i.i9120, 0
  %.312.i.i9122 = select i1 %.311.i.i9121, i64 %arg.batch.5.1.5.0, i64 0
  %365 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i9120
  %.326.i.i9123 = getelementptr double, ptr %365, i64 %.312.i.i9122
  store double %.263.i.i9117, ptr %.326.i.i9123, align 8, !noalias !287
  %exitcond1142.not.i9124 = icmp eq i64 %.188.i.i9116, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i9124, label %B462.endif.i9125, label %B76.if.i.i9114

B1038.i9219:                                      ; preds = %B660.if.i9141
  store double 0.000000e+00, ptr %.1825.i9216, align 8, !noalias !284
  br label %B4948

B418.if.i9096:                                    ; preds = %B418.if.i9096, %B418.if.lr.ph.i9092
  %.727.01132.i9097 = phi i64 [ 0, %B418.if.lr.ph.i9092 ], [ %.798.i9098, %B418.if.i9096 ]
  %.798.i9098 = add nsw i64 %.727.01132.i9097, 1
  %366 = getelementptr double, ptr %361, i64 %.727.01132.i9097
  %.873.i9099 = load double, ptr %366, align 8, !noalias !284
  %.875.i9100 = mul nsw i64 %.727.01132.i9097, %arg.shape.0
  %gep9557 = getelementptr double, ptr %invariant.gep9556, i64 %.875.i9100
  store double %.873.i9099, ptr %gep9557, align 8, !noalias !284
  %exitcond.not.i9105 = icmp eq i64 %.798.i9098, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i9105, label %B462.i9106, label %B418.if.i9096

B462.endif.i9125:                                 ; preds = %B76.if.i.i9114, %B462.i9106
  br i1 %.10931137.not.i9126, label %B660.if.i9141, label %B566.if.lr.ph.i9127

B566.if.lr.ph.i9127:                              ; preds = %B462.endif.i9125
  %.1155.i9128 = select i1 %.434.i9075, i64 %arg.batch.0.0.5.0, i64 0
  %.1156.i9129 = add i64 %.1155.i9128, %.236.i9063
  %.1176.i9130 = mul i64 %.1156.i9129, %arg.batch.0.0.5.1
  %367 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1176.i9130
  %invariant.gep9558 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5329.09416
  br label %B566.if.i9131

B566.if.i9131:                                    ; preds = %B566.if.i9131, %B566.if.lr.ph.i9127
  %.1037.01138.i9132 = phi i64 [ 0, %B566.if.lr.ph.i9127 ], [ %.1106.i9133, %B566.if.i9131 ]
  %.1106.i9133 = add nsw i64 %.1037.01138.i9132, 1
  %368 = getelementptr double, ptr %367, i64 %.1037.01138.i9132
  %.1181.i9134 = load double, ptr %368, align 8, !noalias !284
  %.1183.i9135 = mul nsw i64 %.1037.01138.i9132, %arg.shape.0
  %gep9559 = getelementptr double, ptr %invariant.gep9558, i64 %.1183.i9135
  store double %.1181.i9134, ptr %gep9559, align 8, !noalias !284
  %exitcond1143.not.i9140 = icmp eq i64 %.1106.i9133, %arg.shape.1
  br i1 %exitcond1143.not.i9140, label %B660.if.i9141, label %B566.if.i9131

B660.if.i9141:                                    ; preds = %B566.if.i9131, %B462.endif.i9125
  %invariant.gep.i9142 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5329.09416
  store double 0.000000e+00, ptr %invariant.gep.i9142, align 8, !noalias !284
  %gep.1.i9143 = getelementptr double, ptr %invariant.gep.i9142, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i9143, align 8, !noalias !284
  %gep.2.i9145 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.2.idx.i9144
  store double 0.000000e+00, ptr %gep.2.i9145, align 8, !noalias !284
  %gep.3.i9147 = getelementptr i8, ptr %invariant.gep.i9142, i64 %.idx.i9067
  store double 0.000000e+00, ptr %gep.3.i9147, align 8, !noalias !284
  %gep.4.i9149 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.4.idx.i9148
  store double 0.000000e+00, ptr %gep.4.i9149, align 8, !noalias !284
  %gep.5.i9151 = getelementptr i8, ptr %invariant.gep.i9142, i64 %.idx8804
  store double 0.000000e+00, ptr %gep.5.i9151, align 8, !noalias !284
  %gep.6.i9153 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.6.idx.i9152
  store double 0.000000e+00, ptr %gep.6.i9153, align 8, !noalias !284
  %gep.7.i9155 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.7.idx.i9154
  store double 0.000000e+00, ptr %gep.7.i9155, align 8, !noalias !284
  %gep.8.i9157 = getelementptr i8, ptr %invariant.gep.i9142, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i9157, align 8, !noalias !284
  %gep.9.i9159 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.9.idx.i9158
  store double 0.000000e+00, ptr %gep.9.i9159, align 8, !noalias !284
  %gep.10.i9161 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.10.idx.i9160
  store double 0.000000e+00, ptr %gep.10.i9161, align 8, !noalias !284
  %gep.11.i9163 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.11.idx.i9162
  store double 0.000000e+00, ptr %gep.11.i9163, align 8, !noalias !284
  %gep.12.i9165 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.12.idx.i9164
  store double 0.000000e+00, ptr %gep.12.i9165, align 8, !noalias !284
  %gep.13.i9167 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.13.idx.i9166
  store double 0.000000e+00, ptr %gep.13.i9167, align 8, !noalias !284
  %gep.14.i9169 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.14.idx.i9168
  store double 0.000000e+00, ptr %gep.14.i9169, align 8, !noalias !284
  %gep.15.i9171 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.15.idx.i9170
  store double 0.000000e+00, ptr %gep.15.i9171, align 8, !noalias !284
  %gep.16.i9173 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.16.idx.i9172
  store double 0.000000e+00, ptr %gep.16.i9173, align 8, !noalias !284
  %gep.17.i9175 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.17.idx.i9174
  store double 0.000000e+00, ptr %gep.17.i9175, align 8, !noalias !284
  %gep.18.i9177 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.18.idx.i9176
  store double 0.000000e+00, ptr %gep.18.i9177, align 8, !noalias !284
  %gep.19.i9179 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.19.idx.i9178
  store double 0.000000e+00, ptr %gep.19.i9179, align 8, !noalias !284
  %gep.20.i9181 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.20.idx.i9180
  store double 0.000000e+00, ptr %gep.20.i9181, align 8, !noalias !284
  %gep.21.i9183 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.21.idx.i9182
  store double 0.000000e+00, ptr %gep.21.i9183, align 8, !noalias !284
  %gep.22.i9185 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.22.idx.i9184
  store double 0.000000e+00, ptr %gep.22.i9185, align 8, !noalias !284
  %gep.23.i9187 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.23.idx.i9186
  store double 0.000000e+00, ptr %gep.23.i9187, align 8, !noalias !284
  %gep.24.i9189 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.24.idx.i9188
  store double 0.000000e+00, ptr %gep.24.i9189, align 8, !noalias !284
  %gep.25.i9191 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.25.idx.i9190
  store double 0.000000e+00, ptr %gep.25.i9191, align 8, !noalias !284
  %gep.26.i9193 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.26.idx.i9192
  store double 0.000000e+00, ptr %gep.26.i9193, align 8, !noalias !284
  %gep.27.i9195 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.27.idx.i9194
  store double 0.000000e+00, ptr %gep.27.i9195, align 8, !noalias !284
  %gep.28.i9197 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.28.idx.i9196
  store double 0.000000e+00, ptr %gep.28.i9197, align 8, !noalias !284
  %gep.29.i9199 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.29.idx.i9198
  store double 0.000000e+00, ptr %gep.29.i9199, align 8, !noalias !284
  %gep.30.i9201 = getelementptr i8, ptr %invariant.gep.i9142, i64 %gep.30.idx.i9200
  store double 0.000000e+00, ptr %gep.30.i9201, align 8, !noalias !284
  %.1431.i9202 = load double, ptr %arg.batch.2.4, align 8, !noalias !284
  %.1488.i9203 = load i64, ptr %.583.i9086, align 8, !noalias !284
  %.1503.i9204 = icmp slt i64 %.1488.i9203, 0
  %.1504.i9205 = select i1 %.1503.i9204, i64 %arg.batch.1.2.5.0, i64 0
  %369 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1488.i9203
  %.1518.i9206 = getelementptr double, ptr %369, i64 %.1504.i9205
  %.1519.i9207 = load double, ptr %.1518.i9206, align 8, !noalias !284
  store double %.1431.i9202, ptr %invariant.gep.i9142, align 8, !noalias !284
  %.1620.i9210 = getelementptr double, ptr %104, i64 %.5329.09416
  store double %.1519.i9207, ptr %.1620.i9210, align 8, !noalias !284
  store double 1.000000e+00, ptr %.289.i9068, align 8, !noalias !284
  %.1723.i9212 = getelementptr double, ptr %105, i64 %.5329.09416
  store double 0xFFF0000000000000, ptr %.1723.i9212, align 8, !noalias !284
  %.1774.i9214 = getelementptr double, ptr %106, i64 %.5329.09416
  store double 0x7FF0000000000000, ptr %.1774.i9214, align 8, !noalias !284
  %.1825.i9216 = getelementptr double, ptr %107, i64 %.5329.09416
  %.1826.i9217 = load double, ptr %.1825.i9216, align 8, !noalias !284
  %.1828.i9218 = fcmp ueq double %.1826.i9217, 0xFFF0000000000000
  br i1 %.1828.i9218, label %B4948, label %B1038.i9219

B4690:                                            ; preds = %B4518
  %.6179 = getelementptr double, ptr %108, i64 %.5329.09416
  %.6180 = load double, ptr %.6179, align 8
  %.6182 = fcmp ult double %.6180, 1.500000e+01
  br i1 %.6182, label %B4948, label %B4758

B4758:                                            ; preds = %B4690
  %.6226 = load double, ptr %.6225, align 8
  %.6276 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5329.09416
  %.6277 = load double, ptr %.6276, align 8
  %.6278 = fsub double %.6226, %.6277
  %.6328 = getelementptr double, ptr %111, i64 %.5329.09416
  %.6329 = load double, ptr %.6328, align 8
  %.6331 = fmul double %.6329, 5.000000e+03
  %.6332 = fcmp ogt double %.6278, %.6331
  br i1 %.6332, label %B4948, label %B4914

B4914:                                            ; preds = %B4758
  store double 0.000000e+00, ptr %.6179, align 8
  br label %B4948

B4948:                                            ; preds = %B1038.i9219, %B4562, %B660.if.i9141, %B4758, %B4914, %B4690
  %budget.7.4 = phi i64 [ %budget.5.29418, %B4690 ], [ 0, %B4758 ], [ %budget.5.29418, %B4914 ], [ %budget.5.29418, %B660.if.i9141 ], [ %budget.5.29418, %B4562 ], [ %budget.5.29418, %B1038.i9219 ]
  %.6452 = load i64, ptr %.5486, align 8
  %.6453 = icmp sgt i64 %.6452, -1
  br i1 %.6453, label %B4996, label %B5293

B4996:                                            ; preds = %B4948
  %.6458 = add nsw i64 %active.5.29419, 1
  %.6559 = mul i64 %.6452, %arg.batch.3.3.5.1
  %.6563 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6559
  %.6564 = load i64, ptr %.6563, align 8
  %.6575.0 = and i64 %.6564, 127
  %.6605 = sub nsw i64 128, %.6575.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6605, i64 %.5615)
  %.6689 = getelementptr double, ptr %112, i64 %.5329.09416
  %.6690 = load double, ptr %.6689, align 8
  %.6692 = fcmp ogt double %.6690, 0.000000e+00
  %.6703 = sitofp i64 %.11.i to double
  %"$phi5196.1.2.5" = select i1 %.6692, double 1.000000e+00, double %.6703
  %.6762 = getelementptr double, ptr %113, i64 %.5329.09416
  store double %"$phi5196.1.2.5", ptr %.6762, align 8
  %.107.i5173 = getelementptr i64, ptr %114, i64 %.5329.09416
  %.108.i5174 = load i64, ptr %.107.i5173, align 8, !noalias !291
  %.161.i5220 = getelementptr double, ptr %115, i64 %.5329.09416
  %.162.i5221 = load double, ptr %.161.i5220, align 8, !noalias !291
  %.212.i5266 = getelementptr double, ptr %116, i64 %.5329.09416
  store double %.162.i5221, ptr %.212.i5266, align 8, !noalias !291
  %.225.i5274 = icmp slt i64 %.108.i5174, %arg.batch.2.5.0
  br i1 %.225.i5274, label %B164.i, label %B5293

B164.i:                                           ; preds = %B4996
  %.241.i5289 = icmp slt i64 %.108.i5174, 0
  %.242.i5290 = select i1 %.241.i5289, i64 %arg.batch.2.5.0, i64 0
  %370 = getelementptr double, ptr %arg.batch.2.4, i64 %.108.i5174
  %.256.i5304 = getelementptr double, ptr %370, i64 %.242.i5290
  %.257.i5305 = load double, ptr %.256.i5304, align 8, !noalias !291
  %.312.i5353 = load double, ptr %.161.i5220, align 8, !noalias !291
  %.10.i.i = fcmp olt double %.312.i5353, %.257.i5305
  %.11.i.i = select i1 %.10.i.i, double %.312.i5353, double %.257.i5305
  store double %.11.i.i, ptr %.212.i5266, align 8, !noalias !291
  br label %B5293

B5266:                                            ; preds = %B5293, %B4090
  %budget.4.2 = phi i64 [ %.1139, %B4090 ], [ %budget.6.3, %B5293 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B4090 ], [ %active.6.3, %B5293 ]
  %.6840 = icmp sgt i64 %active.8.2, 0
  %.6854 = icmp sgt i64 %budget.4.2, 0
  %or.cond8868 = select i1 %.6840, i1 %.6854, i1 false
  br i1 %or.cond8868, label %B738, label %B5292

B5292:                                            ; preds = %B5266, %B710
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B710 ], [ %active.8.2, %B5266 ]
  br i1 %.809, label %B5292.endif, label %B82.if.i1944.lr.ph

B82.if.i1944.lr.ph:                               ; preds = %B5292
  %.idx = mul i64 %arg.batch.4.0.5.1, 208
  %371 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8802 = mul i64 %arg.batch.4.0.5.1, 216
  %372 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8802
  %.672.i1617 = add nsw i64 %arg.shape.2, -1
  %.idx8803 = mul i64 %arg.batch.4.0.5.1, 192
  %373 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8803
  br label %B82.if.i1944

B140.i1293:                                       ; preds = %B82.if.i1944
  %.311.i1337 = getelementptr double, ptr %371, i64 %.105.i1143.09426
  %.312.i1338 = load double, ptr %.311.i1337, align 8, !noalias !295
  %.5.i.i1339 = fptosi double %.312.i1338 to i64
  %.386.i1384 = getelementptr double, ptr %372, i64 %.105.i1143.09426
  %.387.i1385 = load double, ptr %.386.i1384, align 8, !noalias !295
  %.5.i1.i1386 = fptosi double %.387.i1385 to i64
  %.463.i1433 = mul i64 %.255.i1286, %arg.batch.3.3.5.1
  %.467.i1436 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.463.i1433
  %.468.i1437 = load i64, ptr %.467.i1436, align 8, !noalias !295
  %.470.i1439 = add nsw i64 %.468.i1437, %.5.i.i1339
  store i64 %.470.i1439, ptr %.467.i1436, align 8, !noalias !295
  %.568.i1523 = getelementptr i8, ptr %.467.i1436, i64 24
  %.569.i1524 = load i64, ptr %.568.i1523, align 8, !noalias !295
  %.571.i1526 = add nsw i64 %.569.i1524, %.5.i1.i1386
  store i64 %.571.i1526, ptr %.568.i1523, align 8, !noalias !295
  %.669.i1614 = getelementptr i8, ptr %.467.i1436, i64 8
  %.670.i1615 = load i64, ptr %.669.i1614, align 8, !noalias !295
  %.675.i1620 = add nsw i64 %.5.i1.i1386, %.5.i.i1339
  %.676.i1621 = mul nsw i64 %.675.i1620, %.672.i1617
  %..5.i.i1339 = select i1 %.625, i64 0, i64 %.5.i.i1339
  %.677.i1622 = add i64 %.676.i1621, %..5.i.i1339
  %.802.i1724 = add i64 %.677.i1622, %.670.i1615
  store i64 %.802.i1724, ptr %.669.i1614, align 8, !noalias !295
  store double 0.000000e+00, ptr %.311.i1337, align 8, !noalias !295
  store double 0.000000e+00, ptr %.386.i1384, align 8, !noalias !295
  %.1017.i1892 = getelementptr double, ptr %373, i64 %.105.i1143.09426
  %.1018.i1893 = load double, ptr %.1017.i1892, align 8, !noalias !295
  %.1026.i1899 = sitofp i64 %.675.i1620 to double
  %.1027.i1900 = fsub double %.1018.i1893, %.1026.i1899
  store double %.1027.i1900, ptr %.1017.i1892, align 8, !noalias !295
  br label %B682.i1290

B682.i1290:                                       ; preds = %B140.i1293, %B82.if.i1944
  %.164.i1224 = icmp sgt i64 %.108.i1144.09427, 1
  br i1 %.164.i1224, label %B82.if.i1944, label %B5292.endif

B82.if.i1944:                                     ; preds = %B82.if.i1944.lr.ph, %B682.i1290
  %.108.i1144.09427 = phi i64 [ %storemerge, %B82.if.i1944.lr.ph ], [ %.173.i1949, %B682.i1290 ]
  %.105.i1143.09426 = phi i64 [ 0, %B82.if.i1944.lr.ph ], [ %.177.i1952, %B682.i1290 ]
  %.173.i1949 = add nsw i64 %.108.i1144.09427, -1
  %.177.i1952 = add nsw i64 %.105.i1143.09426, 1
  %374 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1143.09426
  %.255.i1286 = load i64, ptr %374, align 8, !noalias !295
  %.260.i1289 = icmp sgt i64 %.255.i1286, -1
  br i1 %.260.i1289, label %B140.i1293, label %B682.i1290

B5293:                                            ; preds = %B4996, %B164.i, %B4948, %B4132.if
  %budget.6.3 = phi i64 [ %budget.5.29418, %B4132.if ], [ %budget.7.4, %B4948 ], [ %budget.7.4, %B164.i ], [ %budget.7.4, %B4996 ]
  %active.6.3 = phi i64 [ %active.5.29419, %B4132.if ], [ %active.5.29419, %B4948 ], [ %.6458, %B164.i ], [ %.6458, %B4996 ]
  %.5392 = icmp sgt i64 %.5332.09417, 1
  br i1 %.5392, label %B4132.if, label %B5266

common.ret:                                       ; preds = %B3746.if, %B3700.if, %B3632.endif.if, %B3058.endif.if, %B5292.endif
  %common.ret.op = phi i32 [ %.4645, %B3632.endif.if ], [ %.4068, %B3058.endif.if ], [ 0, %B5292.endif ], [ %common.ret.op.i8953, %B3746.if ], [ %common.ret.op.i, %B3700.if ]
  ret i32 %common.ret.op

B550.if:                                          ; preds = %B550.if.lr.ph, %B646
  %active.4.09245 = phi i64 [ 0, %B550.if.lr.ph ], [ %.1096, %B646 ]
  %.798.09244 = phi i64 [ %storemerge, %B550.if.lr.ph ], [ %.862, %B646 ]
  %.795.09243 = phi i64 [ 0, %B550.if.lr.ph ], [ %.866, %B646 ]
  %.862 = add nsw i64 %.798.09244, -1
  %.866 = add nsw i64 %.795.09243, 1
  %375 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.795.09243
  %.944 = load i64, ptr %375, align 8
  %.945 = icmp slt i64 %.944, 0
  br i1 %.945, label %B602, label %B646

B1706.if:                                         ; preds = %B1674, %B1892
  %.2084.09260 = phi i64 [ %.2153, %B1892 ], [ 1, %B1674 ]
  %.2153 = add i64 %.2084.09260, 1
  %376 = getelementptr i64, ptr %arg.code.4, i64 %.2084.09260
  %377 = getelementptr i8, ptr %376, i64 128
  %.2212 = load i64, ptr %377, align 8
  %.2257 = inttoptr i64 %.2212 to ptr
  tail call void %.2257(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2261 = add nsw i64 %.2084.09260, %.
  %.2263 = mul nsw i64 %.2261, %.463
  %.2309 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2263
  tail call void %.2310(ptr %.571, ptr %.2284, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2309)
  br i1 %or.cond9227.not, label %B68.if.lr.ph.i, label %B1892

B2046.if:                                         ; preds = %B1894, %B2152
  %looked.2.19266 = phi i1 [ %"$phi2152.1.2.2", %B2152 ], [ %spec.select8869, %B1894 ]
  %good.2.19265 = phi i1 [ %"$phi2100.1.2.2", %B2152 ], [ false, %B1894 ]
  %.2529.09264 = phi i64 [ %.2591, %B2152 ], [ %storemerge, %B1894 ]
  %.2526.09263 = phi i64 [ %.2595, %B2152 ], [ 0, %B1894 ]
  %.2591 = add nsw i64 %.2529.09264, -1
  %.2595 = add nsw i64 %.2526.09263, 1
  br i1 %good.2.19265, label %B2100, label %B2054

B2228.if:                                         ; preds = %B2226.preheader, %B2834
  %checked.3.29276 = phi i1 [ %checked.4.3, %B2834 ], [ false, %B2226.preheader ]
  %within.3.29275 = phi i1 [ %within.4.3, %B2834 ], [ false, %B2226.preheader ]
  %.2876.09274 = phi i64 [ %.2945, %B2834 ], [ %storemerge, %B2226.preheader ]
  %.2873.09273 = phi i64 [ %.2949, %B2834 ], [ 0, %B2226.preheader ]
  %.2945 = add nsw i64 %.2876.09274, -1
  %.2949 = add nsw i64 %.2873.09273, 1
  %.3030 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2873.09273
  %.3031 = load i64, ptr %.3030, align 8
  %.3081 = getelementptr i64, ptr %38, i64 %.2873.09273
  %.3082 = load i64, ptr %.3081, align 8
  %.3138 = getelementptr double, ptr %39, i64 %.2873.09273
  store double 0.000000e+00, ptr %.3138, align 8
  %.3141 = icmp sgt i64 %.3031, -1
  br i1 %.3141, label %B2358, label %B2834

B46.i2160:                                        ; preds = %B2406
  %.120.i2186 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2152
  %.121.i2187 = load i64, ptr %.120.i2186, align 8, !noalias !50
  %.122.i2188 = icmp eq i64 %.121.i2187, 0
  br i1 %.122.i2188, label %B80.i2193, label %B2516

B80.i2193:                                        ; preds = %B46.i2160
  store i64 %.5.i, ptr %.120.i2186, align 8, !noalias !50
  br label %B2516

B3058.endif.if:                                   ; preds = %B3058
  %.4069 = load ptr, ptr %excinfo.9, align 8
  store ptr %.4069, ptr %excinfo, align 8
  br label %common.ret

B3258.if:                                         ; preds = %B3210
  %.4259 = load i64, ptr %118, align 8
  %.4304 = inttoptr i64 %.4259 to ptr
  tail call void %.4304(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.4355(ptr %.571, ptr %.4329, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4354)
  %.4259.1 = load i64, ptr %119, align 8
  %.4304.1 = inttoptr i64 %.4259.1 to ptr
  tail call void %.4304.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.4355(ptr %.571, ptr %.4329, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4354.1)
  %.4259.2 = load i64, ptr %120, align 8
  %.4304.2 = inttoptr i64 %.4259.2 to ptr
  tail call void %.4304.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  tail call void %.4355(ptr %.571, ptr %.4329, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4354.2)
  %.4393 = load i64, ptr %.4392, align 8
  %.4438 = inttoptr i64 %.4393 to ptr
  tail call void %.4438(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4470 = load i64, ptr %.4469, align 8
  %.4515 = inttoptr i64 %.4470 to ptr
  tail call void %.4515(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.809, label %B3628, label %B64.if.i3146

B3632.endif.if:                                   ; preds = %B3632
  %.4646 = load ptr, ptr %excinfo.11, align 8
  store ptr %.4646, ptr %excinfo, align 8
  br label %common.ret

B3632.endif.endif:                                ; preds = %B3632
  %.4655 = load i8, ptr %.4591, align 1
  %.4658.not = icmp eq i8 %.4655, 0
  br i1 %.4658.not, label %B3742, label %B3700

B3700.if:                                         ; preds = %_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.12.3, ptr %excinfo, align 8
  br label %common.ret

B3746.if:                                         ; preds = %_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.13.2, ptr %excinfo, align 8
  br label %common.ret

B4132.if:                                         ; preds = %B4090, %B5293
  %active.5.29419 = phi i64 [ %active.6.3, %B5293 ], [ 0, %B4090 ]
  %budget.5.29418 = phi i64 [ %budget.6.3, %B5293 ], [ %.1139, %B4090 ]
  %.5332.09417 = phi i64 [ %.5401, %B5293 ], [ %storemerge, %B4090 ]
  %.5329.09416 = phi i64 [ %.5405, %B5293 ], [ 0, %B4090 ]
  %.5401 = add nsw i64 %.5332.09417, -1
  %.5405 = add nsw i64 %.5329.09416, 1
  %.5486 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5329.09416
  %.5487 = load i64, ptr %.5486, align 8
  %.5492 = icmp slt i64 %.5487, 0
  br i1 %.5492, label %B5293, label %B4190

B5292.endif:                                      ; preds = %B682.i1290, %B5292
  store i64 %active.10.0, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

define internal fastcc range(i32 0, 2) i32 @_ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr noalias nonnull %retptr, ptr noalias nonnull %excinfo, ptr readonly %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.decided, ptr readonly %arg.times.4, i64 %arg.times.5.0, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0) unnamed_addr {
entry:
  %0 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.226 = getelementptr i8, ptr %0, i64 -8
  %.227 = load double, ptr %.226, align 8
  %.256 = load double, ptr %arg.times.4, align 8
  %.257 = fsub double %.227, %.256
  %.258 = fmul double %.257, 1.000000e-13
  %.296 = icmp sgt i64 %arg.shape.2, 4
  %. = select i1 %.296, i64 0, i64 8
  %.354 = sub nsw i64 9, %.
  %.5201302.not = icmp slt i64 %arg.shape.0, 1
  %factor.op.mul = mul i64 %arg.decided, 3
  %.idx1285 = mul i64 %arg.lane.0.5.1, 48
  %1 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1285
  %.idx1286 = shl i64 %arg.lane.0.5.1, 6
  %2 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1286
  %.287.i1299.not = icmp slt i64 %arg.shape.1, 1
  %.358.i = shl nsw i64 %arg.shape.1, 4
  %.644.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.707 = getelementptr i8, ptr %arg.code.4, i64 40
  %.748.idx = shl i64 %arg.lane.0.5.1, 6
  %.748 = getelementptr i8, ptr %arg.lane.0.4, i64 %.748.idx
  %.779 = mul i64 %arg.shape.1, %arg.shape.0
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6 = mul nsw i64 %arg.shape.1, 18
  br label %B256.if

B290.loopexit:                                    ; preds = %B122.if.i, %switch.end
  %exitcond1319.not = icmp eq i64 %arg.shape.0, %.533
  br i1 %exitcond1319.not, label %B358, label %B290.if

B358:                                             ; preds = %B290.loopexit, %B256.if
  %.634 = icmp ult i64 %.341.01305, 8
  %.1288 = select i1 %.634, i64 16, i64 17
  %.650 = mul i64 %.644.reass, %.341.01305
  %.708 = load i64, ptr %.707, align 8
  %.783 = mul i64 %.779, %.1288
  %.801 = getelementptr double, ptr %arg.arrays.0.4, i64 %.783
  %.826 = getelementptr double, ptr %arg.arrays.4.4, i64 %.650
  %.827 = inttoptr i64 %.708 to ptr
  tail call void %.827(ptr %.748, ptr %.801, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.826)
  %.399 = icmp sgt i64 %.344.01306, 1
  br i1 %.399, label %B256.if, label %B600

B600:                                             ; preds = %B358
  %.9351308 = icmp sgt i64 %arg.shape.0, 0
  br i1 %.9351308, label %B634.lr.ph, label %B1548

B634.lr.ph:                                       ; preds = %B600
  %.881.11311 = add nsw i64 %arg.shape.0, -1
  %factor.op.mul1307 = mul i64 %arg.decided, 3
  %.idx = mul i64 %arg.lane.0.5.1, 56
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx1274 = shl i64 %arg.lane.1.5.1, 5
  %4 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1274
  %.idx1275 = shl i64 %arg.lane.0.5.1, 6
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1275
  %.idx1276 = mul i64 %arg.lane.0.5.1, 40
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1276
  %.1289 = select i1 %.296, i64 0, i64 7
  %storemerge1277 = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.194.i79 = mul nsw i64 %arg.decided, %arg.shape.0
  %.idx1279 = mul i64 %arg.lane.0.5.1, 112
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1279
  %.idx1280 = mul i64 %arg.lane.0.5.1, 120
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1280
  %.idx1281 = mul i64 %arg.lane.0.5.1, 48
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1281
  %.1816 = fmul double %.258, 2.000000e+00
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
  %.925.sroa.0.01316 = phi i64 [ 0, %B634.lr.ph ], [ %.925.sroa.0.0, %B1544 ]
  %.881.11315 = phi i64 [ %.881.11311, %B634.lr.ph ], [ %.881.1, %B1544 ]
  %.878.11314 = phi i64 [ 1, %B634.lr.ph ], [ %.878.1, %B1544 ]
  %some.2.01313 = phi i1 [ false, %B634.lr.ph ], [ %some.3.1, %B1544 ]
  %excinfo.3.01312 = phi ptr [ null, %B634.lr.ph ], [ %excinfo.3.1, %B1544 ]
  %.1006 = icmp slt i64 %.925.sroa.0.01316, 0
  %.1007 = select i1 %.1006, i64 %arg.lane.0.5.1, i64 0
  %.1008 = add i64 %.1007, %.925.sroa.0.01316
  %.1029 = getelementptr double, ptr %3, i64 %.1008
  %.1030 = load double, ptr %.1029, align 8
  %.1058 = select i1 %.1006, i64 %arg.lane.1.5.1, i64 0
  %.1059 = add i64 %.1058, %.925.sroa.0.01316
  %.1080 = getelementptr i64, ptr %4, i64 %.1059
  store i64 -1, ptr %.1080, align 8
  %.1131 = getelementptr double, ptr %5, i64 %.1008
  store double %.1030, ptr %.1131, align 8
  %.1182 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1059
  %.1183 = load i64, ptr %.1182, align 8
  %.1184 = icmp sgt i64 %.1183, -1
  br i1 %.1184, label %B792, label %B1544

B792:                                             ; preds = %B634
  %.1238 = getelementptr double, ptr %6, i64 %.1008
  %.1239 = load double, ptr %.1238, align 8
  %.1240 = fcmp ogt double %.1239, 5.000000e-01
  br i1 %.1240, label %B842, label %B1544

B842:                                             ; preds = %B792
  %.1326 = load i64, ptr %.1080, align 8
  %.1327 = icmp slt i64 %.1326, 0
  br i1 %.1327, label %B940, label %B1088

B940:                                             ; preds = %B842, %B1040
  %last.2.3 = phi i64 [ %.1333, %B1040 ], [ %.1289, %B842 ]
  %.1333 = add nsw i64 %last.2.3, 1
  %.151.i51 = mul nsw i64 %.1333, 3
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
  %.161.i = add nsw i64 %.159.i, %.925.sroa.0.01316
  %.175.i63 = icmp slt i64 %.161.i, 0
  %.176.i64 = select i1 %.175.i63, i64 %arg.arrays.4.5.0, i64 0
  %12 = getelementptr double, ptr %arg.arrays.4.4, i64 %.161.i
  %.190.i = getelementptr double, ptr %12, i64 %.176.i64
  %.191.i = load double, ptr %.190.i, align 8, !noalias !299
  %.195.i80 = add nsw i64 %.161.i, %.194.i79
  %.209.i = icmp slt i64 %.195.i80, 0
  %.210.i = select i1 %.209.i, i64 %arg.arrays.4.5.0, i64 0
  %13 = getelementptr double, ptr %arg.arrays.4.4, i64 %.195.i80
  %.224.i91 = getelementptr double, ptr %13, i64 %.210.i
  %.225.i92 = load double, ptr %.224.i91, align 8, !noalias !299
  %.226.i93 = fneg double %.225.i92
  %.227.i94 = fcmp olt double %.191.i, %.226.i93
  br i1 %.227.i94, label %B940.endif, label %B34.i

B1040:                                            ; preds = %B940.endif
  %.1487 = icmp slt i64 %.1348.0, 0
  br i1 %.1487, label %B940, label %B1088

B1088:                                            ; preds = %B940.endif, %B1040, %B842
  %last.3.2 = phi i64 [ %.1289, %B842 ], [ %.1333, %B1040 ], [ 8, %B940.endif ]
  br i1 %.296, label %B1096, label %B1126

B1096:                                            ; preds = %B1088
  %14 = getelementptr double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2
  %switch.gep = getelementptr i8, ptr %14, i64 64
  %switch.load = load double, ptr %switch.gep, align 8
  br label %B1126

B1126:                                            ; preds = %B1096, %B1088
  %"$phi1126.1.2.2" = phi double [ 0.000000e+00, %B1088 ], [ %switch.load, %B1096 ]
  %.1595 = getelementptr double, ptr %7, i64 %.1008
  store double %"$phi1126.1.2.2", ptr %.1595, align 8
  %15 = getelementptr double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2
  %switch.gep4 = getelementptr i8, ptr %15, i64 72
  %switch.load5 = load double, ptr %switch.gep4, align 8
  %.1683 = getelementptr double, ptr %8, i64 %.1008
  store double %switch.load5, ptr %.1683, align 8
  %.1735 = load i64, ptr %.1080, align 8
  %.1736 = icmp sgt i64 %.1735, -1
  %.1746 = sext i1 %.1736 to i64
  %"$phi1274.1.2.2" = add nsw i64 %last.3.2, %.1746
  br i1 %.296, label %B1282, label %B1492

B1282:                                            ; preds = %B1126
  %.1813 = getelementptr double, ptr %9, i64 %.1008
  %.1814 = load double, ptr %.1813, align 8
  %.1817 = fcmp ogt double %.1814, %.1816
  br i1 %.1817, label %B1340, label %B1492

B1340:                                            ; preds = %B1282
  %.96.i = load double, ptr %.1029, align 8, !noalias !303
  %.97.i = tail call double @llvm.fabs.f64(double %.96.i)
  %.98.i = fmul double %.97.i, 1.000000e-15
  %.152.i = fdiv double %.98.i, %.1814
  br i1 %.239454.i, label %B178.lr.ph.i, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

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
  %.282.i = add nsw i64 %.280.i, %.925.sroa.0.01316
  %.192.i.i = add nsw i64 %.282.i, %.41.i.reass
  %.206.i.i = icmp slt i64 %.192.i.i, 0
  %.207.i.i = select i1 %.206.i.i, i64 %arg.arrays.4.5.0, i64 0
  %17 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.i
  %.221.i.i = getelementptr double, ptr %17, i64 %.207.i.i
  %.222.i.i = load double, ptr %.221.i.i, align 8, !noalias !307
  %.472.i.i = icmp slt i64 %.282.i, 0
  %.473.i.i = select i1 %.472.i.i, i64 %arg.arrays.4.5.0, i64 0
  %18 = getelementptr double, ptr %arg.arrays.4.4, i64 %.282.i
  %.487.i.i = getelementptr double, ptr %18, i64 %.473.i.i
  %.488.i.i = load double, ptr %.487.i.i, align 8, !noalias !307
  %.489.i.i = fmul double %.488.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i = fsub double %.222.i.i, %.489.i.i
  %.458.i.1.i = add nsw i64 %.282.i, %.454.i.i
  %.472.i.1.i = icmp slt i64 %.458.i.1.i, 0
  %.473.i.1.i = select i1 %.472.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %19 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.1.i
  %.487.i.1.i = getelementptr double, ptr %19, i64 %.473.i.1.i
  %.488.i.1.i = load double, ptr %.487.i.1.i, align 8, !noalias !307
  %.489.i.1.i = fmul double %.488.i.1.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i = fsub double %.491.i.i, %.489.i.1.i
  %.458.i.2.i = add nsw i64 %.282.i, %.456.i.2.i
  %.472.i.2.i = icmp slt i64 %.458.i.2.i, 0
  %.473.i.2.i = select i1 %.472.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %20 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.2.i
  %.487.i.2.i = getelementptr double, ptr %20, i64 %.473.i.2.i
  %.488.i.2.i = load double, ptr %.487.i.2.i, align 8, !noalias !307
  %.489.i.2.i = fmul double %.488.i.2.i, 0x3FE1306AA3D795F4
  %21 = fadd double %.491.i.1.i, %.489.i.2.i
  %.458.i.3.i = add nsw i64 %.282.i, %.456.i.3.i
  %.472.i.3.i = icmp slt i64 %.458.i.3.i, 0
  %.473.i.3.i = select i1 %.472.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %22 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.3.i
  %.487.i.3.i = getelementptr double, ptr %22, i64 %.473.i.3.i
  %.488.i.3.i = load double, ptr %.487.i.3.i, align 8, !noalias !307
  %.489.i.3.i = fmul double %.488.i.3.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i = fsub double %21, %.489.i.3.i
  %.458.i.4.i = add nsw i64 %.282.i, %.456.i.4.i
  %.472.i.4.i = icmp slt i64 %.458.i.4.i, 0
  %.473.i.4.i = select i1 %.472.i.4.i, i64 %arg.arrays.4.5.0, i64 0
  %23 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.4.i
  %.487.i.4.i = getelementptr double, ptr %23, i64 %.473.i.4.i
  %.488.i.4.i = load double, ptr %.487.i.4.i, align 8, !noalias !307
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
  %.222.i.1.i = load double, ptr %.221.i.1.i, align 8, !noalias !307
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
  %.222.i.2.i = load double, ptr %.221.i.2.i, align 8, !noalias !307
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
  %.222.i.3.i = load double, ptr %.221.i.3.i, align 8, !noalias !307
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
  %.325.i = add nsw i64 %.323.i, %.925.sroa.0.01316
  %34 = getelementptr double, ptr %arg.arrays.4.4, i64 %.325.i
  %.339.i = icmp slt i64 %.325.i, 0
  %.340.i = select i1 %.339.i, i64 %arg.arrays.4.5.0, i64 0
  %.354.i = getelementptr double, ptr %34, i64 %.340.i
  %.355.i = load double, ptr %.354.i, align 8, !noalias !303
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
  %.766.i = load double, ptr %.765.i, align 8, !noalias !303
  %.769.i = mul nsw i64 %.680.sroa.0.0453.i, %.41.i.reass
  %.771.i = add nsw i64 %.769.i, %.282.i
  %.785.i = icmp slt i64 %.771.i, 0
  %.786.i = select i1 %.785.i, i64 %arg.arrays.4.5.0, i64 0
  %36 = getelementptr double, ptr %arg.arrays.4.4, i64 %.771.i
  %.800.i = getelementptr double, ptr %36, i64 %.786.i
  %.801.i = load double, ptr %.800.i, align 8, !noalias !303
  %.803.i = add nsw i64 %.680.sroa.0.0453.i, 1
  %.805.i = mul nsw i64 %.803.i, %.41.i.reass
  %.807.i = add nsw i64 %.805.i, %.282.i
  %.821.i = icmp slt i64 %.807.i, 0
  %.822.i = select i1 %.821.i, i64 %arg.arrays.4.5.0, i64 0
  %37 = getelementptr double, ptr %arg.arrays.4.4, i64 %.807.i
  %.836.i = getelementptr double, ptr %37, i64 %.822.i
  %.837.i = load double, ptr %.836.i, align 8, !noalias !303
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
  br i1 %38, label %switch.lookup7, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

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
  br i1 %.1312.i, label %B1225.i, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1225.i:                                          ; preds = %B1186.i, %B178.i
  %.239.i = icmp sgt i64 %.183.1460.i, 0
  %.252.i = zext i1 %.239.i to i64
  %.180.1.i = add i64 %.180.1459.i, %.252.i
  %.248.i = sext i1 %.239.i to i64
  %.183.1.i = add nsw i64 %.183.1460.i, %.248.i
  %.229.sroa.0.0.i = select i1 %.239.i, i64 %.180.1459.i, i64 0
  br i1 %.239.i, label %B178.i, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

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
  br i1 %39, label %switch.lookup11, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup11:                                  ; preds = %switch.lookup7
  %switch.gep8 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx6
  %switch.load9 = load double, ptr %switch.gep8, align 8
  %switch.gep12 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx10
  %switch.load13 = load double, ptr %switch.gep12, align 8
  %.1047.i = fsub double %switch.load9, %switch.load13
  %switch.tableidx14 = add i64 %.680.sroa.0.0453.i, 10
  %40 = icmp ult i64 %switch.tableidx14, 18
  br i1 %40, label %switch.lookup15, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup15:                                  ; preds = %switch.lookup11
  %switch.tableidx18 = add i64 %.680.sroa.0.0453.i, 9
  %41 = icmp ult i64 %switch.tableidx18, 18
  br i1 %41, label %switch.lookup19, label %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup19:                                  ; preds = %switch.lookup15
  %switch.gep16 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx14
  %switch.load17 = load double, ptr %switch.gep16, align 8
  %switch.gep20 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx18
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

_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1225.i, %B1186.i, %B872.i, %switch.lookup7, %switch.lookup11, %switch.lookup15, %B1340
  %.1855.not = phi i1 [ true, %B1340 ], [ true, %B872.i ], [ true, %switch.lookup15 ], [ true, %switch.lookup11 ], [ true, %switch.lookup7 ], [ true, %B1225.i ], [ false, %B1186.i ]
  %excinfo.3.3 = phi ptr [ %excinfo.3.01312, %B1340 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %B872.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup15 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup11 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup7 ], [ %excinfo.3.01312, %B1186.i ], [ %excinfo.3.01312, %B1225.i ]
  %.1844.not = phi i1 [ true, %B1340 ], [ false, %B872.i ], [ false, %switch.lookup15 ], [ false, %switch.lookup11 ], [ false, %switch.lookup7 ], [ true, %B1186.i ], [ true, %B1225.i ]
  %common.ret.op.i = phi i32 [ 0, %B1340 ], [ 1, %B872.i ], [ 1, %switch.lookup15 ], [ 1, %switch.lookup11 ], [ 1, %switch.lookup7 ], [ 0, %B1186.i ], [ 0, %B1225.i ]
  br i1 %.1844.not, label %B1340.endif.endif, label %B1340.endif.if, !prof !53

B1380:                                            ; preds = %B1340.endif.endif
  %.1926 = fmul double %.1814, 5.000000e-01
  store double 0.000000e+00, ptr %.1238, align 8, !noalias !311
  %.161.i230 = getelementptr double, ptr %10, i64 %.1008
  store double 0.000000e+00, ptr %.161.i230, align 8, !noalias !311
  %.214.i273 = getelementptr double, ptr %11, i64 %.1008
  store double %.1926, ptr %.214.i273, align 8, !noalias !311
  %.268.i313 = load i64, ptr %.1182, align 8, !noalias !311
  %.294.i = icmp slt i64 %.268.i313, 0
  %.295.i = select i1 %.294.i, i64 %arg.results.3.5.0, i64 0
  %.296.i324 = add i64 %.295.i, %.268.i313
  %.316.i333 = mul i64 %.296.i324, %arg.results.3.5.1
  %.320.i = getelementptr i64, ptr %arg.results.3.4, i64 %.316.i333
  %.321.i = load i64, ptr %.320.i, align 8, !noalias !311
  %.322.i336 = add nsw i64 %.321.i, -1
  store i64 %.322.i336, ptr %.320.i, align 8, !noalias !311
  %.426.i = load i64, ptr %.1182, align 8, !noalias !311
  %.452.i = icmp slt i64 %.426.i, 0
  %.453.i = select i1 %.452.i, i64 %arg.results.3.5.0, i64 0
  %.454.i = add i64 %.453.i, %.426.i
  %.474.i = mul i64 %.454.i, %arg.results.3.5.1
  %42 = getelementptr i64, ptr %arg.results.3.4, i64 %.474.i
  %.478.i = getelementptr i8, ptr %42, i64 24
  %.479.i = load i64, ptr %.478.i, align 8, !noalias !311
  %.480.i = add nsw i64 %.479.i, 1
  store i64 %.480.i, ptr %.478.i, align 8, !noalias !311
  store i64 -1, ptr %.1080, align 8
  br label %B1492

B1492:                                            ; preds = %B1126, %B1380, %B1340.endif.endif, %B1282
  %excinfo.3.2 = phi ptr [ %excinfo.3.3, %B1340.endif.endif ], [ %excinfo.3.3, %B1380 ], [ %excinfo.3.01312, %B1282 ], [ %excinfo.3.01312, %B1126 ]
  br i1 %some.2.01313, label %B1544, label %B1496

B1496:                                            ; preds = %B1492
  %.2082 = load i64, ptr %.1080, align 8
  %.2083 = icmp sgt i64 %.2082, -1
  br label %B1544

B1544:                                            ; preds = %B1492, %B1496, %B792, %B634
  %excinfo.3.1 = phi ptr [ %excinfo.3.2, %B1492 ], [ %excinfo.3.2, %B1496 ], [ %excinfo.3.01312, %B792 ], [ %excinfo.3.01312, %B634 ]
  %some.3.1 = phi i1 [ true, %B1492 ], [ %.2083, %B1496 ], [ %some.2.01313, %B792 ], [ %some.2.01313, %B634 ]
  %.935 = icmp sgt i64 %.881.11315, 0
  %.948 = zext i1 %.935 to i64
  %.878.1 = add i64 %.878.11314, %.948
  %.944 = sext i1 %.935 to i64
  %.881.1 = add nsw i64 %.881.11315, %.944
  %.925.sroa.0.0 = select i1 %.935, i64 %.878.11314, i64 0
  br i1 %.935, label %B634, label %B1548.loopexit

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
  %.344.01306 = phi i64 [ %.354, %entry ], [ %.408, %B358 ]
  %.341.01305 = phi i64 [ %., %entry ], [ %.412, %B358 ]
  %.408 = add nsw i64 %.344.01306, -1
  %.412 = add nsw i64 %.341.01305, 1
  br i1 %.5201302.not, label %B358, label %B290.if.preheader

B290.if.preheader:                                ; preds = %B256.if
  %44 = icmp ult i64 %.341.01305, 8
  %switch.gep23 = getelementptr inbounds double, ptr @switch.table._ZN5pages5looks11mark_passedB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.21, i64 %.341.01305
  br label %B290.if

B290.if:                                          ; preds = %B290.if.preheader, %B290.loopexit
  %.464.01303 = phi i64 [ %.533, %B290.loopexit ], [ 0, %B290.if.preheader ]
  %.533 = add nsw i64 %.464.01303, 1
  br i1 %44, label %switch.lookup22, label %switch.end

switch.lookup22:                                  ; preds = %B290.if
  %switch.load24 = load double, ptr %switch.gep23, align 8
  br label %switch.end

switch.end:                                       ; preds = %B290.if, %switch.lookup22
  %.575 = phi double [ %switch.load24, %switch.lookup22 ], [ 1.000000e+00, %B290.if ]
  %.92.i = getelementptr double, ptr %arg.lane.0.4, i64 %.464.01303
  %.93.i = load double, ptr %.92.i, align 8, !noalias !314
  %.146.i = getelementptr double, ptr %1, i64 %.464.01303
  %.147.i = load double, ptr %.146.i, align 8, !noalias !314
  %.149.i = fmul double %.575, %.147.i
  %.150.i = fadd double %.93.i, %.149.i
  %.203.i = getelementptr double, ptr %2, i64 %.464.01303
  store double %.150.i, ptr %.203.i, align 8, !noalias !314
  br i1 %.287.i1299.not, label %B290.loopexit, label %B122.if.i.lr.ph

B122.if.i.lr.ph:                                  ; preds = %switch.end
  %.247.i.i = fsub double 1.000000e+00, %.575
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep26 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep28 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep30 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep32 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep34 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep36 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep38 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  %invariant.gep40 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01303
  br label %B122.if.i

B122.if.i:                                        ; preds = %B122.if.i.lr.ph, %B122.if.i
  %.229.i.01300 = phi i64 [ 0, %B122.if.i.lr.ph ], [ %.300.i, %B122.if.i ]
  %.157.i.i = add nsw i64 %.155.i.i, %.229.i.01300
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep, align 8, !noalias !318
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.575, %.193.i.i
  %.157.i.i.1 = add nsw i64 %.155.i.i.1, %.229.i.01300
  %.159.i.i.1 = mul nsw i64 %.157.i.i.1, %arg.shape.0
  %gep27 = getelementptr double, ptr %invariant.gep26, i64 %.159.i.i.1
  %.191.i.i.1 = load double, ptr %gep27, align 8, !noalias !318
  %.193.i.i.1 = fadd double %.253.i.i, %.191.i.i.1
  %.253.i.i.1 = fmul double %.247.i.i, %.193.i.i.1
  %.157.i.i.2 = add nsw i64 %.155.i.i.2, %.229.i.01300
  %.159.i.i.2 = mul nsw i64 %.157.i.i.2, %arg.shape.0
  %gep29 = getelementptr double, ptr %invariant.gep28, i64 %.159.i.i.2
  %.191.i.i.2 = load double, ptr %gep29, align 8, !noalias !318
  %.193.i.i.2 = fadd double %.253.i.i.1, %.191.i.i.2
  %.253.i.i.2 = fmul double %.575, %.193.i.i.2
  %.157.i.i.3 = add nsw i64 %.155.i.i.3, %.229.i.01300
  %.159.i.i.3 = mul nsw i64 %.157.i.i.3, %arg.shape.0
  %gep31 = getelementptr double, ptr %invariant.gep30, i64 %.159.i.i.3
  %.191.i.i.3 = load double, ptr %gep31, align 8, !noalias !318
  %.193.i.i.3 = fadd double %.253.i.i.2, %.191.i.i.3
  %.253.i.i.3 = fmul double %.247.i.i, %.193.i.i.3
  %.157.i.i.4 = add nsw i64 %.155.i.i.4, %.229.i.01300
  %.159.i.i.4 = mul nsw i64 %.157.i.i.4, %arg.shape.0
  %gep33 = getelementptr double, ptr %invariant.gep32, i64 %.159.i.i.4
  %.191.i.i.4 = load double, ptr %gep33, align 8, !noalias !318
  %.193.i.i.4 = fadd double %.253.i.i.3, %.191.i.i.4
  %.253.i.i.4 = fmul double %.575, %.193.i.i.4
  %.157.i.i.5 = add nsw i64 %.155.i.i.5, %.229.i.01300
  %.159.i.i.5 = mul nsw i64 %.157.i.i.5, %arg.shape.0
  %gep35 = getelementptr double, ptr %invariant.gep34, i64 %.159.i.i.5
  %.191.i.i.5 = load double, ptr %gep35, align 8, !noalias !318
  %.193.i.i.5 = fadd double %.253.i.i.4, %.191.i.i.5
  %.253.i.i.5 = fmul double %.247.i.i, %.193.i.i.5
  %.157.i.i.6 = add nsw i64 %.155.i.i.6, %.229.i.01300
  %.159.i.i.6 = mul nsw i64 %.157.i.i.6, %arg.shape.0
  %gep37 = getelementptr double, ptr %invariant.gep36, i64 %.159.i.i.6
  %.191.i.i.6 = load double, ptr %gep37, align 8, !noalias !318
  %.193.i.i.6 = fadd double %.253.i.i.5, %.191.i.i.6
  %.253.i.i.6 = fmul double %.575, %.193.i.i.6
  %.300.i = add nsw i64 %.229.i.01300, 1
  %.271.i.i = mul nsw i64 %.229.i.01300, %arg.shape.0
  %gep39 = getelementptr double, ptr %invariant.gep38, i64 %.271.i.i
  %.309.i.i = load double, ptr %gep39, align 8, !noalias !318
  %.313.i.i = fadd double %.253.i.i.6, %.309.i.i
  %.359.i = add nsw i64 %.229.i.01300, %.358.i
  %.361.i = mul nsw i64 %.359.i, %arg.shape.0
  %gep41 = getelementptr double, ptr %invariant.gep40, i64 %.361.i
  store double %.313.i.i, ptr %gep41, align 8, !noalias !314
  %exitcond.not = icmp eq i64 %arg.shape.1, %.300.i
  br i1 %exitcond.not, label %B290.loopexit, label %B122.if.i

B940.endif:                                       ; preds = %B36.i, %B34.i
  %.1348.0 = phi i64 [ %.51.i13.0, %B36.i ], [ -1, %B34.i ]
  store i64 %.1348.0, ptr %.1080, align 8
  %exitcond1321.not = icmp eq i64 %last.2.3, 7
  br i1 %exitcond1321.not, label %B1088, label %B1040

B1340.endif.if:                                   ; preds = %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.3.3, ptr %excinfo, align 8
  br label %common.ret

B1340.endif.endif:                                ; preds = %_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1855.not, label %B1492, label %B1380
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.copysign.f64(double, double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

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
!1 = distinct !{!1, !2, !"_ZN5pages6pieces8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN5pages6pieces8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = distinct !{!6, !5, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!7 = !{!8, !10}
!8 = distinct !{!8, !9, !"_ZN5pages5looks6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!9 = distinct !{!9, !"_ZN5pages5looks6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!10 = distinct !{!10, !9, !"_ZN5pages5looks6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN5pages6pieces11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!13 = distinct !{!13, !"_ZN5pages6pieces11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!14 = distinct !{!14, !13, !"_ZN5pages6pieces11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!17 = distinct !{!17, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!18 = !{!19, !12, !14}
!19 = distinct !{!19, !20, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!20 = distinct !{!20, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!21 = !{!22, !24, !12, !14}
!22 = distinct !{!22, !23, !"_ZN5pages6pieces10look_aheadB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!23 = distinct !{!23, !"_ZN5pages6pieces10look_aheadB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!24 = distinct !{!24, !23, !"_ZN5pages6pieces10look_aheadB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!25 = !{!26}
!26 = distinct !{!26, !27, !"_ZN5pages8implicit9lineariseB2v9B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!27 = distinct !{!27, !"_ZN5pages8implicit9lineariseB2v9B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!28 = !{!29, !31, !26}
!29 = distinct !{!29, !30, !"_ZN5pages8implicit13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!30 = distinct !{!30, !"_ZN5pages8implicit13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!31 = distinct !{!31, !30, !"_ZN5pages8implicit13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!32 = !{!33, !35, !29, !31, !26}
!33 = distinct !{!33, !34, !"_ZN5pages8implicit14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!34 = distinct !{!34, !"_ZN5pages8implicit14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!35 = distinct !{!35, !34, !"_ZN5pages8implicit14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!36 = !{!37, !26}
!37 = distinct !{!37, !38, !"_ZN5pages8implicit6factorB3v15B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN5pages8implicit6factorB3v15B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!39 = !{!40, !42, !43}
!40 = distinct !{!40, !41, !"_ZN5pages8implicit5solveB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!41 = distinct !{!41, !"_ZN5pages8implicit5solveB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!42 = distinct !{!42, !41, !"_ZN5pages8implicit5solveB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!43 = distinct !{!43, !44, !"_ZN5pages8implicit11solve_stageB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN5pages8implicit11solve_stageB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!43}
!46 = !{!47, !49}
!47 = distinct !{!47, !48, !"_ZN5pages6solver11count_stepsB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!48 = distinct !{!48, !"_ZN5pages6solver11count_stepsB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!49 = distinct !{!49, !48, !"_ZN5pages6solver11count_stepsB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!52 = distinct !{!52, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!53 = !{!"branch_weights", i32 99, i32 1}
!54 = !{!55, !57}
!55 = distinct !{!55, !56, !"_ZN5pages6solver17check_interpolantB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!56 = distinct !{!56, !"_ZN5pages6solver17check_interpolantB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!57 = distinct !{!57, !56, !"_ZN5pages6solver17check_interpolantB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!58 = !{!59, !55, !57}
!59 = distinct !{!59, !60, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!60 = distinct !{!60, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!61 = !{!62, !64}
!62 = distinct !{!62, !63, !"_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!63 = distinct !{!63, !"_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!64 = distinct !{!64, !63, !"_ZN5pages5kinks12locate_kinksB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!65 = !{!66, !68, !62, !64}
!66 = distinct !{!66, !67, !"_ZN5pages5kinks14measure_effectB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!67 = distinct !{!67, !"_ZN5pages5kinks14measure_effectB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!68 = distinct !{!68, !67, !"_ZN5pages5kinks14measure_effectB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!69 = !{!70, !72, !66, !68, !62, !64}
!70 = distinct !{!70, !71, !"_ZN5pages5looks12first_passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!71 = distinct !{!71, !"_ZN5pages5looks12first_passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!72 = distinct !{!72, !71, !"_ZN5pages5looks12first_passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!73 = !{!74, !76, !66, !68, !62, !64}
!74 = distinct !{!74, !75, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!75 = distinct !{!75, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!76 = distinct !{!76, !75, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!77 = !{!78, !80, !66, !68, !62, !64}
!78 = distinct !{!78, !79, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!79 = distinct !{!79, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!80 = distinct !{!80, !79, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!81 = !{!82, !84, !62, !64}
!82 = distinct !{!82, !83, !"_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!83 = distinct !{!83, !"_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!84 = distinct !{!84, !83, !"_ZN5pages5kinks7bracketB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!85 = !{!86, !88, !82, !84, !62, !64}
!86 = distinct !{!86, !87, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!87 = distinct !{!87, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!88 = distinct !{!88, !87, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!89 = !{!90, !92, !82, !84, !62, !64}
!90 = distinct !{!90, !91, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!92 = distinct !{!92, !91, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!93 = !{!"branch_weights", i32 1, i32 99}
!94 = !{!95, !97, !62, !64}
!95 = distinct !{!95, !96, !"_ZN5pages5kinks6narrowB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!96 = distinct !{!96, !"_ZN5pages5kinks6narrowB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!97 = distinct !{!97, !96, !"_ZN5pages5kinks6narrowB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!98 = !{!99, !101, !95, !97, !62, !64}
!99 = distinct !{!99, !100, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!100 = distinct !{!100, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!101 = distinct !{!101, !100, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!102 = !{!103, !105, !95, !97, !62, !64}
!103 = distinct !{!103, !104, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!104 = distinct !{!104, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!105 = distinct !{!105, !104, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!106 = !{!107, !109, !95, !97, !62, !64}
!107 = distinct !{!107, !108, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!108 = distinct !{!108, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!109 = distinct !{!109, !108, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!110 = !{!111, !113, !107, !109, !95, !97, !62, !64}
!111 = distinct !{!111, !112, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!112 = distinct !{!112, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!113 = distinct !{!113, !112, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!114 = !{!115, !117, !95, !97, !62, !64}
!115 = distinct !{!115, !116, !"_ZN5pages5kinks7to_turnB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!116 = distinct !{!116, !"_ZN5pages5kinks7to_turnB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!117 = distinct !{!117, !116, !"_ZN5pages5kinks7to_turnB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!118 = !{!119, !121, !122, !124, !62, !64}
!119 = distinct !{!119, !120, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!120 = distinct !{!120, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!121 = distinct !{!121, !120, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!122 = distinct !{!122, !123, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!123 = distinct !{!123, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!124 = distinct !{!124, !123, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!125 = !{!122, !124, !62, !64}
!126 = !{!127, !129, !62, !64}
!127 = distinct !{!127, !128, !"_ZN5pages5kinks14measure_effectB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!128 = distinct !{!128, !"_ZN5pages5kinks14measure_effectB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!129 = distinct !{!129, !128, !"_ZN5pages5kinks14measure_effectB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!130 = !{!131, !133, !127, !129, !62, !64}
!131 = distinct !{!131, !132, !"_ZN5pages5looks12first_passedB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!132 = distinct !{!132, !"_ZN5pages5looks12first_passedB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!133 = distinct !{!133, !132, !"_ZN5pages5looks12first_passedB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!134 = !{!135, !137, !127, !129, !62, !64}
!135 = distinct !{!135, !136, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!136 = distinct !{!136, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!137 = distinct !{!137, !136, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!138 = !{!139, !141, !127, !129, !62, !64}
!139 = distinct !{!139, !140, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!140 = distinct !{!140, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!141 = distinct !{!141, !140, !"_ZN5pages5kinks8exchangeB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!142 = !{!143, !145, !62, !64}
!143 = distinct !{!143, !144, !"_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !144, !"_ZN5pages5kinks7bracketB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!146 = !{!147, !149, !143, !145, !62, !64}
!147 = distinct !{!147, !148, !"_ZN5pages5kinks7to_turnB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN5pages5kinks7to_turnB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !148, !"_ZN5pages5kinks7to_turnB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!150 = !{!151, !153, !143, !145, !62, !64}
!151 = distinct !{!151, !152, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!153 = distinct !{!153, !152, !"_ZN5pages5kinks7to_turnB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!154 = !{!155, !157, !62, !64}
!155 = distinct !{!155, !156, !"_ZN5pages5kinks6narrowB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!156 = distinct !{!156, !"_ZN5pages5kinks6narrowB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!157 = distinct !{!157, !156, !"_ZN5pages5kinks6narrowB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!158 = !{!159, !161, !155, !157, !62, !64}
!159 = distinct !{!159, !160, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!160 = distinct !{!160, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!161 = distinct !{!161, !160, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!162 = !{!163, !165, !155, !157, !62, !64}
!163 = distinct !{!163, !164, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!164 = distinct !{!164, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!165 = distinct !{!165, !164, !"_ZN5pages5kinks5triedB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!166 = !{!167, !169, !155, !157, !62, !64}
!167 = distinct !{!167, !168, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!168 = distinct !{!168, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!169 = distinct !{!169, !168, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!170 = !{!171, !173, !167, !169, !155, !157, !62, !64}
!171 = distinct !{!171, !172, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!172 = distinct !{!172, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!173 = distinct !{!173, !172, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!174 = !{!175, !177, !155, !157, !62, !64}
!175 = distinct !{!175, !176, !"_ZN5pages5kinks7to_turnB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!176 = distinct !{!176, !"_ZN5pages5kinks7to_turnB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!177 = distinct !{!177, !176, !"_ZN5pages5kinks7to_turnB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!178 = !{!179, !62, !64}
!179 = distinct !{!179, !180, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!180 = distinct !{!180, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!181 = !{!182, !184, !62, !64}
!182 = distinct !{!182, !183, !"_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!183 = distinct !{!183, !"_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!184 = distinct !{!184, !183, !"_ZN5pages5looks8may_hideB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!185 = !{!186, !188, !182, !184, !62, !64}
!186 = distinct !{!186, !187, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!187 = distinct !{!187, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!188 = distinct !{!188, !187, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!189 = !{!190, !62, !64}
!190 = distinct !{!190, !191, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!191 = distinct !{!191, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!192 = !{!193, !195, !62, !64}
!193 = distinct !{!193, !194, !"_ZN5pages5looks12first_passedB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!194 = distinct !{!194, !"_ZN5pages5looks12first_passedB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE"}
!195 = distinct !{!195, !194, !"_ZN5pages5looks12first_passedB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!196 = !{!197, !199, !62, !64}
!197 = distinct !{!197, !198, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!198 = distinct !{!198, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!199 = distinct !{!199, !198, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!200 = !{!201, !203, !197, !199, !62, !64}
!201 = distinct !{!201, !202, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!202 = distinct !{!202, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!203 = distinct !{!203, !202, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!204 = !{!205, !207}
!205 = distinct !{!205, !206, !"_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!206 = distinct !{!206, !"_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!207 = distinct !{!207, !206, !"_ZN5pages5looks12watch_guardsB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!208 = !{!209, !211, !205, !207}
!209 = distinct !{!209, !210, !"_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!210 = distinct !{!210, !"_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!211 = distinct !{!211, !210, !"_ZN5pages5looks11mark_passedB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx8UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!212 = !{!213, !215, !209, !211, !205, !207}
!213 = distinct !{!213, !214, !"_ZN5pages5looks12first_passedB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!214 = distinct !{!214, !"_ZN5pages5looks12first_passedB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE"}
!215 = distinct !{!215, !214, !"_ZN5pages5looks12first_passedB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!216 = !{!217, !219, !209, !211, !205, !207}
!217 = distinct !{!217, !218, !"_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!218 = distinct !{!218, !"_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!219 = distinct !{!219, !218, !"_ZN5pages5looks8may_hideB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!220 = !{!221, !223, !217, !219, !209, !211, !205, !207}
!221 = distinct !{!221, !222, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!222 = distinct !{!222, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!223 = distinct !{!223, !222, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!224 = !{!225, !209, !211, !205, !207}
!225 = distinct !{!225, !226, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!226 = distinct !{!226, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!227 = !{!228, !230, !209, !211, !205, !207}
!228 = distinct !{!228, !229, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!229 = distinct !{!229, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!230 = distinct !{!230, !229, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!231 = !{!232, !234, !228, !230, !209, !211, !205, !207}
!232 = distinct !{!232, !233, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!233 = distinct !{!233, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!234 = distinct !{!234, !233, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!235 = !{!"branch_weights", i32 101, i32 99}
!236 = !{!"branch_weights", i32 301, i32 99}
!237 = !{!238, !205, !207}
!238 = distinct !{!238, !239, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!239 = distinct !{!239, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!240 = !{!241}
!241 = distinct !{!241, !242, !"_ZN5pages6solver6sampleB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!242 = distinct !{!242, !"_ZN5pages6solver6sampleB3v53B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!243 = !{!244, !246, !241}
!244 = distinct !{!244, !245, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!245 = distinct !{!245, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!246 = distinct !{!246, !245, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!247 = !{!248, !250}
!248 = distinct !{!248, !249, !"_ZN5pages5kinks11decide_anewB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!249 = distinct !{!249, !"_ZN5pages5kinks11decide_anewB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!250 = distinct !{!250, !249, !"_ZN5pages5kinks11decide_anewB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!251 = !{!252, !248, !250}
!252 = distinct !{!252, !253, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!253 = distinct !{!253, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!254 = !{!255, !257}
!255 = distinct !{!255, !256, !"_ZN5pages6pieces6at_endB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!256 = distinct !{!256, !"_ZN5pages6pieces6at_endB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!257 = distinct !{!257, !258, !"_ZN5pages6pieces4jumpB3v55B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!258 = distinct !{!258, !"_ZN5pages6pieces4jumpB3v55B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!259 = !{!257}
!260 = !{!261, !263, !257}
!261 = distinct !{!261, !262, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!262 = distinct !{!262, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!263 = distinct !{!263, !262, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!264 = !{!265, !257}
!265 = distinct !{!265, !266, !"_ZN5pages6pieces6at_endB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!266 = distinct !{!266, !"_ZN5pages6pieces6at_endB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!267 = !{!268, !257}
!268 = distinct !{!268, !269, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!269 = distinct !{!269, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!270 = !{!271, !257}
!271 = distinct !{!271, !272, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!272 = distinct !{!272, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!273 = !{!274}
!274 = distinct !{!274, !275, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!275 = distinct !{!275, !"_ZN5pages9numbering4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!276 = !{!277, !279}
!277 = distinct !{!277, !278, !"_ZN5pages6pieces11enter_pieceB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!278 = distinct !{!278, !"_ZN5pages6pieces11enter_pieceB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!279 = distinct !{!279, !278, !"_ZN5pages6pieces11enter_pieceB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!280 = !{!281, !283, !277, !279}
!281 = distinct !{!281, !282, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!282 = distinct !{!282, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!283 = distinct !{!283, !282, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!284 = !{!285}
!285 = distinct !{!285, !286, !"_ZN5pages6pieces8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!286 = distinct !{!286, !"_ZN5pages6pieces8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!287 = !{!288, !290, !285}
!288 = distinct !{!288, !289, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!289 = distinct !{!289, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!290 = distinct !{!290, !289, !"_ZN5pages6pieces9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!291 = !{!292, !294}
!292 = distinct !{!292, !293, !"_ZN5pages6pieces10look_aheadB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!293 = distinct !{!293, !"_ZN5pages6pieces10look_aheadB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!294 = distinct !{!294, !293, !"_ZN5pages6pieces10look_aheadB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!295 = !{!296, !298}
!296 = distinct !{!296, !297, !"_ZN5pages6solver11count_stepsB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!297 = distinct !{!297, !"_ZN5pages6solver11count_stepsB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!298 = distinct !{!298, !297, !"_ZN5pages6solver11count_stepsB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!299 = !{!300, !302}
!300 = distinct !{!300, !301, !"_ZN5pages5looks12first_passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!301 = distinct !{!301, !"_ZN5pages5looks12first_passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!302 = distinct !{!302, !301, !"_ZN5pages5looks12first_passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!303 = !{!304, !306}
!304 = distinct !{!304, !305, !"_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!305 = distinct !{!305, !"_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!306 = distinct !{!306, !305, !"_ZN5pages5looks8may_hideB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!307 = !{!308, !310, !304, !306}
!308 = distinct !{!308, !309, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!309 = distinct !{!309, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!310 = distinct !{!310, !309, !"_ZN5pages5looks13error_betweenB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!311 = !{!312}
!312 = distinct !{!312, !313, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!313 = distinct !{!313, !"_ZN5pages9numbering9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!314 = !{!315, !317}
!315 = distinct !{!315, !316, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!316 = distinct !{!316, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!317 = distinct !{!317, !316, !"_ZN5pages9numbering12state_withinB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!318 = !{!319, !321, !315, !317}
!319 = distinct !{!319, !320, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!320 = distinct !{!320, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!321 = distinct !{!321, !320, !"_ZN5pages9numbering11interpolateB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}

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
  %number.14 = load ptr, ptr %at.14
  %at.15 = getelementptr i64, ptr %numbers, i64 15
  %number.15 = load ptr, ptr %at.15
  %at.16 = getelementptr i64, ptr %numbers, i64 16
  %number.16 = load i64, ptr %at.16
  %at.17 = getelementptr i64, ptr %numbers, i64 17
  %number.17 = load i64, ptr %at.17
  %at.18 = getelementptr i64, ptr %numbers, i64 18
  %number.18 = load ptr, ptr %at.18
  %at.19 = getelementptr i64, ptr %numbers, i64 19
  %number.19 = load i64, ptr %at.19
  %at.20 = getelementptr i64, ptr %numbers, i64 20
  %number.20 = load i64, ptr %at.20
  %at.21 = getelementptr i64, ptr %numbers, i64 21
  %number.21 = load ptr, ptr %at.21
  %at.22 = getelementptr i64, ptr %numbers, i64 22
  %number.22 = load ptr, ptr %at.22
  %at.23 = getelementptr i64, ptr %numbers, i64 23
  %number.23 = load i64, ptr %at.23
  %at.24 = getelementptr i64, ptr %numbers, i64 24
  %number.24 = load i64, ptr %at.24
  %at.25 = getelementptr i64, ptr %numbers, i64 25
  %number.25 = load ptr, ptr %at.25
  %at.26 = getelementptr i64, ptr %numbers, i64 26
  %number.26 = load i64, ptr %at.26
  %at.27 = getelementptr i64, ptr %numbers, i64 27
  %number.27 = load i64, ptr %at.27
  %at.28 = getelementptr i64, ptr %numbers, i64 28
  %number.28 = load i64, ptr %at.28
  %at.29 = getelementptr i64, ptr %numbers, i64 29
  %number.29 = load i64, ptr %at.29
  %at.30 = getelementptr i64, ptr %numbers, i64 30
  %number.30 = load ptr, ptr %at.30
  %at.31 = getelementptr i64, ptr %numbers, i64 31
  %number.31 = load ptr, ptr %at.31
  %at.32 = getelementptr i64, ptr %numbers, i64 32
  %number.32 = load i64, ptr %at.32
  %at.33 = getelementptr i64, ptr %numbers, i64 33
  %number.33 = load i64, ptr %at.33
  %at.34 = getelementptr i64, ptr %numbers, i64 34
  %number.34 = load ptr, ptr %at.34
  %at.35 = getelementptr i64, ptr %numbers, i64 35
  %number.35 = load i64, ptr %at.35
  %at.36 = getelementptr i64, ptr %numbers, i64 36
  %number.36 = load i64, ptr %at.36
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
  %number.53 = load ptr, ptr %at.53
  %at.54 = getelementptr i64, ptr %numbers, i64 54
  %number.54 = load ptr, ptr %at.54
  %at.55 = getelementptr i64, ptr %numbers, i64 55
  %number.55 = load i64, ptr %at.55
  %at.56 = getelementptr i64, ptr %numbers, i64 56
  %number.56 = load i64, ptr %at.56
  %at.57 = getelementptr i64, ptr %numbers, i64 57
  %number.57 = load ptr, ptr %at.57
  %at.58 = getelementptr i64, ptr %numbers, i64 58
  %number.58 = load i64, ptr %at.58
  %at.59 = getelementptr i64, ptr %numbers, i64 59
  %number.59 = load i64, ptr %at.59
  %at.60 = getelementptr i64, ptr %numbers, i64 60
  %number.60 = load ptr, ptr %at.60
  %at.61 = getelementptr i64, ptr %numbers, i64 61
  %number.61 = load ptr, ptr %at.61
  %at.62 = getelementptr i64, ptr %numbers, i64 62
  %number.62 = load i64, ptr %at.62
  %at.63 = getelementptr i64, ptr %numbers, i64 63
  %number.63 = load i64, ptr %at.63
  %at.64 = getelementptr i64, ptr %numbers, i64 64
  %number.64 = load ptr, ptr %at.64
  %at.65 = getelementptr i64, ptr %numbers, i64 65
  %number.65 = load i64, ptr %at.65
  %at.66 = getelementptr i64, ptr %numbers, i64 66
  %number.66 = load i64, ptr %at.66
  %at.67 = getelementptr i64, ptr %numbers, i64 67
  %number.67 = load ptr, ptr %at.67
  %at.68 = getelementptr i64, ptr %numbers, i64 68
  %number.68 = load ptr, ptr %at.68
  %at.69 = getelementptr i64, ptr %numbers, i64 69
  %number.69 = load i64, ptr %at.69
  %at.70 = getelementptr i64, ptr %numbers, i64 70
  %number.70 = load i64, ptr %at.70
  %at.71 = getelementptr i64, ptr %numbers, i64 71
  %number.71 = load ptr, ptr %at.71
  %at.72 = getelementptr i64, ptr %numbers, i64 72
  %number.72 = load i64, ptr %at.72
  %at.73 = getelementptr i64, ptr %numbers, i64 73
  %number.73 = load i64, ptr %at.73
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
  %number.90 = load ptr, ptr %at.90
  %at.91 = getelementptr i64, ptr %numbers, i64 91
  %number.91 = load ptr, ptr %at.91
  %at.92 = getelementptr i64, ptr %numbers, i64 92
  %number.92 = load i64, ptr %at.92
  %at.93 = getelementptr i64, ptr %numbers, i64 93
  %number.93 = load i64, ptr %at.93
  %at.94 = getelementptr i64, ptr %numbers, i64 94
  %number.94 = load ptr, ptr %at.94
  %at.95 = getelementptr i64, ptr %numbers, i64 95
  %number.95 = load i64, ptr %at.95
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
  %number.101 = load ptr, ptr %at.101
  %at.102 = getelementptr i64, ptr %numbers, i64 102
  %number.102 = load ptr, ptr %at.102
  %at.103 = getelementptr i64, ptr %numbers, i64 103
  %number.103 = load i64, ptr %at.103
  %at.104 = getelementptr i64, ptr %numbers, i64 104
  %number.104 = load i64, ptr %at.104
  %at.105 = getelementptr i64, ptr %numbers, i64 105
  %number.105 = load ptr, ptr %at.105
  %at.106 = getelementptr i64, ptr %numbers, i64 106
  %number.106 = load i64, ptr %at.106
  %at.107 = getelementptr i64, ptr %numbers, i64 107
  %number.107 = load i64, ptr %at.107
  %at.108 = getelementptr i64, ptr %numbers, i64 108
  %number.108 = load ptr, ptr %at.108
  %at.109 = getelementptr i64, ptr %numbers, i64 109
  %number.109 = load ptr, ptr %at.109
  %at.110 = getelementptr i64, ptr %numbers, i64 110
  %number.110 = load i64, ptr %at.110
  %at.111 = getelementptr i64, ptr %numbers, i64 111
  %number.111 = load i64, ptr %at.111
  %at.112 = getelementptr i64, ptr %numbers, i64 112
  %number.112 = load ptr, ptr %at.112
  %at.113 = getelementptr i64, ptr %numbers, i64 113
  %number.113 = load i64, ptr %at.113
  %at.114 = getelementptr i64, ptr %numbers, i64 114
  %number.114 = load i64, ptr %at.114
  %at.115 = getelementptr i64, ptr %numbers, i64 115
  %number.115 = load ptr, ptr %at.115
  %at.116 = getelementptr i64, ptr %numbers, i64 116
  %number.116 = load ptr, ptr %at.116
  %at.117 = getelementptr i64, ptr %numbers, i64 117
  %number.117 = load i64, ptr %at.117
  %at.118 = getelementptr i64, ptr %numbers, i64 118
  %number.118 = load i64, ptr %at.118
  %at.119 = getelementptr i64, ptr %numbers, i64 119
  %number.119 = load ptr, ptr %at.119
  %at.120 = getelementptr i64, ptr %numbers, i64 120
  %number.120 = load i64, ptr %at.120
  %at.121 = getelementptr i64, ptr %numbers, i64 121
  %number.121 = load i64, ptr %at.121
  %at.122 = getelementptr i64, ptr %numbers, i64 122
  %number.122 = load i64, ptr %at.122
  %at.123 = getelementptr i64, ptr %numbers, i64 123
  %number.123 = load i64, ptr %at.123
  %at.124 = getelementptr i64, ptr %numbers, i64 124
  %number.124 = load ptr, ptr %at.124
  %at.125 = getelementptr i64, ptr %numbers, i64 125
  %number.125 = load ptr, ptr %at.125
  %at.126 = getelementptr i64, ptr %numbers, i64 126
  %number.126 = load i64, ptr %at.126
  %at.127 = getelementptr i64, ptr %numbers, i64 127
  %number.127 = load i64, ptr %at.127
  %at.128 = getelementptr i64, ptr %numbers, i64 128
  %number.128 = load ptr, ptr %at.128
  %at.129 = getelementptr i64, ptr %numbers, i64 129
  %number.129 = load i64, ptr %at.129
  %at.130 = getelementptr i64, ptr %numbers, i64 130
  %number.130 = load i64, ptr %at.130
  %at.131 = getelementptr i64, ptr %numbers, i64 131
  %number.131 = load i64, ptr %at.131
  %at.132 = getelementptr i64, ptr %numbers, i64 132
  %number.132 = load i64, ptr %at.132
  %at.133 = getelementptr i64, ptr %numbers, i64 133
  %number.133 = load ptr, ptr %at.133
  %at.134 = getelementptr i64, ptr %numbers, i64 134
  %number.134 = load ptr, ptr %at.134
  %at.135 = getelementptr i64, ptr %numbers, i64 135
  %number.135 = load i64, ptr %at.135
  %at.136 = getelementptr i64, ptr %numbers, i64 136
  %number.136 = load i64, ptr %at.136
  %at.137 = getelementptr i64, ptr %numbers, i64 137
  %number.137 = load ptr, ptr %at.137
  %at.138 = getelementptr i64, ptr %numbers, i64 138
  %number.138 = load i64, ptr %at.138
  %at.139 = getelementptr i64, ptr %numbers, i64 139
  %number.139 = load i64, ptr %at.139
  %at.140 = getelementptr i64, ptr %numbers, i64 140
  %number.140 = load i64, ptr %at.140
  %at.141 = getelementptr i64, ptr %numbers, i64 141
  %number.141 = load i64, ptr %at.141
  %at.142 = getelementptr i64, ptr %numbers, i64 142
  %number.142 = load ptr, ptr %at.142
  %at.143 = getelementptr i64, ptr %numbers, i64 143
  %number.143 = load ptr, ptr %at.143
  %at.144 = getelementptr i64, ptr %numbers, i64 144
  %number.144 = load i64, ptr %at.144
  %at.145 = getelementptr i64, ptr %numbers, i64 145
  %number.145 = load i64, ptr %at.145
  %at.146 = getelementptr i64, ptr %numbers, i64 146
  %number.146 = load ptr, ptr %at.146
  %at.147 = getelementptr i64, ptr %numbers, i64 147
  %number.147 = load i64, ptr %at.147
  %at.148 = getelementptr i64, ptr %numbers, i64 148
  %number.148 = load i64, ptr %at.148
  %at.149 = getelementptr i64, ptr %numbers, i64 149
  %number.149 = load ptr, ptr %at.149
  %at.150 = getelementptr i64, ptr %numbers, i64 150
  %number.150 = load ptr, ptr %at.150
  %at.151 = getelementptr i64, ptr %numbers, i64 151
  %number.151 = load i64, ptr %at.151
  %at.152 = getelementptr i64, ptr %numbers, i64 152
  %number.152 = load i64, ptr %at.152
  %at.153 = getelementptr i64, ptr %numbers, i64 153
  %number.153 = load ptr, ptr %at.153
  %at.154 = getelementptr i64, ptr %numbers, i64 154
  %number.154 = load i64, ptr %at.154
  %at.155 = getelementptr i64, ptr %numbers, i64 155
  %number.155 = load i64, ptr %at.155
  %at.156 = getelementptr i64, ptr %numbers, i64 156
  %number.156 = load ptr, ptr %at.156
  %at.157 = getelementptr i64, ptr %numbers, i64 157
  %number.157 = load ptr, ptr %at.157
  %at.158 = getelementptr i64, ptr %numbers, i64 158
  %number.158 = load i64, ptr %at.158
  %at.159 = getelementptr i64, ptr %numbers, i64 159
  %number.159 = load i64, ptr %at.159
  %at.160 = getelementptr i64, ptr %numbers, i64 160
  %number.160 = load ptr, ptr %at.160
  %at.161 = getelementptr i64, ptr %numbers, i64 161
  %number.161 = load i64, ptr %at.161
  %at.162 = getelementptr i64, ptr %numbers, i64 162
  %number.162 = load i64, ptr %at.162
  %at.163 = getelementptr i64, ptr %numbers, i64 163
  %number.163 = load ptr, ptr %at.163
  %at.164 = getelementptr i64, ptr %numbers, i64 164
  %number.164 = load ptr, ptr %at.164
  %at.165 = getelementptr i64, ptr %numbers, i64 165
  %number.165 = load i64, ptr %at.165
  %at.166 = getelementptr i64, ptr %numbers, i64 166
  %number.166 = load i64, ptr %at.166
  %at.167 = getelementptr i64, ptr %numbers, i64 167
  %number.167 = load ptr, ptr %at.167
  %at.168 = getelementptr i64, ptr %numbers, i64 168
  %number.168 = load i64, ptr %at.168
  %at.169 = getelementptr i64, ptr %numbers, i64 169
  %number.169 = load i64, ptr %at.169
  %at.170 = getelementptr i64, ptr %numbers, i64 170
  %number.170 = load ptr, ptr %at.170
  %at.171 = getelementptr i64, ptr %numbers, i64 171
  %number.171 = load ptr, ptr %at.171
  %at.172 = getelementptr i64, ptr %numbers, i64 172
  %number.172 = load i64, ptr %at.172
  %at.173 = getelementptr i64, ptr %numbers, i64 173
  %number.173 = load i64, ptr %at.173
  %at.174 = getelementptr i64, ptr %numbers, i64 174
  %number.174 = load ptr, ptr %at.174
  %at.175 = getelementptr i64, ptr %numbers, i64 175
  %number.175 = load i64, ptr %at.175
  %at.176 = getelementptr i64, ptr %numbers, i64 176
  %number.176 = load i64, ptr %at.176
  %at.177 = getelementptr i64, ptr %numbers, i64 177
  %number.177 = load ptr, ptr %at.177
  %at.178 = getelementptr i64, ptr %numbers, i64 178
  %number.178 = load ptr, ptr %at.178
  %at.179 = getelementptr i64, ptr %numbers, i64 179
  %number.179 = load i64, ptr %at.179
  %at.180 = getelementptr i64, ptr %numbers, i64 180
  %number.180 = load i64, ptr %at.180
  %at.181 = getelementptr i64, ptr %numbers, i64 181
  %number.181 = load ptr, ptr %at.181
  %at.182 = getelementptr i64, ptr %numbers, i64 182
  %number.182 = load i64, ptr %at.182
  %at.183 = getelementptr i64, ptr %numbers, i64 183
  %number.183 = load i64, ptr %at.183
  %at.184 = getelementptr i64, ptr %numbers, i64 184
  %number.184 = load ptr, ptr %at.184
  %at.185 = getelementptr i64, ptr %numbers, i64 185
  %number.185 = load ptr, ptr %at.185
  %at.186 = getelementptr i64, ptr %numbers, i64 186
  %number.186 = load i64, ptr %at.186
  %at.187 = getelementptr i64, ptr %numbers, i64 187
  %number.187 = load i64, ptr %at.187
  %at.188 = getelementptr i64, ptr %numbers, i64 188
  %number.188 = load ptr, ptr %at.188
  %at.189 = getelementptr i64, ptr %numbers, i64 189
  %number.189 = load i64, ptr %at.189
  %at.190 = getelementptr i64, ptr %numbers, i64 190
  %number.190 = load i64, ptr %at.190
  %at.191 = getelementptr i64, ptr %numbers, i64 191
  %number.191 = load ptr, ptr %at.191
  %at.192 = getelementptr i64, ptr %numbers, i64 192
  %number.192 = load ptr, ptr %at.192
  %at.193 = getelementptr i64, ptr %numbers, i64 193
  %number.193 = load i64, ptr %at.193
  %at.194 = getelementptr i64, ptr %numbers, i64 194
  %number.194 = load i64, ptr %at.194
  %at.195 = getelementptr i64, ptr %numbers, i64 195
  %number.195 = load ptr, ptr %at.195
  %at.196 = getelementptr i64, ptr %numbers, i64 196
  %number.196 = load i64, ptr %at.196
  %at.197 = getelementptr i64, ptr %numbers, i64 197
  %number.197 = load i64, ptr %at.197
  %at.198 = getelementptr i64, ptr %numbers, i64 198
  %number.198 = load ptr, ptr %at.198
  %at.199 = getelementptr i64, ptr %numbers, i64 199
  %number.199 = load ptr, ptr %at.199
  %at.200 = getelementptr i64, ptr %numbers, i64 200
  %number.200 = load i64, ptr %at.200
  %at.201 = getelementptr i64, ptr %numbers, i64 201
  %number.201 = load i64, ptr %at.201
  %at.202 = getelementptr i64, ptr %numbers, i64 202
  %number.202 = load ptr, ptr %at.202
  %at.203 = getelementptr i64, ptr %numbers, i64 203
  %number.203 = load i64, ptr %at.203
  %at.204 = getelementptr i64, ptr %numbers, i64 204
  %number.204 = load i64, ptr %at.204
  %at.205 = getelementptr i64, ptr %numbers, i64 205
  %number.205 = load i64, ptr %at.205
  %at.206 = getelementptr i64, ptr %numbers, i64 206
  %number.206 = load i64, ptr %at.206
  %at.207 = getelementptr i64, ptr %numbers, i64 207
  %number.207 = load i64, ptr %at.207
  %at.208 = getelementptr i64, ptr %numbers, i64 208
  %number.208 = load ptr, ptr %at.208
  %at.209 = getelementptr i64, ptr %numbers, i64 209
  %number.209 = load ptr, ptr %at.209
  %at.210 = getelementptr i64, ptr %numbers, i64 210
  %number.210 = load i64, ptr %at.210
  %at.211 = getelementptr i64, ptr %numbers, i64 211
  %number.211 = load i64, ptr %at.211
  %at.212 = getelementptr i64, ptr %numbers, i64 212
  %number.212 = load ptr, ptr %at.212
  %at.213 = getelementptr i64, ptr %numbers, i64 213
  %number.213 = load i64, ptr %at.213
  %at.214 = getelementptr i64, ptr %numbers, i64 214
  %number.214 = load i64, ptr %at.214
  %at.215 = getelementptr i64, ptr %numbers, i64 215
  %number.215 = load ptr, ptr %at.215
  %at.216 = getelementptr i64, ptr %numbers, i64 216
  %number.216 = load ptr, ptr %at.216
  %at.217 = getelementptr i64, ptr %numbers, i64 217
  %number.217 = load i64, ptr %at.217
  %at.218 = getelementptr i64, ptr %numbers, i64 218
  %number.218 = load i64, ptr %at.218
  %at.219 = getelementptr i64, ptr %numbers, i64 219
  %number.219 = load ptr, ptr %at.219
  %at.220 = getelementptr i64, ptr %numbers, i64 220
  %number.220 = load i64, ptr %at.220
  %at.221 = getelementptr i64, ptr %numbers, i64 221
  %number.221 = load i64, ptr %at.221
  %at.222 = getelementptr i64, ptr %numbers, i64 222
  %number.222 = load ptr, ptr %at.222
  %at.223 = getelementptr i64, ptr %numbers, i64 223
  %number.223 = load ptr, ptr %at.223
  %at.224 = getelementptr i64, ptr %numbers, i64 224
  %number.224 = load i64, ptr %at.224
  %at.225 = getelementptr i64, ptr %numbers, i64 225
  %number.225 = load i64, ptr %at.225
  %at.226 = getelementptr i64, ptr %numbers, i64 226
  %number.226 = load ptr, ptr %at.226
  %at.227 = getelementptr i64, ptr %numbers, i64 227
  %number.227 = load i64, ptr %at.227
  %at.228 = getelementptr i64, ptr %numbers, i64 228
  %number.228 = load i64, ptr %at.228
  %at.229 = getelementptr i64, ptr %numbers, i64 229
  %number.229 = load ptr, ptr %at.229
  %at.230 = getelementptr i64, ptr %numbers, i64 230
  %number.230 = load ptr, ptr %at.230
  %at.231 = getelementptr i64, ptr %numbers, i64 231
  %number.231 = load i64, ptr %at.231
  %at.232 = getelementptr i64, ptr %numbers, i64 232
  %number.232 = load i64, ptr %at.232
  %at.233 = getelementptr i64, ptr %numbers, i64 233
  %number.233 = load ptr, ptr %at.233
  %at.234 = getelementptr i64, ptr %numbers, i64 234
  %number.234 = load i64, ptr %at.234
  %at.235 = getelementptr i64, ptr %numbers, i64 235
  %number.235 = load i64, ptr %at.235
  %at.236 = getelementptr i64, ptr %numbers, i64 236
  %number.236 = load ptr, ptr %at.236
  %at.237 = getelementptr i64, ptr %numbers, i64 237
  %number.237 = load ptr, ptr %at.237
  %at.238 = getelementptr i64, ptr %numbers, i64 238
  %number.238 = load i64, ptr %at.238
  %at.239 = getelementptr i64, ptr %numbers, i64 239
  %number.239 = load i64, ptr %at.239
  %at.240 = getelementptr i64, ptr %numbers, i64 240
  %number.240 = load ptr, ptr %at.240
  %at.241 = getelementptr i64, ptr %numbers, i64 241
  %number.241 = load i64, ptr %at.241
  %at.242 = getelementptr i64, ptr %numbers, i64 242
  %number.242 = load i64, ptr %at.242
  %at.243 = getelementptr i64, ptr %numbers, i64 243
  %number.243 = load ptr, ptr %at.243
  %at.244 = getelementptr i64, ptr %numbers, i64 244
  %number.244 = load ptr, ptr %at.244
  %at.245 = getelementptr i64, ptr %numbers, i64 245
  %number.245 = load i64, ptr %at.245
  %at.246 = getelementptr i64, ptr %numbers, i64 246
  %number.246 = load i64, ptr %at.246
  %at.247 = getelementptr i64, ptr %numbers, i64 247
  %number.247 = load ptr, ptr %at.247
  %at.248 = getelementptr i64, ptr %numbers, i64 248
  %number.248 = load i64, ptr %at.248
  %at.249 = getelementptr i64, ptr %numbers, i64 249
  %number.249 = load i64, ptr %at.249
  %at.250 = getelementptr i64, ptr %numbers, i64 250
  %number.250 = load i64, ptr %at.250
  %at.251 = getelementptr i64, ptr %numbers, i64 251
  %number.251 = load i64, ptr %at.251
  %status = call i32 @advance_of_many(ptr %result, ptr %error, ptr %number.0, ptr %number.1, i64 %number.2, i64 %number.3, ptr %number.4, i64 %number.5, i64 %number.6, i64 %number.7, i64 %number.8, i64 %number.9, i64 %number.10, i64 %number.11, i64 %number.12, i64 %number.13, ptr %number.14, ptr %number.15, i64 %number.16, i64 %number.17, ptr %number.18, i64 %number.19, i64 %number.20, ptr %number.21, ptr %number.22, i64 %number.23, i64 %number.24, ptr %number.25, i64 %number.26, i64 %number.27, i64 %number.28, i64 %number.29, ptr %number.30, ptr %number.31, i64 %number.32, i64 %number.33, ptr %number.34, i64 %number.35, i64 %number.36, i64 %number.37, i64 %number.38, ptr %number.39, ptr %number.40, i64 %number.41, i64 %number.42, ptr %number.43, i64 %number.44, i64 %number.45, ptr %number.46, ptr %number.47, i64 %number.48, i64 %number.49, ptr %number.50, i64 %number.51, i64 %number.52, ptr %number.53, ptr %number.54, i64 %number.55, i64 %number.56, ptr %number.57, i64 %number.58, i64 %number.59, ptr %number.60, ptr %number.61, i64 %number.62, i64 %number.63, ptr %number.64, i64 %number.65, i64 %number.66, ptr %number.67, ptr %number.68, i64 %number.69, i64 %number.70, ptr %number.71, i64 %number.72, i64 %number.73, i64 %number.74, i64 %number.75, ptr %number.76, ptr %number.77, i64 %number.78, i64 %number.79, ptr %number.80, i64 %number.81, i64 %number.82, ptr %number.83, ptr %number.84, i64 %number.85, i64 %number.86, ptr %number.87, i64 %number.88, i64 %number.89, ptr %number.90, ptr %number.91, i64 %number.92, i64 %number.93, ptr %number.94, i64 %number.95, i64 %number.96, i64 %number.97, i64 %number.98, i64 %number.99, i64 %number.100, ptr %number.101, ptr %number.102, i64 %number.103, i64 %number.104, ptr %number.105, i64 %number.106, i64 %number.107, ptr %number.108, ptr %number.109, i64 %number.110, i64 %number.111, ptr %number.112, i64 %number.113, i64 %number.114, ptr %number.115, ptr %number.116, i64 %number.117, i64 %number.118, ptr %number.119, i64 %number.120, i64 %number.121, i64 %number.122, i64 %number.123, ptr %number.124, ptr %number.125, i64 %number.126, i64 %number.127, ptr %number.128, i64 %number.129, i64 %number.130, i64 %number.131, i64 %number.132, ptr %number.133, ptr %number.134, i64 %number.135, i64 %number.136, ptr %number.137, i64 %number.138, i64 %number.139, i64 %number.140, i64 %number.141, ptr %number.142, ptr %number.143, i64 %number.144, i64 %number.145, ptr %number.146, i64 %number.147, i64 %number.148, ptr %number.149, ptr %number.150, i64 %number.151, i64 %number.152, ptr %number.153, i64 %number.154, i64 %number.155, ptr %number.156, ptr %number.157, i64 %number.158, i64 %number.159, ptr %number.160, i64 %number.161, i64 %number.162, ptr %number.163, ptr %number.164, i64 %number.165, i64 %number.166, ptr %number.167, i64 %number.168, i64 %number.169, ptr %number.170, ptr %number.171, i64 %number.172, i64 %number.173, ptr %number.174, i64 %number.175, i64 %number.176, ptr %number.177, ptr %number.178, i64 %number.179, i64 %number.180, ptr %number.181, i64 %number.182, i64 %number.183, ptr %number.184, ptr %number.185, i64 %number.186, i64 %number.187, ptr %number.188, i64 %number.189, i64 %number.190, ptr %number.191, ptr %number.192, i64 %number.193, i64 %number.194, ptr %number.195, i64 %number.196, i64 %number.197, ptr %number.198, ptr %number.199, i64 %number.200, i64 %number.201, ptr %number.202, i64 %number.203, i64 %number.204, i64 %number.205, i64 %number.206, i64 %number.207, ptr %number.208, ptr %number.209, i64 %number.210, i64 %number.211, ptr %number.212, i64 %number.213, i64 %number.214, ptr %number.215, ptr %number.216, i64 %number.217, i64 %number.218, ptr %number.219, i64 %number.220, i64 %number.221, ptr %number.222, ptr %number.223, i64 %number.224, i64 %number.225, ptr %number.226, i64 %number.227, i64 %number.228, ptr %number.229, ptr %number.230, i64 %number.231, i64 %number.232, ptr %number.233, i64 %number.234, i64 %number.235, ptr %number.236, ptr %number.237, i64 %number.238, i64 %number.239, ptr %number.240, i64 %number.241, i64 %number.242, ptr %number.243, ptr %number.244, i64 %number.245, i64 %number.246, ptr %number.247, i64 %number.248, i64 %number.249, i64 %number.250, i64 %number.251)
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
