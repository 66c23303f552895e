; sha256 6c205f35d1ea3fe405ce9a40edb9cd1f65099d8a20952ba32d2c66bfa52e994e

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
@switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.21 = private unnamed_addr constant [8 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, i64 %arg.linear.3.0, i64 %arg.linear.3.1, i64 %arg.linear.3.2, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.4173 = alloca i8, align 1
  store i8 0, ptr %.4173, align 1
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.4776 = alloca i8, align 1
  store i8 0, ptr %.4776, align 1
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
  %.676 = getelementptr i8, ptr %arg.code.4, i64 56
  %.677 = load i64, ptr %.676, align 8
  %.678.not = icmp eq i64 %.677, 0
  br i1 %.678.not, label %B356, label %B380

B356:                                             ; preds = %entry
  %.743 = load i64, ptr %arg.code.4, align 8
  br label %B380

B380:                                             ; preds = %entry, %B356
  %"$phi380.0.2.0" = phi i64 [ %.743, %B356 ], [ %.677, %entry ]
  %.794 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.794, i64 0, i64 %arg.shape.0
  br i1 %.794, label %B556, label %B416.if.lr.ph

B416.if.lr.ph:                                    ; preds = %B380
  %.idx.i = mul i64 %arg.batch.4.0.5.1, 24
  %0 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i
  %.323.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %.418.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %1 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1123.i = shl i64 %arg.batch.4.1.5.1, 4
  %2 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1123.i
  %.idx1124.i = mul i64 %arg.batch.4.1.5.1, 24
  %3 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i
  %.8051131.not.i = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i = icmp slt i64 %arg.shape.1, 1
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
  br label %B416.if

B458:                                             ; preds = %B416.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i8893 = getelementptr double, ptr %0, i64 %.780.09248
  store double 0.000000e+00, ptr %.293.i8893, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B502, label %B132.i

B132.i:                                           ; preds = %B458
  %.359.i8894 = add nsw i64 %.236.i, 1
  store i64 %.359.i8894, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i8895 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i8896 = load i64, ptr %.453.i8895, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i8896, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i8896
  %.484.i8897 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i8898 = load i64, ptr %.484.i8897, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.09248
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.780.09248
  store i64 %.485.i8898, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.780.09248
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.780.09248
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep9556 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.780.09248
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i8900 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i8900, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i8901

B76.if.i.i8901:                                   ; preds = %B76.if.i.i8901, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i8901 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i8902 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i8902, %.780.09248
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i8901

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B502

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep9557 = getelementptr double, ptr %invariant.gep9556, i64 %.895.i
  store double %.893.i, ptr %gep9557, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i8901, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep9558 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.780.09248
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep9559 = getelementptr double, ptr %invariant.gep9558, i64 %.1207.i
  store double %.1205.i, ptr %gep9559, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.780.09248
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
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.780.09248
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i8893, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.780.09248
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.780.09248
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.780.09248
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B502, label %B888.i

B502:                                             ; preds = %B888.i, %B458, %B580.if.i, %B416.if
  %.1071 = load i64, ptr %374, align 8
  %.1072 = icmp sgt i64 %.1071, -1
  %.8871 = zext i1 %.1072 to i64
  %.1089 = add nsw i64 %active.4.09250, %.8871
  %.838 = icmp sgt i64 %.783.09249, 1
  br i1 %.838, label %B416.if, label %B556

B556:                                             ; preds = %B502, %B380
  %active.4.0.lcssa = phi i64 [ 0, %B380 ], [ %.1089, %B502 ]
  %.1106.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1122 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1106.not, i1 %.1122, i1 false
  br i1 %or.cond, label %B584.preheader, label %B4744

B584.preheader:                                   ; preds = %B556
  %.1166 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul9427 = mul i64 %arg.shape.1, 14
  %factor.op.mul9428 = mul i64 %arg.shape.1, 15
  %factor.op.mul9429 = mul i64 %arg.shape.6, %arg.shape.0
  %factor.op.mul = mul i64 %arg.shape.6, 27
  %.1262 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1314 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8870 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8870
  %.537.i9251 = icmp slt i64 %arg.shape.6, 1
  %.691.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1375.not = icmp eq i64 %arg.shape.3, 0
  %.1405 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1532.idx = shl i64 %.463, 4
  %.1532 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1532.idx
  %.1563 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1639 = getelementptr i8, ptr %arg.code.4, i64 88
  %.1740.idx = mul i64 %.463, 136
  %.1740 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1740.idx
  %.1765.idx = mul i64 %.463, 24
  %.1765 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1765.idx
  %.1796 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8862 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8862
  %.idx8863 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8863
  %.idx8864 = mul i64 %arg.batch.4.0.5.1, 264
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8864
  %.8872 = select i1 %.612, i64 0, i64 2
  %.792.i = icmp ne i64 %arg.shape.2, 1
  %"$phi364.4.2.i.2" = zext i1 %.792.i to i64
  %.idx8865 = mul i64 %arg.batch.4.0.5.1, 96
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8865
  %.idx8866 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8866
  %.idx8867 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8867
  %.idx8868 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8868
  %.idx8869 = mul i64 %arg.batch.4.0.5.1, 184
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8869
  %.1934 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2059 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.463
  %.266.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %.266.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.266.idx.i
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
  %.idx.i8908 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8908
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
  %.520.i8903 = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 176
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2178 = add i64 %arg.shape.2, -1
  %storemerge8816 = tail call i64 @llvm.smax.i64(i64 %.2178, i64 0)
  %.22219264.not = icmp slt i64 %.2178, 1
  %.2366.idx = mul i64 %.463, 136
  %.2366 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2366.idx
  %.2392 = inttoptr i64 %"$phi380.0.2.0" to ptr
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond9231.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i8909 = mul nsw i64 %arg.shape.1, 17
  %.idx.i8911 = mul i64 %arg.shape.1, 80
  %invariant.gep9260 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8911
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep9262 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2486 = getelementptr i8, ptr %arg.code.4, i64 72
  %.2563 = icmp sgt i64 %arg.shape.3, 0
  %.2568 = icmp sgt i64 %arg.shape.6, 0
  %.idx8860 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8860
  %.idx8861 = mul i64 %arg.batch.4.0.5.1, 200
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8861
  %.idx8857 = mul i64 %arg.batch.4.0.5.1, 208
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8857
  %.idx8858 = mul i64 %arg.batch.4.0.5.1, 216
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8858
  %.idx8859 = mul i64 %arg.batch.4.0.5.1, 192
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8859
  %.idx8851 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8851
  %.idx8852 = mul i64 %arg.batch.4.0.5.1, 224
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8852
  %.idx8853 = mul i64 %arg.batch.4.0.5.1, 80
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8853
  %.idx8854 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8854
  %.idx8855 = mul i64 %arg.batch.4.0.5.1, 248
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8855
  %.idx8856 = mul i64 %arg.batch.4.0.5.1, 56
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8856
  %44 = or i1 %.612, %.625
  %.3958.idx = mul i64 %.463, 136
  %.3958 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3958.idx
  %.3983.idx = mul i64 %.463, 104
  %.3983 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3983.idx
  %.4023 = getelementptr i8, ptr %arg.code.4, i64 128
  %.4117 = getelementptr i8, ptr %arg.code.4, i64 120
  %.4658.c = getelementptr i8, ptr %arg.code.4, i64 112
  %.4518.idx = mul i64 %.463, 136
  %.4518 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4518.idx
  %.4581 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4658 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx8844 = shl i64 %arg.batch.4.1.5.1, 4
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8844
  %.idx8845 = mul i64 %arg.batch.4.0.5.1, 40
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8845
  %.idx8846 = mul i64 %arg.batch.4.0.5.1, 56
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8846
  %.idx8847 = mul i64 %arg.batch.4.0.5.1, 232
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8847
  %.idx8848 = mul i64 %arg.batch.4.0.5.1, 48
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8848
  %.idx8849 = shl i64 %arg.batch.4.0.5.1, 5
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8849
  %51 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8850 = mul i64 %arg.batch.4.0.5.1, 240
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8850
  %53 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.230.i = getelementptr i8, ptr %53, i64 -8
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx7992.i = mul i64 %arg.batch.4.0.5.1, 152
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7992.i
  %.idx7989.i = mul i64 %arg.batch.4.0.5.1, 48
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7989.i
  %.287.i2218170.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i355.i = shl i64 %arg.shape.1, 4
  %.idx7982.i = shl i64 %arg.batch.4.1.5.1, 5
  %56 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx7982.i
  %.idx7983.i = mul i64 %arg.batch.4.0.5.1, 152
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7983.i
  %.idx7984.i = mul i64 %arg.batch.4.0.5.1, 112
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7984.i
  %.idx7985.i = mul i64 %arg.batch.4.0.5.1, 120
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7985.i
  %storemerge7986.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.194.i.i738.i = mul i64 %arg.shape.6, %arg.shape.0
  %.idx7988.i = mul i64 %arg.batch.4.0.5.1, 160
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7988.i
  %factor.op.mul8196.i.reass = mul i64 %factor.op.mul9427, %arg.shape.0
  %.892.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul8196.i.reass
  %.898.i.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.114.i40.i8180.not.i = icmp slt i64 %.194.i.i738.i, 1
  %.957.i.i = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul8197.i.reass = mul i64 %factor.op.mul9428, %arg.shape.0
  %.1216.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul8197.i.reass
  %.1913.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %factor.op.mul.reass = mul i64 %factor.op.mul9429, 3
  %.155.i.i392.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i392.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i392.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i392.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i392.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i392.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i392.6.i = mul nsw i64 %arg.shape.1, 18
  %.190.i9448214.i = icmp sgt i64 %arg.shape.0, 0
  %.203.i16138215.i = zext i1 %.190.i9448214.i to i64
  %.199.i16108216.i = sext i1 %.190.i9448214.i to i64
  %.134.i.18217.i = add nsw i64 %storemerge.i, %.199.i16108216.i
  %.436.i10698201.not.i = icmp slt i64 %arg.shape.6, 1
  %.586.i.i = mul nsw i64 %arg.shape.6, 30
  %.idx7883.i = mul i64 %arg.batch.4.0.5.1, 136
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7883.i
  %.idx7884.i = mul i64 %arg.batch.4.0.5.1, 144
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7884.i
  %.654.i1934.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.745.i1996.idx.i = shl i64 %.463, 7
  %.745.i1996.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.745.i1996.idx.i
  %.770.i2000.idx.i = mul i64 %.194.i.i738.i, 216
  %.770.i2000.i = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.770.i2000.idx.i
  %.155.i586.i.i = mul nsw i64 %arg.shape.6, 28
  %factor.op.mul8291.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.1453.reass.i = mul i64 %.358.i355.i, %arg.shape.0
  %.1473.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1453.reass.i
  %.1498.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %factor.op.mul8291.i.reass
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
  %.134.i7328.18315.i = add nsw i64 %storemerge.i, -1
  %.155.i.i.i5066.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i5066.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i5066.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i5066.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i5066.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i5066.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i5066.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx7918.i = mul i64 %arg.batch.4.0.5.1, 56
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7918.i
  %.30.i.i = mul i64 %.194.i.i738.i, 3
  %.454.i.i.i = mul i64 %.194.i.i738.i, 6
  %.456.i.2.i.i = mul i64 %.194.i.i738.i, 12
  %.456.i.3.i.i = mul i64 %.194.i.i738.i, 18
  %.456.i.4.i.i = mul i64 %.194.i.i738.i, 24
  %.190.i.1.i.i = mul i64 %.194.i.i738.i, 9
  %.190.i.2.i.i = mul i64 %.194.i.i738.i, 15
  %.190.i.3.i.i = mul i64 %.194.i.i738.i, 21
  %.155.i9519.i = mul nsw i64 %arg.shape.6, 25
  %.idx7926.i = mul i64 %arg.batch.4.0.5.1, 104
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7926.i
  %.idx7927.i = mul i64 %arg.batch.4.0.5.1, 40
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7927.i
  %.idx7928.i = shl i64 %arg.batch.4.0.5.1, 5
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx7928.i
  %67 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4946.not = icmp eq i64 %arg.shape.3, 0
  %.idx630.i = shl i64 %arg.shape.0, 4
  %invariant.gep9369 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx630.i
  %.idx631.i = mul i64 %arg.shape.0, 40
  %invariant.gep9371 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx631.i
  %.idx632.i = shl i64 %arg.shape.0, 6
  %invariant.gep9373 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx632.i
  %.idx633.i = mul i64 %arg.shape.0, 88
  %invariant.gep9375 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx633.i
  %.idx634.i = mul i64 %arg.shape.0, 112
  %invariant.gep9377 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx634.i
  %.idx635.i = mul i64 %arg.shape.0, 136
  %invariant.gep9379 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx635.i
  %.idx636.i = mul i64 %arg.shape.0, 160
  %invariant.gep9381 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx636.i
  %.idx637.i = mul i64 %arg.shape.0, 184
  %invariant.gep9383 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx637.i
  %.idx638.i = mul i64 %arg.shape.0, 208
  %invariant.gep9385 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx638.i
  %68 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.226.i.i = getelementptr i8, ptr %68, i64 -8
  %.296.i.i8963 = icmp sgt i64 %arg.shape.2, 4
  %..i.i = select i1 %.296.i.i8963, i64 0, i64 8
  %.354.i.i8964 = sub nsw i64 9, %..i.i
  %.5201292.not.i.i = icmp slt i64 %arg.shape.0, 1
  %.idx1277.i.i = mul i64 %arg.batch.4.0.5.1, 48
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1277.i.i
  %.287.i1289.not.i.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i = shl nsw i64 %arg.shape.1, 4
  %.706.i.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.155.i.i.i.i8965 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i.i = mul nsw i64 %arg.shape.1, 18
  %.880.11300.i.i = add nsw i64 %arg.shape.0, -1
  %.idx.i.i = mul i64 %arg.batch.4.0.5.1, 56
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i.i
  %.idx1267.i.i = shl i64 %arg.batch.4.1.5.1, 5
  %71 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1267.i.i
  %.idx1269.i.i = mul i64 %arg.batch.4.0.5.1, 40
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1269.i.i
  %.1281.i.i = select i1 %.296.i.i8963, i64 0, i64 7
  %.idx1270.i.i = mul i64 %arg.batch.4.0.5.1, 112
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1270.i.i
  %.idx1271.i.i = mul i64 %arg.batch.4.0.5.1, 120
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1271.i.i
  %.30.i.i.i = mul nsw i64 %arg.shape.0, 3
  %.454.i.i.i.i = mul i64 %arg.shape.0, 6
  %.456.i.2.i.i.i = mul i64 %arg.shape.0, 12
  %.456.i.3.i.i.i = mul i64 %arg.shape.0, 18
  %.456.i.4.i.i.i = mul i64 %arg.shape.0, 24
  %.190.i.1.i.i.i = mul nsw i64 %arg.shape.0, 9
  %.190.i.2.i.i.i = mul nsw i64 %arg.shape.0, 15
  %.190.i.3.i.i.i = mul nsw i64 %arg.shape.0, 21
  %.idx1274.i.i = shl i64 %arg.batch.4.0.5.1, 5
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1274.i.i
  %76 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx.i8970 = shl i64 %arg.batch.4.1.5.1, 5
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8970
  %.idx600.i = mul i64 %arg.batch.4.0.5.1, 40
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx600.i
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i9043 = shl i64 %arg.batch.4.1.5.1, 4
  %79 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i9043
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %82 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 240
  %83 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i9044 = mul nsw i64 %arg.shape.1, 17
  %84 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5156 = icmp sgt i64 %arg.shape.0, 1
  %.5210.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5210 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5210.idx
  %.5242 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx8837 = mul i64 %arg.batch.4.0.5.1, 104
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8837
  %.idx8838 = mul i64 %arg.batch.4.0.5.1, 40
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8838
  %.idx8839 = shl i64 %arg.batch.4.0.5.1, 7
  %87 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8839
  %.552.i35759405.not = icmp slt i64 %arg.shape.1, 1
  %.697.i3612 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %88 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i3642 = getelementptr i8, ptr %88, i64 -8
  %.idx8841 = mul i64 %arg.batch.4.1.5.1, 24
  %89 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8841
  %.idx8842 = mul i64 %arg.batch.4.1.5.1, 24
  %90 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8842
  %.idx8843 = mul i64 %arg.batch.4.0.5.1, 24
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8843
  %.5358.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i9055 = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %94 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i9057 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i9058 = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %95 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx8826 = mul i64 %arg.batch.4.0.5.1, 40
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8826
  %.idx8827 = shl i64 %arg.batch.4.0.5.1, 4
  %97 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8827
  %98 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8828 = mul i64 %arg.batch.4.0.5.1, 24
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8828
  %.175.i.i49729417.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8831 = shl i64 %arg.batch.4.1.5.1, 4
  %100 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8831
  %.idx.i9071 = mul i64 %arg.batch.4.0.5.1, 24
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i9071
  %.323.i9073 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %102 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i9093 = mul i64 %arg.batch.4.1.5.1, 24
  %103 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i9093
  %.8051131.not.i9095 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i9111 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i9130 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i9148 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i9152 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i9156 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i9158 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i9162 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i9164 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i9166 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9168 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9170 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9172 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9174 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9176 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9178 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9180 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9182 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9184 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9186 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9188 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9190 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9192 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9194 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9196 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9198 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i9200 = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i9202 = mul i64 %arg.batch.4.0.5.1, 232
  %gep.30.idx.i9204 = mul i64 %arg.batch.4.0.5.1, 240
  %104 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i9148
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i9176
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.30.idx.i9204
  %.idx1130.i9219 = mul i64 %arg.batch.4.0.5.1, 248
  %107 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9219
  %.idx8830 = mul i64 %arg.batch.4.0.5.1, 248
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8830
  %.6426 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %109 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %110 = getelementptr i8, ptr %109, i64 -8
  %.6440 = getelementptr double, ptr %110, i64 %.6426
  %111 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8832 = mul i64 %arg.batch.4.0.5.1, 248
  %112 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8832
  %.idx8833 = mul i64 %arg.batch.4.0.5.1, 192
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8833
  %.idx8834 = shl i64 %arg.batch.4.1.5.1, 4
  %114 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8834
  %.idx8835 = shl i64 %arg.batch.4.0.5.1, 4
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8835
  %.idx8836 = mul i64 %arg.batch.4.0.5.1, 184
  %116 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8836
  %117 = shl i64 %arg.shape.0, 3
  %118 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4543.idx = mul i64 %.463, 112
  %.4543 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4543.idx
  %119 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4543.1.idx = mul i64 %.463, 120
  %.4543.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4543.1.idx
  %120 = getelementptr i8, ptr %arg.code.4, i64 248
  %.4543.2.idx = shl i64 %.463, 7
  %.4543.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4543.2.idx
  br label %B584

B584:                                             ; preds = %B584.preheader, %B4718
  %excinfo.12.0 = phi ptr [ %excinfo.12.1, %B4718 ], [ null, %B584.preheader ]
  %excinfo.13.0 = phi ptr [ %excinfo.13.1, %B4718 ], [ null, %B584.preheader ]
  %budget.3.1 = phi i64 [ %budget.4.2, %B4718 ], [ %arg.budget, %B584.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4718 ], [ %active.4.0.lcssa, %B584.preheader ]
  %.1132 = add nsw i64 %budget.3.1, -1
  %.1167 = load i64, ptr %.1166, align 8
  %.1168 = icmp eq i64 %.1167, 1
  %.1202 = icmp sgt i64 %.1167, 0
  br i1 %.1202, label %B652, label %B730

B652:                                             ; preds = %B584
  store i64 0, ptr %.1166, align 8
  %.1263 = load i64, ptr %.1262, align 8
  %.1308 = inttoptr i64 %.1263 to ptr
  tail call void %.1308(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B730

B730:                                             ; preds = %B652, %B584
  br i1 %.1168, label %B736, label %B1302

B736:                                             ; preds = %B730
  br i1 %.1314, label %B748, label %B784

B748:                                             ; preds = %B736
  %.163.i = load i64, ptr %.162.i, align 8, !noalias !7
  %.275.i = inttoptr i64 %.163.i to ptr
  tail call void %.275.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.794, label %B326.i, label %B194.if.i

B324.i:                                           ; preds = %B266.if.i, %B194.if.i
  %.359.i = icmp sgt i64 %.304.i.09256, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B748
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B784

B194.if.i:                                        ; preds = %B748, %B324.i
  %.304.i.09256 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B748 ]
  %.301.i.09255 = phi i64 [ %.372.i, %B324.i ], [ 0, %B748 ]
  %.368.i = add nsw i64 %.304.i.09256, -1
  %.372.i = add nsw i64 %.301.i.09255, 1
  %121 = getelementptr double, ptr %19, i64 %.301.i.09255
  %.454.i = load double, ptr %121, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge9433 = select i1 %.455.i, i1 true, i1 %.537.i9251
  br i1 %brmerge9433, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep9560 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.09255
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.09252 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.09252, 1
  %.576.i = mul nsw i64 %.481.i.09252, %arg.shape.0
  %gep9561 = getelementptr double, ptr %invariant.gep9560, i64 %.576.i
  %.608.i = load double, ptr %gep9561, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.09252, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.09255
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %122 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %122, i64 %.629.i
  store double %.608.i, ptr %.643.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.550.i, %arg.shape.6
  br i1 %exitcond.not, label %B324.i, label %B266.if.i

B784:                                             ; preds = %B326.i, %B736
  br i1 %.1375.not, label %B856, label %B788

B788:                                             ; preds = %B784
  %.1406 = load i64, ptr %.1405, align 8
  %.1451 = inttoptr i64 %.1406 to ptr
  tail call void %.1451(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B856

B856:                                             ; preds = %B788, %B784
  br i1 %.612, label %B1260, label %B860

B860:                                             ; preds = %B856
  %.1485 = load i64, ptr %arg.code.4, align 8
  %.1533 = inttoptr i64 %.1485 to ptr
  tail call void %.1533(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1532)
  %.1564 = load i64, ptr %.1563, align 8
  %.1609 = inttoptr i64 %.1564 to ptr
  tail call void %.1609(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1640 = load i64, ptr %.1639, align 8
  %.1685 = inttoptr i64 %.1640 to ptr
  tail call void %.1685(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1716 = load i64, ptr %arg.code.4, align 8
  %.1766 = inttoptr i64 %.1716 to ptr
  tail call void %.1766(ptr %.571, ptr %.1740, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1765)
  %.1797 = load i64, ptr %.1796, align 8
  %.1842 = inttoptr i64 %.1797 to ptr
  tail call void %.1842(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1260

B1260:                                            ; preds = %B860, %B856
  br i1 %.794, label %B1302, label %B64.if.i

B108.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.314.i134, align 8, !noalias !11
  %.432.i191 = getelementptr double, ptr %21, i64 %.161.i.09258
  store double 0.000000e+00, ptr %.432.i191, align 8, !noalias !11
  %.487.i = getelementptr double, ptr %22, i64 %.161.i.09258
  store double 0.000000e+00, ptr %.487.i, align 8, !noalias !11
  %.542.i244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09258
  %.543.i245 = load i64, ptr %.542.i244, align 8, !noalias !11
  %.570.i = icmp slt i64 %.543.i245, 0
  %.571.i = select i1 %.570.i, i64 %arg.batch.3.3.5.0, i64 0
  %.572.i257 = add i64 %.571.i, %.543.i245
  %.592.i271 = mul i64 %.572.i257, %arg.batch.3.3.5.1
  %123 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.592.i271
  %.596.i = getelementptr i8, ptr %123, i64 8
  %.597.i275 = load i64, ptr %.596.i, align 8, !noalias !11
  %.620.i282 = add nsw i64 %.597.i275, %.8872
  store i64 %.620.i282, ptr %.596.i, align 8, !noalias !11
  %.736.i = load i64, ptr %.542.i244, align 8, !noalias !11
  %.763.i354 = icmp slt i64 %.736.i, 0
  %.764.i = select i1 %.763.i354, i64 %arg.batch.3.3.5.0, i64 0
  %.765.i355 = add i64 %.764.i, %.736.i
  %.785.i = mul i64 %.765.i355, %arg.batch.3.3.5.1
  %124 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.785.i
  %.789.i369 = getelementptr i8, ptr %124, i64 16
  %.790.i = load i64, ptr %.789.i369, align 8, !noalias !11
  %.813.i = add nsw i64 %.790.i, %"$phi364.4.2.i.2"
  store i64 %.813.i, ptr %.789.i369, align 8, !noalias !11
  %.928.i = getelementptr double, ptr %23, i64 %.161.i.09258
  %.929.i = load double, ptr %.928.i, align 8, !noalias !11
  %.930.i = fcmp une double %.929.i, 0.000000e+00
  br i1 %.930.i, label %B414.i, label %B460.i

B414.i:                                           ; preds = %B108.i
  %125 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09258
  %.84.i.i = load i64, ptr %125, align 8, !noalias !15
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B460.i

B46.i.i:                                          ; preds = %B414.i
  %.120.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !15
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B460.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !15
  br label %B460.i

B460.i:                                           ; preds = %B80.i.i, %B414.i, %B46.i.i, %B108.i
  br i1 %.1375.not, label %B596.i, label %B464.i

B464.i:                                           ; preds = %B460.i
  %126 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.09258
  %.1000.i = load double, ptr %126, align 8, !noalias !11
  %.1002.i = fcmp olt double %.1000.i, -1.000000e-09
  br i1 %.1002.i, label %B500.i, label %B596.i

B500.i:                                           ; preds = %B464.i
  %127 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09258
  %.84.i63.i = load i64, ptr %127, align 8, !noalias !18
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B46.i71.i:                                        ; preds = %B500.i
  %.120.i91.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !18
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !18
  br label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i: ; preds = %B46.i71.i, %B500.i, %B80.i98.i
  %.1091.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i.09258
  %.1092.i = load double, ptr %.1091.i, align 8, !noalias !11
  %.1146.i = getelementptr double, ptr %24, i64 %.161.i.09258
  store double %.1092.i, ptr %.1146.i, align 8, !noalias !11
  br label %B596.i

B596.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B464.i, %B460.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.161.i.09258
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.161.i.09258
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.161.i.09258
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B630.i

B134.i.i:                                         ; preds = %B596.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %128 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %128, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B630.i

B630.i:                                           ; preds = %B134.i.i, %B596.i, %B64.if.i
  %.220.i = icmp sgt i64 %.164.i70.09259, 1
  br i1 %.220.i, label %B64.if.i, label %B1302

B64.if.i:                                         ; preds = %B1260, %B630.i
  %.164.i70.09259 = phi i64 [ %.229.i381, %B630.i ], [ %storemerge, %B1260 ]
  %.161.i.09258 = phi i64 [ %.233.i384, %B630.i ], [ 0, %B1260 ]
  %.229.i381 = add nsw i64 %.164.i70.09259, -1
  %.233.i384 = add nsw i64 %.161.i.09258, 1
  %.314.i134 = getelementptr double, ptr %20, i64 %.161.i.09258
  %.315.i135 = load double, ptr %.314.i134, align 8, !noalias !11
  %.316.i136 = fcmp ogt double %.315.i135, 5.000000e-01
  br i1 %.316.i136, label %B108.i, label %B630.i

B1302:                                            ; preds = %B630.i, %B1260, %B730
  %.1935 = load i64, ptr %.1934, align 8
  %.1980 = inttoptr i64 %.1935 to ptr
  tail call void %.1980(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.612, label %B1374, label %B1458

B1374:                                            ; preds = %B1302
  %.2013 = load i64, ptr %arg.code.4, align 8
  %.2060 = inttoptr i64 %.2013 to ptr
  tail call void %.2060(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2059)
  br label %B1458

B1458:                                            ; preds = %B1374, %B1302
  br i1 %.610, label %B1462, label %B1502

B1462:                                            ; preds = %B1458
  %.267.i = load double, ptr %.266.i, align 8, !noalias !25
  %.268.i = fcmp olt double %.267.i, 5.000000e-01
  br i1 %.268.i, label %B76.i, label %B116.i

B76.i:                                            ; preds = %B1462
  br i1 %.317.i2117.not.i, label %B166.i.i, label %B84.if.i.i

B166.i.i:                                         ; preds = %B84.if.i.i, %B76.i
  br i1 %.547.i2141.i, label %B232.i.i, label %B116.i

B228.i.loopexit.i:                                ; preds = %B995.i.i, %B702.i.i
  %.547.i.i = icmp sgt i64 %.493.i.12146.i, 0
  %.560.i.i = zext i1 %.547.i.i to i64
  %.490.i.1.i = add i64 %.490.i.12145.i, %.560.i.i
  %.556.i.i = sext i1 %.547.i.i to i64
  %.493.i.1.i = add nsw i64 %.493.i.12146.i, %.556.i.i
  %.537.i.sroa.0.0.i = select i1 %.547.i.i, i64 %.490.i.12145.i, i64 0
  br i1 %.547.i.i, label %B232.i.i, label %B116.i

B232.i.i:                                         ; preds = %B166.i.i, %B228.i.loopexit.i
  %.537.i.sroa.0.02147.i = phi i64 [ %.537.i.sroa.0.0.i, %B228.i.loopexit.i ], [ 0, %B166.i.i ]
  %.493.i.12146.i = phi i64 [ %.493.i.1.i, %B228.i.loopexit.i ], [ %.493.i.12144.i, %B166.i.i ]
  %.490.i.12145.i = phi i64 [ %.490.i.1.i, %B228.i.loopexit.i ], [ 1, %B166.i.i ]
  br i1 %.589.i.i, label %B250.i.i, label %B660.i.i

B250.i.i:                                         ; preds = %B232.i.i
  br i1 %.682.i2120.i, label %B286.if.i.i, label %B352.i.i

B352.i.i:                                         ; preds = %B286.if.i.i, %B250.i.i
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
  br i1 %.1106.i2123.not.i, label %B702.i.i, label %B536.if.i.i

B544.i.i:                                         ; preds = %B536.if.i.i
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
  br label %B652.i.i

B652.i.i:                                         ; preds = %B536.if.i.i, %B544.i.i
  %"$phi652.2.2.i.3.i" = phi i1 [ %.1288.i.i, %B544.i.i ], [ false, %B536.if.i.i ]
  %.1106.i.i = icmp sgt i64 %.1050.i.02125.i, 1
  br i1 %.1106.i.i, label %B536.if.i.i, label %B656.i.i

B656.i.i:                                         ; preds = %B652.i.i
  br i1 %"$phi652.2.2.i.3.i", label %B702.i.i, label %B660.i.i

B660.i.i:                                         ; preds = %B656.i.i, %B232.i.i
  %.151.i.i.i = load double, ptr %.150.i.i.i, align 8, !noalias !32
  %.180.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !32
  %.184.i.i.i = fdiv double %.151.i.i.i, %.180.i.i.i
  br i1 %.317.i2117.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B262.i.i.i:                                       ; preds = %B84.if.i.i.i, %B660.i.i
  %.526.i.i.i = load i64, ptr %.525.i.i.i, align 8, !noalias !32
  %.530.i.i.i = icmp eq i64 %.526.i.i.i, %.537.i.sroa.0.02147.i
  br i1 %.530.i.i.i, label %B286.i.i.i, label %B324.i.i.i

B286.i.i.i:                                       ; preds = %B262.i.i.i
  %.587.i.i.i = load double, ptr %.586.i.i.i, align 8, !noalias !32
  %.588.i.i.i = fmul double %.587.i.i.i, 1.000000e-03
  br label %B324.i.i.i

B324.i.i.i:                                       ; preds = %B286.i.i.i, %B262.i.i.i
  %"$phi324.0.2.i.i.0.i" = phi double [ %.588.i.i.i, %B286.i.i.i ], [ 0.000000e+00, %B262.i.i.i ]
  store double %"$phi324.0.2.i.i.0.i", ptr %.629.i.i.i, align 8, !noalias !32
  br i1 %.317.i2117.not.i, label %B524.i.i.1.critedge.i, label %B428.if.i.i.i

B524.i.i.i:                                       ; preds = %B428.if.i.i.i
  %.1034.i.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1068.i.i.i = load double, ptr %.629.i.i.i, align 8, !noalias !32
  %.1070.i.i.i = fmul double %.1068.i.i.i, 5.000000e-01
  %.1073.i.i.i = fadd double %.1034.i.i.i, %.1070.i.i.i
  store double %.1073.i.i.i, ptr %.571, align 8, !noalias !32
  %.1157.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.i = inttoptr i64 %.1157.i.i.i to ptr
  tail call void %.1277.i.i.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.i), !noalias !32
  br label %B428.if.i.i.1.i

B428.if.i.i.1.i:                                  ; preds = %B428.if.i.i.1.i, %B524.i.i.i
  %.783.i.i.02131.1.i = phi i64 [ %.852.i.i.1.i, %B428.if.i.i.1.i ], [ 0, %B524.i.i.i ]
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
  br i1 %exitcond2155.1.not.i, label %B524.i.i.1.i, label %B428.if.i.i.1.i

B524.i.i.1.critedge.i:                            ; preds = %B324.i.i.i
  %.1034.i.i.c.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1070.i.i.c.i = fmul double %"$phi324.0.2.i.i.0.i", 5.000000e-01
  %.1073.i.i.c.i = fadd double %.1070.i.i.c.i, %.1034.i.i.c.i
  store double %.1073.i.i.c.i, ptr %.571, align 8, !noalias !32
  %.1157.i.i.c.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.c.i = inttoptr i64 %.1157.i.i.c.i to ptr
  tail call void %.1277.i.i.c.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.c.i), !noalias !32
  br label %B524.i.i.1.i

B524.i.i.1.i:                                     ; preds = %B428.if.i.i.1.i, %B524.i.i.1.critedge.i
  %.1034.i.i.1.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1068.i.i.1.i = load double, ptr %.629.i.i.i, align 8, !noalias !32
  %.1070.i.i.1.i = fmul double %.1068.i.i.1.i, 5.000000e-01
  %137 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %137, ptr %.571, align 8, !noalias !32
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !32
  br i1 %.317.i2117.not.i, label %B702.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %138 = getelementptr double, ptr %146, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %138, align 8, !noalias !32
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2111.i, ptr %148, align 8, !noalias !32
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B702.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B660.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B660.i.i ]
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
  br i1 %exitcond2154.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
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
  br i1 %exitcond2155.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
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
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B702.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B656.i.i, %B352.i.i
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
  br i1 %.1514.i2138.not.i, label %B228.i.loopexit.i, label %B764.if.i.i

B920.i.i:                                         ; preds = %B764.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %152 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %152, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !28
  br label %B995.i.i

B966.i.i:                                         ; preds = %B764.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %153 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %153, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !28
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %154 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %154, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !28
  br label %B995.i.i

B995.i.i:                                         ; preds = %B966.i.i, %B920.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B764.if.i.i, label %B228.i.loopexit.i

B84.if.i.i:                                       ; preds = %B76.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B76.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %155, align 8, !noalias !28
  %156 = getelementptr i8, ptr %155, i64 %.idx2159.i
  store double %.384.i.i, ptr %156, align 8, !noalias !28
  %157 = getelementptr i8, ptr %155, i64 %.idx2160.i
  store double 0.000000e+00, ptr %157, align 8, !noalias !28
  %exitcond.not.i8907 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i8907, label %B166.i.i, label %B84.if.i.i

B286.if.i.i:                                      ; preds = %B250.i.i, %B286.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B286.if.i.i ], [ %storemerge2107.i, %B250.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B286.if.i.i ], [ 0, %B250.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %158 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %158, align 8, !noalias !28
  %.755.i.i = icmp eq i64 %.753.i.i, %.537.i.sroa.0.02147.i
  %..i = select i1 %.755.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.626.i.02121.i
  store double %..i, ptr %gep, align 8, !noalias !28
  %.682.i.i = icmp sgt i64 %.629.i.02122.i, 1
  br i1 %.682.i.i, label %B286.if.i.i, label %B352.i.i

B536.if.i.i:                                      ; preds = %B352.i.i, %B652.i.i
  %known.2.i.22126.i = phi i1 [ %"$phi652.2.2.i.3.i", %B652.i.i ], [ true, %B352.i.i ]
  %.1050.i.02125.i = phi i64 [ %.1115.i.i, %B652.i.i ], [ %.1060.i.i, %B352.i.i ]
  %.1047.i.02124.i = phi i64 [ %.1119.i.i, %B652.i.i ], [ %.991.i.i, %B352.i.i ]
  %.1115.i.i = add nsw i64 %.1050.i.02125.i, -1
  %.1119.i.i = add i64 %.1047.i.02124.i, 1
  br i1 %known.2.i.22126.i, label %B544.i.i, label %B652.i.i

B764.if.i.i:                                      ; preds = %B702.i.i, %B995.i.i
  %.1461.i.02140.i = phi i64 [ %.1523.i.i, %B995.i.i ], [ %.1471.i.i, %B702.i.i ]
  %.1458.i.02139.i = phi i64 [ %.1527.i.i, %B995.i.i ], [ %.1400.i.i, %B702.i.i ]
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
  br i1 %.1745.i.i, label %B920.i.i, label %B966.i.i

B116.i:                                           ; preds = %B228.i.loopexit.i, %B166.i.i, %B1462
  br i1 %.402.i, label %B146.if.i, label %B1502

B316.i:                                           ; preds = %B262.if.i, %B146.if.i
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
  br i1 %exitcond2158.not.i, label %B36.if.i.i, label %B146.if.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1502, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %164 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %164, align 8, !noalias !36
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
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

B36.if.i.i:                                       ; preds = %B316.i, %B34.loopexit.i.i
  %.59.0509.i.i = phi i64 [ %.131.i.i, %B34.loopexit.i.i ], [ 0, %B316.i ]
  %.131.i.i = add nsw i64 %.59.0509.i.i, 1
  %.161.i.i = mul nsw i64 %.59.0509.i.i, %arg.shape.1
  %.164.i.i = add nsw i64 %.59.0509.i.i, %arg.linear.3.0
  %.165.i.i = add nsw i64 %.164.i.i, 1
  %.11.i.i.i8906 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %166 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i
  %167 = getelementptr double, ptr %166, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8906, %.131.i.i
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
  %.415.i.i = add nsw i64 %.306.0494.i.i, %.161.i.i
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
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i
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
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
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

B146.if.i:                                        ; preds = %B116.i, %B316.i
  %.388.02152.i = phi i64 [ %.457.i, %B316.i ], [ 0, %B116.i ]
  %.457.i = add nsw i64 %.388.02152.i, 1
  %.489.i = sub i64 %.388.02152.i, %31
  %.11.i.i8904 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i = add i64 %.520.i8903, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i8904
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B316.i, label %B262.if.lr.ph.i

B262.if.lr.ph.i:                                  ; preds = %B146.if.i
  %.670.i = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B262.if.i

B262.if.i:                                        ; preds = %B262.if.i, %B262.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B262.if.lr.ph.i ], [ %.639.i, %B262.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i8904, %B262.if.lr.ph.i ], [ %.643.i8905, %B262.if.i ]
  %.639.i = add nsw i64 %.577.02150.i, -1
  %.643.i8905 = add i64 %.574.02149.i, 1
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
  br i1 %.630.i, label %B262.if.i, label %B316.i

B1502:                                            ; preds = %B34.loopexit.i.i, %B116.i, %B1458
  br i1 %.22219264.not, label %B1728, label %B1534.if

B68.if.lr.ph.i:                                   ; preds = %B1534.if
  %.259.i = mul nsw i64 %.2234, %arg.shape.1
  br label %B68.if.i

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i
  %exitcond633.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond633.not.i, label %B314.if.i.i, label %B34.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0629.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B286.if.lr.ph.i

B286.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.624.i = mul nsw i64 %.2234, %arg.shape.1
  br label %B286.if.i

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
  %gep9263 = getelementptr double, ptr %invariant.gep9262, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep9263, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep9263, align 8, !noalias !39
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i8916 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8916, %.144.i.i
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
  %.755.i.i8917 = getelementptr double, ptr %181, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i8917, align 8, !noalias !39
  %.759.i.i8918 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8918, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %182 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %182, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !39
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i8917, align 8, !noalias !39
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
  %.1044.i.i8919 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i8918
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %184 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %184, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !39
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8919, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !39
  %.975.i.i8920 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i8920, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i8910 = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %185 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %185, i64 %.275.i8910
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %gep9261 = getelementptr double, ptr %invariant.gep9260, i64 %.160.0615.i
  %.323.i8912 = load double, ptr %gep9261, align 8, !noalias !45
  %.324.i8913 = fadd double %.290.i, %.323.i8912
  %186 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %186, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i8909
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i8914 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i = getelementptr double, ptr %187, i64 %.372.i8914
  store double %.324.i8913, ptr %.386.i, align 8, !noalias !45
  %exitcond.not.i8915 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i8915, label %B34.if.i.i, label %B68.if.i

B286.if.i:                                        ; preds = %B286.if.i, %B286.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B286.if.lr.ph.i ], [ %.533.i, %B286.if.i ]
  %.533.i = add nsw i64 %.464.0631.i, 1
  %188 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i = load i64, ptr %188, align 8, !noalias !45
  %.590.i = add nsw i64 %.589.i, %.395.i
  %.604.i = icmp slt i64 %.590.i, 0
  %.605.i = select i1 %.604.i, i64 %arg.batch.5.0.5.0, i64 0
  %189 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %189, i64 %.605.i
  %.620.i = load double, ptr %.619.i, align 8, !noalias !45
  %.625.i = add nsw i64 %.464.0631.i, %.624.i
  %.639.i8921 = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i8921, i64 %arg.batch.5.0.5.0, i64 0
  %190 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i8922 = getelementptr double, ptr %190, i64 %.640.i
  store double %.620.i, ptr %.654.i8922, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i
  br i1 %exitcond634.not.i, label %B1726, label %B286.if.i

B1726:                                            ; preds = %B286.if.i, %B1534.if
  %exitcond9458.not = icmp eq i64 %.2165.09265, %storemerge8816
  br i1 %exitcond9458.not, label %B1728, label %B1534.if

B1728:                                            ; preds = %B1726, %B1502
  %.2487 = load i64, ptr %.2486, align 8
  %.2532 = inttoptr i64 %.2487 to ptr
  tail call void %.2532(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1168, i1 true, i1 %.610
  %or.cond8873 = select i1 %brmerge, i1 true, i1 %.2563
  %spec.select8891 = select i1 %or.cond8873, i1 true, i1 %.2568
  br i1 %.794, label %B1960, label %B1870.if

B1878:                                            ; preds = %B1870.if
  %191 = getelementptr double, ptr %33, i64 %.2608.09268
  %.2767 = load double, ptr %191, align 8
  %.2768 = fcmp ogt double %.2767, 5.000000e-01
  br label %B1914

B1914:                                            ; preds = %B1878, %B1870.if
  %"$phi1914.1.2.2" = phi i1 [ true, %B1870.if ], [ %.2768, %B1878 ]
  br i1 %looked.2.19271, label %B1956, label %B1920

B1920:                                            ; preds = %B1914
  %192 = getelementptr double, ptr %34, i64 %.2608.09268
  %.2842 = load double, ptr %192, align 8
  %.2843 = fcmp ogt double %.2842, 5.000000e-01
  br label %B1956

B1956:                                            ; preds = %B1920, %B1914
  %"$phi1956.1.2.2" = phi i1 [ true, %B1914 ], [ %.2843, %B1920 ]
  %.2664 = icmp sgt i64 %.2611.09269, 1
  br i1 %.2664, label %B1870.if, label %B1960

B1960:                                            ; preds = %B1956, %B1728
  %good.2.1.lcssa = phi i1 [ false, %B1728 ], [ %"$phi1914.1.2.2", %B1956 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select8891, %B1728 ], [ %"$phi1956.1.2.2", %B1956 ]
  %looked.2.1.lcssa.not9462 = xor i1 %looked.2.1.lcssa, true
  %brmerge9463 = or i1 %.794, %looked.2.1.lcssa.not9462
  br i1 %brmerge9463, label %B2538, label %B80.if.i

B2030.preheader:                                  ; preds = %B568.i
  br i1 %.794, label %B2538, label %B2030.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i589 = getelementptr double, ptr %35, i64 %.105.i435.09275
  %.319.i = load double, ptr %.318.i589, align 8, !noalias !46
  %.5.i.i = fptosi double %.319.i to i64
  %.397.i634 = getelementptr double, ptr %36, i64 %.105.i435.09275
  %.398.i635 = load double, ptr %.397.i634, align 8, !noalias !46
  %.5.i1.i = fptosi double %.398.i635 to i64
  %.478.i682 = mul i64 %.258.i, %arg.batch.3.3.5.1
  %.482.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.478.i682
  %.483.i686 = load i64, ptr %.482.i, align 8, !noalias !46
  %.485.i = add nsw i64 %.483.i686, %.5.i.i
  store i64 %.485.i, ptr %.482.i, align 8, !noalias !46
  %.591.i772 = getelementptr i8, ptr %.482.i, i64 24
  %.592.i773 = load i64, ptr %.591.i772, align 8, !noalias !46
  %.594.i775 = add nsw i64 %.592.i773, %.5.i1.i
  store i64 %.594.i775, ptr %.591.i772, align 8, !noalias !46
  %.700.i863 = getelementptr i8, ptr %.482.i, i64 8
  %.701.i864 = load i64, ptr %.700.i863, align 8, !noalias !46
  %.706.i869 = add nsw i64 %.5.i1.i, %.5.i.i
  %.707.i870 = mul nsw i64 %.706.i869, %.2178
  %..5.i.i = select i1 %.625, i64 0, i64 %.5.i.i
  %.708.i871 = add i64 %.707.i870, %..5.i.i
  %.841.i958 = add i64 %.708.i871, %.701.i864
  store i64 %.841.i958, ptr %.700.i863, align 8, !noalias !46
  store double 0.000000e+00, ptr %.318.i589, align 8, !noalias !46
  store double 0.000000e+00, ptr %.397.i634, align 8, !noalias !46
  %.1072.i = getelementptr double, ptr %37, i64 %.105.i435.09275
  %.1073.i1075 = load double, ptr %.1072.i, align 8, !noalias !46
  %.1081.i1080 = sitofp i64 %.706.i869 to double
  %.1082.i1081 = fsub double %.1073.i1075, %.1081.i1080
  store double %.1082.i1081, ptr %.1072.i, align 8, !noalias !46
  br label %B568.i

B568.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i493 = icmp sgt i64 %.108.i.09276, 1
  br i1 %.163.i493, label %B80.if.i, label %B2030.preheader

B80.if.i:                                         ; preds = %B1960, %B568.i
  %.108.i.09276 = phi i64 [ %.172.i1118, %B568.i ], [ %storemerge, %B1960 ]
  %.105.i435.09275 = phi i64 [ %.176.i1121, %B568.i ], [ 0, %B1960 ]
  %.172.i1118 = add nsw i64 %.108.i.09276, -1
  %.176.i1121 = add nsw i64 %.105.i435.09275, 1
  %193 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i435.09275
  %.258.i = load i64, ptr %193, align 8, !noalias !46
  %.263.i545 = icmp sgt i64 %.258.i, -1
  br i1 %.263.i545, label %B126.i, label %B568.i

B2130:                                            ; preds = %B2030.if
  %.3297 = getelementptr double, ptr %40, i64 %.2963.09278
  %.3298 = load double, ptr %.3297, align 8
  %.3299 = fcmp ogt double %.3298, 5.000000e-01
  br i1 %.3299, label %B2168, label %B2268

B2168:                                            ; preds = %B2130
  %.5.i = fptosi double %.3298 to i64
  %194 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.09278
  %.84.i2116 = load i64, ptr %194, align 8, !noalias !50
  %.89.i2119 = icmp sgt i64 %.84.i2116, -1
  br i1 %.89.i2119, label %B46.i, label %B2268

B2268:                                            ; preds = %B2130, %B46.i, %B2168, %B80.i2148
  %.3485 = getelementptr double, ptr %41, i64 %.2963.09278
  %.3486 = load double, ptr %.3485, align 8
  %.3487 = fcmp ogt double %.3486, 5.000000e-01
  br i1 %.3487, label %B2306, label %B2536

B2306:                                            ; preds = %B2268
  %spec.select = select i1 %within.3.29280, i1 true, i1 %.2563
  %.3563 = mul i64 %.3124, %arg.batch.3.3.5.1
  %.3567 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3563
  %.3568 = load i64, ptr %.3567, align 8
  %.3579.0 = and i64 %.3568, 127
  %.3609 = icmp eq i64 %.3579.0, 0
  br i1 %.3609, label %B2414, label %B2376

B2376:                                            ; preds = %B2306
  %.3670 = getelementptr double, ptr %42, i64 %.2963.09278
  %.3671 = load double, ptr %.3670, align 8
  %.3673 = fcmp ogt double %.3671, 0.000000e+00
  br i1 %.3673, label %B2414, label %B2444

B2414:                                            ; preds = %B2306, %B2376
  store double 1.000000e+00, ptr %.3239, align 8
  br label %B2444

B2444:                                            ; preds = %B2414, %B2376
  %checked.5.5 = phi i1 [ true, %B2414 ], [ %checked.3.29281, %B2376 ]
  %.3756 = icmp slt i64 %.3179, %arg.batch.2.5.0
  br i1 %.3756, label %B2482, label %B2536

B2482:                                            ; preds = %B2444
  %.3780 = icmp slt i64 %.3179, 0
  %.3781 = select i1 %.3780, i64 %arg.batch.2.5.0, i64 0
  %195 = getelementptr double, ptr %arg.batch.2.4, i64 %.3179
  %.3795 = getelementptr double, ptr %195, i64 %.3781
  %.3796 = load double, ptr %.3795, align 8
  %.3854 = getelementptr double, ptr %43, i64 %.2963.09278
  %.3855 = load double, ptr %.3854, align 8
  %.3856 = fcmp olt double %.3796, %.3855
  br i1 %.3856, label %B2532, label %B2536

B2532:                                            ; preds = %B2482
  br label %B2536

B2536:                                            ; preds = %B2030.if, %B2532, %B2482, %B2444, %B2268
  %within.4.3 = phi i1 [ true, %B2532 ], [ %spec.select, %B2482 ], [ %spec.select, %B2444 ], [ %within.3.29280, %B2268 ], [ %within.3.29280, %B2030.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2532 ], [ %checked.5.5, %B2482 ], [ %checked.5.5, %B2444 ], [ %checked.3.29281, %B2268 ], [ %checked.3.29281, %B2030.if ]
  %.3025 = icmp sgt i64 %.2966.09279, 1
  br i1 %.3025, label %B2030.if, label %B2538

B2538:                                            ; preds = %B2536, %B1960, %B2030.preheader
  %within.5.1 = phi i1 [ false, %B1960 ], [ false, %B2030.preheader ], [ %within.4.3, %B2536 ]
  %checked.2.1 = phi i1 [ false, %B1960 ], [ false, %B2030.preheader ], [ %checked.4.3, %B2536 ]
  %good.2.1.not = xor i1 %good.2.1.lcssa, true
  %brmerge8875 = select i1 %good.2.1.not, i1 true, i1 %44
  br i1 %brmerge8875, label %B2666, label %B2550

B2550:                                            ; preds = %B2538
  %.3934 = load i64, ptr %arg.code.4, align 8
  %.3984 = inttoptr i64 %.3934 to ptr
  tail call void %.3984(ptr %.571, ptr %.3958, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3983)
  br label %B2666

B2666:                                            ; preds = %B2538, %B2550
  br i1 %checked.2.1, label %B2670, label %B2746

B2670:                                            ; preds = %B2666
  switch i64 %arg.shape.2, label %B2746 [
    i64 12, label %B2678
    i64 7, label %B2678
  ]

B2678:                                            ; preds = %B2670, %B2670
  %.4024 = load i64, ptr %.4023, align 8
  %.4069 = inttoptr i64 %.4024 to ptr
  tail call void %.4069(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B2746

B2746:                                            ; preds = %B2670, %B2678, %B2666
  %brmerge8878.not = and i1 %.2568, %good.2.1.lcssa
  br i1 %brmerge8878.not, label %B2766, label %B2888

B2766:                                            ; preds = %B2746
  %.4118 = load i64, ptr %.4117, align 8
  %.4163 = inttoptr i64 %.4118 to ptr
  tail call void %.4163(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  store i8 0, ptr %.4173, align 1
  %.4227 = call fastcc i32 @_ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4173, ptr %excinfo.9, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4229.not = icmp eq i32 %.4227, 0
  %.4237 = load i8, ptr %.4173, align 1
  %.4240 = icmp ne i8 %.4237, 0
  br i1 %.4229.not, label %B2888, label %B2766.endif.if, !prof !53

B2888:                                            ; preds = %B2766, %B2746
  %beyond.2.1 = phi i1 [ false, %B2746 ], [ %.4240, %B2766 ]
  %brmerge8879 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8879, label %B2898, label %B3458

B2898:                                            ; preds = %B2888
  br i1 %.614, label %B2946.if, label %B3314.critedge

B140.i:                                           ; preds = %B64.if.i3121
  %.409.i2505 = getelementptr double, ptr %46, i64 %.138.i2278.09288
  %.410.i2506 = load double, ptr %.409.i2505, align 8, !noalias !54
  %.411.i2507 = fcmp uge double %.410.i2506, 5.000000e-01
  %.424.i2515.not = icmp slt i64 %.346.i2456, %arg.batch.2.5.0
  %or.cond8880 = select i1 %.411.i2507, i1 %.424.i2515.not, i1 false
  br i1 %or.cond8880, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i = icmp slt i64 %.346.i2456, 0
  %.441.i2526 = select i1 %.440.i, i64 %arg.batch.2.5.0, i64 0
  %196 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i2456
  %.455.i2540 = getelementptr double, ptr %196, i64 %.441.i2526
  %.456.i2541 = load double, ptr %.455.i2540, align 8, !noalias !54
  %.510.i2588 = getelementptr double, ptr %47, i64 %.138.i2278.09288
  %.511.i2589 = load double, ptr %.510.i2588, align 8, !noalias !54
  %.512.i2590 = fcmp ult double %.456.i2541, %.511.i2589
  br i1 %.512.i2590, label %B268.i2591, label %B453.i

B268.i2591:                                       ; preds = %B216.i
  %.574.i2637 = getelementptr double, ptr %48, i64 %.138.i2278.09288
  %.575.i2638 = load double, ptr %.574.i2637, align 8, !noalias !54
  %.576.i2639 = fcmp ogt double %.575.i2638, 1.000000e+00
  br i1 %.576.i2639, label %B306.i, label %B453.i

B306.i:                                           ; preds = %B268.i2591
  %.632.i = getelementptr double, ptr %49, i64 %.138.i2278.09288
  %.633.i2689 = load double, ptr %.632.i, align 8, !noalias !54
  store double 0.000000e+00, ptr %.409.i2505, align 8, !noalias !58
  %.161.i.i2846 = getelementptr double, ptr %50, i64 %.138.i2278.09288
  store double 0.000000e+00, ptr %.161.i.i2846, align 8, !noalias !58
  %.214.i.i2874 = getelementptr double, ptr %51, i64 %.138.i2278.09288
  store double %.633.i2689, ptr %.214.i.i2874, align 8, !noalias !58
  %.268.i.i2896 = load i64, ptr %.290.i2409, align 8, !noalias !58
  %.294.i.i2906 = icmp slt i64 %.268.i.i2896, 0
  %.295.i.i = select i1 %.294.i.i2906, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i = add i64 %.295.i.i, %.268.i.i2896
  %.316.i.i2918 = mul i64 %.296.i.i, %arg.batch.3.3.5.1
  %.320.i.i2919 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i2918
  %.321.i.i2920 = load i64, ptr %.320.i.i2919, align 8, !noalias !58
  %.322.i.i = add nsw i64 %.321.i.i2920, -1
  store i64 %.322.i.i, ptr %.320.i.i2919, align 8, !noalias !58
  %.426.i.i2952 = load i64, ptr %.290.i2409, align 8, !noalias !58
  %.452.i.i = icmp slt i64 %.426.i.i2952, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i2952
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %197 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %197, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !58
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !58
  %.705.i2981 = load double, ptr %.455.i2540, align 8, !noalias !54
  %.763.i3027 = getelementptr double, ptr %52, i64 %.138.i2278.09288
  store double %.705.i2981, ptr %.763.i3027, align 8, !noalias !54
  %.816.i3071 = mul i64 %.291.i2410, %arg.batch.3.3.5.1
  %198 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i3071
  %.820.i3075 = getelementptr i8, ptr %198, i64 8
  %.821.i3076 = load i64, ptr %.820.i3075, align 8, !noalias !54
  %.822.i3077 = add nsw i64 %.821.i3076, 3
  store i64 %.822.i3077, ptr %.820.i3075, align 8, !noalias !54
  br label %B453.i

B453.i:                                           ; preds = %B268.i2591, %B306.i, %B64.if.i3121, %B140.i, %B216.i
  %.196.i2346 = icmp sgt i64 %.141.i2279.09287, 1
  br i1 %.196.i2346, label %B64.if.i3121, label %B3314

B64.if.i3121:                                     ; preds = %B2946.if, %B453.i
  %.138.i2278.09288 = phi i64 [ %.209.i3128, %B453.i ], [ 0, %B2946.if ]
  %.141.i2279.09287 = phi i64 [ %.205.i3125, %B453.i ], [ %storemerge, %B2946.if ]
  %.205.i3125 = add nsw i64 %.141.i2279.09287, -1
  %.209.i3128 = add nsw i64 %.138.i2278.09288, 1
  %.290.i2409 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2278.09288
  %.291.i2410 = load i64, ptr %.290.i2409, align 8, !noalias !54
  %.345.i2455 = getelementptr i64, ptr %45, i64 %.138.i2278.09288
  %.346.i2456 = load i64, ptr %.345.i2455, align 8, !noalias !54
  %.354.i2460 = icmp slt i64 %.291.i2410, 0
  br i1 %.354.i2460, label %B453.i, label %B140.i

B3314.critedge:                                   ; preds = %B2898
  %.4659.c = load i64, ptr %.4658.c, align 8
  %.4704.c = inttoptr i64 %.4659.c to ptr
  tail call void %.4704.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3314

B3314:                                            ; preds = %B453.i, %B2946.if, %B3314.critedge
  br i1 %beyond.2.1, label %B3318, label %B3414

B3318:                                            ; preds = %B3314
  store i8 0, ptr %.4776, align 1
  %.4830 = call fastcc i32 @_ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4776, ptr %excinfo.11, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4832.not = icmp eq i32 %.4830, 0
  br i1 %.4832.not, label %B3318.endif.endif, label %B3318.endif.if, !prof !53

B3372:                                            ; preds = %B3318.endif.endif
  %.231.i8923 = load double, ptr %.230.i, align 8, !noalias !61
  %.260.i8924 = load double, ptr %arg.batch.2.4, align 8, !noalias !61
  %.261.i = fsub double %.231.i8923, %.260.i8924
  %.262.i = fmul double %.261.i, 1.000000e-13
  br i1 %.794, label %B286.preheader.i8927.preheader, label %B178.if.i.preheader

B178.if.i.preheader:                              ; preds = %B3372
  tail call void @llvm.memset.p0.i64(ptr align 8 %54, i8 0, i64 %117, i1 false), !noalias !61
  br label %B286.preheader.i8927.preheader

B286.preheader.i8927.preheader:                   ; preds = %B178.if.i.preheader, %B3372
  br label %B286.preheader.i8927

B286.preheader.i8927:                             ; preds = %B286.preheader.i8927.preheader, %B354.endif.i
  %.549.sroa.0.08200.i = phi i64 [ %.506.18199.i, %B354.endif.i ], [ 8, %B286.preheader.i8927.preheader ]
  %.506.18199.i = phi i64 [ %.506.1.i, %B354.endif.i ], [ 7, %B286.preheader.i8927.preheader ]
  br i1 %.794, label %B354.endif.i, label %B286.if.i8928.preheader

B286.if.i8928.preheader:                          ; preds = %B286.preheader.i8927
  %switch.tableidx9502 = add i64 %.549.sroa.0.08200.i, 9
  %199 = icmp ult i64 %switch.tableidx9502, 17
  %switch.gep9504 = getelementptr inbounds double, ptr @switch.table.advance_of_many.8, i64 %switch.tableidx9502
  br label %B286.if.i8928

B286.loopexit.i:                                  ; preds = %B122.if.i467.i, %switch.end.i
  %exitcond8383.not.i = icmp eq i64 %arg.shape.0, %.693.i
  br i1 %exitcond8383.not.i, label %B88.if.i.lr.ph.i, label %B286.if.i8928

B88.if.i.lr.ph.i:                                 ; preds = %B286.loopexit.i
  %.151.i.i.i8930 = mul nsw i64 %.549.sroa.0.08200.i, 3
  %.153.i.i7077987.i = add nsw i64 %.151.i.i.i8930, 1
  %.155.i.i709.i = mul i64 %.153.i.i7077987.i, %arg.shape.6
  br label %B88.if.i.i

B130.i.i:                                         ; preds = %B88.if.i.i
  %200 = getelementptr double, ptr %57, i64 %.203.i538.08177.i
  %.416.i.i = load double, ptr %200, align 8, !noalias !65
  %.417.i.i = fcmp ugt double %.416.i.i, 1.000000e-01
  br i1 %.417.i.i, label %B294.i.i, label %B182.i.i

B182.i.i:                                         ; preds = %B130.i.i
  %.481.i.i = getelementptr double, ptr %58, i64 %.203.i538.08177.i
  %.482.i.i = load double, ptr %.481.i.i, align 8, !noalias !65
  %.536.i.i8959 = getelementptr double, ptr %59, i64 %.203.i538.08177.i
  %.537.i.i8960 = load double, ptr %.536.i.i8959, align 8, !noalias !65
  %.538.i.i = fcmp olt double %.482.i.i, %.537.i.i8960
  br i1 %.538.i.i, label %B34.i.i.i, label %B294.i.i

B34.i.i.i:                                        ; preds = %B182.i.i, %B34.if.i.i.i
  %.51.i.i492.0.i = phi i64 [ %.122.i.i.i, %B34.if.i.i.i ], [ 0, %B182.i.i ]
  %exitcond8384.not.i = icmp eq i64 %.51.i.i492.0.i, %storemerge7986.i
  br i1 %exitcond8384.not.i, label %B294.i.i, label %B34.if.i.i.i

B128.i.i.i:                                       ; preds = %B34.if.i.i.i
  %201 = icmp sgt i64 %.51.i.i492.0.i, -1
  br label %B294.i.i

B34.if.i.i.i:                                     ; preds = %B34.i.i.i
  %.122.i.i.i = add i64 %.51.i.i492.0.i, 1
  %.157.i.i711.i = add nsw i64 %.51.i.i492.0.i, %.155.i.i709.i
  %.159.i.i713.i = mul nsw i64 %.157.i.i711.i, %arg.shape.0
  %.161.i.i715.i = add nsw i64 %.159.i.i713.i, %.203.i538.08177.i
  %.175.i.i723.i = icmp slt i64 %.161.i.i715.i, 0
  %.176.i.i724.i = select i1 %.175.i.i723.i, i64 %arg.batch.5.4.5.0, i64 0
  %202 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i715.i
  %.190.i.i734.i = getelementptr double, ptr %202, i64 %.176.i.i724.i
  %.191.i.i735.i = load double, ptr %.190.i.i734.i, align 8, !noalias !69
  %.195.i.i.i = add nsw i64 %.161.i.i715.i, %.194.i.i738.i
  %.209.i.i741.i = icmp slt i64 %.195.i.i.i, 0
  %.210.i.i.i = select i1 %.209.i.i741.i, i64 %arg.batch.5.4.5.0, i64 0
  %203 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i.i.i
  %.224.i.i746.i = getelementptr double, ptr %203, i64 %.210.i.i.i
  %.225.i.i.i = load double, ptr %.224.i.i746.i, align 8, !noalias !69
  %.226.i.i747.i = fneg double %.225.i.i.i
  %.227.i.i.i = fcmp olt double %.191.i.i735.i, %.226.i.i747.i
  br i1 %.227.i.i.i, label %B128.i.i.i, label %B34.i.i.i

B294.i.i:                                         ; preds = %B34.i.i.i, %B88.if.i.i, %B128.i.i.i, %B182.i.i, %B130.i.i
  %"$phi294.1.2.i.1.i" = phi i1 [ false, %B130.i.i ], [ false, %B182.i.i ], [ false, %B88.if.i.i ], [ %201, %B128.i.i.i ], [ false, %B34.i.i.i ]
  %spec.select.i = or i1 %some.2.i.08179.i, %"$phi294.1.2.i.1.i"
  %"$phi312.2.2.i.1.i" = select i1 %"$phi294.1.2.i.1.i", double 1.000000e+00, double 0.000000e+00
  %204 = getelementptr double, ptr %60, i64 %.203.i538.08177.i
  store double %"$phi312.2.2.i.1.i", ptr %204, align 8, !noalias !65
  %exitcond8385.not.i = icmp eq i64 %arg.shape.0, %.274.i.i
  br i1 %exitcond8385.not.i, label %B340.i.i, label %B88.if.i.i

B340.i.i:                                         ; preds = %B294.i.i
  br i1 %spec.select.i, label %B348.i.i8954, label %B354.endif.i

B348.i.i8954:                                     ; preds = %B340.i.i
  %.719.i.not.i = icmp eq i64 %.549.sroa.0.08200.i, 8
  %..i8955 = select i1 %.719.i.not.i, i64 17, i64 16
  %.734.i.i = mul i64 %..i8955, %.463
  %.742.i.i = mul i64 %factor.op.mul.reass, %.549.sroa.0.08200.i
  %.777.i.i = load i64, ptr %arg.code.4, align 8, !noalias !65
  %.867.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.734.i.i
  %.893.i.i = inttoptr i64 %.777.i.i to ptr
  tail call void %.893.i.i(ptr %.571, ptr %.867.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.892.i.i), !noalias !65
  br i1 %.114.i40.i8180.not.i, label %B396.endif.endif.i.i.critedge, label %B34.if.i111.i.i

B34.if.i111.i.i:                                  ; preds = %B348.i.i8954, %B34.if.i111.i.i
  %.56.i.i485.08181.i = phi i64 [ %.127.i115.i.i, %B34.if.i111.i.i ], [ 0, %B348.i.i8954 ]
  %.127.i115.i.i = add nsw i64 %.56.i.i485.08181.i, 1
  %.153.i49.i.i = add nsw i64 %.56.i.i485.08181.i, %.742.i.i
  %.167.i56.i.i = icmp slt i64 %.153.i49.i.i, 0
  %.168.i.i.i = select i1 %.167.i56.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %205 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i49.i.i
  %.182.i.i.i = getelementptr double, ptr %205, i64 %.168.i.i.i
  %.183.i68.i.i = load double, ptr %.182.i.i.i, align 8, !noalias !73
  %.185.i70.i.i = add nsw i64 %.56.i.i485.08181.i, %.898.i.i
  %.199.i.i.i = icmp slt i64 %.185.i70.i.i, 0
  %.200.i.i.i = select i1 %.199.i.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i70.i.i
  %.214.i89.i.i = getelementptr double, ptr %206, i64 %.200.i.i.i
  %.215.i90.i.i = load double, ptr %.214.i89.i.i, align 8, !noalias !73
  store double %.183.i68.i.i, ptr %.214.i89.i.i, align 8, !noalias !73
  store double %.215.i90.i.i, ptr %.182.i.i.i, align 8, !noalias !73
  %exitcond8386.not.i = icmp eq i64 %.194.i.i738.i, %.127.i115.i.i
  br i1 %exitcond8386.not.i, label %B396.endif.i.i, label %B34.if.i111.i.i

B964.i.loopexit.i:                                ; preds = %B1040.if.i.i, %B964.if.i.i
  %exitcond8389.not.i = icmp eq i64 %arg.shape.0, %.1501.i.i
  br i1 %exitcond8389.not.i, label %B354.endif.i, label %B964.if.i.i

B88.if.i.i:                                       ; preds = %B294.i.i, %B88.if.i.lr.ph.i
  %some.2.i.08179.i = phi i1 [ false, %B88.if.i.lr.ph.i ], [ %spec.select.i, %B294.i.i ]
  %.203.i538.08177.i = phi i64 [ 0, %B88.if.i.lr.ph.i ], [ %.274.i.i, %B294.i.i ]
  %.274.i.i = add nsw i64 %.203.i538.08177.i, 1
  %207 = getelementptr i64, ptr %56, i64 %.203.i538.08177.i
  %.356.i.i = load i64, ptr %207, align 8, !noalias !65
  %.357.i663.i = icmp sgt i64 %.356.i.i, -1
  br i1 %.357.i663.i, label %B130.i.i, label %B294.i.i

B396.endif.i.i:                                   ; preds = %B34.if.i111.i.i
  %.958.i.i8956 = load i64, ptr %.957.i.i, align 8, !noalias !65
  %.1070.i.i = inttoptr i64 %.958.i.i8956 to ptr
  tail call void %.1070.i.i(ptr %.571, ptr %.867.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !65
  %.1101.i.i = load i64, ptr %arg.code.4, align 8, !noalias !65
  %.1217.i.i = inttoptr i64 %.1101.i.i to ptr
  tail call void %.1217.i.i(ptr %.571, ptr %.867.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1216.i.i), !noalias !65
  br label %B34.if.i316.i.i

B34.if.i316.i.i:                                  ; preds = %B396.endif.i.i, %B34.if.i316.i.i
  %.56.i149.i.08184.i = phi i64 [ %.127.i324.i.i, %B34.if.i316.i.i ], [ 0, %B396.endif.i.i ]
  %.127.i324.i.i = add nsw i64 %.56.i149.i.08184.i, 1
  %.153.i217.i.i = add nsw i64 %.56.i149.i.08184.i, %.742.i.i
  %.167.i227.i.i = icmp slt i64 %.153.i217.i.i, 0
  %.168.i228.i.i = select i1 %.167.i227.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %208 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i217.i.i
  %.182.i241.i.i = getelementptr double, ptr %208, i64 %.168.i228.i.i
  %.183.i242.i.i = load double, ptr %.182.i241.i.i, align 8, !noalias !77
  %.185.i244.i.i = add nsw i64 %.56.i149.i.08184.i, %.898.i.i
  %.199.i254.i.i = icmp slt i64 %.185.i244.i.i, 0
  %.200.i255.i.i = select i1 %.199.i254.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %209 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i244.i.i
  %.214.i268.i.i = getelementptr double, ptr %209, i64 %.200.i255.i.i
  %.215.i269.i.i = load double, ptr %.214.i268.i.i, align 8, !noalias !77
  store double %.183.i242.i.i, ptr %.214.i268.i.i, align 8, !noalias !77
  store double %.215.i269.i.i, ptr %.182.i241.i.i, align 8, !noalias !77
  %exitcond8387.not.i = icmp eq i64 %.194.i.i738.i, %.127.i324.i.i
  br i1 %exitcond8387.not.i, label %B396.endif.endif.i.i, label %B34.if.i316.i.i

B396.endif.endif.i.i.critedge:                    ; preds = %B348.i.i8954
  %.958.i.i8956.c = load i64, ptr %.957.i.i, align 8, !noalias !65
  %.1070.i.i.c = inttoptr i64 %.958.i.i8956.c to ptr
  tail call void %.1070.i.i.c(ptr %.571, ptr %.867.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !65
  %.1101.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !65
  %.1217.i.i.c = inttoptr i64 %.1101.i.i.c to ptr
  tail call void %.1217.i.i.c(ptr %.571, ptr %.867.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1216.i.i), !noalias !65
  br label %B396.endif.endif.i.i

B396.endif.endif.i.i:                             ; preds = %B34.if.i316.i.i, %B396.endif.endif.i.i.critedge
  %.1284.i.i = load i64, ptr %.957.i.i, align 8, !noalias !65
  %.1398.i.i = inttoptr i64 %.1284.i.i to ptr
  tail call void %.1398.i.i(ptr %.571, ptr %.867.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !65
  br label %B964.if.i.i

B964.if.i.i:                                      ; preds = %B396.endif.endif.i.i, %B964.i.loopexit.i
  %.1432.i.08192.i = phi i64 [ %.1501.i.i, %B964.i.loopexit.i ], [ 0, %B396.endif.endif.i.i ]
  %.1501.i.i = add nsw i64 %.1432.i.08192.i, 1
  %.1582.i.i = getelementptr double, ptr %60, i64 %.1432.i.08192.i
  %.1583.i.i = load double, ptr %.1582.i.i, align 8, !noalias !65
  %.1584.i.i = fcmp ule double %.1583.i.i, 5.000000e-01
  %.1681.i8188.not.i = select i1 %.1584.i.i, i1 true, i1 %.287.i2218170.not.i
  br i1 %.1681.i8188.not.i, label %B964.i.loopexit.i, label %B1040.if.i.lr.ph.i

B1040.if.i.lr.ph.i:                               ; preds = %B964.if.i.i
  %gep8195.i = getelementptr double, ptr %55, i64 %.1432.i.08192.i
  %gep.i = getelementptr double, ptr %57, i64 %.1432.i.08192.i
  br label %B1040.if.i.i

B1040.if.i.i:                                     ; preds = %B1040.if.i.i, %B1040.if.i.lr.ph.i
  %.1625.i.08189.i = phi i64 [ 0, %B1040.if.i.lr.ph.i ], [ %.1694.i.i, %B1040.if.i.i ]
  %.1694.i.i = add nsw i64 %.1625.i.08189.i, 1
  %210 = mul nsw i64 %.1625.i.08189.i, %arg.shape.0
  %.1722.i.i = add nsw i64 %210, %.1432.i.08192.i
  %211 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1722.i.i
  %.1752.i.i = load double, ptr %211, align 8, !noalias !65
  %.1761.i.i = add nsw i64 %.1722.i.i, %factor.op.mul8197.i.reass
  %.1775.i.i = icmp slt i64 %.1761.i.i, 0
  %.1776.i.i = select i1 %.1775.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %212 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1761.i.i
  %.1790.i.i = getelementptr double, ptr %212, i64 %.1776.i.i
  %.1791.i.i = load double, ptr %.1790.i.i, align 8, !noalias !65
  %.1796.i.i = add nsw i64 %.1722.i.i, %factor.op.mul8196.i.reass
  %.1810.i.i = icmp slt i64 %.1796.i.i, 0
  %.1811.i.i = select i1 %.1810.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %213 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1796.i.i
  %.1825.i.i = getelementptr double, ptr %213, i64 %.1811.i.i
  %.1826.i.i = load double, ptr %.1825.i.i, align 8, !noalias !65
  %.1827.i.i = fsub double %.1791.i.i, %.1826.i.i
  %.1828.i.i = tail call double @llvm.fabs.f64(double %.1827.i.i)
  %.1883.i.i = load double, ptr %gep8195.i, align 8, !noalias !65
  %.1884.i.i = fmul double %.1883.i.i, %.1828.i.i
  %.1914.i.i = load double, ptr %.1913.i.i, align 8, !noalias !65
  %.1944.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !65
  %.1945.i.i = tail call double @llvm.fabs.f64(double %.1752.i.i)
  %.1946.i.i = fmul double %.1945.i.i, %.1944.i.i
  %.1947.i.i = fadd double %.1914.i.i, %.1946.i.i
  %.1951.i.i = fdiv double %.1884.i.i, %.1947.i.i
  %.1957.i.i = fsub double %.1951.i.i, %.1951.i.i
  %.1958.i.i = fcmp oeq double %.1957.i.i, 0.000000e+00
  %.1951.i..i = select i1 %.1958.i.i, double %.1951.i.i, double 0x7FF0000000000000
  %.2029.i.i = load double, ptr %gep.i, align 8, !noalias !65
  %.10.i.i.i8957 = fcmp ogt double %.1951.i..i, %.2029.i.i
  %.11.i.i.i8958 = select i1 %.10.i.i.i8957, double %.1951.i..i, double %.2029.i.i
  store double %.11.i.i.i8958, ptr %gep.i, align 8, !noalias !65
  %exitcond8388.not.i = icmp eq i64 %arg.shape.1, %.1694.i.i
  br i1 %exitcond8388.not.i, label %B964.i.loopexit.i, label %B1040.if.i.i

B438.i:                                           ; preds = %B354.endif.i, %B658.endif.i
  %.936.sroa.0.08298.i = phi i1 [ true, %B658.endif.i ], [ false, %B354.endif.i ]
  %.893.18297.i = phi i64 [ %.893.1.i, %B658.endif.i ], [ 31, %B354.endif.i ]
  br i1 %.190.i9448214.i, label %B92.i.lr.ph.i, label %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B92.i.lr.ph.i:                                    ; preds = %B438.i
  %.480.i15187972.i = select i1 %.936.sroa.0.08298.i, i64 28, i64 1
  %.482.i1520.i = mul i64 %.480.i15187972.i, %arg.shape.6
  br label %B92.i.i

B92.i.i:                                          ; preds = %B855.i.i, %B92.i.lr.ph.i
  %.180.i823.sroa.0.08222.i = phi i64 [ 0, %B92.i.lr.ph.i ], [ %.180.i823.sroa.0.0.i, %B855.i.i ]
  %.134.i.18221.i = phi i64 [ %.134.i.18217.i, %B92.i.lr.ph.i ], [ %.134.i.1.i, %B855.i.i ]
  %.131.i821.18220.i = phi i64 [ %.203.i16138215.i, %B92.i.lr.ph.i ], [ %.131.i821.1.i, %B855.i.i ]
  %some.2.i815.08218.i = phi i1 [ false, %B92.i.lr.ph.i ], [ %some.3.i.1.i, %B855.i.i ]
  %.261.i979.i = icmp slt i64 %.180.i823.sroa.0.08222.i, 0
  %.262.i980.i = select i1 %.261.i979.i, i64 %arg.batch.4.1.5.1, i64 0
  %214 = getelementptr i64, ptr %56, i64 %.180.i823.sroa.0.08222.i
  %.284.i996.i = getelementptr i64, ptr %214, i64 %.262.i980.i
  %.285.i997.i = load i64, ptr %.284.i996.i, align 8, !noalias !81
  %.286.i998.i = icmp slt i64 %.285.i997.i, 0
  br i1 %.286.i998.i, label %B855.i.i, label %B132.i.i

B132.i.i:                                         ; preds = %B92.i.i
  %.319.i1017.i = select i1 %.261.i979.i, i64 %arg.batch.4.0.5.1, i64 0
  %.320.i1018.i = add i64 %.319.i1017.i, %.180.i823.sroa.0.08222.i
  %.341.i1038.i = getelementptr double, ptr %57, i64 %.320.i1018.i
  %.342.i.i = load double, ptr %.341.i1038.i, align 8, !noalias !81
  %.343.i.i = fcmp ogt double %.342.i.i, 1.000000e-01
  br i1 %.343.i.i, label %B855.i.i, label %B190.i.i

B190.i.i:                                         ; preds = %B132.i.i
  br i1 %.436.i10698201.not.i, label %B396.i1075.i, label %B220.if.i.i

B286.i.i:                                         ; preds = %B220.if.i.i
  %.484.i.i = add nsw i64 %.380.i831.08202.i, %.482.i1520.i
  %.486.i1523.i = mul nsw i64 %.484.i.i, %arg.shape.0
  %.488.i.i8953 = add nsw i64 %.486.i1523.i, %.180.i823.sroa.0.08222.i
  %.512.i1559.i = icmp slt i64 %.488.i.i8953, 0
  %.513.i1560.i = select i1 %.512.i1559.i, i64 %arg.batch.5.4.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.488.i.i8953
  %.527.i1571.i = getelementptr double, ptr %215, i64 %.513.i1560.i
  %.528.i1572.i = load double, ptr %.527.i1571.i, align 8, !noalias !81
  %.533.i.i = add nsw i64 %.488.i.i8953, %.194.i.i738.i
  %.549.i1580.i = icmp slt i64 %.533.i.i, 0
  %.550.i1581.i = select i1 %.549.i1580.i, i64 %arg.batch.5.4.5.0, i64 0
  %216 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.533.i.i
  %.564.i.i = getelementptr double, ptr %216, i64 %.550.i1581.i
  %.565.i.i = load double, ptr %.564.i.i, align 8, !noalias !81
  %.566.i.i = fneg double %.565.i.i
  %.567.i.i = fcmp olt double %.528.i1572.i, %.566.i.i
  %217 = select i1 %.567.i.i, double -1.000000e+00, double 1.000000e+00
  br label %B334.i.i

B334.i.i:                                         ; preds = %B220.if.i.i, %B286.i.i
  %"$phi334.2.2.i.3.i" = phi double [ %217, %B286.i.i ], [ 1.000000e+00, %B220.if.i.i ]
  %.588.i.i = add nsw i64 %.380.i831.08202.i, %.586.i.i
  %.592.i1536.i = mul nsw i64 %.588.i.i, %arg.shape.0
  %.594.i.i = add nsw i64 %.592.i1536.i, %.180.i823.sroa.0.08222.i
  %.609.i.i = icmp slt i64 %.594.i.i, 0
  %.610.i.i8950 = select i1 %.609.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %218 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.594.i.i
  %.624.i1549.i = getelementptr double, ptr %218, i64 %.610.i.i8950
  store double %"$phi334.2.2.i.3.i", ptr %.624.i1549.i, align 8, !noalias !81
  %exitcond8390.not.i = icmp eq i64 %arg.shape.6, %.449.i.i8949
  br i1 %exitcond8390.not.i, label %B396.i1075.i, label %B220.if.i.i

B396.i1075.i:                                     ; preds = %B334.i.i, %B190.i.i
  br i1 %.936.sroa.0.08298.i, label %B418.i.i, label %B450.i.i

B418.i.i:                                         ; preds = %B396.i1075.i
  %.689.i.i = getelementptr double, ptr %59, i64 %.320.i1018.i
  %.690.i1512.i = load double, ptr %.689.i.i, align 8, !noalias !81
  br label %B450.i.i

B450.i.i:                                         ; preds = %B418.i.i, %B396.i1075.i
  %"$phi450.1.2.i.2.i" = phi double [ %.690.i1512.i, %B418.i.i ], [ 0.000000e+00, %B396.i1075.i ]
  br i1 %.436.i10698201.not.i, label %B532.i.i.preheader, label %B58.if.i.i.i

B58.if.i.i.i:                                     ; preds = %B450.i.i, %B58.if.i.i.i
  %least.2.i.i.08207.i = phi double [ %.11.i.i.i.i8952, %B58.if.i.i.i ], [ 0x7FF0000000000000, %B450.i.i ]
  %.54.i.i804.08205.i = phi i64 [ %.125.i.i1473.i, %B58.if.i.i.i ], [ 0, %B450.i.i ]
  %.125.i.i1473.i = add nsw i64 %.54.i.i804.08205.i, 1
  %.156.i.i1391.i = add nsw i64 %.54.i.i804.08205.i, %.482.i1520.i
  %.158.i.i1393.i = mul nsw i64 %.156.i.i1391.i, %arg.shape.0
  %.160.i.i1395.i = add nsw i64 %.158.i.i1393.i, %.180.i823.sroa.0.08222.i
  %.164.i.i1398.i = add nsw i64 %.54.i.i804.08205.i, %.586.i.i
  %.166.i.i1400.i = mul nsw i64 %.164.i.i1398.i, %arg.shape.0
  %.168.i.i1402.i = add nsw i64 %.166.i.i1400.i, %.180.i823.sroa.0.08222.i
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
  %.233.i.i1444.i = add nsw i64 %.160.i.i1395.i, %.194.i.i738.i
  %.247.i.i1450.i = icmp slt i64 %.233.i.i1444.i, 0
  %.248.i.i1451.i = select i1 %.247.i.i1450.i, i64 %arg.batch.5.4.5.0, i64 0
  %221 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i.i1444.i
  %.262.i.i1461.i = getelementptr double, ptr %221, i64 %.248.i.i1451.i
  %.263.i.i1462.i = load double, ptr %.262.i.i1461.i, align 8, !noalias !85
  %.264.i.i1463.i = fadd double %.229.i.i1440.i, %.263.i.i1462.i
  %.10.i.i.i.i8951 = fcmp olt double %.264.i.i1463.i, %least.2.i.i.08207.i
  %.11.i.i.i.i8952 = select i1 %.10.i.i.i.i8951, double %.264.i.i1463.i, double %least.2.i.i.08207.i
  %exitcond8391.not.i = icmp eq i64 %arg.shape.6, %.125.i.i1473.i
  br i1 %exitcond8391.not.i, label %B532.i.i.preheader, label %B58.if.i.i.i

B532.i.i.preheader:                               ; preds = %B58.if.i.i.i, %B450.i.i
  %here.4.i.2.i.ph = phi double [ 0x7FF0000000000000, %B450.i.i ], [ %.11.i.i.i.i8952, %B58.if.i.i.i ]
  br label %B532.i.i

B532.i.i:                                         ; preds = %B532.i.i.preheader, %B646.i.i
  %look.2.i.2.i = phi i64 [ %.991.i1176.i, %B646.i.i ], [ 1, %B532.i.i.preheader ]
  %low.2.i.2.i = phi double [ %low.3.i.3.i, %B646.i.i ], [ %"$phi450.1.2.i.2.i", %B532.i.i.preheader ]
  %ahead.3.i.2.i = phi double [ %ahead.2.i.3.i, %B646.i.i ], [ 0.000000e+00, %B532.i.i.preheader ]
  %here.4.i.2.i = phi double [ %here.3.i.3.i, %B646.i.i ], [ %here.4.i.2.i.ph, %B532.i.i.preheader ]
  %222 = icmp ult i64 %look.2.i.2.i, 9
  br i1 %222, label %switch.lookup, label %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B58.if.i186.i.i:                                  ; preds = %B58.if.i186.i.lr.ph.i, %B58.if.i186.i.i
  %least.2.i16.i.08212.i = phi double [ 0x7FF0000000000000, %B58.if.i186.i.lr.ph.i ], [ %.11.i.i182.i.i, %B58.if.i186.i.i ]
  %.54.i20.i.08210.i = phi i64 [ 0, %B58.if.i186.i.lr.ph.i ], [ %.125.i192.i.i, %B58.if.i186.i.i ]
  %.125.i192.i.i = add nsw i64 %.54.i20.i.08210.i, 1
  %.156.i98.i.i = add nsw i64 %.54.i20.i.08210.i, %.155.i97.i.i
  %.158.i100.i.i = mul nsw i64 %.156.i98.i.i, %arg.shape.0
  %.160.i102.i.i = add nsw i64 %.158.i100.i.i, %.180.i823.sroa.0.08222.i
  %.164.i105.i.i = add nsw i64 %.54.i20.i.08210.i, %.586.i.i
  %.166.i107.i.i = mul nsw i64 %.164.i105.i.i, %arg.shape.0
  %.168.i109.i.i = add nsw i64 %.166.i107.i.i, %.180.i823.sroa.0.08222.i
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
  %.233.i154.i.i = add nsw i64 %.160.i102.i.i, %.194.i.i738.i
  %.247.i162.i.i = icmp slt i64 %.233.i154.i.i, 0
  %.248.i163.i.i = select i1 %.247.i162.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i154.i.i
  %.262.i173.i.i = getelementptr double, ptr %225, i64 %.248.i163.i.i
  %.263.i174.i.i = load double, ptr %.262.i173.i.i, align 8, !noalias !89
  %.264.i175.i.i = fadd double %.229.i150.i.i, %.263.i174.i.i
  %.10.i.i181.i.i = fcmp olt double %.264.i175.i.i, %least.2.i16.i.08212.i
  %.11.i.i182.i.i = select i1 %.10.i.i181.i.i, double %.264.i175.i.i, double %least.2.i16.i.08212.i
  %exitcond8392.not.i = icmp eq i64 %arg.shape.6, %.125.i192.i.i
  br i1 %exitcond8392.not.i, label %B566.endif.i.i, label %B58.if.i186.i.i

B616.i.i:                                         ; preds = %B566.endif.i.i
  switch i64 %look.2.i.2.i, label %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i [
    i64 0, label %B646.i.i
    i64 6, label %switch.6.1.i.i
    i64 1, label %switch.1.1.i.i
    i64 8, label %switch.8.1.i.i
    i64 2, label %switch.2.1.i.i
    i64 5, label %switch.5.1.i.i
    i64 3, label %switch.3.1.i.i
    i64 7, label %switch.7.1.i.i
    i64 4, label %switch.4.1.i.i
  ]

B646.i.i:                                         ; preds = %switch.8.1.i.i, %switch.7.1.i.i, %switch.6.1.i.i, %switch.5.1.i.i, %switch.4.1.i.i, %switch.3.1.i.i, %switch.2.1.i.i, %switch.1.1.i.i, %B566.endif.i.i, %switch.lookup, %B616.i.i
  %low.3.i.3.i = phi double [ %low.2.i.2.i, %switch.lookup ], [ %low.2.i.2.i, %B566.endif.i.i ], [ 1.000000e+00, %switch.8.1.i.i ], [ 0x3FB48E8A71DE69AD, %switch.1.1.i.i ], [ 2.500000e-01, %switch.2.1.i.i ], [ 3.333000e-01, %switch.3.1.i.i ], [ 5.000000e-01, %switch.4.1.i.i ], [ 0x3FE50A3D70A3D70A, %switch.5.1.i.i ], [ 7.500000e-01, %switch.6.1.i.i ], [ 8.889000e-01, %switch.7.1.i.i ], [ 0.000000e+00, %B616.i.i ]
  %ahead.2.i.3.i = phi double [ %ahead.3.i.2.i, %switch.lookup ], [ %least.2.i16.i.0.lcssa.i, %B566.endif.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.8.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.1.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.2.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.3.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.4.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.5.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.6.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.7.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %B616.i.i ]
  %here.3.i.3.i = phi double [ %here.4.i.2.i, %switch.lookup ], [ %here.4.i.2.i, %B566.endif.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.8.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.1.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.2.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.3.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.4.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.5.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.6.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %switch.7.1.i.i ], [ %least.2.i16.i.0.lcssa.i, %B616.i.i ]
  %.1001.i.i = icmp eq i64 %look.2.i.2.i, 8
  %.991.i1176.i = add nsw i64 %look.2.i.2.i, 1
  %.1034.i.i = fcmp ult double %ahead.2.i.3.i, 0.000000e+00
  %or.cond.i = select i1 %.1001.i.i, i1 true, i1 %.1034.i.i
  br i1 %or.cond.i, label %B690.i.i, label %B532.i.i

B690.i.i:                                         ; preds = %B646.i.i
  br i1 %.1034.i.i, label %switch.lookup9478, label %B738.i.i

switch.lookup9478:                                ; preds = %B690.i.i
  %switch.gep9479 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i.2.i
  %switch.load9480 = load double, ptr %switch.gep9479, align 8
  br label %B738.i.i

B738.i.i:                                         ; preds = %switch.lookup9478, %B690.i.i
  %"$phi738.2.2.i.2.i" = phi double [ %low.3.i.3.i, %B690.i.i ], [ %switch.load9480, %switch.lookup9478 ]
  %.1172.i1219.i = getelementptr double, ptr %58, i64 %.320.i1018.i
  store double %low.3.i.3.i, ptr %.1172.i1219.i, align 8, !noalias !81
  %.1230.i.i = getelementptr double, ptr %59, i64 %.320.i1018.i
  store double %"$phi738.2.2.i.2.i", ptr %.1230.i.i, align 8, !noalias !81
  %.1288.i1279.i = getelementptr double, ptr %61, i64 %.320.i1018.i
  store double %here.3.i.3.i, ptr %.1288.i1279.i, align 8, !noalias !81
  %.1348.i.i = getelementptr double, ptr %62, i64 %.320.i1018.i
  store double %ahead.2.i.3.i, ptr %.1348.i.i, align 8, !noalias !81
  %.1359.i1317.i = fcmp olt double %ahead.2.i.3.i, 0.000000e+00
  %spec.select7995.i = select i1 %some.2.i815.08218.i, i1 true, i1 %.1359.i1317.i
  br label %B855.i.i

B854.i.loopexit.i:                                ; preds = %B855.i.i
  %226 = xor i1 %some.3.i.1.i, true
  br label %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B855.i.i:                                         ; preds = %B738.i.i, %B132.i.i, %B92.i.i
  %some.3.i.1.i = phi i1 [ %spec.select7995.i, %B738.i.i ], [ %some.2.i815.08218.i, %B132.i.i ], [ %some.2.i815.08218.i, %B92.i.i ]
  %.190.i944.i = icmp sgt i64 %.134.i.18221.i, 0
  %.203.i1613.i = zext i1 %.190.i944.i to i64
  %.131.i821.1.i = add i64 %.131.i821.18220.i, %.203.i1613.i
  %.199.i1610.i = sext i1 %.190.i944.i to i64
  %.134.i.1.i = add nsw i64 %.134.i.18221.i, %.199.i1610.i
  %.180.i823.sroa.0.0.i = select i1 %.190.i944.i, i64 %.131.i821.18220.i, i64 0
  br i1 %.190.i944.i, label %B92.i.i, label %B854.i.loopexit.i

B220.if.i.i:                                      ; preds = %B190.i.i, %B334.i.i
  %.380.i831.08202.i = phi i64 [ %.449.i.i8949, %B334.i.i ], [ 0, %B190.i.i ]
  %.449.i.i8949 = add nsw i64 %.380.i831.08202.i, 1
  br i1 %.936.sroa.0.08298.i, label %B286.i.i, label %B334.i.i

switch.lookup:                                    ; preds = %B532.i.i
  %switch.gep = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i.2.i
  %switch.load = load double, ptr %switch.gep, align 8
  %.876.i.i = fcmp ogt double %switch.load, %low.2.i.2.i
  br i1 %.876.i.i, label %B58.i66.i.preheader.i, label %B646.i.i

B58.i66.i.preheader.i:                            ; preds = %switch.lookup
  br i1 %.436.i10698201.not.i, label %B566.endif.i.i, label %B58.if.i186.i.lr.ph.i

B58.if.i186.i.lr.ph.i:                            ; preds = %B58.i66.i.preheader.i
  %.151.i93.i.i = mul nsw i64 %look.2.i.2.i, 3
  %.153.i95.i7885.i = add nsw i64 %.151.i93.i.i, 1
  %.155.i97.i.i = mul i64 %.153.i95.i7885.i, %arg.shape.6
  br label %B58.if.i186.i.i

B566.endif.i.i:                                   ; preds = %B58.if.i186.i.i, %B58.i66.i.preheader.i
  %least.2.i16.i.0.lcssa.i = phi double [ 0x7FF0000000000000, %B58.i66.i.preheader.i ], [ %.11.i.i182.i.i, %B58.if.i186.i.i ]
  %.927.i.i = fcmp ult double %least.2.i16.i.0.lcssa.i, 0.000000e+00
  br i1 %.927.i.i, label %B646.i.i, label %B616.i.i

switch.1.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.2.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.3.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.4.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.5.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.6.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.7.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

switch.8.1.i.i:                                   ; preds = %B616.i.i
  br label %B646.i.i

_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B616.i.i, %B532.i.i, %B854.i.loopexit.i, %B438.i
  %.190.i9448155.i = phi i1 [ false, %B854.i.loopexit.i ], [ false, %B438.i ], [ true, %B532.i.i ], [ true, %B616.i.i ]
  %.1005.0.i = phi i1 [ %226, %B854.i.loopexit.i ], [ true, %B438.i ], [ true, %B532.i.i ], [ true, %B616.i.i ]
  %.10291620.i = phi i32 [ 0, %B854.i.loopexit.i ], [ 0, %B438.i ], [ 1, %B532.i.i ], [ 1, %B616.i.i ]
  br i1 %.190.i9448155.i, label %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B482.endif.endif.i, !prof !93

B114.i.loopexit.i:                                ; preds = %B769.i.i
  %.219.i1837.i = icmp ne i64 %.163.i1731.18253.i, 0
  %227 = sub nsw i64 45, %.160.i1730.18252.i
  %.232.i2833.i = zext i1 %.219.i1837.i to i64
  %.160.i1730.1.i = add i64 %.160.i1730.18252.i, %.232.i2833.i
  %.228.i2830.i = sext i1 %.219.i1837.i to i64
  %.163.i1731.1.i = add nsw i64 %.163.i1731.18253.i, %.228.i2830.i
  %.209.i1733.sroa.0.0.i = select i1 %.219.i1837.i, i64 %227, i64 45
  br i1 %.219.i1837.i, label %B154.i.preheader.i, label %B586.if.i.preheader

B586.if.i.preheader:                              ; preds = %B306.i1894.i, %B114.i.loopexit.i
  br label %B586.if.i

B154.i.preheader.i:                               ; preds = %B154.i.preheader.i.preheader, %B114.i.loopexit.i
  %.209.i1733.sroa.0.08254.i = phi i64 [ %.209.i1733.sroa.0.0.i, %B114.i.loopexit.i ], [ 45, %B154.i.preheader.i.preheader ]
  %.163.i1731.18253.i = phi i64 [ %.163.i1731.1.i, %B114.i.loopexit.i ], [ 44, %B154.i.preheader.i.preheader ]
  %.160.i1730.18252.i = phi i64 [ %.160.i1730.1.i, %B114.i.loopexit.i ], [ 1, %B154.i.preheader.i.preheader ]
  %.108.not.i.i = icmp eq i64 %.209.i1733.sroa.0.08254.i, 0
  br label %B154.if.i.i

B154.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %B230.endif.i.i
  %exitcond8395.not.i = icmp eq i64 %arg.shape.0, %.356.i2819.i
  br i1 %exitcond8395.not.i, label %B306.i1894.i, label %B154.if.i.i

B162.i.i:                                         ; preds = %B154.if.i.i
  %.445.i2428.i = getelementptr double, ptr %59, i64 %.287.i1740.08232.i
  %.446.i2429.i = load double, ptr %.445.i2428.i, align 8, !noalias !94
  %.500.i2470.i = getelementptr double, ptr %58, i64 %.287.i1740.08232.i
  %.501.i2471.i = load double, ptr %.500.i2470.i, align 8, !noalias !94
  %.502.i2472.i = fsub double %.446.i2429.i, %.501.i2471.i
  %.504.i2474.i = fcmp ogt double %.502.i2472.i, 1.000000e-05
  br label %B230.i.i

B230.i.i:                                         ; preds = %B154.if.i.i, %B162.i.i
  %"$phi230.2.2.i.2.i" = phi i1 [ true, %B154.if.i.i ], [ %.504.i2474.i, %B162.i.i ]
  %.71.i.i2534.i = getelementptr double, ptr %58, i64 %.287.i1740.08232.i
  %.72.i.i2535.i = load double, ptr %.71.i.i2534.i, align 8, !noalias !98
  %.124.i.i2568.i = getelementptr double, ptr %59, i64 %.287.i1740.08232.i
  %.125.i.i2569.i = load double, ptr %.124.i.i2568.i, align 8, !noalias !98
  %.177.i.i2602.i = getelementptr double, ptr %61, i64 %.287.i1740.08232.i
  %.178.i.i2603.i = load double, ptr %.177.i.i2602.i, align 8, !noalias !98
  %.230.i.i2637.i = getelementptr double, ptr %62, i64 %.287.i1740.08232.i
  %.231.i.i2638.i = load double, ptr %.230.i.i2637.i, align 8, !noalias !98
  %.248.i.i2647.i = fadd double %.72.i.i2535.i, %.125.i.i2569.i
  %.249.i.i2648.i = fmul double %.248.i.i2647.i, 5.000000e-01
  br i1 %.108.not.i.i, label %B0.endif.i.i2662.i, label %B282.i.i

B282.i.i:                                         ; preds = %B230.i.i, %B282.i.i
  %r.2.0.i.i = phi double [ %r.3.1.i.i, %B282.i.i ], [ 1.000000e+00, %B230.i.i ]
  %a.1.2.0.i.i = phi double [ %.147.i8004.i, %B282.i.i ], [ 2.000000e+00, %B230.i.i ]
  %exp.4.0.i.i = phi i64 [ %.142.i.i, %B282.i.i ], [ %.209.i1733.sroa.0.08254.i, %B230.i.i ]
  %.122.i.i8932 = and i64 %exp.4.0.i.i, 1
  %.123.not.i.i = icmp eq i64 %.122.i.i8932, 0
  %.127.i.i = fmul double %r.2.0.i.i, %a.1.2.0.i.i
  %r.3.1.i.i = select i1 %.123.not.i.i, double %r.2.0.i.i, double %.127.i.i
  %.142.i.i = lshr i64 %exp.4.0.i.i, 1
  %.147.i8004.i = fmul double %a.1.2.0.i.i, %a.1.2.0.i.i
  %.150.not.i.i = icmp eq i64 %.142.i.i, 0
  br i1 %.150.not.i.i, label %B334.i8005.loopexit.i, label %B282.i.i

B334.i8005.loopexit.i:                            ; preds = %B282.i.i
  %228 = fmul double %r.3.1.i.i, 1.000000e-05
  br label %B0.endif.i.i2662.i

B460.i.i.i:                                       ; preds = %B0.endif.i.i2662.i
  %.10.i3.i.i.i = fcmp olt double %.285.i.i2667.i, 0.000000e+00
  %.11.i4.i.i.i = select i1 %.10.i3.i.i.i, double 0.000000e+00, double %.285.i.i2667.i
  %.444.i.i.i = fmul double %.340.i.i.i, %.11.i4.i.i.i
  %.448.i.i.i = fsub double %.249.i.i2648.i, %.444.i.i.i
  br label %B230.endif.i.i

B0.endif.i.i2662.i:                               ; preds = %B334.i8005.loopexit.i, %B230.i.i
  %r.4.1.i.i = phi double [ 1.000000e-05, %B230.i.i ], [ %228, %B334.i8005.loopexit.i ]
  %.283.i.i2665.i = fsub double %.125.i.i2569.i, %.72.i.i2535.i
  %.284.i.i2666.i = fsub double %r.4.1.i.i, %.283.i.i2665.i
  %.285.i.i2667.i = fmul double %.284.i.i2666.i, 5.000000e-01
  %.290.i.i2670.i = fmul double %.72.i.i2535.i, %.231.i.i2638.i
  %.292.i.i2672.i = fmul double %.125.i.i2569.i, %.178.i.i2603.i
  %.293.i.i2673.i = fsub double %.290.i.i2670.i, %.292.i.i2672.i
  %.294.i.i2674.i = fsub double %.231.i.i2638.i, %.178.i.i2603.i
  %.298.i.i2677.i = fdiv double %.293.i.i2673.i, %.294.i.i2674.i
  %.304.i.i2680.i = fcmp olt double %.72.i.i2535.i, %.298.i.i2677.i
  %.312.i.i2805.i = fcmp olt double %.298.i.i2677.i, %.125.i.i2569.i
  %or.cond8000.i = select i1 %.304.i.i2680.i, i1 %.312.i.i2805.i, i1 false
  %"$phi268.0.2.i.i.0.i" = select i1 %or.cond8000.i, double %.298.i.i2677.i, double %.249.i.i2648.i
  %.339.i.i.i = fsub double %.249.i.i2648.i, %"$phi268.0.2.i.i.0.i"
  %.340.i.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.339.i.i.i)
  %.354.i.i.i = fmul double %.283.i.i2665.i, %.283.i.i2665.i
  %.357.i.i.i = tail call double @llvm.fabs.f64(double %.339.i.i.i)
  %.10.i.i.i2685.i = fcmp olt double %.357.i.i.i, %.354.i.i.i
  %.11.i.i.i2686.i = select i1 %.10.i.i.i2685.i, double %.357.i.i.i, double %.354.i.i.i
  %.387.i.i.i = fmul double %.340.i.i.i, %.11.i.i.i2686.i
  %.388.i.i.i = fadd double %"$phi268.0.2.i.i.0.i", %.387.i.i.i
  %.394.i.i.i = fsub double %.388.i.i.i, %.249.i.i2648.i
  %.395.i.i.i = tail call double @llvm.fabs.f64(double %.394.i.i.i)
  %.397.i.i.i = fcmp ugt double %.395.i.i.i, %.285.i.i2667.i
  br i1 %.397.i.i.i, label %B460.i.i.i, label %B230.endif.i.i

B306.i1894.i:                                     ; preds = %B154.i.loopexit.i
  br i1 %"$phi230.2.2.i.2.i", label %B316.i.i, label %B586.if.i.preheader

B316.i.i:                                         ; preds = %B306.i1894.i
  %.655.i1935.i = load i64, ptr %.654.i1934.i, align 8, !noalias !94
  %.771.i2001.i = inttoptr i64 %.655.i1935.i to ptr
  tail call void %.771.i2001.i(ptr %.571, ptr %.745.i1996.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.770.i2000.i), !noalias !94
  br label %B490.if.i.i

B564.i.i:                                         ; preds = %B490.if.i.i
  %.177.i139.i.i = getelementptr double, ptr %61, i64 %.797.i1761.08244.i
  %.178.i140.i.i = load double, ptr %.177.i139.i.i, align 8, !noalias !102
  %.230.i175.i.i = getelementptr double, ptr %62, i64 %.797.i1761.08244.i
  %.231.i176.i.i = load double, ptr %.230.i175.i.i, align 8, !noalias !102
  %.248.i185.i.i = fadd double %.948.i2082.i, %.1003.i2124.i
  %.249.i186.i.i = fmul double %.248.i185.i.i, 5.000000e-01
  br i1 %.108.not.i.i, label %B0.endif.i200.i.i, label %B282.i8012.i

B282.i8012.i:                                     ; preds = %B564.i.i, %B282.i8012.i
  %r.2.0.i8013.i = phi double [ %r.3.1.i8019.i, %B282.i8012.i ], [ 1.000000e+00, %B564.i.i ]
  %a.1.2.0.i8014.i = phi double [ %.147.i8021.i, %B282.i8012.i ], [ 2.000000e+00, %B564.i.i ]
  %exp.4.0.i8015.i = phi i64 [ %.142.i8020.i, %B282.i8012.i ], [ %.209.i1733.sroa.0.08254.i, %B564.i.i ]
  %.122.i8016.i = and i64 %exp.4.0.i8015.i, 1
  %.123.not.i8017.i = icmp eq i64 %.122.i8016.i, 0
  %.127.i8018.i = fmul double %r.2.0.i8013.i, %a.1.2.0.i8014.i
  %r.3.1.i8019.i = select i1 %.123.not.i8017.i, double %r.2.0.i8013.i, double %.127.i8018.i
  %.142.i8020.i = lshr i64 %exp.4.0.i8015.i, 1
  %.147.i8021.i = fmul double %a.1.2.0.i8014.i, %a.1.2.0.i8014.i
  %.150.not.i8022.i = icmp eq i64 %.142.i8020.i, 0
  br i1 %.150.not.i8022.i, label %B334.i8023.loopexit.i, label %B282.i8012.i

B334.i8023.loopexit.i:                            ; preds = %B282.i8012.i
  %229 = fmul double %r.3.1.i8019.i, 1.000000e-05
  br label %B0.endif.i200.i.i

B460.i267.i.i:                                    ; preds = %B0.endif.i200.i.i
  %.10.i3.i274.i.i = fcmp olt double %.285.i206.i.i, 0.000000e+00
  %.11.i4.i275.i.i = select i1 %.10.i3.i274.i.i, double 0.000000e+00, double %.285.i206.i.i
  %.444.i280.i.i = fmul double %.340.i235.i.i, %.11.i4.i275.i.i
  %.448.i283.i.i = fsub double %.249.i186.i.i, %.444.i280.i.i
  br label %B564.endif.i.i

B0.endif.i200.i.i:                                ; preds = %B334.i8023.loopexit.i, %B564.i.i
  %r.4.1.i8024.i = phi double [ 1.000000e-05, %B564.i.i ], [ %229, %B334.i8023.loopexit.i ]
  %.284.i205.i.i = fsub double %r.4.1.i8024.i, %.1004.i2125.i
  %.285.i206.i.i = fmul double %.284.i205.i.i, 5.000000e-01
  %.290.i209.i.i = fmul double %.1003.i2124.i, %.231.i176.i.i
  %.292.i211.i.i = fmul double %.948.i2082.i, %.178.i140.i.i
  %.293.i212.i.i = fsub double %.290.i209.i.i, %.292.i211.i.i
  %.294.i213.i.i = fsub double %.231.i176.i.i, %.178.i140.i.i
  %.298.i216.i.i = fdiv double %.293.i212.i.i, %.294.i213.i.i
  %.304.i220.i.i = fcmp olt double %.1003.i2124.i, %.298.i216.i.i
  %.312.i294.i.i = fcmp olt double %.298.i216.i.i, %.948.i2082.i
  %or.cond8001.i = and i1 %.304.i220.i.i, %.312.i294.i.i
  %"$phi268.0.2.i26.i.0.i" = select i1 %or.cond8001.i, double %.298.i216.i.i, double %.249.i186.i.i
  %.339.i234.i.i = fsub double %.249.i186.i.i, %"$phi268.0.2.i26.i.0.i"
  %.340.i235.i.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.339.i234.i.i)
  %.354.i245.i.i = fmul double %.1004.i2125.i, %.1004.i2125.i
  %.357.i248.i.i = tail call double @llvm.fabs.f64(double %.339.i234.i.i)
  %.10.i.i253.i.i = fcmp olt double %.357.i248.i.i, %.354.i245.i.i
  %.11.i.i254.i.i = select i1 %.10.i.i253.i.i, double %.357.i248.i.i, double %.354.i245.i.i
  %.387.i258.i.i = fmul double %.340.i235.i.i, %.11.i.i254.i.i
  %.388.i259.i.i = fadd double %"$phi268.0.2.i26.i.0.i", %.387.i258.i.i
  %.394.i263.i.i = fsub double %.388.i259.i.i, %.249.i186.i.i
  %.395.i264.i.i = tail call double @llvm.fabs.f64(double %.394.i263.i.i)
  %.397.i266.i.i = fcmp ugt double %.395.i264.i.i, %.285.i206.i.i
  br i1 %.397.i266.i.i, label %B460.i267.i.i, label %B564.endif.i.i

B660.i.i8947:                                     ; preds = %B564.endif.endif.i.i
  store double %.1013.i1770.0.i, ptr %.947.i2081.i, align 8, !noalias !94
  store double %least.2.i.i1624.0.lcssa.i, ptr %.230.i175.i.i, align 8, !noalias !94
  br label %B769.i.i

B712.i.i:                                         ; preds = %B564.endif.endif.i.i
  store double %.1013.i1770.0.i, ptr %.1002.i2123.i, align 8, !noalias !94
  store double %least.2.i.i1624.0.lcssa.i, ptr %.177.i139.i.i, align 8, !noalias !94
  br label %B769.i.i

B769.i.i:                                         ; preds = %B490.if.i.i, %B712.i.i, %B660.i.i8947
  %exitcond8397.not.i = icmp eq i64 %arg.shape.0, %.866.i2375.i
  br i1 %exitcond8397.not.i, label %B114.i.loopexit.i, label %B490.if.i.i

B154.if.i.i:                                      ; preds = %B154.i.loopexit.i, %B154.i.preheader.i
  %wide.2.i.18234.i = phi i1 [ false, %B154.i.preheader.i ], [ %"$phi230.2.2.i.2.i", %B154.i.loopexit.i ]
  %.287.i1740.08232.i = phi i64 [ 0, %B154.i.preheader.i ], [ %.356.i2819.i, %B154.i.loopexit.i ]
  %.356.i2819.i = add nsw i64 %.287.i1740.08232.i, 1
  br i1 %wide.2.i.18234.i, label %B230.i.i, label %B162.i.i

B230.endif.i.i:                                   ; preds = %B0.endif.i.i2662.i, %B460.i.i.i
  %.519.i1748.0.i = phi double [ %.388.i.i.i, %B0.endif.i.i2662.i ], [ %.448.i.i.i, %B460.i.i.i ]
  %.92.i.i2743.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.287.i1740.08232.i
  %.93.i.i2744.i = load double, ptr %.92.i.i2743.i, align 8, !noalias !106
  %.146.i.i2756.i = getelementptr double, ptr %55, i64 %.287.i1740.08232.i
  %.147.i394.i.i = load double, ptr %.146.i.i2756.i, align 8, !noalias !106
  %.149.i396.i.i = fmul double %.519.i1748.0.i, %.147.i394.i.i
  %.150.i397.i.i = fadd double %.93.i.i2744.i, %.149.i396.i.i
  %.203.i428.i.i = getelementptr double, ptr %.571, i64 %.287.i1740.08232.i
  store double %.150.i397.i.i, ptr %.203.i428.i.i, align 8, !noalias !106
  br i1 %.287.i2218170.not.i, label %B154.i.loopexit.i, label %B122.if.i.i.lr.ph.i

B122.if.i.i.lr.ph.i:                              ; preds = %B230.endif.i.i
  %.247.i.i.i.i = fsub double 1.000000e+00, %.519.i1748.0.i
  %invariant.gep9307 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9309 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9311 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9313 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9315 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9317 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9319 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9321 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  %invariant.gep9323 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i1740.08232.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.lr.ph.i
  %.229.i325.i.08229.i = phi i64 [ 0, %B122.if.i.i.lr.ph.i ], [ %.300.i497.i.i, %B122.if.i.i.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep9308 = getelementptr double, ptr %invariant.gep9307, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep9308, align 8, !noalias !110
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.519.i1748.0.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep9310 = getelementptr double, ptr %invariant.gep9309, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep9310, align 8, !noalias !110
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep9312 = getelementptr double, ptr %invariant.gep9311, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep9312, align 8, !noalias !110
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.519.i1748.0.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep9314 = getelementptr double, ptr %invariant.gep9313, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep9314, align 8, !noalias !110
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep9316 = getelementptr double, ptr %invariant.gep9315, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep9316, align 8, !noalias !110
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.519.i1748.0.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep9318 = getelementptr double, ptr %invariant.gep9317, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep9318, align 8, !noalias !110
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i325.i.08229.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep9320 = getelementptr double, ptr %invariant.gep9319, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep9320, align 8, !noalias !110
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.519.i1748.0.i, %.193.i.i.i.6.i
  %.300.i497.i.i = add nsw i64 %.229.i325.i.08229.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i325.i.08229.i, %arg.shape.0
  %gep9322 = getelementptr double, ptr %invariant.gep9321, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep9322, align 8, !noalias !110
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i482.i.i = add nsw i64 %.229.i325.i.08229.i, %.358.i355.i
  %.361.i.i.i = mul nsw i64 %.359.i482.i.i, %arg.shape.0
  %gep9324 = getelementptr double, ptr %invariant.gep9323, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep9324, align 8, !noalias !106
  %exitcond8394.not.i = icmp eq i64 %arg.shape.1, %.300.i497.i.i
  br i1 %exitcond8394.not.i, label %B154.i.loopexit.i, label %B122.if.i.i.i

B490.if.i.i:                                      ; preds = %B769.i.i, %B316.i.i
  %.797.i1761.08244.i = phi i64 [ 0, %B316.i.i ], [ %.866.i2375.i, %B769.i.i ]
  %.866.i2375.i = add nsw i64 %.797.i1761.08244.i, 1
  %.947.i2081.i = getelementptr double, ptr %59, i64 %.797.i1761.08244.i
  %.948.i2082.i = load double, ptr %.947.i2081.i, align 8, !noalias !94
  %.1002.i2123.i = getelementptr double, ptr %58, i64 %.797.i1761.08244.i
  %.1003.i2124.i = load double, ptr %.1002.i2123.i, align 8, !noalias !94
  %.1004.i2125.i = fsub double %.948.i2082.i, %.1003.i2124.i
  %.1006.i2127.i = fcmp ogt double %.1004.i2125.i, 1.000000e-05
  br i1 %.1006.i2127.i, label %B564.i.i, label %B769.i.i

B564.endif.i.i:                                   ; preds = %B0.endif.i200.i.i, %B460.i267.i.i
  %.1013.i1770.0.i = phi double [ %.388.i259.i.i, %B0.endif.i200.i.i ], [ %.448.i283.i.i, %B460.i267.i.i ]
  br i1 %.436.i10698201.not.i, label %B564.endif.endif.i.i, label %B58.if.i.i2367.i.preheader

B58.if.i.i2367.i.preheader:                       ; preds = %B564.endif.i.i
  %invariant.gep9325 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.797.i1761.08244.i
  %invariant.gep9327 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.797.i1761.08244.i
  br label %B58.if.i.i2367.i

B58.if.i.i2367.i:                                 ; preds = %B58.if.i.i2367.i.preheader, %B58.if.i.i2367.i
  %least.2.i.i1624.08241.i = phi double [ %.11.i.i683.i.i, %B58.if.i.i2367.i ], [ 0x7FF0000000000000, %B58.if.i.i2367.i.preheader ]
  %.54.i516.i.08239.i = phi i64 [ %.125.i694.i.i, %B58.if.i.i2367.i ], [ 0, %B58.if.i.i2367.i.preheader ]
  %.125.i694.i.i = add nsw i64 %.54.i516.i.08239.i, 1
  %.156.i587.i.i = add nsw i64 %.54.i516.i.08239.i, %.155.i586.i.i
  %.158.i589.i.i = mul nsw i64 %.156.i587.i.i, %arg.shape.0
  %.164.i594.i.i = add nsw i64 %.54.i516.i.08239.i, %.586.i.i
  %.166.i595.i.i = mul nsw i64 %.164.i594.i.i, %arg.shape.0
  %gep9326 = getelementptr double, ptr %invariant.gep9325, i64 %.166.i595.i.i
  %.198.i.i2360.i = load double, ptr %gep9326, align 8, !noalias !114
  %gep9328 = getelementptr double, ptr %invariant.gep9327, i64 %.158.i589.i.i
  %.228.i645.i.i = load double, ptr %gep9328, align 8, !noalias !114
  %.229.i646.i.i = fmul double %.198.i.i2360.i, %.228.i645.i.i
  %230 = getelementptr double, ptr %gep9328, i64 %.194.i.i738.i
  %.263.i673.i.i = load double, ptr %230, align 8, !noalias !114
  %.264.i674.i.i = fadd double %.229.i646.i.i, %.263.i673.i.i
  %.10.i.i682.i.i = fcmp olt double %.264.i674.i.i, %least.2.i.i1624.08241.i
  %.11.i.i683.i.i = select i1 %.10.i.i682.i.i, double %.264.i674.i.i, double %least.2.i.i1624.08241.i
  %exitcond8396.not.i = icmp eq i64 %arg.shape.6, %.125.i694.i.i
  br i1 %exitcond8396.not.i, label %B564.endif.endif.i.i, label %B58.if.i.i2367.i

B564.endif.endif.i.i:                             ; preds = %B58.if.i.i2367.i, %B564.endif.i.i
  %least.2.i.i1624.0.lcssa.i = phi double [ 0x7FF0000000000000, %B564.endif.i.i ], [ %.11.i.i683.i.i, %B58.if.i.i2367.i ]
  %.1079.i2184.i = fcmp olt double %least.2.i.i1624.0.lcssa.i, 0.000000e+00
  br i1 %.1079.i2184.i, label %B660.i.i8947, label %B712.i.i

B586.loopexit.i:                                  ; preds = %B122.if.i.i, %B586.if.i
  %exitcond8400.not.i = icmp eq i64 %arg.shape.0, %.1230.i
  br i1 %exitcond8400.not.i, label %B658.i, label %B586.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.08259.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.08259.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9330 = getelementptr double, ptr %invariant.gep9329, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9330, align 8, !noalias !118
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.1309.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.08259.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9332 = getelementptr double, ptr %invariant.gep9331, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9332, align 8, !noalias !118
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.08259.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9334 = getelementptr double, ptr %invariant.gep9333, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9334, align 8, !noalias !118
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.1309.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.08259.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9336 = getelementptr double, ptr %invariant.gep9335, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9336, align 8, !noalias !118
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.08259.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9338 = getelementptr double, ptr %invariant.gep9337, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9338, align 8, !noalias !118
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.1309.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.08259.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9340 = getelementptr double, ptr %invariant.gep9339, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9340, align 8, !noalias !118
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.08259.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9342 = getelementptr double, ptr %invariant.gep9341, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9342, align 8, !noalias !118
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.1309.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.08259.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.08259.i, %arg.shape.0
  %gep9344 = getelementptr double, ptr %invariant.gep9343, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep9344, align 8, !noalias !118
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.359.i.i = add nsw i64 %.229.i.08259.i, %.358.i355.i
  %.361.i.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep9346 = getelementptr double, ptr %invariant.gep9345, i64 %.361.i.i
  store double %.313.i.i.i, ptr %gep9346, align 8, !noalias !125
  %exitcond8399.not.i = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond8399.not.i, label %B586.loopexit.i, label %B122.if.i.i

B658.i:                                           ; preds = %B586.loopexit.i
  %.1383.i = load i64, ptr %.654.i1934.i, align 8, !noalias !61
  %.1499.i = inttoptr i64 %.1383.i to ptr
  tail call void %.1499.i(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1498.i), !noalias !61
  br label %B88.if.i7249.i

B130.i7197.i:                                     ; preds = %B88.if.i7249.i
  %231 = getelementptr double, ptr %57, i64 %.203.i5410.08265.i
  %.416.i7246.i = load double, ptr %231, align 8, !noalias !126
  %.417.i7247.i = fcmp ugt double %.416.i7246.i, 1.000000e-01
  br i1 %.417.i7247.i, label %B294.i6841.i, label %B182.i7099.i

B182.i7099.i:                                     ; preds = %B130.i7197.i
  %.481.i7144.i = getelementptr double, ptr %58, i64 %.203.i5410.08265.i
  %.482.i7145.i = load double, ptr %.481.i7144.i, align 8, !noalias !126
  %.536.i7193.i = getelementptr double, ptr %59, i64 %.203.i5410.08265.i
  %.537.i7194.i = load double, ptr %.536.i7193.i, align 8, !noalias !126
  %.538.i7195.i = fcmp olt double %.482.i7145.i, %.537.i7194.i
  br i1 %.538.i7195.i, label %B34.i.i6970.i, label %B294.i6841.i

B34.i.i6970.i:                                    ; preds = %B182.i7099.i, %B34.if.i.i7084.i
  %.51.i.i5271.0.i = phi i64 [ %.122.i.i7090.i, %B34.if.i.i7084.i ], [ 0, %B182.i7099.i ]
  %exitcond8401.not.i = icmp eq i64 %.51.i.i5271.0.i, %storemerge7986.i
  br i1 %exitcond8401.not.i, label %B294.i6841.i, label %B34.if.i.i7084.i

B128.i.i7075.i:                                   ; preds = %B34.if.i.i7084.i
  %232 = icmp sgt i64 %.51.i.i5271.0.i, -1
  br label %B294.i6841.i

B34.if.i.i7084.i:                                 ; preds = %B34.i.i6970.i
  %.122.i.i7090.i = add i64 %.51.i.i5271.0.i, 1
  %.157.i.i7022.i = add nsw i64 %.51.i.i5271.0.i, %.155.i586.i.i
  %.159.i.i7024.i = mul nsw i64 %.157.i.i7022.i, %arg.shape.0
  %.161.i.i7026.i = add nsw i64 %.159.i.i7024.i, %.203.i5410.08265.i
  %.175.i.i7034.i = icmp slt i64 %.161.i.i7026.i, 0
  %.176.i.i7035.i = select i1 %.175.i.i7034.i, i64 %arg.batch.5.4.5.0, i64 0
  %233 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i7026.i
  %.190.i.i7045.i = getelementptr double, ptr %233, i64 %.176.i.i7035.i
  %.191.i.i7046.i = load double, ptr %.190.i.i7045.i, align 8, !noalias !130
  %.195.i.i7050.i = add nsw i64 %.161.i.i7026.i, %.194.i.i738.i
  %.209.i.i7058.i = icmp slt i64 %.195.i.i7050.i, 0
  %.210.i.i7059.i = select i1 %.209.i.i7058.i, i64 %arg.batch.5.4.5.0, i64 0
  %234 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i.i7050.i
  %.224.i.i7069.i = getelementptr double, ptr %234, i64 %.210.i.i7059.i
  %.225.i.i7070.i = load double, ptr %.224.i.i7069.i, align 8, !noalias !130
  %.226.i.i7071.i = fneg double %.225.i.i7070.i
  %.227.i.i7072.i = fcmp olt double %.191.i.i7046.i, %.226.i.i7071.i
  br i1 %.227.i.i7072.i, label %B128.i.i7075.i, label %B34.i.i6970.i

B294.i6841.i:                                     ; preds = %B34.i.i6970.i, %B88.if.i7249.i, %B128.i.i7075.i, %B182.i7099.i, %B130.i7197.i
  %"$phi294.1.2.i5426.1.i" = phi i1 [ false, %B130.i7197.i ], [ false, %B182.i7099.i ], [ false, %B88.if.i7249.i ], [ %232, %B128.i.i7075.i ], [ false, %B34.i.i6970.i ]
  %spec.select7996.i = or i1 %some.2.i5406.08267.i, %"$phi294.1.2.i5426.1.i"
  %"$phi312.2.2.i5431.1.i" = select i1 %"$phi294.1.2.i5426.1.i", double 1.000000e+00, double 0.000000e+00
  %235 = getelementptr double, ptr %60, i64 %.203.i5410.08265.i
  store double %"$phi312.2.2.i5431.1.i", ptr %235, align 8, !noalias !126
  %exitcond8402.not.i = icmp eq i64 %arg.shape.0, %.274.i7257.i
  br i1 %exitcond8402.not.i, label %B340.i5578.i, label %B88.if.i7249.i

B340.i5578.i:                                     ; preds = %B294.i6841.i
  br i1 %spec.select7996.i, label %B348.i5598.i, label %B658.endif.i

B348.i5598.i:                                     ; preds = %B340.i5578.i
  %.776.i5643.i = load i64, ptr %arg.code.4, align 8, !noalias !126
  %.892.i5713.i = inttoptr i64 %.776.i5643.i to ptr
  tail call void %.892.i5713.i(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.892.i.i), !noalias !126
  br i1 %.114.i40.i8180.not.i, label %B396.endif.endif.i6109.i.critedge, label %B34.if.i111.i6763.i

B34.if.i111.i6763.i:                              ; preds = %B348.i5598.i, %B34.if.i111.i6763.i
  %.56.i.i5250.08270.i = phi i64 [ %.127.i115.i6769.i, %B34.if.i111.i6763.i ], [ 0, %B348.i5598.i ]
  %.127.i115.i6769.i = add nsw i64 %.56.i.i5250.08270.i, 1
  %.153.i49.i6678.i = add nsw i64 %.56.i.i5250.08270.i, %factor.op.mul8291.i.reass
  %.167.i56.i6686.i = icmp slt i64 %.153.i49.i6678.i, 0
  %.168.i.i6687.i = select i1 %.167.i56.i6686.i, i64 %arg.batch.5.4.5.0, i64 0
  %236 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i49.i6678.i
  %.182.i.i6697.i = getelementptr double, ptr %236, i64 %.168.i.i6687.i
  %.183.i68.i6698.i = load double, ptr %.182.i.i6697.i, align 8, !noalias !134
  %.185.i70.i6700.i = add nsw i64 %.56.i.i5250.08270.i, %.898.i.i
  %.199.i.i6708.i = icmp slt i64 %.185.i70.i6700.i, 0
  %.200.i.i6709.i = select i1 %.199.i.i6708.i, i64 %arg.batch.5.1.5.0, i64 0
  %237 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i70.i6700.i
  %.214.i89.i6719.i = getelementptr double, ptr %237, i64 %.200.i.i6709.i
  %.215.i90.i6720.i = load double, ptr %.214.i89.i6719.i, align 8, !noalias !134
  store double %.183.i68.i6698.i, ptr %.214.i89.i6719.i, align 8, !noalias !134
  store double %.215.i90.i6720.i, ptr %.182.i.i6697.i, align 8, !noalias !134
  %exitcond8403.not.i = icmp eq i64 %.194.i.i738.i, %.127.i115.i6769.i
  br i1 %exitcond8403.not.i, label %B396.endif.i5815.i, label %B34.if.i111.i6763.i

B964.i6223.loopexit.i:                            ; preds = %B1040.if.i6533.i, %B964.if.i6545.i
  %exitcond8406.not.i = icmp eq i64 %arg.shape.0, %.1500.i6549.i
  br i1 %exitcond8406.not.i, label %B658.endif.i, label %B964.if.i6545.i

B88.if.i7249.i:                                   ; preds = %B658.i, %B294.i6841.i
  %some.2.i5406.08267.i = phi i1 [ %spec.select7996.i, %B294.i6841.i ], [ false, %B658.i ]
  %.203.i5410.08265.i = phi i64 [ %.274.i7257.i, %B294.i6841.i ], [ 0, %B658.i ]
  %.274.i7257.i = add nsw i64 %.203.i5410.08265.i, 1
  %238 = getelementptr i64, ptr %56, i64 %.203.i5410.08265.i
  %.356.i6830.i = load i64, ptr %238, align 8, !noalias !126
  %.357.i6831.i = icmp sgt i64 %.356.i6830.i, -1
  br i1 %.357.i6831.i, label %B130.i7197.i, label %B294.i6841.i

B396.endif.i5815.i:                               ; preds = %B34.if.i111.i6763.i
  %.957.i5836.i = load i64, ptr %.957.i.i, align 8, !noalias !126
  %.1069.i5908.i = inttoptr i64 %.957.i5836.i to ptr
  tail call void %.1069.i5908.i(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  %.1100.i5933.i = load i64, ptr %arg.code.4, align 8, !noalias !126
  %.1216.i6006.i = inttoptr i64 %.1100.i5933.i to ptr
  tail call void %.1216.i6006.i(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1216.i.i), !noalias !126
  br label %B34.if.i316.i6652.i

B34.if.i316.i6652.i:                              ; preds = %B396.endif.i5815.i, %B34.if.i316.i6652.i
  %.56.i149.i5230.08273.i = phi i64 [ %.127.i324.i6658.i, %B34.if.i316.i6652.i ], [ 0, %B396.endif.i5815.i ]
  %.127.i324.i6658.i = add nsw i64 %.56.i149.i5230.08273.i, 1
  %.153.i217.i6567.i = add nsw i64 %.56.i149.i5230.08273.i, %factor.op.mul8291.i.reass
  %.167.i227.i6575.i = icmp slt i64 %.153.i217.i6567.i, 0
  %.168.i228.i6576.i = select i1 %.167.i227.i6575.i, i64 %arg.batch.5.4.5.0, i64 0
  %239 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i217.i6567.i
  %.182.i241.i6586.i = getelementptr double, ptr %239, i64 %.168.i228.i6576.i
  %.183.i242.i6587.i = load double, ptr %.182.i241.i6586.i, align 8, !noalias !138
  %.185.i244.i6589.i = add nsw i64 %.56.i149.i5230.08273.i, %.898.i.i
  %.199.i254.i6597.i = icmp slt i64 %.185.i244.i6589.i, 0
  %.200.i255.i6598.i = select i1 %.199.i254.i6597.i, i64 %arg.batch.5.1.5.0, i64 0
  %240 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i244.i6589.i
  %.214.i268.i6608.i = getelementptr double, ptr %240, i64 %.200.i255.i6598.i
  %.215.i269.i6609.i = load double, ptr %.214.i268.i6608.i, align 8, !noalias !138
  store double %.183.i242.i6587.i, ptr %.214.i268.i6608.i, align 8, !noalias !138
  store double %.215.i269.i6609.i, ptr %.182.i241.i6586.i, align 8, !noalias !138
  %exitcond8404.not.i = icmp eq i64 %.194.i.i738.i, %.127.i324.i6658.i
  br i1 %exitcond8404.not.i, label %B396.endif.endif.i6109.i, label %B34.if.i316.i6652.i

B396.endif.endif.i6109.i.critedge:                ; preds = %B348.i5598.i
  %.957.i5836.i.c = load i64, ptr %.957.i.i, align 8, !noalias !126
  %.1069.i5908.i.c = inttoptr i64 %.957.i5836.i.c to ptr
  tail call void %.1069.i5908.i.c(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  %.1100.i5933.i.c = load i64, ptr %arg.code.4, align 8, !noalias !126
  %.1216.i6006.i.c = inttoptr i64 %.1100.i5933.i.c to ptr
  tail call void %.1216.i6006.i.c(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1216.i.i), !noalias !126
  br label %B396.endif.endif.i6109.i

B396.endif.endif.i6109.i:                         ; preds = %B34.if.i316.i6652.i, %B396.endif.endif.i6109.i.critedge
  %.1283.i6134.i = load i64, ptr %.957.i.i, align 8, !noalias !126
  %.1397.i6203.i = inttoptr i64 %.1283.i6134.i to ptr
  tail call void %.1397.i6203.i(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  br label %B964.if.i6545.i

B964.if.i6545.i:                                  ; preds = %B396.endif.endif.i6109.i, %B964.i6223.loopexit.i
  %.1431.i5476.08283.i = phi i64 [ %.1500.i6549.i, %B964.i6223.loopexit.i ], [ 0, %B396.endif.endif.i6109.i ]
  %.1500.i6549.i = add nsw i64 %.1431.i5476.08283.i, 1
  %.1581.i6265.i = getelementptr double, ptr %60, i64 %.1431.i5476.08283.i
  %.1582.i6266.i = load double, ptr %.1581.i6265.i, align 8, !noalias !126
  %.1583.i6267.i = fcmp ule double %.1582.i6266.i, 5.000000e-01
  %.1680.i62938279.not.i = select i1 %.1583.i6267.i, i1 true, i1 %.287.i2218170.not.i
  br i1 %.1680.i62938279.not.i, label %B964.i6223.loopexit.i, label %B1040.if.i6533.lr.ph.i

B1040.if.i6533.lr.ph.i:                           ; preds = %B964.if.i6545.i
  %gep8286.i = getelementptr double, ptr %55, i64 %.1431.i5476.08283.i
  %gep8288.i = getelementptr double, ptr %57, i64 %.1431.i5476.08283.i
  br label %B1040.if.i6533.i

B1040.if.i6533.i:                                 ; preds = %B1040.if.i6533.i, %B1040.if.i6533.lr.ph.i
  %.1624.i5487.08280.i = phi i64 [ 0, %B1040.if.i6533.lr.ph.i ], [ %.1693.i6537.i, %B1040.if.i6533.i ]
  %.1693.i6537.i = add nsw i64 %.1624.i5487.08280.i, 1
  %241 = mul nsw i64 %.1624.i5487.08280.i, %arg.shape.0
  %.1721.i6302.i = add nsw i64 %241, %.1431.i5476.08283.i
  %242 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1721.i6302.i
  %.1751.i6321.i = load double, ptr %242, align 8, !noalias !126
  %.1760.i6330.i = add nsw i64 %.1721.i6302.i, %factor.op.mul8197.i.reass
  %.1774.i6337.i = icmp slt i64 %.1760.i6330.i, 0
  %.1775.i6338.i = select i1 %.1774.i6337.i, i64 %arg.batch.5.0.5.0, i64 0
  %243 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1760.i6330.i
  %.1789.i.i = getelementptr double, ptr %243, i64 %.1775.i6338.i
  %.1790.i6349.i = load double, ptr %.1789.i.i, align 8, !noalias !126
  %.1795.i6354.i = add nsw i64 %.1721.i6302.i, %factor.op.mul8196.i.reass
  %.1809.i6361.i = icmp slt i64 %.1795.i6354.i, 0
  %.1810.i6362.i = select i1 %.1809.i6361.i, i64 %arg.batch.5.0.5.0, i64 0
  %244 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1795.i6354.i
  %.1824.i.i = getelementptr double, ptr %244, i64 %.1810.i6362.i
  %.1825.i6373.i = load double, ptr %.1824.i.i, align 8, !noalias !126
  %.1826.i6374.i = fsub double %.1790.i6349.i, %.1825.i6373.i
  %.1827.i6375.i = tail call double @llvm.fabs.f64(double %.1826.i6374.i)
  %.1882.i6411.i = load double, ptr %gep8286.i, align 8, !noalias !126
  %.1883.i6412.i = fmul double %.1882.i6411.i, %.1827.i6375.i
  %.1913.i6428.i = load double, ptr %.1913.i.i, align 8, !noalias !126
  %.1943.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !126
  %.1944.i6443.i = tail call double @llvm.fabs.f64(double %.1751.i6321.i)
  %.1945.i6444.i = fmul double %.1944.i6443.i, %.1943.i.i
  %.1946.i6445.i = fadd double %.1913.i6428.i, %.1945.i6444.i
  %.1950.i.i = fdiv double %.1883.i6412.i, %.1946.i6445.i
  %.1956.i6449.i = fsub double %.1950.i.i, %.1950.i.i
  %.1957.i6450.i = fcmp oeq double %.1956.i6449.i, 0.000000e+00
  %.1950.i..i = select i1 %.1957.i6450.i, double %.1950.i.i, double 0x7FF0000000000000
  %.2028.i6488.i = load double, ptr %gep8288.i, align 8, !noalias !126
  %.10.i.i6493.i = fcmp ogt double %.1950.i..i, %.2028.i6488.i
  %.11.i.i6494.i = select i1 %.10.i.i6493.i, double %.1950.i..i, double %.2028.i6488.i
  store double %.11.i.i6494.i, ptr %gep8288.i, align 8, !noalias !126
  %exitcond8405.not.i = icmp eq i64 %arg.shape.1, %.1693.i6537.i
  br i1 %exitcond8405.not.i, label %B964.i6223.loopexit.i, label %B1040.if.i6533.i

B854.i:                                           ; preds = %B658.endif.i, %B482.endif.endif.i
  br i1 %.190.i9448214.i, label %B92.i7522.i, label %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B92.i7522.i:                                      ; preds = %B854.i, %B855.i8085.i
  %.180.i7331.sroa.0.08320.i = phi i64 [ %.180.i7331.sroa.0.0.i, %B855.i8085.i ], [ 0, %B854.i ]
  %.134.i7328.18319.i = phi i64 [ %.134.i7328.1.i, %B855.i8085.i ], [ %.134.i7328.18315.i, %B854.i ]
  %.131.i7327.18318.i = phi i64 [ %.131.i7327.1.i, %B855.i8085.i ], [ 1, %B854.i ]
  %some.2.i7321.08316.i = phi i1 [ %some.3.i7339.1.i, %B855.i8085.i ], [ false, %B854.i ]
  %.261.i7550.i = icmp slt i64 %.180.i7331.sroa.0.08320.i, 0
  %.262.i7551.i = select i1 %.261.i7550.i, i64 %arg.batch.4.1.5.1, i64 0
  %245 = getelementptr i64, ptr %56, i64 %.180.i7331.sroa.0.08320.i
  %.284.i7572.i = getelementptr i64, ptr %245, i64 %.262.i7551.i
  %.285.i7573.i = load i64, ptr %.284.i7572.i, align 8, !noalias !142
  %.286.i7574.i = icmp slt i64 %.285.i7573.i, 0
  br i1 %.286.i7574.i, label %B855.i8085.i, label %B132.i7575.i

B132.i7575.i:                                     ; preds = %B92.i7522.i
  %.319.i7601.i = select i1 %.261.i7550.i, i64 %arg.batch.4.0.5.1, i64 0
  %.320.i7602.i = add i64 %.319.i7601.i, %.180.i7331.sroa.0.08320.i
  %.341.i7623.i = getelementptr double, ptr %57, i64 %.320.i7602.i
  %.342.i7624.i = load double, ptr %.341.i7623.i, align 8, !noalias !142
  %.343.i7625.i = fcmp ule double %.342.i7624.i, 1.000000e-01
  br i1 %.343.i7625.i, label %B855.i8085.i, label %B190.i7628.i

B190.i7628.i:                                     ; preds = %B132.i7575.i
  br i1 %.436.i10698201.not.i, label %B532.i7814.i.preheader, label %B220.if.i8456.i

B58.if.i.i8382.i:                                 ; preds = %B220.if.i8456.i, %B58.if.i.i8382.i
  %least.2.i.i7296.08305.i = phi double [ %.11.i.i.i8378.i, %B58.if.i.i8382.i ], [ 0x7FF0000000000000, %B220.if.i8456.i ]
  %.54.i.i7300.08303.i = phi i64 [ %.125.i.i8388.i, %B58.if.i.i8382.i ], [ 0, %B220.if.i8456.i ]
  %.125.i.i8388.i = add nsw i64 %.54.i.i7300.08303.i, 1
  %.156.i.i8294.i = add nsw i64 %.54.i.i7300.08303.i, %arg.shape.6
  %.158.i.i8296.i = mul nsw i64 %.156.i.i8294.i, %arg.shape.0
  %.160.i.i8298.i = add nsw i64 %.158.i.i8296.i, %.180.i7331.sroa.0.08320.i
  %.164.i.i8301.i = add nsw i64 %.54.i.i7300.08303.i, %.586.i.i
  %.166.i.i8303.i = mul nsw i64 %.164.i.i8301.i, %arg.shape.0
  %.168.i.i8305.i = add nsw i64 %.166.i.i8303.i, %.180.i7331.sroa.0.08320.i
  %.182.i.i8313.i = icmp slt i64 %.168.i.i8305.i, 0
  %.183.i.i8314.i = select i1 %.182.i.i8313.i, i64 %arg.batch.5.4.5.0, i64 0
  %246 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.168.i.i8305.i
  %.197.i.i8324.i = getelementptr double, ptr %246, i64 %.183.i.i8314.i
  %.198.i.i8325.i = load double, ptr %.197.i.i8324.i, align 8, !noalias !146
  %.212.i.i8333.i = icmp slt i64 %.160.i.i8298.i, 0
  %.213.i.i8334.i = select i1 %.212.i.i8333.i, i64 %arg.batch.5.4.5.0, i64 0
  %247 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i8298.i
  %.227.i.i8344.i = getelementptr double, ptr %247, i64 %.213.i.i8334.i
  %.228.i.i8345.i = load double, ptr %.227.i.i8344.i, align 8, !noalias !146
  %.229.i.i8346.i = fmul double %.198.i.i8325.i, %.228.i.i8345.i
  %.233.i.i8350.i = add nsw i64 %.160.i.i8298.i, %.194.i.i738.i
  %.247.i.i8358.i = icmp slt i64 %.233.i.i8350.i, 0
  %.248.i.i8359.i = select i1 %.247.i.i8358.i, i64 %arg.batch.5.4.5.0, i64 0
  %248 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i.i8350.i
  %.262.i.i8369.i = getelementptr double, ptr %248, i64 %.248.i.i8359.i
  %.263.i.i8370.i = load double, ptr %.262.i.i8369.i, align 8, !noalias !146
  %.264.i.i8371.i = fadd double %.229.i.i8346.i, %.263.i.i8370.i
  %.10.i.i.i8377.i = fcmp olt double %.264.i.i8371.i, %least.2.i.i7296.08305.i
  %.11.i.i.i8378.i = select i1 %.10.i.i.i8377.i, double %.264.i.i8371.i, double %least.2.i.i7296.08305.i
  %exitcond8408.not.i = icmp eq i64 %arg.shape.6, %.125.i.i8388.i
  br i1 %exitcond8408.not.i, label %B532.i7814.i.preheader, label %B58.if.i.i8382.i

B532.i7814.i.preheader:                           ; preds = %B58.if.i.i8382.i, %B190.i7628.i
  %here.4.i7373.2.i.ph = phi double [ 0x7FF0000000000000, %B190.i7628.i ], [ %.11.i.i.i8378.i, %B58.if.i.i8382.i ]
  br label %B532.i7814.i

B532.i7814.i:                                     ; preds = %B532.i7814.i.preheader, %B646.i7833.i
  %here.4.i7373.2.i = phi double [ %here.3.i7377.3.i, %B646.i7833.i ], [ %here.4.i7373.2.i.ph, %B532.i7814.i.preheader ]
  %ahead.3.i7372.2.i = phi double [ %ahead.2.i7376.3.i, %B646.i7833.i ], [ 0.000000e+00, %B532.i7814.i.preheader ]
  %low.2.i7371.2.i = phi double [ %low.3.i7375.3.i, %B646.i7833.i ], [ 0.000000e+00, %B532.i7814.i.preheader ]
  %look.2.i7370.2.i = phi i64 [ %.989.i7844.i, %B646.i7833.i ], [ 1, %B532.i7814.i.preheader ]
  %249 = icmp ult i64 %look.2.i7370.2.i, 9
  br i1 %249, label %switch.lookup9481, label %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B58.if.i183.i.i:                                  ; preds = %B58.if.i183.i.lr.ph.i, %B58.if.i183.i.i
  %least.2.i16.i7273.08310.i = phi double [ 0x7FF0000000000000, %B58.if.i183.i.lr.ph.i ], [ %.11.i.i179.i.i, %B58.if.i183.i.i ]
  %.54.i20.i7277.08308.i = phi i64 [ 0, %B58.if.i183.i.lr.ph.i ], [ %.125.i189.i.i, %B58.if.i183.i.i ]
  %.125.i189.i.i = add nsw i64 %.54.i20.i7277.08308.i, 1
  %.156.i95.i.i = add nsw i64 %.54.i20.i7277.08308.i, %.155.i.i8268.i
  %.158.i97.i.i = mul nsw i64 %.156.i95.i.i, %arg.shape.0
  %.160.i99.i.i = add nsw i64 %.158.i97.i.i, %.180.i7331.sroa.0.08320.i
  %.164.i102.i.i = add nsw i64 %.54.i20.i7277.08308.i, %.586.i.i
  %.166.i104.i.i = mul nsw i64 %.164.i102.i.i, %arg.shape.0
  %.168.i106.i.i = add nsw i64 %.166.i104.i.i, %.180.i7331.sroa.0.08320.i
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
  %.233.i151.i.i = add nsw i64 %.160.i99.i.i, %.194.i.i738.i
  %.247.i159.i.i = icmp slt i64 %.233.i151.i.i, 0
  %.248.i160.i.i = select i1 %.247.i159.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %252 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.233.i151.i.i
  %.262.i170.i.i = getelementptr double, ptr %252, i64 %.248.i160.i.i
  %.263.i171.i.i = load double, ptr %.262.i170.i.i, align 8, !noalias !150
  %.264.i172.i.i = fadd double %.229.i147.i.i, %.263.i171.i.i
  %.10.i.i178.i.i = fcmp olt double %.264.i172.i.i, %least.2.i16.i7273.08310.i
  %.11.i.i179.i.i = select i1 %.10.i.i178.i.i, double %.264.i172.i.i, double %least.2.i16.i7273.08310.i
  %exitcond8409.not.i = icmp eq i64 %arg.shape.6, %.125.i189.i.i
  br i1 %exitcond8409.not.i, label %B566.endif.i8226.i, label %B58.if.i183.i.i

B616.i8232.i:                                     ; preds = %B566.endif.i8226.i
  switch i64 %look.2.i7370.2.i, label %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i [
    i64 0, label %B646.i7833.i
    i64 6, label %switch.6.1.i8244.i
    i64 1, label %switch.1.1.i8249.i
    i64 8, label %switch.8.1.i8236.i
    i64 2, label %switch.2.1.i8248.i
    i64 5, label %switch.5.1.i8245.i
    i64 3, label %switch.3.1.i8247.i
    i64 7, label %switch.7.1.i8243.i
    i64 4, label %switch.4.1.i8246.i
  ]

B646.i7833.i:                                     ; preds = %switch.8.1.i8236.i, %switch.7.1.i8243.i, %switch.6.1.i8244.i, %switch.5.1.i8245.i, %switch.4.1.i8246.i, %switch.3.1.i8247.i, %switch.2.1.i8248.i, %switch.1.1.i8249.i, %B566.endif.i8226.i, %switch.lookup9481, %B616.i8232.i
  %here.3.i7377.3.i = phi double [ %here.4.i7373.2.i, %switch.lookup9481 ], [ %here.4.i7373.2.i, %B566.endif.i8226.i ], [ %least.2.i16.i7273.0.lcssa.i, %B616.i8232.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.8.1.i8236.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.7.1.i8243.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.6.1.i8244.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.5.1.i8245.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.4.1.i8246.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.3.1.i8247.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.2.1.i8248.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.1.1.i8249.i ]
  %ahead.2.i7376.3.i = phi double [ %ahead.3.i7372.2.i, %switch.lookup9481 ], [ %least.2.i16.i7273.0.lcssa.i, %B566.endif.i8226.i ], [ %least.2.i16.i7273.0.lcssa.i, %B616.i8232.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.8.1.i8236.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.7.1.i8243.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.6.1.i8244.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.5.1.i8245.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.4.1.i8246.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.3.1.i8247.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.2.1.i8248.i ], [ %least.2.i16.i7273.0.lcssa.i, %switch.1.1.i8249.i ]
  %low.3.i7375.3.i = phi double [ %low.2.i7371.2.i, %switch.lookup9481 ], [ %low.2.i7371.2.i, %B566.endif.i8226.i ], [ 0.000000e+00, %B616.i8232.i ], [ 1.000000e+00, %switch.8.1.i8236.i ], [ 8.889000e-01, %switch.7.1.i8243.i ], [ 7.500000e-01, %switch.6.1.i8244.i ], [ 0x3FE50A3D70A3D70A, %switch.5.1.i8245.i ], [ 5.000000e-01, %switch.4.1.i8246.i ], [ 3.333000e-01, %switch.3.1.i8247.i ], [ 2.500000e-01, %switch.2.1.i8248.i ], [ 0x3FB48E8A71DE69AD, %switch.1.1.i8249.i ]
  %.999.i7850.i = icmp eq i64 %look.2.i7370.2.i, 8
  %.989.i7844.i = add nsw i64 %look.2.i7370.2.i, 1
  %.1032.i8127.i = fcmp ult double %ahead.2.i7376.3.i, 0.000000e+00
  %or.cond7998.i = select i1 %.999.i7850.i, i1 true, i1 %.1032.i8127.i
  br i1 %or.cond7998.i, label %B690.i7851.i, label %B532.i7814.i

B690.i7851.i:                                     ; preds = %B646.i7833.i
  br i1 %.1032.i8127.i, label %switch.lookup9484, label %B738.i7873.i

switch.lookup9484:                                ; preds = %B690.i7851.i
  %switch.gep9485 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i7370.2.i
  %switch.load9486 = load double, ptr %switch.gep9485, align 8
  br label %B738.i7873.i

B738.i7873.i:                                     ; preds = %switch.lookup9484, %B690.i7851.i
  %"$phi738.2.2.i7383.2.i" = phi double [ %low.3.i7375.3.i, %B690.i7851.i ], [ %switch.load9486, %switch.lookup9484 ]
  %.1170.i7921.i = getelementptr double, ptr %58, i64 %.320.i7602.i
  store double %low.3.i7375.3.i, ptr %.1170.i7921.i, align 8, !noalias !142
  %.1228.i7970.i = getelementptr double, ptr %59, i64 %.320.i7602.i
  store double %"$phi738.2.2.i7383.2.i", ptr %.1228.i7970.i, align 8, !noalias !142
  %.1286.i8019.i = getelementptr double, ptr %61, i64 %.320.i7602.i
  store double %here.3.i7377.3.i, ptr %.1286.i8019.i, align 8, !noalias !142
  %.1346.i8070.i = getelementptr double, ptr %62, i64 %.320.i7602.i
  store double %ahead.2.i7376.3.i, ptr %.1346.i8070.i, align 8, !noalias !142
  %.1357.i8077.i = fcmp olt double %ahead.2.i7376.3.i, 0.000000e+00
  %spec.select7999.i = select i1 %some.2.i7321.08316.i, i1 true, i1 %.1357.i8077.i
  br label %B855.i8085.i

B854.i7509.loopexit.i:                            ; preds = %B855.i8085.i
  %253 = xor i1 %some.3.i7339.1.i, true
  br label %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B855.i8085.i:                                     ; preds = %B738.i7873.i, %B132.i7575.i, %B92.i7522.i
  %some.3.i7339.1.i = phi i1 [ %spec.select7999.i, %B738.i7873.i ], [ %some.2.i7321.08316.i, %B132.i7575.i ], [ %some.2.i7321.08316.i, %B92.i7522.i ]
  %.190.i7500.i = icmp sgt i64 %.134.i7328.18319.i, 0
  %.203.i8486.i = zext i1 %.190.i7500.i to i64
  %.131.i7327.1.i = add i64 %.131.i7327.18318.i, %.203.i8486.i
  %.199.i8483.i = sext i1 %.190.i7500.i to i64
  %.134.i7328.1.i = add nsw i64 %.134.i7328.18319.i, %.199.i8483.i
  %.180.i7331.sroa.0.0.i = select i1 %.190.i7500.i, i64 %.131.i7327.18318.i, i64 0
  br i1 %.190.i7500.i, label %B92.i7522.i, label %B854.i7509.loopexit.i

B220.if.i8456.i:                                  ; preds = %B190.i7628.i, %B220.if.i8456.i
  %.380.i7343.08300.i = phi i64 [ %.449.i8463.i, %B220.if.i8456.i ], [ 0, %B190.i7628.i ]
  %.449.i8463.i = add nsw i64 %.380.i7343.08300.i, 1
  %.587.i8423.i = add nsw i64 %.380.i7343.08300.i, %.586.i.i
  %.591.i8426.i = mul nsw i64 %.587.i8423.i, %arg.shape.0
  %.593.i8428.i = add nsw i64 %.591.i8426.i, %.180.i7331.sroa.0.08320.i
  %.608.i8438.i = icmp slt i64 %.593.i8428.i, 0
  %.609.i8439.i = select i1 %.608.i8438.i, i64 %arg.batch.5.4.5.0, i64 0
  %254 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.593.i8428.i
  %.623.i8452.i = getelementptr double, ptr %254, i64 %.609.i8439.i
  store double 1.000000e+00, ptr %.623.i8452.i, align 8, !noalias !142
  %exitcond8407.not.i = icmp eq i64 %arg.shape.6, %.449.i8463.i
  br i1 %exitcond8407.not.i, label %B58.if.i.i8382.i, label %B220.if.i8456.i

switch.lookup9481:                                ; preds = %B532.i7814.i
  %switch.gep9482 = getelementptr inbounds double, ptr @switch.table.advance_of_many.3, i64 %look.2.i7370.2.i
  %switch.load9483 = load double, ptr %switch.gep9482, align 8
  %.874.i7832.i = fcmp ogt double %switch.load9483, %low.2.i7371.2.i
  br i1 %.874.i7832.i, label %B58.i66.i8193.preheader.i, label %B646.i7833.i

B58.i66.i8193.preheader.i:                        ; preds = %switch.lookup9481
  br i1 %.436.i10698201.not.i, label %B566.endif.i8226.i, label %B58.if.i183.i.lr.ph.i

B58.if.i183.i.lr.ph.i:                            ; preds = %B58.i66.i8193.preheader.i
  %.151.i.i8266.i = mul nsw i64 %look.2.i7370.2.i, 3
  %.153.i.i82677896.i = add nsw i64 %.151.i.i8266.i, 1
  %.155.i.i8268.i = mul i64 %.153.i.i82677896.i, %arg.shape.6
  br label %B58.if.i183.i.i

B566.endif.i8226.i:                               ; preds = %B58.if.i183.i.i, %B58.i66.i8193.preheader.i
  %least.2.i16.i7273.0.lcssa.i = phi double [ 0x7FF0000000000000, %B58.i66.i8193.preheader.i ], [ %.11.i.i179.i.i, %B58.if.i183.i.i ]
  %.925.i8231.i = fcmp ult double %least.2.i16.i7273.0.lcssa.i, 0.000000e+00
  br i1 %.925.i8231.i, label %B646.i7833.i, label %B616.i8232.i

switch.1.1.i8249.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.2.1.i8248.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.3.1.i8247.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.4.1.i8246.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.5.1.i8245.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.6.1.i8244.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.7.1.i8243.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

switch.8.1.i8236.i:                               ; preds = %B616.i8232.i
  br label %B646.i7833.i

_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B616.i8232.i, %B532.i7814.i, %B854.i7509.loopexit.i, %B854.i
  %.190.i75008149.i = phi i1 [ false, %B854.i7509.loopexit.i ], [ false, %B854.i ], [ true, %B532.i7814.i ], [ true, %B616.i8232.i ]
  %.1588.0.i = phi i1 [ %253, %B854.i7509.loopexit.i ], [ true, %B854.i ], [ true, %B532.i7814.i ], [ true, %B616.i8232.i ]
  %excinfo.7.6.i = phi ptr [ null, %B854.i7509.loopexit.i ], [ null, %B854.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53, %B532.i7814.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.53, %B616.i8232.i ]
  %.16128497.i = phi i32 [ 0, %B854.i7509.loopexit.i ], [ 0, %B854.i ], [ 1, %B532.i7814.i ], [ 1, %B616.i8232.i ]
  br i1 %.190.i75008149.i, label %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B854.endif.endif.i, !prof !93

B114.i3167.loopexit.i:                            ; preds = %B769.i3523.i
  %.219.i3172.i = icmp ne i64 %.163.i3048.18351.i, 0
  %255 = sub nsw i64 45, %.160.i3047.18350.i
  %.232.i5211.i = zext i1 %.219.i3172.i to i64
  %.160.i3047.1.i = add i64 %.160.i3047.18350.i, %.232.i5211.i
  %.228.i5208.i = sext i1 %.219.i3172.i to i64
  %.163.i3048.1.i = add nsw i64 %.163.i3048.18351.i, %.228.i5208.i
  %.209.i3051.sroa.0.0.i = select i1 %.219.i3172.i, i64 %255, i64 45
  br i1 %.219.i3172.i, label %B154.i3233.preheader.i, label %B946.i

B154.i3233.preheader.i:                           ; preds = %B154.i3233.preheader.i.preheader, %B114.i3167.loopexit.i
  %.209.i3051.sroa.0.08352.i = phi i64 [ %.209.i3051.sroa.0.0.i, %B114.i3167.loopexit.i ], [ 45, %B154.i3233.preheader.i.preheader ]
  %.163.i3048.18351.i = phi i64 [ %.163.i3048.1.i, %B114.i3167.loopexit.i ], [ 44, %B154.i3233.preheader.i.preheader ]
  %.160.i3047.18350.i = phi i64 [ %.160.i3047.1.i, %B114.i3167.loopexit.i ], [ 1, %B154.i3233.preheader.i.preheader ]
  %.108.not.i8040.i = icmp eq i64 %.209.i3051.sroa.0.08352.i, 0
  br label %B154.if.i5186.i

B154.i3233.loopexit.i:                            ; preds = %B122.if.i.i5141.i, %B230.endif.i4679.i
  %exitcond8412.not.i = icmp eq i64 %arg.shape.0, %.356.i5194.i
  br i1 %exitcond8412.not.i, label %B306.i3247.i, label %B154.if.i5186.i

B162.i4283.i:                                     ; preds = %B154.if.i5186.i
  %.445.i4330.i = getelementptr double, ptr %59, i64 %.287.i3061.08330.i
  %.446.i4331.i = load double, ptr %.445.i4330.i, align 8, !noalias !154
  %.500.i4377.i = getelementptr double, ptr %58, i64 %.287.i3061.08330.i
  %.501.i4378.i = load double, ptr %.500.i4377.i, align 8, !noalias !154
  %.502.i4379.i = fsub double %.446.i4331.i, %.501.i4378.i
  %.504.i4381.i = fcmp ogt double %.502.i4379.i, 1.000000e-13
  br label %B230.i4383.i

B230.i4383.i:                                     ; preds = %B154.if.i5186.i, %B162.i4283.i
  %"$phi230.2.2.i3070.2.i" = phi i1 [ true, %B154.if.i5186.i ], [ %.504.i4381.i, %B162.i4283.i ]
  %.71.i.i4449.i = getelementptr double, ptr %58, i64 %.287.i3061.08330.i
  %.72.i.i4450.i = load double, ptr %.71.i.i4449.i, align 8, !noalias !158
  %.124.i.i4485.i = getelementptr double, ptr %59, i64 %.287.i3061.08330.i
  %.125.i.i4486.i = load double, ptr %.124.i.i4485.i, align 8, !noalias !158
  %.177.i.i4521.i = getelementptr double, ptr %61, i64 %.287.i3061.08330.i
  %.178.i.i4522.i = load double, ptr %.177.i.i4521.i, align 8, !noalias !158
  %.230.i.i4557.i = getelementptr double, ptr %62, i64 %.287.i3061.08330.i
  %.231.i.i4558.i = load double, ptr %.230.i.i4557.i, align 8, !noalias !158
  %.248.i.i4567.i = fadd double %.72.i.i4450.i, %.125.i.i4486.i
  %.249.i.i4568.i = fmul double %.248.i.i4567.i, 5.000000e-01
  br i1 %.108.not.i8040.i, label %B0.endif.i.i4582.i, label %B282.i8041.i

B282.i8041.i:                                     ; preds = %B230.i4383.i, %B282.i8041.i
  %r.2.0.i8042.i = phi double [ %r.3.1.i8048.i, %B282.i8041.i ], [ 1.000000e+00, %B230.i4383.i ]
  %a.1.2.0.i8043.i = phi double [ %.147.i8050.i, %B282.i8041.i ], [ 2.000000e+00, %B230.i4383.i ]
  %exp.4.0.i8044.i = phi i64 [ %.142.i8049.i, %B282.i8041.i ], [ %.209.i3051.sroa.0.08352.i, %B230.i4383.i ]
  %.122.i8045.i = and i64 %exp.4.0.i8044.i, 1
  %.123.not.i8046.i = icmp eq i64 %.122.i8045.i, 0
  %.127.i8047.i = fmul double %r.2.0.i8042.i, %a.1.2.0.i8043.i
  %r.3.1.i8048.i = select i1 %.123.not.i8046.i, double %r.2.0.i8042.i, double %.127.i8047.i
  %.142.i8049.i = lshr i64 %exp.4.0.i8044.i, 1
  %.147.i8050.i = fmul double %a.1.2.0.i8043.i, %a.1.2.0.i8043.i
  %.150.not.i8051.i = icmp eq i64 %.142.i8049.i, 0
  br i1 %.150.not.i8051.i, label %B334.i8052.loopexit.i, label %B282.i8041.i

B334.i8052.loopexit.i:                            ; preds = %B282.i8041.i
  %256 = fmul double %r.3.1.i8048.i, 1.000000e-13
  br label %B0.endif.i.i4582.i

B460.i.i4649.i:                                   ; preds = %B0.endif.i.i4582.i
  %.10.i3.i.i4656.i = fcmp olt double %.285.i.i4588.i, 0.000000e+00
  %.11.i4.i.i4657.i = select i1 %.10.i3.i.i4656.i, double 0.000000e+00, double %.285.i.i4588.i
  %.444.i.i4662.i = fmul double %.340.i.i4617.i, %.11.i4.i.i4657.i
  %.448.i.i4665.i = fsub double %.249.i.i4568.i, %.444.i.i4662.i
  br label %B230.endif.i4679.i

B0.endif.i.i4582.i:                               ; preds = %B334.i8052.loopexit.i, %B230.i4383.i
  %r.4.1.i8053.i = phi double [ 1.000000e-13, %B230.i4383.i ], [ %256, %B334.i8052.loopexit.i ]
  %.283.i.i4586.i = fsub double %.125.i.i4486.i, %.72.i.i4450.i
  %.284.i.i4587.i = fsub double %r.4.1.i8053.i, %.283.i.i4586.i
  %.285.i.i4588.i = fmul double %.284.i.i4587.i, 5.000000e-01
  %.290.i.i4591.i = fmul double %.72.i.i4450.i, %.231.i.i4558.i
  %.292.i.i4593.i = fmul double %.125.i.i4486.i, %.178.i.i4522.i
  %.293.i.i4594.i = fsub double %.290.i.i4591.i, %.292.i.i4593.i
  %.294.i.i4595.i = fsub double %.231.i.i4558.i, %.178.i.i4522.i
  %.298.i.i4598.i = fdiv double %.293.i.i4594.i, %.294.i.i4595.i
  %.304.i.i4602.i = fcmp olt double %.72.i.i4450.i, %.298.i.i4598.i
  %.312.i.i5172.i = fcmp olt double %.298.i.i4598.i, %.125.i.i4486.i
  %or.cond8002.i = select i1 %.304.i.i4602.i, i1 %.312.i.i5172.i, i1 false
  %"$phi268.0.2.i.i2949.0.i" = select i1 %or.cond8002.i, double %.298.i.i4598.i, double %.249.i.i4568.i
  %.339.i.i4616.i = fsub double %.249.i.i4568.i, %"$phi268.0.2.i.i2949.0.i"
  %.340.i.i4617.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.339.i.i4616.i)
  %.354.i.i4627.i = fmul double %.283.i.i4586.i, %.283.i.i4586.i
  %.357.i.i4630.i = tail call double @llvm.fabs.f64(double %.339.i.i4616.i)
  %.10.i.i.i4635.i = fcmp olt double %.357.i.i4630.i, %.354.i.i4627.i
  %.11.i.i.i4636.i = select i1 %.10.i.i.i4635.i, double %.357.i.i4630.i, double %.354.i.i4627.i
  %.387.i.i4640.i = fmul double %.340.i.i4617.i, %.11.i.i.i4636.i
  %.388.i.i4641.i = fadd double %"$phi268.0.2.i.i2949.0.i", %.387.i.i4640.i
  %.394.i.i4645.i = fsub double %.388.i.i4641.i, %.249.i.i4568.i
  %.395.i.i4646.i = tail call double @llvm.fabs.f64(double %.394.i.i4645.i)
  %.397.i.i4648.i = fcmp ugt double %.395.i.i4646.i, %.285.i.i4588.i
  br i1 %.397.i.i4648.i, label %B460.i.i4649.i, label %B230.endif.i4679.i

B306.i3247.i:                                     ; preds = %B154.i3233.loopexit.i
  br i1 %"$phi230.2.2.i3070.2.i", label %B316.i3266.i, label %B946.i

B316.i3266.i:                                     ; preds = %B306.i3247.i
  %.655.i3294.i = load i64, ptr %.654.i1934.i, align 8, !noalias !154
  %.771.i3370.i = inttoptr i64 %.655.i3294.i to ptr
  tail call void %.771.i3370.i(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1498.i), !noalias !154
  br label %B490.if.i4258.i

B564.i3524.i:                                     ; preds = %B490.if.i4258.i
  %.177.i139.i3658.i = getelementptr double, ptr %61, i64 %.797.i3089.08342.i
  %.178.i140.i3659.i = load double, ptr %.177.i139.i3658.i, align 8, !noalias !162
  %.230.i175.i3694.i = getelementptr double, ptr %62, i64 %.797.i3089.08342.i
  %.231.i176.i3695.i = load double, ptr %.230.i175.i3694.i, align 8, !noalias !162
  %.248.i185.i3704.i = fadd double %.948.i3470.i, %.1003.i3517.i
  %.249.i186.i3705.i = fmul double %.248.i185.i3704.i, 5.000000e-01
  br i1 %.108.not.i8040.i, label %B0.endif.i200.i3719.i, label %B282.i8070.i

B282.i8070.i:                                     ; preds = %B564.i3524.i, %B282.i8070.i
  %r.2.0.i8071.i = phi double [ %r.3.1.i8077.i, %B282.i8070.i ], [ 1.000000e+00, %B564.i3524.i ]
  %a.1.2.0.i8072.i = phi double [ %.147.i8079.i, %B282.i8070.i ], [ 2.000000e+00, %B564.i3524.i ]
  %exp.4.0.i8073.i = phi i64 [ %.142.i8078.i, %B282.i8070.i ], [ %.209.i3051.sroa.0.08352.i, %B564.i3524.i ]
  %.122.i8074.i = and i64 %exp.4.0.i8073.i, 1
  %.123.not.i8075.i = icmp eq i64 %.122.i8074.i, 0
  %.127.i8076.i = fmul double %r.2.0.i8071.i, %a.1.2.0.i8072.i
  %r.3.1.i8077.i = select i1 %.123.not.i8075.i, double %r.2.0.i8071.i, double %.127.i8076.i
  %.142.i8078.i = lshr i64 %exp.4.0.i8073.i, 1
  %.147.i8079.i = fmul double %a.1.2.0.i8072.i, %a.1.2.0.i8072.i
  %.150.not.i8080.i = icmp eq i64 %.142.i8078.i, 0
  br i1 %.150.not.i8080.i, label %B334.i8081.loopexit.i, label %B282.i8070.i

B334.i8081.loopexit.i:                            ; preds = %B282.i8070.i
  %257 = fmul double %r.3.1.i8077.i, 1.000000e-13
  br label %B0.endif.i200.i3719.i

B460.i267.i3786.i:                                ; preds = %B0.endif.i200.i3719.i
  %.10.i3.i274.i3793.i = fcmp olt double %.285.i206.i3725.i, 0.000000e+00
  %.11.i4.i275.i3794.i = select i1 %.10.i3.i274.i3793.i, double 0.000000e+00, double %.285.i206.i3725.i
  %.444.i280.i3799.i = fmul double %.340.i235.i3754.i, %.11.i4.i275.i3794.i
  %.448.i283.i3802.i = fsub double %.249.i186.i3705.i, %.444.i280.i3799.i
  br label %B564.endif.i3816.i

B0.endif.i200.i3719.i:                            ; preds = %B334.i8081.loopexit.i, %B564.i3524.i
  %r.4.1.i8082.i = phi double [ 1.000000e-13, %B564.i3524.i ], [ %257, %B334.i8081.loopexit.i ]
  %.284.i205.i3724.i = fsub double %r.4.1.i8082.i, %.1004.i3518.i
  %.285.i206.i3725.i = fmul double %.284.i205.i3724.i, 5.000000e-01
  %.290.i209.i3728.i = fmul double %.1003.i3517.i, %.231.i176.i3695.i
  %.292.i211.i3730.i = fmul double %.948.i3470.i, %.178.i140.i3659.i
  %.293.i212.i3731.i = fsub double %.290.i209.i3728.i, %.292.i211.i3730.i
  %.294.i213.i3732.i = fsub double %.231.i176.i3695.i, %.178.i140.i3659.i
  %.298.i216.i3735.i = fdiv double %.293.i212.i3731.i, %.294.i213.i3732.i
  %.304.i220.i3739.i = fcmp olt double %.1003.i3517.i, %.298.i216.i3735.i
  %.312.i294.i4244.i = fcmp olt double %.298.i216.i3735.i, %.948.i3470.i
  %or.cond8003.i = and i1 %.304.i220.i3739.i, %.312.i294.i4244.i
  %"$phi268.0.2.i26.i2929.0.i" = select i1 %or.cond8003.i, double %.298.i216.i3735.i, double %.249.i186.i3705.i
  %.339.i234.i3753.i = fsub double %.249.i186.i3705.i, %"$phi268.0.2.i26.i2929.0.i"
  %.340.i235.i3754.i = tail call double @llvm.copysign.f64(double 1.000000e+00, double %.339.i234.i3753.i)
  %.354.i245.i3764.i = fmul double %.1004.i3518.i, %.1004.i3518.i
  %.357.i248.i3767.i = tail call double @llvm.fabs.f64(double %.339.i234.i3753.i)
  %.10.i.i253.i3772.i = fcmp olt double %.357.i248.i3767.i, %.354.i245.i3764.i
  %.11.i.i254.i3773.i = select i1 %.10.i.i253.i3772.i, double %.357.i248.i3767.i, double %.354.i245.i3764.i
  %.387.i258.i3777.i = fmul double %.340.i235.i3754.i, %.11.i.i254.i3773.i
  %.388.i259.i3778.i = fadd double %"$phi268.0.2.i26.i2929.0.i", %.387.i258.i3777.i
  %.394.i263.i3782.i = fsub double %.388.i259.i3778.i, %.249.i186.i3705.i
  %.395.i264.i3783.i = tail call double @llvm.fabs.f64(double %.394.i263.i3782.i)
  %.397.i266.i3785.i = fcmp ugt double %.395.i264.i3783.i, %.285.i206.i3725.i
  br i1 %.397.i266.i3785.i, label %B460.i267.i3786.i, label %B564.endif.i3816.i

B660.i4011.i:                                     ; preds = %B564.endif.endif.i3907.i
  store double %.1013.i3100.0.i, ptr %.947.i3469.i, align 8, !noalias !154
  store double %least.2.i.i2848.0.lcssa.i, ptr %.230.i175.i3694.i, align 8, !noalias !154
  br label %B769.i3523.i

B712.i3911.i:                                     ; preds = %B564.endif.endif.i3907.i
  store double %.1013.i3100.0.i, ptr %.1002.i3516.i, align 8, !noalias !154
  store double %least.2.i.i2848.0.lcssa.i, ptr %.177.i139.i3658.i, align 8, !noalias !154
  br label %B769.i3523.i

B769.i3523.i:                                     ; preds = %B490.if.i4258.i, %B712.i3911.i, %B660.i4011.i
  %exitcond8414.not.i = icmp eq i64 %arg.shape.0, %.866.i4265.i
  br i1 %exitcond8414.not.i, label %B114.i3167.loopexit.i, label %B490.if.i4258.i

B154.if.i5186.i:                                  ; preds = %B154.i3233.loopexit.i, %B154.i3233.preheader.i
  %wide.2.i3057.18332.i = phi i1 [ false, %B154.i3233.preheader.i ], [ %"$phi230.2.2.i3070.2.i", %B154.i3233.loopexit.i ]
  %.287.i3061.08330.i = phi i64 [ 0, %B154.i3233.preheader.i ], [ %.356.i5194.i, %B154.i3233.loopexit.i ]
  %.356.i5194.i = add nsw i64 %.287.i3061.08330.i, 1
  br i1 %wide.2.i3057.18332.i, label %B230.i4383.i, label %B162.i4283.i

B230.endif.i4679.i:                               ; preds = %B0.endif.i.i4582.i, %B460.i.i4649.i
  %.519.i3073.0.i = phi double [ %.388.i.i4641.i, %B0.endif.i.i4582.i ], [ %.448.i.i4665.i, %B460.i.i4649.i ]
  %.92.i.i4760.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.287.i3061.08330.i
  %.93.i.i4761.i = load double, ptr %.92.i.i4760.i, align 8, !noalias !166
  %.146.i.i4797.i = getelementptr double, ptr %55, i64 %.287.i3061.08330.i
  %.147.i394.i4798.i = load double, ptr %.146.i.i4797.i, align 8, !noalias !166
  %.149.i396.i4800.i = fmul double %.519.i3073.0.i, %.147.i394.i4798.i
  %.150.i397.i4801.i = fadd double %.93.i.i4761.i, %.149.i396.i4800.i
  %.203.i428.i4837.i = getelementptr double, ptr %.571, i64 %.287.i3061.08330.i
  store double %.150.i397.i4801.i, ptr %.203.i428.i4837.i, align 8, !noalias !166
  br i1 %.287.i2218170.not.i, label %B154.i3233.loopexit.i, label %B122.if.i.i5141.lr.ph.i

B122.if.i.i5141.lr.ph.i:                          ; preds = %B230.endif.i4679.i
  %.247.i.i.i5111.i = fsub double 1.000000e+00, %.519.i3073.0.i
  %invariant.gep9347 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9349 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9351 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9353 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9355 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9357 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9359 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9361 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  %invariant.gep9363 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.287.i3061.08330.i
  br label %B122.if.i.i5141.i

B122.if.i.i5141.i:                                ; preds = %B122.if.i.i5141.i, %B122.if.i.i5141.lr.ph.i
  %.229.i325.i2904.08327.i = phi i64 [ 0, %B122.if.i.i5141.lr.ph.i ], [ %.300.i497.i5147.i, %B122.if.i.i5141.i ]
  %.157.i.i.i5068.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.i
  %.159.i.i.i5070.i = mul nsw i64 %.157.i.i.i5068.i, %arg.shape.0
  %gep9348 = getelementptr double, ptr %invariant.gep9347, i64 %.159.i.i.i5070.i
  %.191.i.i.i5092.i = load double, ptr %gep9348, align 8, !noalias !170
  %.193.i.i.i5094.i = fadd double %.191.i.i.i5092.i, 0.000000e+00
  %.253.i.i.i5116.i = fmul double %.519.i3073.0.i, %.193.i.i.i5094.i
  %.157.i.i.i5068.1.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.1.i
  %.159.i.i.i5070.1.i = mul nsw i64 %.157.i.i.i5068.1.i, %arg.shape.0
  %gep9350 = getelementptr double, ptr %invariant.gep9349, i64 %.159.i.i.i5070.1.i
  %.191.i.i.i5092.1.i = load double, ptr %gep9350, align 8, !noalias !170
  %.193.i.i.i5094.1.i = fadd double %.191.i.i.i5092.1.i, %.253.i.i.i5116.i
  %.253.i.i.i5116.1.i = fmul double %.247.i.i.i5111.i, %.193.i.i.i5094.1.i
  %.157.i.i.i5068.2.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.2.i
  %.159.i.i.i5070.2.i = mul nsw i64 %.157.i.i.i5068.2.i, %arg.shape.0
  %gep9352 = getelementptr double, ptr %invariant.gep9351, i64 %.159.i.i.i5070.2.i
  %.191.i.i.i5092.2.i = load double, ptr %gep9352, align 8, !noalias !170
  %.193.i.i.i5094.2.i = fadd double %.191.i.i.i5092.2.i, %.253.i.i.i5116.1.i
  %.253.i.i.i5116.2.i = fmul double %.519.i3073.0.i, %.193.i.i.i5094.2.i
  %.157.i.i.i5068.3.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.3.i
  %.159.i.i.i5070.3.i = mul nsw i64 %.157.i.i.i5068.3.i, %arg.shape.0
  %gep9354 = getelementptr double, ptr %invariant.gep9353, i64 %.159.i.i.i5070.3.i
  %.191.i.i.i5092.3.i = load double, ptr %gep9354, align 8, !noalias !170
  %.193.i.i.i5094.3.i = fadd double %.191.i.i.i5092.3.i, %.253.i.i.i5116.2.i
  %.253.i.i.i5116.3.i = fmul double %.247.i.i.i5111.i, %.193.i.i.i5094.3.i
  %.157.i.i.i5068.4.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.4.i
  %.159.i.i.i5070.4.i = mul nsw i64 %.157.i.i.i5068.4.i, %arg.shape.0
  %gep9356 = getelementptr double, ptr %invariant.gep9355, i64 %.159.i.i.i5070.4.i
  %.191.i.i.i5092.4.i = load double, ptr %gep9356, align 8, !noalias !170
  %.193.i.i.i5094.4.i = fadd double %.191.i.i.i5092.4.i, %.253.i.i.i5116.3.i
  %.253.i.i.i5116.4.i = fmul double %.519.i3073.0.i, %.193.i.i.i5094.4.i
  %.157.i.i.i5068.5.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.5.i
  %.159.i.i.i5070.5.i = mul nsw i64 %.157.i.i.i5068.5.i, %arg.shape.0
  %gep9358 = getelementptr double, ptr %invariant.gep9357, i64 %.159.i.i.i5070.5.i
  %.191.i.i.i5092.5.i = load double, ptr %gep9358, align 8, !noalias !170
  %.193.i.i.i5094.5.i = fadd double %.191.i.i.i5092.5.i, %.253.i.i.i5116.4.i
  %.253.i.i.i5116.5.i = fmul double %.247.i.i.i5111.i, %.193.i.i.i5094.5.i
  %.157.i.i.i5068.6.i = add nsw i64 %.229.i325.i2904.08327.i, %.155.i.i.i5066.6.i
  %.159.i.i.i5070.6.i = mul nsw i64 %.157.i.i.i5068.6.i, %arg.shape.0
  %gep9360 = getelementptr double, ptr %invariant.gep9359, i64 %.159.i.i.i5070.6.i
  %.191.i.i.i5092.6.i = load double, ptr %gep9360, align 8, !noalias !170
  %.193.i.i.i5094.6.i = fadd double %.191.i.i.i5092.6.i, %.253.i.i.i5116.5.i
  %.253.i.i.i5116.6.i = fmul double %.519.i3073.0.i, %.193.i.i.i5094.6.i
  %.300.i497.i5147.i = add nsw i64 %.229.i325.i2904.08327.i, 1
  %.271.i.i.i4989.i = mul nsw i64 %.229.i325.i2904.08327.i, %arg.shape.0
  %gep9362 = getelementptr double, ptr %invariant.gep9361, i64 %.271.i.i.i4989.i
  %.309.i.i.i5014.i = load double, ptr %gep9362, align 8, !noalias !170
  %.313.i.i.i5017.i = fadd double %.309.i.i.i5014.i, %.253.i.i.i5116.6.i
  %.359.i482.i5030.i = add nsw i64 %.229.i325.i2904.08327.i, %.358.i355.i
  %.361.i.i5032.i = mul nsw i64 %.359.i482.i5030.i, %arg.shape.0
  %gep9364 = getelementptr double, ptr %invariant.gep9363, i64 %.361.i.i5032.i
  store double %.313.i.i.i5017.i, ptr %gep9364, align 8, !noalias !166
  %exitcond8411.not.i = icmp eq i64 %arg.shape.1, %.300.i497.i5147.i
  br i1 %exitcond8411.not.i, label %B154.i3233.loopexit.i, label %B122.if.i.i5141.i

B490.if.i4258.i:                                  ; preds = %B769.i3523.i, %B316.i3266.i
  %.797.i3089.08342.i = phi i64 [ 0, %B316.i3266.i ], [ %.866.i4265.i, %B769.i3523.i ]
  %.866.i4265.i = add nsw i64 %.797.i3089.08342.i, 1
  %.947.i3469.i = getelementptr double, ptr %59, i64 %.797.i3089.08342.i
  %.948.i3470.i = load double, ptr %.947.i3469.i, align 8, !noalias !154
  %.1002.i3516.i = getelementptr double, ptr %58, i64 %.797.i3089.08342.i
  %.1003.i3517.i = load double, ptr %.1002.i3516.i, align 8, !noalias !154
  %.1004.i3518.i = fsub double %.948.i3470.i, %.1003.i3517.i
  %.1006.i3520.i = fcmp ogt double %.1004.i3518.i, 1.000000e-13
  br i1 %.1006.i3520.i, label %B564.i3524.i, label %B769.i3523.i

B564.endif.i3816.i:                               ; preds = %B0.endif.i200.i3719.i, %B460.i267.i3786.i
  %.1013.i3100.0.i = phi double [ %.388.i259.i3778.i, %B0.endif.i200.i3719.i ], [ %.448.i283.i3802.i, %B460.i267.i3786.i ]
  br i1 %.436.i10698201.not.i, label %B564.endif.endif.i3907.i, label %B58.if.i.i4213.i.preheader

B58.if.i.i4213.i.preheader:                       ; preds = %B564.endif.i3816.i
  %invariant.gep9365 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.797.i3089.08342.i
  %invariant.gep9367 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.797.i3089.08342.i
  br label %B58.if.i.i4213.i

B58.if.i.i4213.i:                                 ; preds = %B58.if.i.i4213.i.preheader, %B58.if.i.i4213.i
  %least.2.i.i2848.08339.i = phi double [ %.11.i.i683.i4209.i, %B58.if.i.i4213.i ], [ 0x7FF0000000000000, %B58.if.i.i4213.i.preheader ]
  %.54.i516.i2852.08337.i = phi i64 [ %.125.i694.i4219.i, %B58.if.i.i4213.i ], [ 0, %B58.if.i.i4213.i.preheader ]
  %.125.i694.i4219.i = add nsw i64 %.54.i516.i2852.08337.i, 1
  %.156.i587.i4125.i = add nsw i64 %.54.i516.i2852.08337.i, %.155.i586.i.i
  %.158.i589.i4127.i = mul nsw i64 %.156.i587.i4125.i, %arg.shape.0
  %.164.i594.i4132.i = add nsw i64 %.54.i516.i2852.08337.i, %.586.i.i
  %.166.i595.i4134.i = mul nsw i64 %.164.i594.i4132.i, %arg.shape.0
  %gep9366 = getelementptr double, ptr %invariant.gep9365, i64 %.166.i595.i4134.i
  %.198.i.i4156.i = load double, ptr %gep9366, align 8, !noalias !174
  %gep9368 = getelementptr double, ptr %invariant.gep9367, i64 %.158.i589.i4127.i
  %.228.i645.i4176.i = load double, ptr %gep9368, align 8, !noalias !174
  %.229.i646.i4177.i = fmul double %.198.i.i4156.i, %.228.i645.i4176.i
  %258 = getelementptr double, ptr %gep9368, i64 %.194.i.i738.i
  %.263.i673.i4201.i = load double, ptr %258, align 8, !noalias !174
  %.264.i674.i4202.i = fadd double %.229.i646.i4177.i, %.263.i673.i4201.i
  %.10.i.i682.i4208.i = fcmp olt double %.264.i674.i4202.i, %least.2.i.i2848.08339.i
  %.11.i.i683.i4209.i = select i1 %.10.i.i682.i4208.i, double %.264.i674.i4202.i, double %least.2.i.i2848.08339.i
  %exitcond8413.not.i = icmp eq i64 %arg.shape.6, %.125.i694.i4219.i
  br i1 %exitcond8413.not.i, label %B564.endif.endif.i3907.i, label %B58.if.i.i4213.i

B564.endif.endif.i3907.i:                         ; preds = %B58.if.i.i4213.i, %B564.endif.i3816.i
  %least.2.i.i2848.0.lcssa.i = phi double [ 0x7FF0000000000000, %B564.endif.i3816.i ], [ %.11.i.i683.i4209.i, %B58.if.i.i4213.i ]
  %.1079.i3910.i = fcmp olt double %least.2.i.i2848.0.lcssa.i, 0.000000e+00
  br i1 %.1079.i3910.i, label %B660.i4011.i, label %B712.i3911.i

B946.i:                                           ; preds = %B306.i3247.i, %B114.i3167.loopexit.i, %B854.endif.endif.i
  br i1 %.794, label %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B978.if.lr.ph.i

B978.if.lr.ph.i:                                  ; preds = %B946.i
  %.2125.i = fmul double %.262.i, 2.000000e+00
  br label %B978.if.i

B1072.i:                                          ; preds = %B978.if.i
  %.2058.i = getelementptr double, ptr %55, i64 %.1737.08354.i
  %.2059.i = load double, ptr %.2058.i, align 8, !noalias !61
  %.2127.i = fcmp ogt double %.2059.i, %.2125.i
  %.2181.i = getelementptr double, ptr %58, i64 %.1737.08354.i
  %.2182.i = load double, ptr %.2181.i, align 8, !noalias !61
  %.2236.i = getelementptr double, ptr %59, i64 %.1737.08354.i
  %.2237.i = load double, ptr %.2236.i, align 8, !noalias !61
  %.2238.i = fcmp olt double %.2182.i, %.2237.i
  %.2298.i = getelementptr double, ptr %57, i64 %.1737.08354.i
  %.2299.i = load double, ptr %.2298.i, align 8, !noalias !61
  %.2300.i = fcmp ogt double %.2299.i, 1.000000e-01
  br i1 %.2300.i, label %B1310.i, label %B1550.i

B1310.i:                                          ; preds = %B1072.i
  br i1 %.2127.i, label %B1408.i, label %B1512.i

B1408.i:                                          ; preds = %B1310.i
  %.2115.i = load double, ptr %.1888.i, align 8, !noalias !61
  %.2116.i = tail call double @llvm.fabs.f64(double %.2115.i)
  %.2117.i = fmul double %.2116.i, 2.000000e-12
  %.2363.i = fmul double %.2059.i, 0x3D719799812DEA11
  %.10.i.i8945 = fcmp ogt double %.2117.i, %.2363.i
  %.11.i.i8946 = select i1 %.10.i.i8945, double %.2117.i, double %.2363.i
  %.2359.i = fsub double 1.000000e+00, %.2182.i
  %.2361.i = fmul double %.2059.i, %.2359.i
  %.2395.i = fcmp ugt double %.2361.i, %.11.i.i8946
  br i1 %.2395.i, label %B1412.i, label %B1512.i

B1412.i:                                          ; preds = %B1408.i
  %.2464.i = fmul double %.2059.i, %.2237.i
  %.10.i8094.i = fcmp ogt double %.262.i, %.2464.i
  %.11.i8095.i = select i1 %.10.i8094.i, double %.262.i, double %.2464.i
  %.108.i9062.i = getelementptr double, ptr %65, i64 %.1737.08354.i
  store double 0.000000e+00, ptr %.108.i9062.i, align 8, !noalias !178
  %.161.i9108.i = getelementptr double, ptr %66, i64 %.1737.08354.i
  store double 0.000000e+00, ptr %.161.i9108.i, align 8, !noalias !178
  %.214.i9154.i = getelementptr double, ptr %67, i64 %.1737.08354.i
  store double %.11.i8095.i, ptr %.214.i9154.i, align 8, !noalias !178
  %.267.i9200.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1737.08354.i
  %.268.i9201.i = load i64, ptr %.267.i9200.i, align 8, !noalias !178
  %.294.i9222.i = icmp slt i64 %.268.i9201.i, 0
  %.295.i9223.i = select i1 %.294.i9222.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i9224.i = add i64 %.295.i9223.i, %.268.i9201.i
  %.316.i9243.i = mul i64 %.296.i9224.i, %arg.batch.3.3.5.1
  %.320.i9247.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i9243.i
  %.321.i9248.i = load i64, ptr %.320.i9247.i, align 8, !noalias !178
  %.322.i9249.i = add nsw i64 %.321.i9248.i, -1
  store i64 %.322.i9249.i, ptr %.320.i9247.i, align 8, !noalias !178
  %.426.i9342.i = load i64, ptr %.267.i9200.i, align 8, !noalias !178
  %.452.i9364.i = icmp slt i64 %.426.i9342.i, 0
  %.453.i9365.i = select i1 %.452.i9364.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i9366.i = add i64 %.453.i9365.i, %.426.i9342.i
  %.474.i9386.i = mul i64 %.454.i9366.i, %arg.batch.3.3.5.1
  %259 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i9386.i
  %.478.i9390.i = getelementptr i8, ptr %259, i64 24
  %.479.i9391.i = load i64, ptr %.478.i9390.i, align 8, !noalias !178
  %.480.i9392.i = add nsw i64 %.479.i9391.i, 1
  store i64 %.480.i9392.i, ptr %.478.i9390.i, align 8, !noalias !178
  br label %B1747.i

B1512.i:                                          ; preds = %B1408.i, %B1310.i
  %.2599.i = getelementptr double, ptr %64, i64 %.1737.08354.i
  store double 1.000000e+00, ptr %.2599.i, align 8, !noalias !61
  br label %B1747.i

B1550.i:                                          ; preds = %B1072.i
  br i1 %.2127.i, label %B1554.i, label %B1652.i

B1554.i:                                          ; preds = %B1550.i
  br i1 %.2238.i, label %B1606.i, label %B50.i.i

B50.i.i:                                          ; preds = %B1554.i, %B860.i.i
  %.58.0.i.i = phi i64 [ %.130.i.i, %B860.i.i ], [ 0, %B1554.i ]
  %exitcond.not.i.i8934 = icmp eq i64 %.58.0.i.i, %storemerge7986.i
  br i1 %exitcond.not.i.i8934, label %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B52.if.i.i

B216.i.i:                                         ; preds = %B52.if.i.i, %B935.i.i
  %.300.sroa.0.0341.i.i = phi i64 [ 1, %B52.if.i.i ], [ %.300.sroa.0.0.i.i, %B935.i.i ]
  %.256.1340.i.i = phi i64 [ 6, %B52.if.i.i ], [ %.256.1.i.i, %B935.i.i ]
  %.253.1339.i.i = phi i64 [ 2, %B52.if.i.i ], [ %.253.1.i.i, %B935.i.i ]
  %nearest.3.1338.i.i = phi double [ 0x7FF0000000000000, %B52.if.i.i ], [ %nearest.4.2.i.i, %B935.i.i ]
  %.352.i8099.i = add nsw i64 %.300.sroa.0.0341.i.i, -1
  %.354.i.i = mul nsw i64 %.352.i8099.i, %.30.i.i
  %.356.i8100.i = add nsw i64 %.354.i.i, %.160.i.i
  %.370.i.i = icmp slt i64 %.356.i8100.i, 0
  %.371.i.i8935 = select i1 %.370.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.356.i8100.i
  %.385.i.i = getelementptr double, ptr %260, i64 %.371.i.i8935
  %.386.i.i = load double, ptr %.385.i.i, align 8, !noalias !181
  %.389.i.i = mul nsw i64 %.300.sroa.0.0341.i.i, %.30.i.i
  %.391.i.i = add nsw i64 %.389.i.i, %.160.i.i
  %.405.i.i = icmp slt i64 %.391.i.i, 0
  %.406.i.i8936 = select i1 %.405.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %261 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.391.i.i
  %.420.i.i = getelementptr double, ptr %261, i64 %.406.i.i8936
  %.421.i.i = load double, ptr %.420.i.i, align 8, !noalias !181
  %.423.i8101.i = add nsw i64 %.300.sroa.0.0341.i.i, 1
  %.425.i.i = mul nsw i64 %.423.i8101.i, %.30.i.i
  %.427.i.i = add nsw i64 %.425.i.i, %.160.i.i
  %.441.i.i = icmp slt i64 %.427.i.i, 0
  %.442.i.i = select i1 %.441.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %262 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.427.i.i
  %.456.i.i = getelementptr double, ptr %262, i64 %.442.i.i
  %.457.i.i = load double, ptr %.456.i.i, align 8, !noalias !181
  %.480.i.i8937 = fcmp olt double %.421.i.i, 0.000000e+00
  %.483.i.i = fneg double %.386.i.i
  %.487.i.i = fneg double %.421.i.i
  %.491.i.i = fneg double %.457.i.i
  %c.2.2.i.i = select i1 %.480.i.i8937, double %.491.i.i, double %.457.i.i
  %b.2.2.i.i = select i1 %.480.i.i8937, double %.487.i.i, double %.421.i.i
  %a.2.2.i.i = select i1 %.480.i.i8937, double %.483.i.i, double %.386.i.i
  %.508.i.i = icmp eq i64 %.300.sroa.0.0341.i.i, 1
  %.515.i.i = fcmp ogt double %a.2.2.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.508.i.i, i1 true, i1 %.515.i.i
  br i1 %or.cond.i.i, label %B368.i.i, label %B424.i.i

B368.i.i:                                         ; preds = %B216.i.i
  %.521.i.i8944 = icmp eq i64 %.300.sroa.0.0341.i.i, 8
  %.527.i.i = fcmp ogt double %c.2.2.i.i, 0.000000e+00
  %or.cond307.i.i = select i1 %.521.i.i8944, i1 true, i1 %.527.i.i
  br i1 %or.cond307.i.i, label %B392.i.i, label %B424.i.i

B392.i.i:                                         ; preds = %B368.i.i
  %.10.i.i8133.i = fcmp olt double %b.2.2.i.i, %nearest.3.1338.i.i
  %.11.i.i8134.i = select i1 %.10.i.i8133.i, double %b.2.2.i.i, double %nearest.3.1338.i.i
  br label %B424.i.i

B424.i.i:                                         ; preds = %B392.i.i, %B368.i.i, %B216.i.i
  %nearest.6.3.i.i = phi double [ %.11.i.i8134.i, %B392.i.i ], [ %nearest.3.1338.i.i, %B368.i.i ], [ %nearest.3.1338.i.i, %B216.i.i ]
  %.572.i.i = icmp slt i64 %.300.sroa.0.0341.i.i, 8
  br i1 %.572.i.i, label %B436.i.i, label %B935.i.i

B436.i.i:                                         ; preds = %B424.i.i
  %.581.i.i = fsub double %a.2.2.i.i, %b.2.2.i.i
  %.582.i.i = tail call double @llvm.fabs.f64(double %.581.i.i)
  %.585.i.i = fsub double %c.2.2.i.i, %b.2.2.i.i
  %.586.i8103.i = tail call double @llvm.fabs.f64(double %.585.i.i)
  %.587.i.i = fadd double %.582.i.i, %.586.i8103.i
  %.588.i8104.i = fmul double %.587.i.i, 3.000000e+00
  %.589.i.i8940 = fadd double %.578.i.i, %.588.i8104.i
  %.591.i.i = fcmp olt double %b.2.2.i.i, %.589.i.i8940
  br i1 %.591.i.i, label %B546.i.i, label %B935.i.i

B546.i.i:                                         ; preds = %B436.i.i
  %switch.tableidx = add i64 %.300.sroa.0.0341.i.i, 9
  %263 = icmp ult i64 %switch.tableidx, 18
  br i1 %263, label %switch.lookup9487, label %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i

B752.i.i:                                         ; preds = %switch.lookup9499
  %.800.i.i = fneg double %.741.i.i8941
  %.804.i.i = fmul double %.790.i.i8942, 5.000000e-01
  %.809.i.i = fdiv double %.804.i.i, %.773.i.i
  %.810.i.i = fcmp ogt double %.809.i.i, %.800.i.i
  %.820.i.i = fcmp olt double %.809.i.i, %.667.i.i
  %or.cond309.i.i = and i1 %.810.i.i, %.820.i.i
  br i1 %or.cond309.i.i, label %B792.i.i, label %B935.i.i

B792.i.i:                                         ; preds = %B752.i.i
  %.847.i8109.i = fmul double %.790.i.i8942, 2.500000e-01
  %.849.i8110.i = fmul double %.790.i.i8942, %.847.i8109.i
  %.856.i8111.i = fdiv double %.849.i8110.i, %.773.i.i
  %.860.i.i = fsub double %b.2.2.i.i, %.856.i8111.i
  %.10.i310.i.i = fcmp olt double %.860.i.i, %nearest.6.3.i.i
  %.11.i311.i.i = select i1 %.10.i310.i.i, double %.860.i.i, double %nearest.6.3.i.i
  br label %B935.i.i

B860.i.i:                                         ; preds = %B935.i.i
  %.929.i.i = add nsw i64 %.160.i.i, %.194.i.i738.i
  %.945.i.i = icmp slt i64 %.929.i.i, 0
  %.946.i.i = select i1 %.945.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %264 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.929.i.i
  %.960.i.i = getelementptr double, ptr %264, i64 %.946.i.i
  %.961.i.i = load double, ptr %.960.i.i, align 8, !noalias !181
  %.963.i.i = fcmp ule double %.11.i.i.3.i.i, %.961.i.i
  %.970.i.i = fcmp ugt double %nearest.4.2.i.i, %.578.i.i
  %or.cond308.i.i = select i1 %.963.i.i, i1 true, i1 %.970.i.i
  br i1 %or.cond308.i.i, label %B50.i.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i

B935.i.i:                                         ; preds = %switch.lookup9499, %B792.i.i, %B752.i.i, %B436.i.i, %B424.i.i
  %nearest.4.2.i.i = phi double [ %nearest.6.3.i.i, %B752.i.i ], [ %.11.i311.i.i, %B792.i.i ], [ %nearest.6.3.i.i, %B424.i.i ], [ %nearest.6.3.i.i, %switch.lookup9499 ], [ %nearest.6.3.i.i, %B436.i.i ]
  %.310.i.i = icmp ne i64 %.256.1340.i.i, 0
  %.323.i.i = zext i1 %.310.i.i to i64
  %.253.1.i.i = add i64 %.253.1339.i.i, %.323.i.i
  %.319.i.i8938 = sext i1 %.310.i.i to i64
  %.256.1.i.i = add nsw i64 %.256.1340.i.i, %.319.i.i8938
  %.300.sroa.0.0.i.i = select i1 %.310.i.i, i64 %.253.1339.i.i, i64 0
  br i1 %.310.i.i, label %B216.i.i, label %B860.i.i

B52.if.i.i:                                       ; preds = %B50.i.i
  %.130.i.i = add i64 %.58.0.i.i, 1
  %.156.i.i = add nsw i64 %.58.0.i.i, %arg.shape.6
  %.158.i.i = mul nsw i64 %.156.i.i, %arg.shape.0
  %.160.i.i = add nsw i64 %.158.i.i, %.1737.08354.i
  %.192.i.i.i = add nsw i64 %.160.i.i, %.30.i.i
  %.206.i.i.i = icmp slt i64 %.192.i.i.i, 0
  %.207.i.i.i = select i1 %.206.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %265 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i
  %.221.i.i.i = getelementptr double, ptr %265, i64 %.207.i.i.i
  %.222.i.i.i = load double, ptr %.221.i.i.i, align 8, !noalias !185
  %.472.i.i.i = icmp slt i64 %.160.i.i, 0
  %.473.i.i.i = select i1 %.472.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %266 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i
  %.487.i.i.i = getelementptr double, ptr %266, i64 %.473.i.i.i
  %.488.i.i.i = load double, ptr %.487.i.i.i, align 8, !noalias !185
  %.489.i.i.i = fmul double %.488.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i = fsub double %.222.i.i.i, %.489.i.i.i
  %.458.i.1.i.i = add nsw i64 %.160.i.i, %.454.i.i.i
  %.472.i.1.i.i = icmp slt i64 %.458.i.1.i.i, 0
  %.473.i.1.i.i = select i1 %.472.i.1.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %267 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i
  %.487.i.1.i.i = getelementptr double, ptr %267, i64 %.473.i.1.i.i
  %.488.i.1.i.i = load double, ptr %.487.i.1.i.i, align 8, !noalias !185
  %.489.i.1.i.i = fmul double %.488.i.1.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i = fsub double %.491.i.i.i, %.489.i.1.i.i
  %.458.i.2.i.i = add nsw i64 %.160.i.i, %.456.i.2.i.i
  %.472.i.2.i.i = icmp slt i64 %.458.i.2.i.i, 0
  %.473.i.2.i.i = select i1 %.472.i.2.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %268 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i
  %.487.i.2.i.i = getelementptr double, ptr %268, i64 %.473.i.2.i.i
  %.488.i.2.i.i = load double, ptr %.487.i.2.i.i, align 8, !noalias !185
  %.489.i.2.i.i = fmul double %.488.i.2.i.i, 0x3FE1306AA3D795F4
  %269 = fadd double %.491.i.1.i.i, %.489.i.2.i.i
  %.458.i.3.i.i = add nsw i64 %.160.i.i, %.456.i.3.i.i
  %.472.i.3.i.i = icmp slt i64 %.458.i.3.i.i, 0
  %.473.i.3.i.i = select i1 %.472.i.3.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %270 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i
  %.487.i.3.i.i = getelementptr double, ptr %270, i64 %.473.i.3.i.i
  %.488.i.3.i.i = load double, ptr %.487.i.3.i.i, align 8, !noalias !185
  %.489.i.3.i.i = fmul double %.488.i.3.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i = fsub double %269, %.489.i.3.i.i
  %.458.i.4.i.i = add nsw i64 %.160.i.i, %.456.i.4.i.i
  %.472.i.4.i.i = icmp slt i64 %.458.i.4.i.i, 0
  %.473.i.4.i.i = select i1 %.472.i.4.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %271 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i
  %.487.i.4.i.i = getelementptr double, ptr %271, i64 %.473.i.4.i.i
  %.488.i.4.i.i = load double, ptr %.487.i.4.i.i, align 8, !noalias !185
  %.489.i.4.i.i = fmul double %.488.i.4.i.i, 0x3FA4EAF2D6B11E79
  %272 = fadd double %.491.i.3.i.i, %.489.i.4.i.i
  %.502.i.i.i = tail call double @llvm.fabs.f64(double %272)
  %.10.i.i.i8097.i = fcmp ogt double %.502.i.i.i, 0.000000e+00
  %.11.i.i.i8098.i = select i1 %.10.i.i.i8097.i, double %.502.i.i.i, double 0.000000e+00
  %.192.i.1.i.i = add nsw i64 %.160.i.i, %.190.i.1.i.i
  %.206.i.1.i.i = icmp slt i64 %.192.i.1.i.i, 0
  %.207.i.1.i.i = select i1 %.206.i.1.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %273 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i
  %.221.i.1.i.i = getelementptr double, ptr %273, i64 %.207.i.1.i.i
  %.222.i.1.i.i = load double, ptr %.221.i.1.i.i, align 8, !noalias !185
  %.489.i.1377.i.i = fmul double %.488.i.i.i, 0x3FA5118805F8B876
  %274 = fadd double %.489.i.1377.i.i, %.222.i.1.i.i
  %.489.i.1.1.i.i = fmul double %.488.i.1.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i = fsub double %274, %.489.i.1.1.i.i
  %.489.i.2.1.i.i = fmul double %.488.i.2.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i = fsub double %.491.i.1.1.i.i, %.489.i.2.1.i.i
  %.489.i.3.1.i.i = fmul double %.488.i.3.i.i, 0x3FC0DA0C684D1D67
  %275 = fadd double %.489.i.3.1.i.i, %.491.i.2.1.i.i
  %.489.i.4.1.i.i = fmul double %.488.i.4.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i = fsub double %275, %.489.i.4.1.i.i
  %.502.i.1.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i)
  %.10.i.i.1.i.i = fcmp ogt double %.502.i.1.i.i, %.11.i.i.i8098.i
  %.11.i.i.1.i.i = select i1 %.10.i.i.1.i.i, double %.502.i.1.i.i, double %.11.i.i.i8098.i
  %.192.i.2.i.i = add nsw i64 %.160.i.i, %.190.i.2.i.i
  %.206.i.2.i.i = icmp slt i64 %.192.i.2.i.i, 0
  %.207.i.2.i.i = select i1 %.206.i.2.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %276 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i
  %.221.i.2.i.i = getelementptr double, ptr %276, i64 %.207.i.2.i.i
  %.222.i.2.i.i = load double, ptr %.221.i.2.i.i, align 8, !noalias !185
  %.489.i.2404.i.i = fmul double %.488.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2405.i.i = fsub double %.222.i.2.i.i, %.489.i.2404.i.i
  %.489.i.1.2.i.i = fmul double %.488.i.1.i.i, 0x3FC1EAE0FF33D241
  %277 = fadd double %.489.i.1.2.i.i, %.491.i.2405.i.i
  %.489.i.2.2.i.i = fmul double %.488.i.2.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i = fsub double %277, %.489.i.2.2.i.i
  %.489.i.3.2.i.i = fmul double %.488.i.3.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i = fsub double %.491.i.2.2.i.i, %.489.i.3.2.i.i
  %.489.i.4.2.i.i = fmul double %.488.i.4.i.i, 0x3FA55161A739EB34
  %278 = fadd double %.489.i.4.2.i.i, %.491.i.3.2.i.i
  %.502.i.2.i.i = tail call double @llvm.fabs.f64(double %278)
  %.10.i.i.2.i.i = fcmp ogt double %.502.i.2.i.i, %.11.i.i.1.i.i
  %.11.i.i.2.i.i = select i1 %.10.i.i.2.i.i, double %.502.i.2.i.i, double %.11.i.i.1.i.i
  %.192.i.3.i.i = add nsw i64 %.160.i.i, %.190.i.3.i.i
  %.206.i.3.i.i = icmp slt i64 %.192.i.3.i.i, 0
  %.207.i.3.i.i = select i1 %.206.i.3.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %279 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i
  %.221.i.3.i.i = getelementptr double, ptr %279, i64 %.207.i.3.i.i
  %.222.i.3.i.i = load double, ptr %.221.i.3.i.i, align 8, !noalias !185
  %.489.i.3431.i.i = fmul double %.488.i.i.i, 0x3FA4F0C0BB579409
  %280 = fadd double %.489.i.3431.i.i, %.222.i.3.i.i
  %.489.i.1.3.i.i = fmul double %.488.i.1.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i = fsub double %280, %.489.i.1.3.i.i
  %.489.i.2.3.i.i = fmul double %.488.i.2.i.i, 0x3FE1F2DB6FEE3151
  %281 = fadd double %.489.i.2.3.i.i, %.491.i.1.3.i.i
  %.489.i.3.3.i.i = fmul double %.488.i.3.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i = fsub double %281, %.489.i.3.3.i.i
  %.489.i.4.3.i.i = fmul double %.488.i.4.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i = fsub double %.491.i.3.3.i.i, %.489.i.4.3.i.i
  %.502.i.3.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i)
  %.10.i.i.3.i.i = fcmp ogt double %.502.i.3.i.i, %.11.i.i.2.i.i
  %.11.i.i.3.i.i = select i1 %.10.i.i.3.i.i, double %.502.i.3.i.i, double %.11.i.i.2.i.i
  %.578.i.i = fmul double %.11.i.i.3.i.i, 1.000000e+01
  br label %B216.i.i

switch.lookup9487:                                ; preds = %B546.i.i
  %switch.tableidx9490 = add i64 %.300.sroa.0.0341.i.i, 8
  %282 = icmp ult i64 %switch.tableidx9490, 18
  br i1 %282, label %switch.lookup9491, label %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup9491:                                ; preds = %switch.lookup9487
  %switch.gep9488 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx
  %switch.load9489 = load double, ptr %switch.gep9488, align 8
  %switch.gep9492 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9490
  %switch.load9493 = load double, ptr %switch.gep9492, align 8
  %.667.i.i = fsub double %switch.load9489, %switch.load9493
  %switch.tableidx9494 = add i64 %.300.sroa.0.0341.i.i, 10
  %283 = icmp ult i64 %switch.tableidx9494, 18
  br i1 %283, label %switch.lookup9495, label %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup9495:                                ; preds = %switch.lookup9491
  %switch.tableidx9498 = add i64 %.300.sroa.0.0341.i.i, 9
  %284 = icmp ult i64 %switch.tableidx9498, 18
  br i1 %284, label %switch.lookup9499, label %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i

switch.lookup9499:                                ; preds = %switch.lookup9495
  %switch.gep9496 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9494
  %switch.load9497 = load double, ptr %switch.gep9496, align 8
  %switch.gep9500 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9498
  %switch.load9501 = load double, ptr %switch.gep9500, align 8
  %.741.i.i8941 = fsub double %switch.load9497, %switch.load9501
  %.757.i.i = fdiv double %.585.i.i, %.741.i.i8941
  %.760.i.i = fsub double %b.2.2.i.i, %a.2.2.i.i
  %.765.i.i = fdiv double %.760.i.i, %.667.i.i
  %.766.i.i = fsub double %.757.i.i, %.765.i.i
  %.769.i.i = fadd double %.667.i.i, %.741.i.i8941
  %.773.i.i = fdiv double %.766.i.i, %.769.i.i
  %.789.i.i = fmul double %.667.i.i, %.773.i.i
  %.790.i.i8942 = fadd double %.765.i.i, %.789.i.i
  %.795.i.i8943 = fcmp ogt double %.773.i.i, 0.000000e+00
  br i1 %.795.i.i8943, label %B752.i.i, label %B935.i.i

_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B860.i.i, %B50.i.i, %B546.i.i, %switch.lookup9487, %switch.lookup9491, %switch.lookup9495
  %.2636.not.i = phi i1 [ true, %B546.i.i ], [ true, %switch.lookup9495 ], [ true, %switch.lookup9491 ], [ true, %switch.lookup9487 ], [ %exitcond.not.i.i8934, %B50.i.i ], [ %exitcond.not.i.i8934, %B860.i.i ]
  %excinfo.12.4.i = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %B546.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup9495 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup9491 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.70, %switch.lookup9487 ], [ %excinfo.12.08358.i, %B50.i.i ], [ %excinfo.12.08358.i, %B860.i.i ]
  %.2625.not.i = phi i1 [ false, %B546.i.i ], [ false, %switch.lookup9495 ], [ false, %switch.lookup9491 ], [ false, %switch.lookup9487 ], [ true, %B50.i.i ], [ true, %B860.i.i ]
  %common.ret.op.i8102.i = phi i32 [ 1, %B546.i.i ], [ 1, %switch.lookup9495 ], [ 1, %switch.lookup9491 ], [ 1, %switch.lookup9487 ], [ 0, %B50.i.i ], [ 0, %B860.i.i ]
  br i1 %.2625.not.i, label %B1558.endif.endif.i, label %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, !prof !53

B1606.i:                                          ; preds = %B1558.endif.endif.i, %B1554.i
  %excinfo.12.3.i = phi ptr [ %excinfo.12.08358.i, %B1554.i ], [ %excinfo.12.4.i, %B1558.endif.endif.i ]
  %.2655.i = fmul double %.2059.i, 5.000000e-01
  %.108.i8594.i = getelementptr double, ptr %65, i64 %.1737.08354.i
  store double 0.000000e+00, ptr %.108.i8594.i, align 8, !noalias !189
  %.161.i.i8939 = getelementptr double, ptr %66, i64 %.1737.08354.i
  store double 0.000000e+00, ptr %.161.i.i8939, align 8, !noalias !189
  %.214.i8680.i = getelementptr double, ptr %67, i64 %.1737.08354.i
  store double %.2655.i, ptr %.214.i8680.i, align 8, !noalias !189
  %.267.i8725.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1737.08354.i
  %.268.i8726.i = load i64, ptr %.267.i8725.i, align 8, !noalias !189
  %.294.i8746.i = icmp slt i64 %.268.i8726.i, 0
  %.295.i8747.i = select i1 %.294.i8746.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i8748.i = add i64 %.295.i8747.i, %.268.i8726.i
  %.316.i8767.i = mul i64 %.296.i8748.i, %arg.batch.3.3.5.1
  %.320.i8771.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i8767.i
  %.321.i8772.i = load i64, ptr %.320.i8771.i, align 8, !noalias !189
  %.322.i8773.i = add nsw i64 %.321.i8772.i, -1
  store i64 %.322.i8773.i, ptr %.320.i8771.i, align 8, !noalias !189
  %.426.i8866.i = load i64, ptr %.267.i8725.i, align 8, !noalias !189
  %.452.i8887.i = icmp slt i64 %.426.i8866.i, 0
  %.453.i8888.i = select i1 %.452.i8887.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i8889.i = add i64 %.453.i8888.i, %.426.i8866.i
  %.474.i8907.i = mul i64 %.454.i8889.i, %arg.batch.3.3.5.1
  %285 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i8907.i
  %.478.i8911.i = getelementptr i8, ptr %285, i64 24
  %.479.i8912.i = load i64, ptr %.478.i8911.i, align 8, !noalias !189
  %.480.i8913.i = add nsw i64 %.479.i8912.i, 1
  store i64 %.480.i8913.i, ptr %.478.i8911.i, align 8, !noalias !189
  br label %B1747.i

B1652.i:                                          ; preds = %B1558.endif.endif.i, %B1550.i
  %excinfo.12.2.i = phi ptr [ %excinfo.12.4.i, %B1558.endif.endif.i ], [ %excinfo.12.08358.i, %B1550.i ]
  br label %B34.i.i

B34.i.i:                                          ; preds = %B34.if.i.i8933, %B1652.i
  %.51.i9453.0.i = phi i64 [ 0, %B1652.i ], [ %.122.i9598.i, %B34.if.i.i8933 ]
  %exitcond8415.not.i = icmp eq i64 %.51.i9453.0.i, %storemerge7986.i
  br i1 %exitcond8415.not.i, label %B1747.i, label %B34.if.i.i8933

B128.i.i:                                         ; preds = %B34.if.i.i8933
  %286 = icmp sgt i64 %.51.i9453.0.i, -1
  br i1 %286, label %B1708.i, label %B1747.i

B34.if.i.i8933:                                   ; preds = %B34.i.i
  %.122.i9598.i = add i64 %.51.i9453.0.i, 1
  %.157.i9521.i = add nsw i64 %.51.i9453.0.i, %.155.i9519.i
  %.159.i9523.i = mul nsw i64 %.157.i9521.i, %arg.shape.0
  %.161.i9525.i = add nsw i64 %.159.i9523.i, %.1737.08354.i
  %.175.i9534.i = icmp slt i64 %.161.i9525.i, 0
  %.176.i9535.i = select i1 %.175.i9534.i, i64 %arg.batch.5.4.5.0, i64 0
  %287 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i9525.i
  %.190.i9549.i = getelementptr double, ptr %287, i64 %.176.i9535.i
  %.191.i9550.i = load double, ptr %.190.i9549.i, align 8, !noalias !192
  %.195.i9554.i = add nsw i64 %.161.i9525.i, %.194.i.i738.i
  %.209.i9564.i = icmp slt i64 %.195.i9554.i, 0
  %.210.i9565.i = select i1 %.209.i9564.i, i64 %arg.batch.5.4.5.0, i64 0
  %288 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i9554.i
  %.224.i9578.i = getelementptr double, ptr %288, i64 %.210.i9565.i
  %.225.i9579.i = load double, ptr %.224.i9578.i, align 8, !noalias !192
  %.226.i9580.i = fneg double %.225.i9579.i
  %.227.i9581.i = fcmp olt double %.191.i9550.i, %.226.i9580.i
  br i1 %.227.i9581.i, label %B128.i.i, label %B34.i.i

B1708.i:                                          ; preds = %B128.i.i
  %.2794.i = getelementptr double, ptr %64, i64 %.1737.08354.i
  store double 1.000000e+00, ptr %.2794.i, align 8, !noalias !61
  br label %B1747.i

B1747.i:                                          ; preds = %B34.i.i, %B978.if.i, %B1708.i, %B128.i.i, %B1606.i, %B1512.i, %B1412.i
  %excinfo.12.1.i = phi ptr [ %excinfo.12.08358.i, %B978.if.i ], [ %excinfo.12.08358.i, %B1412.i ], [ %excinfo.12.08358.i, %B1512.i ], [ %excinfo.12.3.i, %B1606.i ], [ %excinfo.12.2.i, %B1708.i ], [ %excinfo.12.2.i, %B128.i.i ], [ %excinfo.12.2.i, %B34.i.i ]
  %exitcond8416.not.i = icmp eq i64 %arg.shape.0, %.1807.i
  br i1 %exitcond8416.not.i, label %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B978.if.i

B286.if.i8928:                                    ; preds = %B286.if.i8928.preheader, %B286.loopexit.i
  %.624.08174.i = phi i64 [ %.693.i, %B286.loopexit.i ], [ 0, %B286.if.i8928.preheader ]
  %.693.i = add nsw i64 %.624.08174.i, 1
  br i1 %199, label %switch.lookup9503, label %switch.end.i

switch.lookup9503:                                ; preds = %B286.if.i8928
  %switch.load9505 = load double, ptr %switch.gep9504, align 8
  br label %switch.end.i

switch.end.i:                                     ; preds = %B286.if.i8928, %switch.lookup9503
  %.735.i8929 = phi double [ %switch.load9505, %switch.lookup9503 ], [ 1.000000e+00, %B286.if.i8928 ]
  %.92.i107.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.624.08174.i
  %.93.i108.i = load double, ptr %.92.i107.i, align 8, !noalias !196
  %.146.i144.i = getelementptr double, ptr %55, i64 %.624.08174.i
  %.147.i145.i = load double, ptr %.146.i144.i, align 8, !noalias !196
  %.149.i147.i = fmul double %.735.i8929, %.147.i145.i
  %.150.i148.i = fadd double %.93.i108.i, %.149.i147.i
  %.203.i184.i = getelementptr double, ptr %.571, i64 %.624.08174.i
  store double %.150.i148.i, ptr %.203.i184.i, align 8, !noalias !196
  br i1 %.287.i2218170.not.i, label %B286.loopexit.i, label %B122.if.i467.lr.ph.i

B122.if.i467.lr.ph.i:                             ; preds = %switch.end.i
  %.247.i.i437.i = fsub double 1.000000e+00, %.735.i8929
  %invariant.gep9289 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9291 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9293 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9295 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9297 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9299 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9301 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9303 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  %invariant.gep9305 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.624.08174.i
  br label %B122.if.i467.i

B122.if.i467.i:                                   ; preds = %B122.if.i467.i, %B122.if.i467.lr.ph.i
  %.229.i60.08171.i = phi i64 [ 0, %B122.if.i467.lr.ph.i ], [ %.300.i473.i, %B122.if.i467.i ]
  %.157.i.i394.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.i
  %.159.i.i396.i = mul nsw i64 %.157.i.i394.i, %arg.shape.0
  %gep9290 = getelementptr double, ptr %invariant.gep9289, i64 %.159.i.i396.i
  %.191.i.i418.i = load double, ptr %gep9290, align 8, !noalias !200
  %.193.i.i420.i = fadd double %.191.i.i418.i, 0.000000e+00
  %.253.i.i442.i = fmul double %.735.i8929, %.193.i.i420.i
  %.157.i.i394.1.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.1.i
  %.159.i.i396.1.i = mul nsw i64 %.157.i.i394.1.i, %arg.shape.0
  %gep9292 = getelementptr double, ptr %invariant.gep9291, i64 %.159.i.i396.1.i
  %.191.i.i418.1.i = load double, ptr %gep9292, align 8, !noalias !200
  %.193.i.i420.1.i = fadd double %.191.i.i418.1.i, %.253.i.i442.i
  %.253.i.i442.1.i = fmul double %.247.i.i437.i, %.193.i.i420.1.i
  %.157.i.i394.2.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.2.i
  %.159.i.i396.2.i = mul nsw i64 %.157.i.i394.2.i, %arg.shape.0
  %gep9294 = getelementptr double, ptr %invariant.gep9293, i64 %.159.i.i396.2.i
  %.191.i.i418.2.i = load double, ptr %gep9294, align 8, !noalias !200
  %.193.i.i420.2.i = fadd double %.191.i.i418.2.i, %.253.i.i442.1.i
  %.253.i.i442.2.i = fmul double %.735.i8929, %.193.i.i420.2.i
  %.157.i.i394.3.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.3.i
  %.159.i.i396.3.i = mul nsw i64 %.157.i.i394.3.i, %arg.shape.0
  %gep9296 = getelementptr double, ptr %invariant.gep9295, i64 %.159.i.i396.3.i
  %.191.i.i418.3.i = load double, ptr %gep9296, align 8, !noalias !200
  %.193.i.i420.3.i = fadd double %.191.i.i418.3.i, %.253.i.i442.2.i
  %.253.i.i442.3.i = fmul double %.247.i.i437.i, %.193.i.i420.3.i
  %.157.i.i394.4.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.4.i
  %.159.i.i396.4.i = mul nsw i64 %.157.i.i394.4.i, %arg.shape.0
  %gep9298 = getelementptr double, ptr %invariant.gep9297, i64 %.159.i.i396.4.i
  %.191.i.i418.4.i = load double, ptr %gep9298, align 8, !noalias !200
  %.193.i.i420.4.i = fadd double %.191.i.i418.4.i, %.253.i.i442.3.i
  %.253.i.i442.4.i = fmul double %.735.i8929, %.193.i.i420.4.i
  %.157.i.i394.5.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.5.i
  %.159.i.i396.5.i = mul nsw i64 %.157.i.i394.5.i, %arg.shape.0
  %gep9300 = getelementptr double, ptr %invariant.gep9299, i64 %.159.i.i396.5.i
  %.191.i.i418.5.i = load double, ptr %gep9300, align 8, !noalias !200
  %.193.i.i420.5.i = fadd double %.191.i.i418.5.i, %.253.i.i442.4.i
  %.253.i.i442.5.i = fmul double %.247.i.i437.i, %.193.i.i420.5.i
  %.157.i.i394.6.i = add nsw i64 %.229.i60.08171.i, %.155.i.i392.6.i
  %.159.i.i396.6.i = mul nsw i64 %.157.i.i394.6.i, %arg.shape.0
  %gep9302 = getelementptr double, ptr %invariant.gep9301, i64 %.159.i.i396.6.i
  %.191.i.i418.6.i = load double, ptr %gep9302, align 8, !noalias !200
  %.193.i.i420.6.i = fadd double %.191.i.i418.6.i, %.253.i.i442.5.i
  %.253.i.i442.6.i = fmul double %.735.i8929, %.193.i.i420.6.i
  %.300.i473.i = add nsw i64 %.229.i60.08171.i, 1
  %.271.i.i315.i = mul nsw i64 %.229.i60.08171.i, %arg.shape.0
  %gep9304 = getelementptr double, ptr %invariant.gep9303, i64 %.271.i.i315.i
  %.309.i.i340.i = load double, ptr %gep9304, align 8, !noalias !200
  %.313.i.i343.i = fadd double %.309.i.i340.i, %.253.i.i442.6.i
  %.359.i356.i = add nsw i64 %.229.i60.08171.i, %.358.i355.i
  %.361.i358.i = mul nsw i64 %.359.i356.i, %arg.shape.0
  %gep9306 = getelementptr double, ptr %invariant.gep9305, i64 %.361.i358.i
  store double %.313.i.i343.i, ptr %gep9306, align 8, !noalias !196
  %exitcond8382.not.i = icmp eq i64 %arg.shape.1, %.300.i473.i
  br i1 %exitcond8382.not.i, label %B286.loopexit.i, label %B122.if.i467.i

B354.endif.i:                                     ; preds = %B964.i.loopexit.i, %B286.preheader.i8927, %B340.i.i
  %.559.i = icmp ne i64 %.506.18199.i, 0
  %.568.i = sext i1 %.559.i to i64
  %.506.1.i = add nsw i64 %.506.18199.i, %.568.i
  br i1 %.559.i, label %B286.preheader.i8927, label %B438.i

B482.endif.endif.i:                               ; preds = %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.1005.0.i, label %B854.i, label %B154.i.preheader.i.preheader

B154.i.preheader.i.preheader:                     ; preds = %B482.endif.endif.i
  br i1 %.794, label %B658.endif.i.critedge, label %B154.i.preheader.i

B586.if.i:                                        ; preds = %B586.if.i.preheader, %B586.loopexit.i
  %.1161.08262.i = phi i64 [ %.1230.i, %B586.loopexit.i ], [ 0, %B586.if.i.preheader ]
  %.1230.i = add nsw i64 %.1161.08262.i, 1
  %289 = getelementptr double, ptr %59, i64 %.1161.08262.i
  %.1309.i = load double, ptr %289, align 8, !noalias !61
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1161.08262.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !125
  %.146.i.i = getelementptr double, ptr %55, i64 %.1161.08262.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !125
  %.149.i.i = fmul double %.1309.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.571, i64 %.1161.08262.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !125
  br i1 %.287.i2218170.not.i, label %B586.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B586.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %.1309.i
  %invariant.gep9329 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9331 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9333 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9335 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9337 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9339 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9341 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9343 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  %invariant.gep9345 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1161.08262.i
  br label %B122.if.i.i

B658.endif.i.critedge:                            ; preds = %B154.i.preheader.i.preheader
  %.1383.i.c = load i64, ptr %.654.i1934.i, align 8, !noalias !61
  %.1499.i.c = inttoptr i64 %.1383.i.c to ptr
  tail call void %.1499.i.c(ptr %.571, ptr %.1473.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1498.i), !noalias !61
  br label %B658.endif.i

B658.endif.i:                                     ; preds = %B964.i6223.loopexit.i, %B658.endif.i.critedge, %B340.i5578.i
  %.946.i = icmp ne i64 %.893.18297.i, 0
  %.955.i = sext i1 %.946.i to i64
  %.893.1.i = add nsw i64 %.893.18297.i, %.955.i
  br i1 %.946.i, label %B438.i, label %B854.i

B854.endif.endif.i:                               ; preds = %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.1588.0.i, label %B946.i, label %B154.i3233.preheader.i.preheader

B154.i3233.preheader.i.preheader:                 ; preds = %B854.endif.endif.i
  br i1 %.794, label %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B154.i3233.preheader.i

B978.if.i:                                        ; preds = %B1747.i, %B978.if.lr.ph.i
  %excinfo.12.08358.i = phi ptr [ null, %B978.if.lr.ph.i ], [ %excinfo.12.1.i, %B1747.i ]
  %.1737.08354.i = phi i64 [ 0, %B978.if.lr.ph.i ], [ %.1807.i, %B1747.i ]
  %.1807.i = add nsw i64 %.1737.08354.i, 1
  %.1888.i = getelementptr double, ptr %63, i64 %.1737.08354.i
  %.1889.i = load double, ptr %.1888.i, align 8, !noalias !61
  %.1943.i = getelementptr double, ptr %.571, i64 %.1737.08354.i
  store double %.1889.i, ptr %.1943.i, align 8, !noalias !61
  %.1998.i = getelementptr i64, ptr %56, i64 %.1737.08354.i
  %.1999.i = load i64, ptr %.1998.i, align 8, !noalias !61
  %.2000.i = icmp slt i64 %.1999.i, 0
  br i1 %.2000.i, label %B1747.i, label %B1072.i

B1558.endif.endif.i:                              ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.2636.not.i, label %B1652.i, label %B1606.i

_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1747.i, %B154.i3233.preheader.i.preheader, %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B946.i
  %excinfo.12.3 = phi ptr [ %excinfo.12.0, %B946.i ], [ %excinfo.12.0, %B1747.i ], [ %excinfo.7.6.i, %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %excinfo.12.0, %B154.i3233.preheader.i.preheader ], [ %excinfo.12.4.i, %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.19, %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %common.ret.op.i = phi i32 [ 0, %B946.i ], [ 0, %B1747.i ], [ %.16128497.i, %_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B154.i3233.preheader.i.preheader ], [ %common.ret.op.i8102.i, %_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.10291620.i, %_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.4926.not = icmp eq i32 %common.ret.op.i, 0
  br i1 %.4926.not, label %B3414, label %B3372.if, !prof !53

B3414:                                            ; preds = %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3318.endif.endif, %B3314
  %excinfo.12.2 = phi ptr [ %excinfo.12.0, %B3318.endif.endif ], [ %excinfo.12.3, %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.12.0, %B3314 ]
  br i1 %.4946.not, label %B3458, label %B3418

B3418:                                            ; preds = %B3414
  br i1 %.794, label %B116.loopexit.8.i, label %B150.if.i

B150.if.1.i:                                      ; preds = %B150.if.i, %B150.if.1.i
  %.361.0604.1.i = phi i64 [ %.430.1.i, %B150.if.1.i ], [ 0, %B150.if.i ]
  %.430.1.i = add nsw i64 %.361.0604.1.i, 1
  %gep9372 = getelementptr double, ptr %invariant.gep9371, i64 %.361.0604.1.i
  store double 1.000000e-09, ptr %gep9372, align 8, !noalias !204
  %exitcond.1.not.i = icmp eq i64 %arg.shape.0, %.430.1.i
  br i1 %exitcond.1.not.i, label %B150.if.2.i, label %B150.if.1.i

B150.if.2.i:                                      ; preds = %B150.if.1.i, %B150.if.2.i
  %.361.0604.2.i = phi i64 [ %.430.2.i, %B150.if.2.i ], [ 0, %B150.if.1.i ]
  %.430.2.i = add nsw i64 %.361.0604.2.i, 1
  %gep9374 = getelementptr double, ptr %invariant.gep9373, i64 %.361.0604.2.i
  store double 1.000000e-09, ptr %gep9374, align 8, !noalias !204
  %exitcond.2.not.i = icmp eq i64 %arg.shape.0, %.430.2.i
  br i1 %exitcond.2.not.i, label %B150.if.3.i, label %B150.if.2.i

B150.if.3.i:                                      ; preds = %B150.if.2.i, %B150.if.3.i
  %.361.0604.3.i = phi i64 [ %.430.3.i, %B150.if.3.i ], [ 0, %B150.if.2.i ]
  %.430.3.i = add nsw i64 %.361.0604.3.i, 1
  %gep9376 = getelementptr double, ptr %invariant.gep9375, i64 %.361.0604.3.i
  store double 1.000000e-09, ptr %gep9376, align 8, !noalias !204
  %exitcond.3.not.i = icmp eq i64 %arg.shape.0, %.430.3.i
  br i1 %exitcond.3.not.i, label %B150.if.4.i, label %B150.if.3.i

B150.if.4.i:                                      ; preds = %B150.if.3.i, %B150.if.4.i
  %.361.0604.4.i = phi i64 [ %.430.4.i, %B150.if.4.i ], [ 0, %B150.if.3.i ]
  %.430.4.i = add nsw i64 %.361.0604.4.i, 1
  %gep9378 = getelementptr double, ptr %invariant.gep9377, i64 %.361.0604.4.i
  store double 1.000000e-09, ptr %gep9378, align 8, !noalias !204
  %exitcond.4.not.i = icmp eq i64 %arg.shape.0, %.430.4.i
  br i1 %exitcond.4.not.i, label %B150.if.5.i, label %B150.if.4.i

B150.if.5.i:                                      ; preds = %B150.if.4.i, %B150.if.5.i
  %.361.0604.5.i = phi i64 [ %.430.5.i, %B150.if.5.i ], [ 0, %B150.if.4.i ]
  %.430.5.i = add nsw i64 %.361.0604.5.i, 1
  %gep9380 = getelementptr double, ptr %invariant.gep9379, i64 %.361.0604.5.i
  store double 1.000000e-09, ptr %gep9380, align 8, !noalias !204
  %exitcond.5.not.i = icmp eq i64 %arg.shape.0, %.430.5.i
  br i1 %exitcond.5.not.i, label %B150.if.6.i, label %B150.if.5.i

B150.if.6.i:                                      ; preds = %B150.if.5.i, %B150.if.6.i
  %.361.0604.6.i = phi i64 [ %.430.6.i, %B150.if.6.i ], [ 0, %B150.if.5.i ]
  %.430.6.i = add nsw i64 %.361.0604.6.i, 1
  %gep9382 = getelementptr double, ptr %invariant.gep9381, i64 %.361.0604.6.i
  store double 1.000000e-09, ptr %gep9382, align 8, !noalias !204
  %exitcond.6.not.i = icmp eq i64 %arg.shape.0, %.430.6.i
  br i1 %exitcond.6.not.i, label %B150.if.7.i, label %B150.if.6.i

B150.if.7.i:                                      ; preds = %B150.if.6.i, %B150.if.7.i
  %.361.0604.7.i = phi i64 [ %.430.7.i, %B150.if.7.i ], [ 0, %B150.if.6.i ]
  %.430.7.i = add nsw i64 %.361.0604.7.i, 1
  %gep9384 = getelementptr double, ptr %invariant.gep9383, i64 %.361.0604.7.i
  store double 1.000000e-09, ptr %gep9384, align 8, !noalias !204
  %exitcond.7.not.i = icmp eq i64 %arg.shape.0, %.430.7.i
  br i1 %exitcond.7.not.i, label %B150.if.8.i, label %B150.if.7.i

B150.if.8.i:                                      ; preds = %B150.if.7.i, %B150.if.8.i
  %.361.0604.8.i = phi i64 [ %.430.8.i, %B150.if.8.i ], [ 0, %B150.if.7.i ]
  %.430.8.i = add nsw i64 %.361.0604.8.i, 1
  %gep9386 = getelementptr double, ptr %invariant.gep9385, i64 %.361.0604.8.i
  store double 1.000000e-09, ptr %gep9386, align 8, !noalias !204
  %exitcond.8.not.i = icmp eq i64 %arg.shape.0, %.430.8.i
  br i1 %exitcond.8.not.i, label %B116.loopexit.8.i, label %B150.if.8.i

B116.loopexit.8.i:                                ; preds = %B150.if.8.i, %B3418
  %.227.i.i = load double, ptr %.226.i.i, align 8, !noalias !208
  %.256.i.i = load double, ptr %arg.batch.2.4, align 8, !noalias !208
  br label %B246.if.i.i

B280.loopexit.i.i:                                ; preds = %B122.if.i.i.i9023, %switch.end.i.i9019
  %exitcond1308.not.i.i = icmp eq i64 %arg.shape.0, %.533.i.i9017
  br i1 %exitcond1308.not.i.i, label %B348.i.i8966, label %B280.if.i.i

B348.i.i8966:                                     ; preds = %B280.loopexit.i.i, %B246.if.i.i
  %.634.i.i = icmp ult i64 %.341.01295.i.i, 8
  %.1280.i.i = select i1 %.634.i.i, i64 16, i64 17
  %.644.i.i = mul nsw i64 %.341.01295.i.i, 3
  %.6501276.i.i = add nsw i64 %.644.i.i, 1
  %.672.i.i = mul i64 %.6501276.i.i, %arg.shape.0
  %.707.i.i = load i64, ptr %.706.i.i, align 8, !noalias !208
  %.782.i.i = mul i64 %.1280.i.i, %.463
  %.800.i.i8967 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.782.i.i
  %.825.i.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %.672.i.i
  %.826.i.i = inttoptr i64 %.707.i.i to ptr
  tail call void %.826.i.i(ptr %.571, ptr %.800.i.i8967, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.825.i.i), !noalias !208
  %.399.i.i = icmp sgt i64 %.344.01296.i.i, 1
  br i1 %.399.i.i, label %B246.if.i.i, label %B550.i.i

B550.i.i:                                         ; preds = %B348.i.i8966
  br i1 %.5201292.not.i.i, label %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B584.lr.ph.i.i

B584.lr.ph.i.i:                                   ; preds = %B550.i.i
  %.257.i.i = fsub double %.227.i.i, %.256.i.i
  %.258.i.i8980 = fmul double %.257.i.i, 1.000000e-13
  %.1863.i.i = fmul double %.258.i.i8980, 2.000000e+00
  br label %B584.i.i

B584.i.i:                                         ; preds = %B1342.i.i, %B584.lr.ph.i.i
  %.924.sroa.0.01305.i.i = phi i64 [ 0, %B584.lr.ph.i.i ], [ %.924.sroa.0.0.i.i, %B1342.i.i ]
  %.880.11304.i.i = phi i64 [ %.880.11300.i.i, %B584.lr.ph.i.i ], [ %.880.1.i.i, %B1342.i.i ]
  %.877.11303.i.i = phi i64 [ 1, %B584.lr.ph.i.i ], [ %.877.1.i.i, %B1342.i.i ]
  %some.2.01302.i.i = phi i1 [ false, %B584.lr.ph.i.i ], [ %some.3.1.i.i, %B1342.i.i ]
  %excinfo.3.01301.i.i = phi ptr [ null, %B584.lr.ph.i.i ], [ %excinfo.3.1.i.i, %B1342.i.i ]
  %.1009.i.i = icmp slt i64 %.924.sroa.0.01305.i.i, 0
  %.1010.i.i = select i1 %.1009.i.i, i64 %arg.batch.4.0.5.1, i64 0
  %.1011.i.i = add i64 %.1010.i.i, %.924.sroa.0.01305.i.i
  %.1032.i.i = getelementptr double, ptr %70, i64 %.1011.i.i
  %.1033.i.i = load double, ptr %.1032.i.i, align 8, !noalias !208
  %.1065.i.i = select i1 %.1009.i.i, i64 %arg.batch.4.1.5.1, i64 0
  %.1066.i.i = add i64 %.1065.i.i, %.924.sroa.0.01305.i.i
  %.1087.i.i = getelementptr i64, ptr %71, i64 %.1066.i.i
  store i64 -1, ptr %.1087.i.i, align 8, !noalias !208
  %.1142.i.i = getelementptr double, ptr %.571, i64 %.1011.i.i
  store double %.1033.i.i, ptr %.1142.i.i, align 8, !noalias !208
  %.1197.i.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1066.i.i
  %.1198.i.i = load i64, ptr %.1197.i.i, align 8, !noalias !208
  %.1199.i.i = icmp sgt i64 %.1198.i.i, -1
  br i1 %.1199.i.i, label %B702.i.i8981, label %B1342.i.i

B702.i.i8981:                                     ; preds = %B584.i.i
  %.1257.i.i = getelementptr double, ptr %72, i64 %.1011.i.i
  %.1258.i.i = load double, ptr %.1257.i.i, align 8, !noalias !208
  %.1259.i.i = fcmp ogt double %.1258.i.i, 5.000000e-01
  br i1 %.1259.i.i, label %B742.i.i, label %B1342.i.i

B742.i.i:                                         ; preds = %B702.i.i8981
  %.1349.i.i = load i64, ptr %.1087.i.i, align 8, !noalias !208
  %.1350.i.i = icmp slt i64 %.1349.i.i, 0
  br i1 %.1350.i.i, label %B830.i.i, label %B958.i.i

B830.i.i:                                         ; preds = %B742.i.i, %B830.i.i
  %last.2.3.i.i = phi i64 [ %.1356.i.i, %B830.i.i ], [ %.1281.i.i, %B742.i.i ]
  %.1356.i.i = add nsw i64 %last.2.3.i.i, 1
  %.151.i51.i.i = mul nsw i64 %.1356.i.i, 3
  %.155.i.i.i9013 = add nsw i64 %.151.i51.i.i, 1
  %.159.i.i.i9014 = mul nsw i64 %.155.i.i.i9013, %arg.shape.0
  %.161.i.i.i = add nsw i64 %.159.i.i.i9014, %.924.sroa.0.01305.i.i
  %.175.i63.i.i = icmp slt i64 %.161.i.i.i, 0
  %.176.i64.i.i = select i1 %.175.i63.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %290 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i.i
  %.190.i.i.i = getelementptr double, ptr %290, i64 %.176.i64.i.i
  %.191.i.i.i9015 = load double, ptr %.190.i.i.i, align 8, !noalias !212
  %.195.i80.i.i = add nsw i64 %.161.i.i.i, %arg.shape.0
  %.209.i.i.i = icmp slt i64 %.195.i80.i.i, 0
  %.210.i.i.i9016 = select i1 %.209.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %291 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i80.i.i
  %.224.i91.i.i = getelementptr double, ptr %291, i64 %.210.i.i.i9016
  %.225.i92.i.i = load double, ptr %.224.i91.i.i, align 8, !noalias !212
  %.226.i93.i.i = fneg double %.225.i92.i.i
  %.227.i94.i.i = fcmp uge double %.191.i.i.i9015, %.226.i93.i.i
  %.1371.0.i.i = sext i1 %.227.i94.i.i to i64
  store i64 %.1371.0.i.i, ptr %.1087.i.i, align 8, !noalias !208
  %exitcond1310.not.i.i = icmp ne i64 %last.2.3.i.i, 7
  %brmerge.not.i.i = and i1 %exitcond1310.not.i.i, %.227.i94.i.i
  br i1 %brmerge.not.i.i, label %B830.i.i, label %B958.i.i

B958.i.i:                                         ; preds = %B830.i.i, %B742.i.i
  %last.3.2.i.i = phi i64 [ %.1281.i.i, %B742.i.i ], [ %.1356.i.i, %B830.i.i ]
  br i1 %.296.i.i8963, label %B966.i.i9004, label %B996.i.i

B966.i.i9004:                                     ; preds = %B958.i.i
  %292 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2.i.i
  %switch.gep9508 = getelementptr i8, ptr %292, i64 64
  %switch.load9509 = load double, ptr %switch.gep9508, align 8
  br label %B996.i.i

B996.i.i:                                         ; preds = %B966.i.i9004, %B958.i.i
  %"$phi996.1.2.2.i.i" = phi double [ 0.000000e+00, %B958.i.i ], [ %switch.load9509, %B966.i.i9004 ]
  %.1630.i.i = getelementptr double, ptr %73, i64 %.1011.i.i
  store double %"$phi996.1.2.2.i.i", ptr %.1630.i.i, align 8, !noalias !208
  %293 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2.i.i
  %switch.gep9512 = getelementptr i8, ptr %293, i64 72
  %switch.load9513 = load double, ptr %switch.gep9512, align 8
  %.1722.i.i8985 = getelementptr double, ptr %74, i64 %.1011.i.i
  store double %switch.load9513, ptr %.1722.i.i8985, align 8, !noalias !208
  %.1778.i.i = load i64, ptr %.1087.i.i, align 8, !noalias !208
  %.1779.i.i = icmp sgt i64 %.1778.i.i, -1
  %.1789.i.i8986 = sext i1 %.1779.i.i to i64
  %"$phi1114.1.2.2.i.i" = add nsw i64 %last.3.2.i.i, %.1789.i.i8986
  br i1 %.296.i.i8963, label %B1122.i.i, label %B1300.i.i

B1122.i.i:                                        ; preds = %B996.i.i
  %.1860.i.i = getelementptr double, ptr %69, i64 %.1011.i.i
  %.1861.i.i = load double, ptr %.1860.i.i, align 8, !noalias !208
  %.1864.i.i8987 = fcmp ogt double %.1861.i.i, %.1863.i.i
  br i1 %.1864.i.i8987, label %B1170.i.i, label %B1300.i.i

B1170.i.i:                                        ; preds = %B1122.i.i
  %294 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1114.1.2.2.i.i", i64 0)
  %storemerge.i.i.i = tail call i64 @llvm.smin.i64(i64 %294, i64 7)
  %.310338.i.i.i = icmp sgt i64 %"$phi1114.1.2.2.i.i", 0
  %.253.1340.i.i.i = select i1 %.310338.i.i.i, i64 2, i64 1
  %.319341.i.i.i = sext i1 %.310338.i.i.i to i64
  %.256.1342.i.i.i = add nsw i64 %storemerge.i.i.i, %.319341.i.i.i
  %.300.sroa.0.0343.i.i.i = zext i1 %.310338.i.i.i to i64
  %.160.i.i.i = add nsw i64 %.924.sroa.0.01305.i.i, %arg.shape.0
  %.192.i.i.i.i = add nsw i64 %.160.i.i.i, %.30.i.i.i
  %.206.i.i.i.i = icmp slt i64 %.192.i.i.i.i, 0
  %.207.i.i.i.i = select i1 %.206.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %295 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i.i
  %.221.i.i.i.i = getelementptr double, ptr %295, i64 %.207.i.i.i.i
  %.472.i.i.i.i = icmp slt i64 %.160.i.i.i, 0
  %.473.i.i.i.i = select i1 %.472.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %296 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i.i
  %.487.i.i.i.i = getelementptr double, ptr %296, i64 %.473.i.i.i.i
  %.458.i.1.i.i.i = add nsw i64 %.160.i.i.i, %.454.i.i.i.i
  %.472.i.1.i.i.i = icmp slt i64 %.458.i.1.i.i.i, 0
  %.473.i.1.i.i.i = select i1 %.472.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %297 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i.i
  %.487.i.1.i.i.i = getelementptr double, ptr %297, i64 %.473.i.1.i.i.i
  %.458.i.2.i.i.i = add nsw i64 %.160.i.i.i, %.456.i.2.i.i.i
  %.472.i.2.i.i.i = icmp slt i64 %.458.i.2.i.i.i, 0
  %.473.i.2.i.i.i = select i1 %.472.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %298 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i.i
  %.487.i.2.i.i.i = getelementptr double, ptr %298, i64 %.473.i.2.i.i.i
  %.458.i.3.i.i.i = add nsw i64 %.160.i.i.i, %.456.i.3.i.i.i
  %.472.i.3.i.i.i = icmp slt i64 %.458.i.3.i.i.i, 0
  %.473.i.3.i.i.i = select i1 %.472.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %299 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i.i
  %.487.i.3.i.i.i = getelementptr double, ptr %299, i64 %.473.i.3.i.i.i
  %.458.i.4.i.i.i = add nsw i64 %.160.i.i.i, %.456.i.4.i.i.i
  %.472.i.4.i.i.i = icmp slt i64 %.458.i.4.i.i.i, 0
  %.473.i.4.i.i.i = select i1 %.472.i.4.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %300 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i.i
  %.487.i.4.i.i.i = getelementptr double, ptr %300, i64 %.473.i.4.i.i.i
  %.192.i.1.i.i.i = add nsw i64 %.160.i.i.i, %.190.i.1.i.i.i
  %.206.i.1.i.i.i = icmp slt i64 %.192.i.1.i.i.i, 0
  %.207.i.1.i.i.i = select i1 %.206.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %301 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i.i
  %.221.i.1.i.i.i = getelementptr double, ptr %301, i64 %.207.i.1.i.i.i
  %.192.i.2.i.i.i = add nsw i64 %.160.i.i.i, %.190.i.2.i.i.i
  %.206.i.2.i.i.i = icmp slt i64 %.192.i.2.i.i.i, 0
  %.207.i.2.i.i.i = select i1 %.206.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %302 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i.i
  %.221.i.2.i.i.i = getelementptr double, ptr %302, i64 %.207.i.2.i.i.i
  %.192.i.3.i.i.i = add nsw i64 %.160.i.i.i, %.190.i.3.i.i.i
  %.206.i.3.i.i.i = icmp slt i64 %.192.i.3.i.i.i, 0
  %.207.i.3.i.i.i = select i1 %.206.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %303 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i.i
  %.221.i.3.i.i.i = getelementptr double, ptr %303, i64 %.207.i.3.i.i.i
  %.929.i.i.i = add nsw i64 %.160.i.i.i, %arg.shape.0
  %.945.i.i.i = icmp slt i64 %.929.i.i.i, 0
  %.946.i.i.i = select i1 %.945.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %304 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.929.i.i.i
  %.960.i.i.i = getelementptr double, ptr %304, i64 %.946.i.i.i
  br label %B50.i.i.i

B50.i.i.i:                                        ; preds = %B860.i.i.i, %B1170.i.i
  %exitcond.not.i.i.i = phi i1 [ false, %B1170.i.i ], [ true, %B860.i.i.i ]
  br i1 %exitcond.not.i.i.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B52.if.i.i.i

B216.i.i.i:                                       ; preds = %B216.lr.ph.i.i.i, %B935.i.i.i
  %.300.sroa.0.0347.i.i.i = phi i64 [ %.300.sroa.0.0343.i.i.i, %B216.lr.ph.i.i.i ], [ %.300.sroa.0.0.i.i.i, %B935.i.i.i ]
  %.256.1346.i.i.i = phi i64 [ %.256.1342.i.i.i, %B216.lr.ph.i.i.i ], [ %.256.1.i.i.i, %B935.i.i.i ]
  %.253.1345.i.i.i = phi i64 [ %.253.1340.i.i.i, %B216.lr.ph.i.i.i ], [ %.253.1.i.i.i, %B935.i.i.i ]
  %nearest.3.1344.i.i.i = phi double [ 0x7FF0000000000000, %B216.lr.ph.i.i.i ], [ %nearest.4.2.i.i.i, %B935.i.i.i ]
  %.352.i.i.i = add nsw i64 %.300.sroa.0.0347.i.i.i, -1
  %.354.i.i.i8989 = mul nsw i64 %.352.i.i.i, %.30.i.i.i
  %.356.i.i.i = add nsw i64 %.354.i.i.i8989, %.160.i.i.i
  %.370.i.i.i = icmp slt i64 %.356.i.i.i, 0
  %.371.i.i.i = select i1 %.370.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %305 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.356.i.i.i
  %.385.i.i.i = getelementptr double, ptr %305, i64 %.371.i.i.i
  %.386.i.i.i = load double, ptr %.385.i.i.i, align 8, !noalias !216
  %.389.i.i.i = mul nsw i64 %.300.sroa.0.0347.i.i.i, %.30.i.i.i
  %.391.i.i.i = add nsw i64 %.389.i.i.i, %.160.i.i.i
  %.405.i.i.i = icmp slt i64 %.391.i.i.i, 0
  %.406.i.i.i = select i1 %.405.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %306 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.391.i.i.i
  %.420.i.i.i = getelementptr double, ptr %306, i64 %.406.i.i.i
  %.421.i.i.i = load double, ptr %.420.i.i.i, align 8, !noalias !216
  %.423.i.i.i = add nsw i64 %.300.sroa.0.0347.i.i.i, 1
  %.425.i.i.i = mul nsw i64 %.423.i.i.i, %.30.i.i.i
  %.427.i.i.i = add nsw i64 %.425.i.i.i, %.160.i.i.i
  %.441.i.i.i = icmp slt i64 %.427.i.i.i, 0
  %.442.i.i.i = select i1 %.441.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %307 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.427.i.i.i
  %.456.i.i.i = getelementptr double, ptr %307, i64 %.442.i.i.i
  %.457.i.i.i = load double, ptr %.456.i.i.i, align 8, !noalias !216
  %.480.i1282.i.i = fcmp olt double %.421.i.i.i, 0.000000e+00
  %.483.i.i.i = fneg double %.386.i.i.i
  %.487.i.i.i8990 = fneg double %.421.i.i.i
  %.491.i.i.i8991 = fneg double %.457.i.i.i
  %c.2.2.i.i.i = select i1 %.480.i1282.i.i, double %.491.i.i.i8991, double %.457.i.i.i
  %b.2.2.i.i.i = select i1 %.480.i1282.i.i, double %.487.i.i.i8990, double %.421.i.i.i
  %a.2.2.i.i.i = select i1 %.480.i1282.i.i, double %.483.i.i.i, double %.386.i.i.i
  %.508.i.i.i = icmp eq i64 %.300.sroa.0.0347.i.i.i, 1
  %.515.i.i.i = fcmp ogt double %a.2.2.i.i.i, 0.000000e+00
  %or.cond.i.i.i = select i1 %.508.i.i.i, i1 true, i1 %.515.i.i.i
  br i1 %or.cond.i.i.i, label %B368.i.i.i, label %B424.i.i.i

B368.i.i.i:                                       ; preds = %B216.i.i.i
  %.521.i.i.i = icmp eq i64 %.300.sroa.0.0347.i.i.i, %"$phi1114.1.2.2.i.i"
  %.527.i.i.i = fcmp ogt double %c.2.2.i.i.i, 0.000000e+00
  %or.cond306.i.i.i = select i1 %.521.i.i.i, i1 true, i1 %.527.i.i.i
  br i1 %or.cond306.i.i.i, label %B392.i.i.i, label %B424.i.i.i

B392.i.i.i:                                       ; preds = %B368.i.i.i
  %.10.i.i.i.i8995 = fcmp olt double %b.2.2.i.i.i, %nearest.3.1344.i.i.i
  %.11.i.i.i.i8996 = select i1 %.10.i.i.i.i8995, double %b.2.2.i.i.i, double %nearest.3.1344.i.i.i
  br label %B424.i.i.i

B424.i.i.i:                                       ; preds = %B392.i.i.i, %B368.i.i.i, %B216.i.i.i
  %nearest.6.3.i.i.i = phi double [ %.11.i.i.i.i8996, %B392.i.i.i ], [ %nearest.3.1344.i.i.i, %B368.i.i.i ], [ %nearest.3.1344.i.i.i, %B216.i.i.i ]
  %.572.i.i.i = icmp slt i64 %.300.sroa.0.0347.i.i.i, %"$phi1114.1.2.2.i.i"
  br i1 %.572.i.i.i, label %B436.i.i.i, label %B935.i.i.i

B436.i.i.i:                                       ; preds = %B424.i.i.i
  %.581.i.i.i = fsub double %a.2.2.i.i.i, %b.2.2.i.i.i
  %.582.i.i.i = tail call double @llvm.fabs.f64(double %.581.i.i.i)
  %.585.i.i.i = fsub double %c.2.2.i.i.i, %b.2.2.i.i.i
  %.586.i.i.i8992 = tail call double @llvm.fabs.f64(double %.585.i.i.i)
  %.587.i.i.i8993 = fadd double %.582.i.i.i, %.586.i.i.i8992
  %.588.i.i.i8994 = fmul double %.587.i.i.i8993, 3.000000e+00
  %.589.i.i.i = fadd double %.578.i.i.i, %.588.i.i.i8994
  %.591.i.i.i = fcmp olt double %b.2.2.i.i.i, %.589.i.i.i
  br i1 %.591.i.i.i, label %B546.i.i.i, label %B935.i.i.i

B546.i.i.i:                                       ; preds = %B436.i.i.i
  %switch.tableidx9514 = add i64 %.300.sroa.0.0347.i.i.i, 9
  %308 = icmp ult i64 %switch.tableidx9514, 18
  br i1 %308, label %switch.lookup9515, label %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B752.i.i.i:                                       ; preds = %switch.lookup9527
  %.800.i.i.i = fneg double %.741.i.i.i
  %.804.i.i.i = fmul double %.790.i.i.i, 5.000000e-01
  %.809.i.i.i = fdiv double %.804.i.i.i, %.773.i.i.i
  %.810.i.i.i = fcmp ogt double %.809.i.i.i, %.800.i.i.i
  %.820.i.i.i = fcmp olt double %.809.i.i.i, %.667.i.i.i
  %or.cond308.i.i.i = and i1 %.810.i.i.i, %.820.i.i.i
  br i1 %or.cond308.i.i.i, label %B792.i.i.i, label %B935.i.i.i

B792.i.i.i:                                       ; preds = %B752.i.i.i
  %.847.i.i.i = fmul double %.790.i.i.i, 2.500000e-01
  %.849.i.i.i = fmul double %.790.i.i.i, %.847.i.i.i
  %.856.i.i.i = fdiv double %.849.i.i.i, %.773.i.i.i
  %.860.i.i.i = fsub double %b.2.2.i.i.i, %.856.i.i.i
  %.10.i309.i.i.i = fcmp olt double %.860.i.i.i, %nearest.6.3.i.i.i
  %.11.i310.i.i.i = select i1 %.10.i309.i.i.i, double %.860.i.i.i, double %nearest.6.3.i.i.i
  br label %B935.i.i.i

B860.i.i.i:                                       ; preds = %B935.i.i.i, %B52.if.i.i.i
  %nearest.3.1.lcssa.i.i.i = phi double [ 0x7FF0000000000000, %B52.if.i.i.i ], [ %nearest.4.2.i.i.i, %B935.i.i.i ]
  %.961.i.i.i = load double, ptr %.960.i.i.i, align 8, !noalias !216
  %.963.i.i.i = fcmp ule double %.11.i.i.3.i.i.i, %.961.i.i.i
  %.966.i.i.i = fmul double %.11.i.i.3.i.i.i, 1.000000e+01
  %.970.i.i.i = fcmp ugt double %nearest.3.1.lcssa.i.i.i, %.966.i.i.i
  %or.cond307.i.i.i = select i1 %.963.i.i.i, i1 true, i1 %.970.i.i.i
  br i1 %or.cond307.i.i.i, label %B50.i.i.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B935.i.i.i:                                       ; preds = %switch.lookup9527, %B792.i.i.i, %B752.i.i.i, %B436.i.i.i, %B424.i.i.i
  %nearest.4.2.i.i.i = phi double [ %nearest.6.3.i.i.i, %B752.i.i.i ], [ %.11.i310.i.i.i, %B792.i.i.i ], [ %nearest.6.3.i.i.i, %B424.i.i.i ], [ %nearest.6.3.i.i.i, %switch.lookup9527 ], [ %nearest.6.3.i.i.i, %B436.i.i.i ]
  %.310.i.i.i = icmp sgt i64 %.256.1346.i.i.i, 0
  %.323.i.i.i = zext i1 %.310.i.i.i to i64
  %.253.1.i.i.i = add i64 %.253.1345.i.i.i, %.323.i.i.i
  %.319.i.i.i = sext i1 %.310.i.i.i to i64
  %.256.1.i.i.i = add nsw i64 %.256.1346.i.i.i, %.319.i.i.i
  %.300.sroa.0.0.i.i.i = select i1 %.310.i.i.i, i64 %.253.1345.i.i.i, i64 0
  br i1 %.310.i.i.i, label %B216.i.i.i, label %B860.i.i.i

B52.if.i.i.i:                                     ; preds = %B50.i.i.i
  %.222.i.i.i.i = load double, ptr %.221.i.i.i.i, align 8, !noalias !220
  %.488.i.i.i.i = load double, ptr %.487.i.i.i.i, align 8, !noalias !220
  %.489.i.i.i.i = fmul double %.488.i.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i.i = fsub double %.222.i.i.i.i, %.489.i.i.i.i
  %.488.i.1.i.i.i = load double, ptr %.487.i.1.i.i.i, align 8, !noalias !220
  %.489.i.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i.i = fsub double %.491.i.i.i.i, %.489.i.1.i.i.i
  %.488.i.2.i.i.i = load double, ptr %.487.i.2.i.i.i, align 8, !noalias !220
  %.489.i.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1306AA3D795F4
  %309 = fadd double %.491.i.1.i.i.i, %.489.i.2.i.i.i
  %.488.i.3.i.i.i = load double, ptr %.487.i.3.i.i.i, align 8, !noalias !220
  %.489.i.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i.i = fsub double %309, %.489.i.3.i.i.i
  %.488.i.4.i.i.i = load double, ptr %.487.i.4.i.i.i, align 8, !noalias !220
  %.489.i.4.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA4EAF2D6B11E79
  %310 = fadd double %.491.i.3.i.i.i, %.489.i.4.i.i.i
  %.502.i.i.i.i = tail call double @llvm.fabs.f64(double %310)
  %.10.i.i.i.i.i = fcmp ogt double %.502.i.i.i.i, 0.000000e+00
  %.11.i.i.i.i.i = select i1 %.10.i.i.i.i.i, double %.502.i.i.i.i, double 0.000000e+00
  %.222.i.1.i.i.i = load double, ptr %.221.i.1.i.i.i, align 8, !noalias !220
  %.489.i.1383.i.i.i = fmul double %.488.i.i.i.i, 0x3FA5118805F8B876
  %311 = fadd double %.489.i.1383.i.i.i, %.222.i.1.i.i.i
  %.489.i.1.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i.i = fsub double %311, %.489.i.1.1.i.i.i
  %.489.i.2.1.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i.i = fsub double %.491.i.1.1.i.i.i, %.489.i.2.1.i.i.i
  %.489.i.3.1.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FC0DA0C684D1D67
  %312 = fadd double %.489.i.3.1.i.i.i, %.491.i.2.1.i.i.i
  %.489.i.4.1.i.i.i = fmul double %.488.i.4.i.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i.i = fsub double %312, %.489.i.4.1.i.i.i
  %.502.i.1.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i.i)
  %.10.i.i.1.i.i.i = fcmp ogt double %.502.i.1.i.i.i, %.11.i.i.i.i.i
  %.11.i.i.1.i.i.i = select i1 %.10.i.i.1.i.i.i, double %.502.i.1.i.i.i, double %.11.i.i.i.i.i
  %.222.i.2.i.i.i = load double, ptr %.221.i.2.i.i.i, align 8, !noalias !220
  %.489.i.2410.i.i.i = fmul double %.488.i.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2411.i.i.i = fsub double %.222.i.2.i.i.i, %.489.i.2410.i.i.i
  %.489.i.1.2.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FC1EAE0FF33D241
  %313 = fadd double %.489.i.1.2.i.i.i, %.491.i.2411.i.i.i
  %.489.i.2.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i.i = fsub double %313, %.489.i.2.2.i.i.i
  %.489.i.3.2.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i.i = fsub double %.491.i.2.2.i.i.i, %.489.i.3.2.i.i.i
  %.489.i.4.2.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA55161A739EB34
  %314 = fadd double %.489.i.4.2.i.i.i, %.491.i.3.2.i.i.i
  %.502.i.2.i.i.i = tail call double @llvm.fabs.f64(double %314)
  %.10.i.i.2.i.i.i = fcmp ogt double %.502.i.2.i.i.i, %.11.i.i.1.i.i.i
  %.11.i.i.2.i.i.i = select i1 %.10.i.i.2.i.i.i, double %.502.i.2.i.i.i, double %.11.i.i.1.i.i.i
  %.222.i.3.i.i.i = load double, ptr %.221.i.3.i.i.i, align 8, !noalias !220
  %.489.i.3437.i.i.i = fmul double %.488.i.i.i.i, 0x3FA4F0C0BB579409
  %315 = fadd double %.489.i.3437.i.i.i, %.222.i.3.i.i.i
  %.489.i.1.3.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i.i = fsub double %315, %.489.i.1.3.i.i.i
  %.489.i.2.3.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1F2DB6FEE3151
  %316 = fadd double %.489.i.2.3.i.i.i, %.491.i.1.3.i.i.i
  %.489.i.3.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i.i = fsub double %316, %.489.i.3.3.i.i.i
  %.489.i.4.3.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i.i = fsub double %.491.i.3.3.i.i.i, %.489.i.4.3.i.i.i
  %.502.i.3.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i.i)
  %.10.i.i.3.i.i.i = fcmp ogt double %.502.i.3.i.i.i, %.11.i.i.2.i.i.i
  %.11.i.i.3.i.i.i = select i1 %.10.i.i.3.i.i.i, double %.502.i.3.i.i.i, double %.11.i.i.2.i.i.i
  br i1 %.310338.i.i.i, label %B216.lr.ph.i.i.i, label %B860.i.i.i

B216.lr.ph.i.i.i:                                 ; preds = %B52.if.i.i.i
  %.578.i.i.i = fmul double %.11.i.i.3.i.i.i, 1.000000e+01
  br label %B216.i.i.i

switch.lookup9515:                                ; preds = %B546.i.i.i
  %switch.tableidx9518 = add i64 %.300.sroa.0.0347.i.i.i, 8
  %317 = icmp ult i64 %switch.tableidx9518, 18
  br i1 %317, label %switch.lookup9519, label %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9519:                                ; preds = %switch.lookup9515
  %switch.gep9516 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9514
  %switch.load9517 = load double, ptr %switch.gep9516, align 8
  %switch.gep9520 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9518
  %switch.load9521 = load double, ptr %switch.gep9520, align 8
  %.667.i.i.i = fsub double %switch.load9517, %switch.load9521
  %switch.tableidx9522 = add i64 %.300.sroa.0.0347.i.i.i, 10
  %318 = icmp ult i64 %switch.tableidx9522, 18
  br i1 %318, label %switch.lookup9523, label %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9523:                                ; preds = %switch.lookup9519
  %switch.tableidx9526 = add i64 %.300.sroa.0.0347.i.i.i, 9
  %319 = icmp ult i64 %switch.tableidx9526, 18
  br i1 %319, label %switch.lookup9527, label %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9527:                                ; preds = %switch.lookup9523
  %switch.gep9524 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9522
  %switch.load9525 = load double, ptr %switch.gep9524, align 8
  %switch.gep9528 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx9526
  %switch.load9529 = load double, ptr %switch.gep9528, align 8
  %.741.i.i.i = fsub double %switch.load9525, %switch.load9529
  %.757.i.i.i = fdiv double %.585.i.i.i, %.741.i.i.i
  %.760.i.i.i = fsub double %b.2.2.i.i.i, %a.2.2.i.i.i
  %.765.i.i.i = fdiv double %.760.i.i.i, %.667.i.i.i
  %.766.i.i.i = fsub double %.757.i.i.i, %.765.i.i.i
  %.769.i.i.i = fadd double %.667.i.i.i, %.741.i.i.i
  %.773.i.i.i = fdiv double %.766.i.i.i, %.769.i.i.i
  %.789.i.i.i = fmul double %.667.i.i.i, %.773.i.i.i
  %.790.i.i.i = fadd double %.765.i.i.i, %.789.i.i.i
  %.795.i.i.i = fcmp ogt double %.773.i.i.i, 0.000000e+00
  br i1 %.795.i.i.i, label %B752.i.i.i, label %B935.i.i.i

_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B860.i.i.i, %B50.i.i.i, %B546.i.i.i, %switch.lookup9515, %switch.lookup9519, %switch.lookup9523
  %.1897.not.i.i = phi i1 [ true, %B546.i.i.i ], [ true, %switch.lookup9523 ], [ true, %switch.lookup9519 ], [ true, %switch.lookup9515 ], [ %exitcond.not.i.i.i, %B50.i.i.i ], [ %exitcond.not.i.i.i, %B860.i.i.i ]
  %excinfo.3.3.i.i = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %B546.i.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %switch.lookup9523 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %switch.lookup9519 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.106, %switch.lookup9515 ], [ %excinfo.3.01301.i.i, %B50.i.i.i ], [ %excinfo.3.01301.i.i, %B860.i.i.i ]
  %.1886.not.i.i = phi i1 [ false, %B546.i.i.i ], [ false, %switch.lookup9523 ], [ false, %switch.lookup9519 ], [ false, %switch.lookup9515 ], [ true, %B50.i.i.i ], [ true, %B860.i.i.i ]
  br i1 %.1886.not.i.i, label %B1170.endif.endif.i.i, label %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, !prof !53

B1208.i.i:                                        ; preds = %B1170.endif.endif.i.i
  %.1972.i.i = fmul double %.1861.i.i, 5.000000e-01
  store double 0.000000e+00, ptr %.1257.i.i, align 8, !noalias !224
  %.161.i230.i.i = getelementptr double, ptr %75, i64 %.1011.i.i
  store double 0.000000e+00, ptr %.161.i230.i.i, align 8, !noalias !224
  %.214.i273.i.i = getelementptr double, ptr %76, i64 %.1011.i.i
  store double %.1972.i.i, ptr %.214.i273.i.i, align 8, !noalias !224
  %.268.i313.i.i = load i64, ptr %.1197.i.i, align 8, !noalias !224
  %.294.i.i.i = icmp slt i64 %.268.i313.i.i, 0
  %.295.i.i.i = select i1 %.294.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i324.i.i = add i64 %.295.i.i.i, %.268.i313.i.i
  %.316.i333.i.i = mul i64 %.296.i324.i.i, %arg.batch.3.3.5.1
  %.320.i.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i333.i.i
  %.321.i.i.i = load i64, ptr %.320.i.i.i, align 8, !noalias !224
  %.322.i336.i.i = add nsw i64 %.321.i.i.i, -1
  store i64 %.322.i336.i.i, ptr %.320.i.i.i, align 8, !noalias !224
  %.426.i.i.i = load i64, ptr %.1197.i.i, align 8, !noalias !224
  %.452.i.i.i = icmp slt i64 %.426.i.i.i, 0
  %.453.i.i.i = select i1 %.452.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i.i8988 = add i64 %.453.i.i.i, %.426.i.i.i
  %.474.i.i.i = mul i64 %.454.i.i.i8988, %arg.batch.3.3.5.1
  %320 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i.i
  %.478.i.i.i = getelementptr i8, ptr %320, i64 24
  %.479.i.i.i = load i64, ptr %.478.i.i.i, align 8, !noalias !224
  %.480.i.i.i = add nsw i64 %.479.i.i.i, 1
  store i64 %.480.i.i.i, ptr %.478.i.i.i, align 8, !noalias !224
  store i64 -1, ptr %.1087.i.i, align 8, !noalias !208
  br label %B1300.i.i

B1300.i.i:                                        ; preds = %B1170.endif.endif.i.i, %B996.i.i, %B1208.i.i, %B1122.i.i
  %excinfo.3.2.i.i = phi ptr [ %excinfo.3.3.i.i, %B1170.endif.endif.i.i ], [ %excinfo.3.3.i.i, %B1208.i.i ], [ %excinfo.3.01301.i.i, %B1122.i.i ], [ %excinfo.3.01301.i.i, %B996.i.i ]
  br i1 %some.2.01302.i.i, label %B1342.i.i, label %B1304.i.i

B1304.i.i:                                        ; preds = %B1300.i.i
  %.2136.i.i = load i64, ptr %.1087.i.i, align 8, !noalias !208
  %.2137.i.i = icmp sgt i64 %.2136.i.i, -1
  br label %B1342.i.i

B1342.i.i:                                        ; preds = %B1304.i.i, %B1300.i.i, %B702.i.i8981, %B584.i.i
  %excinfo.3.1.i.i = phi ptr [ %excinfo.3.2.i.i, %B1300.i.i ], [ %excinfo.3.2.i.i, %B1304.i.i ], [ %excinfo.3.01301.i.i, %B702.i.i8981 ], [ %excinfo.3.01301.i.i, %B584.i.i ]
  %some.3.1.i.i = phi i1 [ true, %B1300.i.i ], [ %.2137.i.i, %B1304.i.i ], [ %some.2.01302.i.i, %B702.i.i8981 ], [ %some.2.01302.i.i, %B584.i.i ]
  %.934.i.i = icmp sgt i64 %.880.11304.i.i, 0
  %.947.i.i = zext i1 %.934.i.i to i64
  %.877.1.i.i = add i64 %.877.11303.i.i, %.947.i.i
  %.943.i.i = sext i1 %.934.i.i to i64
  %.880.1.i.i = add nsw i64 %.880.11304.i.i, %.943.i.i
  %.924.sroa.0.0.i.i = select i1 %.934.i.i, i64 %.877.11303.i.i, i64 0
  br i1 %.934.i.i, label %B584.i.i, label %B1346.loopexit.i.i

B1346.loopexit.i.i:                               ; preds = %B1342.i.i
  %321 = xor i1 %some.3.1.i.i, true
  br label %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i

B246.if.i.i:                                      ; preds = %B348.i.i8966, %B116.loopexit.8.i
  %.344.01296.i.i = phi i64 [ %.354.i.i8964, %B116.loopexit.8.i ], [ %.408.i.i, %B348.i.i8966 ]
  %.341.01295.i.i = phi i64 [ %..i.i, %B116.loopexit.8.i ], [ %.412.i.i, %B348.i.i8966 ]
  %.408.i.i = add nsw i64 %.344.01296.i.i, -1
  %.412.i.i = add nsw i64 %.341.01295.i.i, 1
  br i1 %.5201292.not.i.i, label %B348.i.i8966, label %B280.if.i.i.preheader

B280.if.i.i.preheader:                            ; preds = %B246.if.i.i
  %322 = icmp ult i64 %.341.01295.i.i, 8
  %switch.gep9531 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.21, i64 %.341.01295.i.i
  br label %B280.if.i.i

B280.if.i.i:                                      ; preds = %B280.if.i.i.preheader, %B280.loopexit.i.i
  %.464.01293.i.i = phi i64 [ %.533.i.i9017, %B280.loopexit.i.i ], [ 0, %B280.if.i.i.preheader ]
  %.533.i.i9017 = add nsw i64 %.464.01293.i.i, 1
  br i1 %322, label %switch.lookup9530, label %switch.end.i.i9019

switch.lookup9530:                                ; preds = %B280.if.i.i
  %switch.load9532 = load double, ptr %switch.gep9531, align 8
  br label %switch.end.i.i9019

switch.end.i.i9019:                               ; preds = %B280.if.i.i, %switch.lookup9530
  %.575.i.i = phi double [ %switch.load9532, %switch.lookup9530 ], [ 1.000000e+00, %B280.if.i.i ]
  %.92.i.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.464.01293.i.i
  %.93.i.i.i = load double, ptr %.92.i.i.i, align 8, !noalias !227
  %.146.i.i.i = getelementptr double, ptr %69, i64 %.464.01293.i.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !227
  %.149.i.i.i = fmul double %.575.i.i, %.147.i.i.i
  %.150.i.i.i9020 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.464.01293.i.i
  store double %.150.i.i.i9020, ptr %.203.i.i.i, align 8, !noalias !227
  br i1 %.287.i1289.not.i.i, label %B280.loopexit.i.i, label %B122.if.i.lr.ph.i.i

B122.if.i.lr.ph.i.i:                              ; preds = %switch.end.i.i9019
  %.247.i.i.i.i9021 = fsub double 1.000000e+00, %.575.i.i
  %invariant.gep.i9022 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.464.01293.i.i
  br label %B122.if.i.i.i9023

B122.if.i.i.i9023:                                ; preds = %B122.if.i.i.i9023, %B122.if.i.lr.ph.i.i
  %.229.i.01290.i.i = phi i64 [ 0, %B122.if.i.lr.ph.i.i ], [ %.300.i.i.i, %B122.if.i.i.i9023 ]
  %.157.i.i.i.i9024 = add nsw i64 %.229.i.01290.i.i, %.155.i.i.i.i8965
  %.159.i.i.i.i9025 = mul nsw i64 %.157.i.i.i.i9024, %arg.shape.0
  %gep.i9026 = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.i.i9025
  %.191.i.i.i.i9027 = load double, ptr %gep.i9026, align 8, !noalias !231
  %.193.i.i.i.i9028 = fadd double %.191.i.i.i.i9027, 0.000000e+00
  %.253.i.i.i.i9029 = fmul double %.575.i.i, %.193.i.i.i.i9028
  %.157.i.i.1.i.i = add nsw i64 %.229.i.01290.i.i, %.155.i.i.1.i.i
  %.159.i.i.1.i.i = mul nsw i64 %.157.i.i.1.i.i, %arg.shape.0
  %gep609.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.1.i.i
  %.191.i.i.1.i.i = load double, ptr %gep609.i, align 8, !noalias !231
  %.193.i.i.1.i.i = fadd double %.191.i.i.1.i.i, %.253.i.i.i.i9029
  %.253.i.i.1.i.i = fmul double %.247.i.i.i.i9021, %.193.i.i.1.i.i
  %.157.i.i.2.i.i = add nsw i64 %.229.i.01290.i.i, %.155.i.i.2.i.i
  %.159.i.i.2.i.i = mul nsw i64 %.157.i.i.2.i.i, %arg.shape.0
  %gep611.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.2.i.i
  %.191.i.i.2.i.i = load double, ptr %gep611.i, align 8, !noalias !231
  %.193.i.i.2.i.i = fadd double %.191.i.i.2.i.i, %.253.i.i.1.i.i
  %.253.i.i.2.i.i = fmul double %.575.i.i, %.193.i.i.2.i.i
  %.157.i.i.3.i.i = add nsw i64 %.229.i.01290.i.i, %.155.i.i.3.i.i
  %.159.i.i.3.i.i = mul nsw i64 %.157.i.i.3.i.i, %arg.shape.0
  %gep613.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.3.i.i
  %.191.i.i.3.i.i = load double, ptr %gep613.i, align 8, !noalias !231
  %.193.i.i.3.i.i = fadd double %.191.i.i.3.i.i, %.253.i.i.2.i.i
  %.253.i.i.3.i.i = fmul double %.247.i.i.i.i9021, %.193.i.i.3.i.i
  %.157.i.i.4.i.i = add nsw i64 %.229.i.01290.i.i, %.155.i.i.4.i.i
  %.159.i.i.4.i.i = mul nsw i64 %.157.i.i.4.i.i, %arg.shape.0
  %gep615.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.4.i.i
  %.191.i.i.4.i.i = load double, ptr %gep615.i, align 8, !noalias !231
  %.193.i.i.4.i.i = fadd double %.191.i.i.4.i.i, %.253.i.i.3.i.i
  %.253.i.i.4.i.i = fmul double %.575.i.i, %.193.i.i.4.i.i
  %.157.i.i.5.i.i = add nsw i64 %.229.i.01290.i.i, %.155.i.i.5.i.i
  %.159.i.i.5.i.i = mul nsw i64 %.157.i.i.5.i.i, %arg.shape.0
  %gep617.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.5.i.i
  %.191.i.i.5.i.i = load double, ptr %gep617.i, align 8, !noalias !231
  %.193.i.i.5.i.i = fadd double %.191.i.i.5.i.i, %.253.i.i.4.i.i
  %.253.i.i.5.i.i = fmul double %.247.i.i.i.i9021, %.193.i.i.5.i.i
  %.157.i.i.6.i.i = add nsw i64 %.229.i.01290.i.i, %.155.i.i.6.i.i
  %.159.i.i.6.i.i = mul nsw i64 %.157.i.i.6.i.i, %arg.shape.0
  %gep619.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.159.i.i.6.i.i
  %.191.i.i.6.i.i = load double, ptr %gep619.i, align 8, !noalias !231
  %.193.i.i.6.i.i = fadd double %.191.i.i.6.i.i, %.253.i.i.5.i.i
  %.253.i.i.6.i.i = fmul double %.575.i.i, %.193.i.i.6.i.i
  %.300.i.i.i = add nsw i64 %.229.i.01290.i.i, 1
  %.271.i.i.i.i9030 = mul nsw i64 %.229.i.01290.i.i, %arg.shape.0
  %gep621.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.271.i.i.i.i9030
  %.309.i.i.i.i9031 = load double, ptr %gep621.i, align 8, !noalias !231
  %.313.i.i.i.i9032 = fadd double %.309.i.i.i.i9031, %.253.i.i.6.i.i
  %.359.i.i.i = add nsw i64 %.229.i.01290.i.i, %.358.i.i.i
  %.361.i.i.i9033 = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep623.i = getelementptr double, ptr %invariant.gep.i9022, i64 %.361.i.i.i9033
  store double %.313.i.i.i.i9032, ptr %gep623.i, align 8, !noalias !227
  %exitcond.not.i.i9034 = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond.not.i.i9034, label %B280.loopexit.i.i, label %B122.if.i.i.i9023

B1170.endif.endif.i.i:                            ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %.1897.not.i.i, label %B1300.i.i, label %B1208.i.i

_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1346.loopexit.i.i, %B550.i.i
  %.512.0.i = phi i1 [ %321, %B1346.loopexit.i.i ], [ true, %B550.i.i ], [ true, %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %excinfo.1.0.i = phi ptr [ null, %B1346.loopexit.i.i ], [ null, %B550.i.i ], [ %excinfo.3.3.i.i, %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %common.ret.op.i.i.not = phi i1 [ false, %B1346.loopexit.i.i ], [ false, %B550.i.i ], [ true, %_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %brmerge9227 = select i1 %common.ret.op.i.i.not, i1 true, i1 %.512.0.i, !prof !93
  %brmerge9228 = or i1 %.5201292.not.i.i, %brmerge9227
  %excinfo.1.0.i.mux.mux = select i1 %common.ret.op.i.i.not, ptr %excinfo.1.0.i, ptr %excinfo.13.0, !prof !235
  %.mux.mux = zext i1 %common.ret.op.i.i.not to i32
  br i1 %brmerge9228, label %_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B286.if.i8971, !prof !236

B328.i:                                           ; preds = %B286.if.i8971
  %323 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.634.0625.i
  %.84.i.i8973 = load i64, ptr %323, align 8, !noalias !237
  %.89.i.i8974 = icmp sgt i64 %.84.i.i8973, -1
  br i1 %.89.i.i8974, label %B46.i.i8975, label %B328.endif.i

B46.i.i8975:                                      ; preds = %B328.i
  %.120.i.i8976 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i8973
  %.121.i.i8977 = load i64, ptr %.120.i.i8976, align 8, !noalias !237
  %.122.i.i8978 = icmp eq i64 %.121.i.i8977, 0
  br i1 %.122.i.i8978, label %B80.i.i8979, label %B328.endif.i

B80.i.i8979:                                      ; preds = %B46.i.i8975
  store i64 4, ptr %.120.i.i8976, align 8, !noalias !237
  br label %B328.endif.i

B398.i:                                           ; preds = %B328.endif.i, %B286.if.i8971
  %exitcond629.not.i = icmp eq i64 %.703.i, %arg.shape.0
  br i1 %exitcond629.not.i, label %_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B286.if.i8971

B150.if.i:                                        ; preds = %B3418, %B150.if.i
  %.361.0604.i = phi i64 [ %.430.i8961, %B150.if.i ], [ 0, %B3418 ]
  %.430.i8961 = add nsw i64 %.361.0604.i, 1
  %gep9370 = getelementptr double, ptr %invariant.gep9369, i64 %.361.0604.i
  store double 1.000000e-09, ptr %gep9370, align 8, !noalias !204
  %exitcond.not.i8962 = icmp eq i64 %arg.shape.0, %.430.i8961
  br i1 %exitcond.not.i8962, label %B150.if.1.i, label %B150.if.i

B286.if.i8971:                                    ; preds = %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, %B398.i
  %.634.0625.i = phi i64 [ %.703.i, %B398.i ], [ 0, %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  %.703.i = add nsw i64 %.634.0625.i, 1
  %324 = getelementptr i64, ptr %77, i64 %.634.0625.i
  %.785.i8972 = load i64, ptr %324, align 8, !noalias !204
  %.786.i = icmp sgt i64 %.785.i8972, -1
  br i1 %.786.i, label %B328.i, label %B398.i

B328.endif.i:                                     ; preds = %B80.i.i8979, %B46.i.i8975, %B328.i
  %325 = getelementptr double, ptr %78, i64 %.634.0625.i
  store double 0.000000e+00, ptr %325, align 8, !noalias !204
  br label %B398.i

_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %B398.i, %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %excinfo.13.2 = phi ptr [ %excinfo.1.0.i.mux.mux, %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %excinfo.13.0, %B398.i ]
  %common.ret.op.i8968 = phi i32 [ %.mux.mux, %_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ 0, %B398.i ]
  %.5011.not = icmp eq i32 %common.ret.op.i8968, 0
  br i1 %.5011.not, label %B3458, label %B3418.if, !prof !53

B3458:                                            ; preds = %B2888, %_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3414
  %excinfo.12.1 = phi ptr [ %excinfo.12.2, %B3414 ], [ %excinfo.12.2, %_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.12.0, %B2888 ]
  %excinfo.13.1 = phi ptr [ %excinfo.13.0, %B3414 ], [ %excinfo.13.2, %_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.13.0, %B2888 ]
  %brmerge8882.not = and i1 %good.2.1.lcssa, %looked.2.1.lcssa
  br i1 %brmerge8882.not, label %B3466, label %B3518

B3466:                                            ; preds = %B3458
  %brmerge8883.not = select i1 %within.5.1, i1 %.614, i1 false
  %"$phi3502.7.2.2" = select i1 %brmerge8883.not, i64 3, i64 0
  br i1 %.794, label %B3518, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i = getelementptr double, ptr %80, i64 %.180.0654.i
  %.453.i9045 = load double, ptr %.452.i, align 8, !noalias !240
  %.454.i9046 = fcmp olt double %.453.i9045, 5.000000e-01
  br i1 %.454.i9046, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i9047 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i9047, align 8, !noalias !240
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %326 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %326, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !240
  %.556.i = add nsw i64 %.554.i, %"$phi3502.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !240
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i = load double, ptr %.662.i, align 8, !noalias !240
  %.717.i = getelementptr double, ptr %81, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !240
  %.772.i = getelementptr double, ptr %82, i64 %.180.0654.i
  %.773.i = load double, ptr %.772.i, align 8, !noalias !240
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i = icmp slt i64 %.389.i, 0
  %.818.i9048 = select i1 %.817.i, i64 %arg.batch.2.5.0, i64 0
  %327 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i9049 = getelementptr double, ptr %327, i64 %.818.i9048
  %.833.i9050 = load double, ptr %.832.i9049, align 8, !noalias !240
  %.837.i = fcmp ugt double %.833.i9050, %.773.i
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %83, i64 %.180.0654.i
  %328 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9387 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9389 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9391 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9393 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9395 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9397 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9399 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9401 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9403 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i = icmp slt i64 %done.2.3.i, 0
  %.980.i = select i1 %.979.i, i64 %arg.batch.2.5.0, i64 0
  %329 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i = getelementptr double, ptr %329, i64 %.980.i
  %.1220.i = select i1 %.979.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %330 = getelementptr double, ptr %328, i64 %.1250.i
  br label %B474.if.i

B502.i:                                           ; preds = %B474.if.i
  %.1002.i9054 = add nsw i64 %.868.0650.i, %.1000.i9044
  %.1004.i = mul nsw i64 %.1002.i9054, %arg.shape.0
  %gep9404 = getelementptr double, ptr %invariant.gep9403, i64 %.1004.i
  %.1036.i = load double, ptr %gep9404, align 8, !noalias !240
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !240
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %84
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %331 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %331, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !240
  %.1379.i = fcmp ugt double %.1375.i, %.773.i
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !240
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3518, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i ]
  %332 = getelementptr double, ptr %330, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %332, align 8, !noalias !240
  %exitcond.not.i9053 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i9053, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3466, %B789.i
  %.180.0654.i = phi i64 [ %.252.i, %B789.i ], [ 0, %B3466 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !240
  %.388.i = getelementptr i64, ptr %79, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !240
  %.397.i = icmp slt i64 %.334.i, 0
  br i1 %.397.i, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i = load double, ptr %.994.i, align 8, !noalias !240
  %.997.i = fcmp oeq double %.995.i, %.773.i
  br i1 %.997.i, label %B502.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i, %.663.i
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9388 = getelementptr double, ptr %invariant.gep9387, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep9388, align 8, !noalias !243
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i9051 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9390 = getelementptr double, ptr %invariant.gep9389, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9390, align 8, !noalias !243
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i9051
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9392 = getelementptr double, ptr %invariant.gep9391, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9392, align 8, !noalias !243
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9394 = getelementptr double, ptr %invariant.gep9393, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9394, align 8, !noalias !243
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9396 = getelementptr double, ptr %invariant.gep9395, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9396, align 8, !noalias !243
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9398 = getelementptr double, ptr %invariant.gep9397, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9398, align 8, !noalias !243
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9400 = getelementptr double, ptr %invariant.gep9399, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9400, align 8, !noalias !243
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i9052 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep9402 = getelementptr double, ptr %invariant.gep9401, i64 %.271.i.i9052
  %.309.i.i = load double, ptr %gep9402, align 8, !noalias !243
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3518:                                            ; preds = %B789.i, %B3466, %B3458
  br i1 %.5156, label %B3568, label %B3530

B3530:                                            ; preds = %B3518
  %.5211 = load double, ptr %.5210, align 8
  %.5212 = fcmp ogt double %.5211, 5.000000e-01
  br i1 %.5212, label %B3568, label %B3636

B3568:                                            ; preds = %B3530, %B3518
  %.5243 = load i64, ptr %.5242, align 8
  %.5288 = inttoptr i64 %.5243 to ptr
  tail call void %.5288(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3636

B3636:                                            ; preds = %B3568, %B3530
  %brmerge8878.not.not = xor i1 %brmerge8878.not, true
  %brmerge9435 = or i1 %.794, %brmerge8878.not.not
  br i1 %brmerge9435, label %B3692, label %B80.if.i4162

B134.i:                                           ; preds = %B80.if.i4162
  %.351.i3436 = getelementptr double, ptr %86, i64 %.141.i3231.09412
  %.352.i3437 = load double, ptr %.351.i3436, align 8, !noalias !247
  %.353.i3438 = fcmp ogt double %.352.i3437, 5.000000e-01
  br i1 %.353.i3438, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i3486 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3231.09412
  %.409.i3487 = load double, ptr %.408.i3486, align 8, !noalias !247
  %.463.i3535 = getelementptr double, ptr %87, i64 %.141.i3231.09412
  %.464.i3536 = load double, ptr %.463.i3535, align 8, !noalias !247
  %.465.i3537 = fsub double %.409.i3487, %.464.i3536
  br i1 %.552.i35759405.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep9562 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3231.09412
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i3587 = fmul double %.465.i3537, %fastest.2.i.2.lcssa
  %.698.i3613 = load double, ptr %.697.i3612, align 8, !noalias !247
  %.699.i3614 = fcmp ogt double %.666.i3587, %.698.i3613
  %.8887 = select i1 %.699.i3614, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i3643 = load double, ptr %.742.i3642, align 8, !noalias !247
  %.773.i3668 = load double, ptr %arg.batch.2.4, align 8, !noalias !247
  %.774.i3669 = fsub double %.743.i3643, %.773.i3668
  %.776.i3671 = fmul double %.8887, %.774.i3669
  %.780.i3674 = fcmp olt double %.465.i3537, %.776.i3671
  br i1 %.780.i3674, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %333 = getelementptr i64, ptr %89, i64 %.141.i3231.09412
  %.838.i4098 = load i64, ptr %333, align 8, !noalias !247
  %.839.i4099 = add nsw i64 %.838.i4098, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i4099, %B490.i ], [ 0, %B380.i ]
  %334 = getelementptr i64, ptr %90, i64 %.141.i3231.09412
  store i64 %"$phi528.1.2.i.2", ptr %334, align 8, !noalias !247
  %.959.i3769 = load double, ptr %.408.i3486, align 8, !noalias !247
  store double %.959.i3769, ptr %.463.i3535, align 8, !noalias !247
  %.1068.i3850 = getelementptr double, ptr %91, i64 %.141.i3231.09412
  store double 1.000000e+00, ptr %.1068.i3850, align 8, !noalias !247
  store i64 1, ptr %.1166, align 8, !noalias !247
  %.1154.i = load i64, ptr %334, align 8, !noalias !247
  %.1155.i = icmp sgt i64 %.1154.i, 1000
  br i1 %.1155.i, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %335 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3231.09412
  %.84.i.i3993 = load i64, ptr %335, align 8, !noalias !251
  %.89.i.i3996 = icmp sgt i64 %.84.i.i3993, -1
  br i1 %.89.i.i3996, label %B46.i.i4001, label %B740.i

B46.i.i4001:                                      ; preds = %B694.i
  %.120.i.i4021 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i3993
  %.121.i.i4022 = load i64, ptr %.120.i.i4021, align 8, !noalias !251
  %.122.i.i4023 = icmp eq i64 %.121.i.i4022, 0
  br i1 %.122.i.i4023, label %B80.i.i4028, label %B740.i

B80.i.i4028:                                      ; preds = %B46.i.i4001
  store i64 6, ptr %.120.i.i4021, align 8, !noalias !251
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i4028, %B694.i, %B46.i.i4001, %B528.i, %B134.i, %B80.if.i4162
  store double 0.000000e+00, ptr %.294.i3376, align 8, !noalias !247
  %.200.i3317 = icmp sgt i64 %.144.i3232.09411, 1
  br i1 %.200.i3317, label %B80.if.i4162, label %B3692

B80.if.i4162:                                     ; preds = %B3636, %B740.i
  %.141.i3231.09412 = phi i64 [ %.213.i4170, %B740.i ], [ 0, %B3636 ]
  %.144.i3232.09411 = phi i64 [ %.209.i4167, %B740.i ], [ %storemerge, %B3636 ]
  %.209.i4167 = add nsw i64 %.144.i3232.09411, -1
  %.213.i4170 = add nsw i64 %.141.i3231.09412, 1
  %.294.i3376 = getelementptr double, ptr %85, i64 %.141.i3231.09412
  %.295.i3377 = load double, ptr %.294.i3376, align 8, !noalias !247
  %.296.i3378 = fcmp oeq double %.295.i3377, 1.000000e+00
  br i1 %.296.i3378, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.29408 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i3248.09407 = phi i64 [ %.565.i4154, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i4154 = add nsw i64 %.496.i3248.09407, 1
  %.592.i4106 = add nsw i64 %.496.i3248.09407, %arg.shape.1
  %.594.i4108 = mul nsw i64 %.592.i4106, %arg.shape.0
  %gep9563 = getelementptr double, ptr %invariant.gep9562, i64 %.594.i4108
  %.626.i4136 = load double, ptr %gep9563, align 8, !noalias !247
  %.627.i4137 = tail call double @llvm.fabs.f64(double %.626.i4136)
  %.10.i.i = fcmp ogt double %.627.i4137, %fastest.2.i.29408
  %.11.i.i = select i1 %.10.i.i, double %.627.i4137, double %fastest.2.i.29408
  %exitcond9460.not = icmp eq i64 %arg.shape.1, %.565.i4154
  br i1 %exitcond9460.not, label %B380.i, label %B270.if.i

B3692:                                            ; preds = %B740.i, %B3636
  %brmerge8889.not = and i1 %.5358.not, %looked.2.1.lcssa
  %brmerge8889.not.not = xor i1 %brmerge8889.not, true
  %brmerge9434 = or i1 %.794, %brmerge8889.not.not
  br i1 %brmerge9434, label %B3742, label %B114.if.i

B46.i.i9056:                                      ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !254
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i9062, label %B228.i

B80.i.i9062:                                      ; preds = %B46.i.i9056
  %.196.i.i = getelementptr double, ptr %92, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !254
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i9062
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !254
  %.321.i.i = getelementptr double, ptr %93, i64 %.302.01639.i
  %.322.i.i9063 = load double, ptr %.321.i.i, align 8, !noalias !254
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i9063
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i9064

B76.if.i.lr.ph.i9064:                             ; preds = %B122.i.i
  %336 = getelementptr i64, ptr %94, i64 %.302.01639.i
  %.513.i = load i64, ptr %336, align 8, !noalias !259
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %337 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i9065

B76.if.i.i9065:                                   ; preds = %B76.if.i.i9065, %B76.if.i.lr.ph.i9064
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i9064 ], [ %.188.i390.i, %B76.if.i.i9065 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %338 = getelementptr double, ptr %337, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %338, align 8, !noalias !260
  %339 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %339, align 8, !noalias !260
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %340 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %340, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !260
  %exitcond.not.i9066 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i9066, label %B228.i, label %B76.if.i.i9065

B228.i:                                           ; preds = %B76.if.i.i9065, %B114.if.i, %B122.i.i, %B80.i.i9062, %B46.i.i9056
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i ], [ %some.2.01641.i, %B80.i.i9062 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i9056 ], [ true, %B76.if.i.i9065 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3742

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !259
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !259
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !259
  %.896.i = inttoptr i64 %.780.i to ptr
  tail call void %.896.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i9057), !noalias !259
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i9058, align 8, !noalias !259
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i9057, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !259
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !264
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %92, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !264
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !264
  %.321.i223.i = getelementptr double, ptr %93, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !264
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %95, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !259
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %341 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %341, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !259
  %.1448.i = fcmp oeq double %.1392.i, %.265.i185.i
  br label %B768.i

B768.i:                                           ; preds = %B714.i, %B638.i
  %"$phi768.1.2.1.i" = phi i1 [ %.1448.i, %B714.i ], [ false, %B638.i ]
  br i1 %.15441642.not.i, label %B978.i, label %B800.if.lr.ph.i

B800.if.lr.ph.i:                                  ; preds = %B768.i
  %.1674.i = add nsw i64 %.1345.i, -1
  %.1713.i = select i1 %.1356.i, i64 0, i64 %arg.batch.3.0.5.1
  %.1714.i = add i64 %.1674.i, %.1713.i
  %.1741.i = mul i64 %.1739.i, %.99.i78.i
  %.1743.i = mul i64 %.1714.i, %arg.batch.3.0.5.2
  %342 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %343 = getelementptr double, ptr %342, i64 %.1743.i
  %invariant.gep9413 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep9415 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %344 = getelementptr double, ptr %343, i64 %.1488.01643.i
  store double %.1622.i, ptr %344, align 8, !noalias !259
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %345 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %345, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %348, align 8, !noalias !267
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !267
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !267
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %346 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %346, align 8, !noalias !259
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %348, align 8, !noalias !270
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !270
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !270
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i9061 = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i9061, label %B598.if.i, label %B3742

B114.if.i:                                        ; preds = %B3692, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3692 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3692 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %347 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %347, align 8, !noalias !254
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i9056

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i9060, %B1076.i ], [ %storemerge.i9055, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i9060 = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %348 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %348, align 8, !noalias !264
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i = mul nsw i64 %.1588.i, %arg.shape.0
  %gep9414 = getelementptr double, ptr %invariant.gep9413, i64 %.1590.i
  %.1622.i = load double, ptr %gep9414, align 8, !noalias !259
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep9416 = getelementptr double, ptr %invariant.gep9415, i64 %.1637.i
  store double %.1622.i, ptr %gep9416, align 8, !noalias !259
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3742:                                            ; preds = %B1076.i, %B3692, %B230.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge9436 = or i1 %.794, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9436, label %B4718, label %B3784.if

B3832:                                            ; preds = %B3784.if
  %.5743 = mul i64 %.5670, %arg.batch.3.3.5.1
  %.5747 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5743
  %.5748 = load i64, ptr %.5747, align 8
  %.5804 = getelementptr i8, ptr %.5747, i64 24
  %.5805 = load i64, ptr %.5804, align 8
  %349 = add i64 %.5748, %.5805
  %.5806 = sub i64 %arg.most, %349
  %.5811 = icmp slt i64 %.5806, 1
  br i1 %.5811, label %B3912, label %B3958

B3912:                                            ; preds = %B3832
  %350 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5508.09421
  %.84.i4251 = load i64, ptr %350, align 8, !noalias !273
  %.89.i4254 = icmp sgt i64 %.84.i4251, -1
  br i1 %.89.i4254, label %B46.i4259, label %B3958

B46.i4259:                                        ; preds = %B3912
  %.120.i4285 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i4251
  %.121.i4286 = load i64, ptr %.120.i4285, align 8, !noalias !273
  %.122.i4287 = icmp eq i64 %.121.i4286, 0
  br i1 %.122.i4287, label %B80.i4292, label %B3958

B80.i4292:                                        ; preds = %B46.i4259
  store i64 5, ptr %.120.i4285, align 8, !noalias !273
  br label %B3958

B3958:                                            ; preds = %B80.i4292, %B3912, %B46.i4259, %B3832
  %.5901 = getelementptr double, ptr %96, i64 %.5508.09421
  %.5902 = load double, ptr %.5901, align 8
  %.5903 = fcmp ogt double %.5902, 5.000000e-01
  br i1 %.5903, label %B3996, label %B4100

B3996:                                            ; preds = %B3958
  %.5958 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5508.09421
  %.5959 = load double, ptr %.5958, align 8
  %.6013 = getelementptr double, ptr %97, i64 %.5508.09421
  %.6014 = load double, ptr %.6013, align 8
  %.6015 = fcmp oeq double %.5959, %.6014
  br i1 %.6015, label %B4060, label %B4100

B4060:                                            ; preds = %B3996
  %.192.i4518 = load i64, ptr %.5669, align 8, !noalias !276
  %.248.i4566 = getelementptr i64, ptr %98, i64 %.5508.09421
  %.249.i4567 = load i64, ptr %.248.i4566, align 8, !noalias !276
  %.250.i4568 = add nsw i64 %.249.i4567, 1
  store i64 %.250.i4568, ptr %.248.i4566, align 8, !noalias !276
  %.373.i4673 = icmp slt i64 %.249.i4567, -1
  %.374.i4674 = select i1 %.373.i4673, i64 %arg.batch.1.2.5.0, i64 0
  %351 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i4568
  %.388.i4688 = getelementptr double, ptr %351, i64 %.374.i4674
  %.389.i4689 = load double, ptr %.388.i4688, align 8, !noalias !276
  %.390.i4690 = fcmp oeq double %.389.i4689, 0x7FF0000000000000
  br i1 %.390.i4690, label %B182.i, label %B240.i

B182.i:                                           ; preds = %B4060
  %.424.i5206 = icmp slt i64 %.192.i4518, 0
  %.425.i5207 = select i1 %.424.i5206, i64 %arg.batch.3.1.5.0, i64 0
  %352 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i4518
  %.439.i5221 = getelementptr i64, ptr %352, i64 %.425.i5207
  %.440.i5222 = load i64, ptr %.439.i5221, align 8, !noalias !276
  %.441.i5223 = icmp eq i64 %.440.i5222, 0
  br i1 %.441.i5223, label %B216.i5227, label %B4100

B216.i5227:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i5221, align 8, !noalias !276
  br label %B4100

B240.i:                                           ; preds = %B4060
  store double %.389.i4689, ptr %.6013, align 8, !noalias !276
  %.592.i4780 = select i1 %.373.i4673, i64 %arg.batch.1.4.5.0, i64 0
  %353 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i4568
  %.606.i4794 = getelementptr i64, ptr %353, i64 %.592.i4780
  %.607.i4795 = load i64, ptr %.606.i4794, align 8, !noalias !276
  %.610.i4797 = icmp eq i64 %.607.i4795, 0
  br i1 %.610.i4797, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i
  %.665.i5160 = getelementptr double, ptr %99, i64 %.5508.09421
  store double 1.000000e+00, ptr %.665.i5160, align 8, !noalias !276
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i
  %.733.i4823 = load i64, ptr %.1166, align 8, !noalias !276
  %.734.i4824 = icmp eq i64 %.733.i4823, 0
  br i1 %.734.i4824, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.1166, align 8, !noalias !276
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i49729417.not, label %B4100, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i5017 = select i1 %.373.i4673, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i5018 = add i64 %.237.i.i5017, %.250.i4568
  %.258.i.i5034 = mul i64 %.238.i.i5018, %arg.batch.1.3.5.1
  %354 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i5034
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4329.09419 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i5081, %B76.if.i.i ]
  %.188.i.i5081 = add nsw i64 %.117.i.i4329.09419, 1
  %355 = getelementptr double, ptr %354, i64 %.117.i.i4329.09419
  %.263.i.i5037 = load double, ptr %355, align 8, !noalias !280
  %356 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4329.09419
  %.293.i.i5053 = load i64, ptr %356, align 8, !noalias !280
  %.295.i.i5055 = mul nsw i64 %.293.i.i5053, %arg.shape.0
  %.297.i.i5057 = add nsw i64 %.295.i.i5055, %.5508.09421
  %.311.i.i5064 = icmp slt i64 %.297.i.i5057, 0
  %.312.i.i5065 = select i1 %.311.i.i5064, i64 %arg.batch.5.1.5.0, i64 0
  %357 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i5057
  %.326.i.i5075 = getelementptr double, ptr %357, i64 %.312.i.i5065
  store double %.263.i.i5037, ptr %.326.i.i5075, align 8, !noalias !280
  %exitcond9461.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i5081
  br i1 %exitcond9461.not, label %B4100, label %B76.if.i.i

B4100:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i5227, %B182.i, %B3996, %B3958
  %.6104 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5670
  %.6105 = load i64, ptr %.6104, align 8
  %.6106.not = icmp eq i64 %.6105, 0
  br i1 %.6106.not, label %B4242, label %B4134

B4134:                                            ; preds = %B4100
  %.6167 = getelementptr i64, ptr %100, i64 %.5508.09421
  %.6168 = load i64, ptr %.6167, align 8
  %.6198 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5670
  store i64 %.6168, ptr %.6198, align 8
  store i64 -1, ptr %.5669, align 8
  %.236.i9067 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !284
  %.293.i9072 = getelementptr double, ptr %101, i64 %.5508.09421
  store double 0.000000e+00, ptr %.293.i9072, align 8, !noalias !284
  %.324.i9074 = load i64, ptr %.323.i9073, align 8, !noalias !284
  %.326.i9075 = icmp eq i64 %.236.i9067, %.324.i9074
  br i1 %.326.i9075, label %B4450, label %B132.i9076

B132.i9076:                                       ; preds = %B4134
  %.359.i9077 = add nsw i64 %.236.i9067, 1
  store i64 %.359.i9077, ptr %arg.batch.4.2.4, align 8, !noalias !284
  store i64 1, ptr %.1166, align 8, !noalias !284
  %.438.i9079 = icmp slt i64 %.236.i9067, 0
  %.439.i9080 = select i1 %.438.i9079, i64 %arg.batch.0.2.5.0, i64 0
  %358 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i9067
  %.453.i9081 = getelementptr i64, ptr %358, i64 %.439.i9080
  %.454.i9082 = load i64, ptr %.453.i9081, align 8, !noalias !284
  %.469.i9083 = icmp slt i64 %.454.i9082, 0
  %.470.i9084 = select i1 %.469.i9083, i64 %arg.batch.1.0.5.0, i64 0
  %359 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i9082
  %.484.i9085 = getelementptr i64, ptr %359, i64 %.470.i9084
  %.485.i9086 = load i64, ptr %.484.i9085, align 8, !noalias !284
  store i64 %.236.i9067, ptr %.5669, align 8, !noalias !284
  %.595.i9090 = getelementptr i64, ptr %102, i64 %.5508.09421
  store i64 %.485.i9086, ptr %.595.i9090, align 8, !noalias !284
  store i64 1, ptr %.6167, align 8, !noalias !284
  %.709.i9094 = getelementptr i64, ptr %103, i64 %.5508.09421
  store i64 0, ptr %.709.i9094, align 8, !noalias !284
  br i1 %.8051131.not.i9095, label %B402.i9110, label %B358.if.lr.ph.i9096

B358.if.lr.ph.i9096:                              ; preds = %B132.i9076
  %.867.i9097 = select i1 %.438.i9079, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i9098 = add i64 %.867.i9097, %.236.i9067
  %.888.i9099 = mul i64 %.868.i9098, %arg.batch.0.1.5.1
  %360 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i9099
  %invariant.gep9564 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5508.09421
  br label %B358.if.i9100

B402.i9110:                                       ; preds = %B358.if.i9100, %B132.i9076
  br i1 %.175.i1134.not.i9111, label %B402.endif.i9129, label %B76.if.i.lr.ph.i9112

B76.if.i.lr.ph.i9112:                             ; preds = %B402.i9110
  %.990.i9113 = load i64, ptr %.595.i9090, align 8, !noalias !284
  %.236.i.i9114 = icmp slt i64 %.990.i9113, 0
  %.237.i.i9115 = select i1 %.236.i.i9114, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i9116 = add i64 %.237.i.i9115, %.990.i9113
  %.258.i.i9117 = mul i64 %.238.i.i9116, %arg.batch.1.3.5.1
  %361 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9117
  br label %B76.if.i.i9118

B76.if.i.i9118:                                   ; preds = %B76.if.i.i9118, %B76.if.i.lr.ph.i9112
  %.117.i.01135.i9119 = phi i64 [ 0, %B76.if.i.lr.ph.i9112 ], [ %.188.i.i9120, %B76.if.i.i9118 ]
  %.188.i.i9120 = add nsw i64 %.117.i.01135.i9119, 1
  %362 = getelementptr double, ptr %361, i64 %.117.i.01135.i9119
  %.263.i.i9121 = load double, ptr %362, align 8, !noalias !287
  %363 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i9119
  %.293.i.i9122 = load i64, ptr %363, align 8, !noalias !287
  %.295.i.i9123 = mul nsw i64 %.293.i.i9122, %arg.shape.0
  %.297.i.i9124 = add nsw i64 %.295.i.i9123, %.5508.09421
  %.311.i.i9125 = icmp slt i64 %.297.i.i9124, 0
  %.312.i.i9126 = select i1 %.311.i.i9125, i64 %arg.batch.5.1.5.0, i64 0
  %364 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i9124
  %.326.i.i9127 = getelementptr double, ptr %364, i64 %.312.i.i9126
  store double %.263.i.i9121, ptr %.326.i.i9127, align 8, !noalias !287
  %exitcond1142.not.i9128 = icmp eq i64 %.188.i.i9120, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i9128, label %B402.endif.i9129, label %B76.if.i.i9118

B888.i9223:                                       ; preds = %B580.if.i9145
  store double 0.000000e+00, ptr %.1877.i9220, align 8, !noalias !284
  br label %B4450

B358.if.i9100:                                    ; preds = %B358.if.i9100, %B358.if.lr.ph.i9096
  %.747.01132.i9101 = phi i64 [ 0, %B358.if.lr.ph.i9096 ], [ %.818.i9102, %B358.if.i9100 ]
  %.818.i9102 = add nsw i64 %.747.01132.i9101, 1
  %365 = getelementptr double, ptr %360, i64 %.747.01132.i9101
  %.893.i9103 = load double, ptr %365, align 8, !noalias !284
  %.895.i9104 = mul nsw i64 %.747.01132.i9101, %arg.shape.0
  %gep9565 = getelementptr double, ptr %invariant.gep9564, i64 %.895.i9104
  store double %.893.i9103, ptr %gep9565, align 8, !noalias !284
  %exitcond.not.i9109 = icmp eq i64 %.818.i9102, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i9109, label %B402.i9110, label %B358.if.i9100

B402.endif.i9129:                                 ; preds = %B76.if.i.i9118, %B402.i9110
  br i1 %.11171137.not.i9130, label %B580.if.i9145, label %B496.if.lr.ph.i9131

B496.if.lr.ph.i9131:                              ; preds = %B402.endif.i9129
  %.1179.i9132 = select i1 %.438.i9079, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i9133 = add i64 %.1179.i9132, %.236.i9067
  %.1200.i9134 = mul i64 %.1180.i9133, %arg.batch.0.0.5.1
  %366 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i9134
  %invariant.gep9566 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5508.09421
  br label %B496.if.i9135

B496.if.i9135:                                    ; preds = %B496.if.i9135, %B496.if.lr.ph.i9131
  %.1061.01138.i9136 = phi i64 [ 0, %B496.if.lr.ph.i9131 ], [ %.1130.i9137, %B496.if.i9135 ]
  %.1130.i9137 = add nsw i64 %.1061.01138.i9136, 1
  %367 = getelementptr double, ptr %366, i64 %.1061.01138.i9136
  %.1205.i9138 = load double, ptr %367, align 8, !noalias !284
  %.1207.i9139 = mul nsw i64 %.1061.01138.i9136, %arg.shape.0
  %gep9567 = getelementptr double, ptr %invariant.gep9566, i64 %.1207.i9139
  store double %.1205.i9138, ptr %gep9567, align 8, !noalias !284
  %exitcond1143.not.i9144 = icmp eq i64 %.1130.i9137, %arg.shape.1
  br i1 %exitcond1143.not.i9144, label %B580.if.i9145, label %B496.if.i9135

B580.if.i9145:                                    ; preds = %B496.if.i9135, %B402.endif.i9129
  %invariant.gep.i9146 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5508.09421
  store double 0.000000e+00, ptr %invariant.gep.i9146, align 8, !noalias !284
  %gep.1.i9147 = getelementptr double, ptr %invariant.gep.i9146, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i9147, align 8, !noalias !284
  %gep.2.i9149 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.2.idx.i9148
  store double 0.000000e+00, ptr %gep.2.i9149, align 8, !noalias !284
  %gep.3.i9151 = getelementptr i8, ptr %invariant.gep.i9146, i64 %.idx.i9071
  store double 0.000000e+00, ptr %gep.3.i9151, align 8, !noalias !284
  %gep.4.i9153 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.4.idx.i9152
  store double 0.000000e+00, ptr %gep.4.i9153, align 8, !noalias !284
  %gep.5.i9155 = getelementptr i8, ptr %invariant.gep.i9146, i64 %.idx8826
  store double 0.000000e+00, ptr %gep.5.i9155, align 8, !noalias !284
  %gep.6.i9157 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.6.idx.i9156
  store double 0.000000e+00, ptr %gep.6.i9157, align 8, !noalias !284
  %gep.7.i9159 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.7.idx.i9158
  store double 0.000000e+00, ptr %gep.7.i9159, align 8, !noalias !284
  %gep.8.i9161 = getelementptr i8, ptr %invariant.gep.i9146, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i9161, align 8, !noalias !284
  %gep.9.i9163 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.9.idx.i9162
  store double 0.000000e+00, ptr %gep.9.i9163, align 8, !noalias !284
  %gep.10.i9165 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.10.idx.i9164
  store double 0.000000e+00, ptr %gep.10.i9165, align 8, !noalias !284
  %gep.11.i9167 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.11.idx.i9166
  store double 0.000000e+00, ptr %gep.11.i9167, align 8, !noalias !284
  %gep.12.i9169 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.12.idx.i9168
  store double 0.000000e+00, ptr %gep.12.i9169, align 8, !noalias !284
  %gep.13.i9171 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.13.idx.i9170
  store double 0.000000e+00, ptr %gep.13.i9171, align 8, !noalias !284
  %gep.14.i9173 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.14.idx.i9172
  store double 0.000000e+00, ptr %gep.14.i9173, align 8, !noalias !284
  %gep.15.i9175 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.15.idx.i9174
  store double 0.000000e+00, ptr %gep.15.i9175, align 8, !noalias !284
  %gep.16.i9177 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.16.idx.i9176
  store double 0.000000e+00, ptr %gep.16.i9177, align 8, !noalias !284
  %gep.17.i9179 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.17.idx.i9178
  store double 0.000000e+00, ptr %gep.17.i9179, align 8, !noalias !284
  %gep.18.i9181 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.18.idx.i9180
  store double 0.000000e+00, ptr %gep.18.i9181, align 8, !noalias !284
  %gep.19.i9183 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.19.idx.i9182
  store double 0.000000e+00, ptr %gep.19.i9183, align 8, !noalias !284
  %gep.20.i9185 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.20.idx.i9184
  store double 0.000000e+00, ptr %gep.20.i9185, align 8, !noalias !284
  %gep.21.i9187 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.21.idx.i9186
  store double 0.000000e+00, ptr %gep.21.i9187, align 8, !noalias !284
  %gep.22.i9189 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.22.idx.i9188
  store double 0.000000e+00, ptr %gep.22.i9189, align 8, !noalias !284
  %gep.23.i9191 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.23.idx.i9190
  store double 0.000000e+00, ptr %gep.23.i9191, align 8, !noalias !284
  %gep.24.i9193 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.24.idx.i9192
  store double 0.000000e+00, ptr %gep.24.i9193, align 8, !noalias !284
  %gep.25.i9195 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.25.idx.i9194
  store double 0.000000e+00, ptr %gep.25.i9195, align 8, !noalias !284
  %gep.26.i9197 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.26.idx.i9196
  store double 0.000000e+00, ptr %gep.26.i9197, align 8, !noalias !284
  %gep.27.i9199 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.27.idx.i9198
  store double 0.000000e+00, ptr %gep.27.i9199, align 8, !noalias !284
  %gep.28.i9201 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.28.idx.i9200
  store double 0.000000e+00, ptr %gep.28.i9201, align 8, !noalias !284
  %gep.29.i9203 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.29.idx.i9202
  store double 0.000000e+00, ptr %gep.29.i9203, align 8, !noalias !284
  %gep.30.i9205 = getelementptr i8, ptr %invariant.gep.i9146, i64 %gep.30.idx.i9204
  store double 0.000000e+00, ptr %gep.30.i9205, align 8, !noalias !284
  %.1455.i9206 = load double, ptr %arg.batch.2.4, align 8, !noalias !284
  %.1516.i9207 = load i64, ptr %.595.i9090, align 8, !noalias !284
  %.1531.i9208 = icmp slt i64 %.1516.i9207, 0
  %.1532.i9209 = select i1 %.1531.i9208, i64 %arg.batch.1.2.5.0, i64 0
  %368 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i9207
  %.1546.i9210 = getelementptr double, ptr %368, i64 %.1532.i9209
  %.1547.i9211 = load double, ptr %.1546.i9210, align 8, !noalias !284
  store double %.1455.i9206, ptr %invariant.gep.i9146, align 8, !noalias !284
  %.1656.i9214 = getelementptr double, ptr %104, i64 %.5508.09421
  store double %.1547.i9211, ptr %.1656.i9214, align 8, !noalias !284
  store double 1.000000e+00, ptr %.293.i9072, align 8, !noalias !284
  %.1767.i9216 = getelementptr double, ptr %105, i64 %.5508.09421
  store double 0xFFF0000000000000, ptr %.1767.i9216, align 8, !noalias !284
  %.1822.i9218 = getelementptr double, ptr %106, i64 %.5508.09421
  store double 0x7FF0000000000000, ptr %.1822.i9218, align 8, !noalias !284
  %.1877.i9220 = getelementptr double, ptr %107, i64 %.5508.09421
  %.1878.i9221 = load double, ptr %.1877.i9220, align 8, !noalias !284
  %.1880.i9222 = fcmp ueq double %.1878.i9221, 0xFFF0000000000000
  br i1 %.1880.i9222, label %B4450, label %B888.i9223

B4242:                                            ; preds = %B4100
  %.6394 = getelementptr double, ptr %108, i64 %.5508.09421
  %.6395 = load double, ptr %.6394, align 8
  %.6397 = fcmp ult double %.6395, 1.500000e+01
  br i1 %.6397, label %B4450, label %B4290

B4290:                                            ; preds = %B4242
  %.6441 = load double, ptr %.6440, align 8
  %.6495 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5508.09421
  %.6496 = load double, ptr %.6495, align 8
  %.6497 = fsub double %.6441, %.6496
  %.6551 = getelementptr double, ptr %111, i64 %.5508.09421
  %.6552 = load double, ptr %.6551, align 8
  %.6554 = fmul double %.6552, 5.000000e+03
  %.6555 = fcmp ogt double %.6497, %.6554
  br i1 %.6555, label %B4450, label %B4426

B4426:                                            ; preds = %B4290
  store double 0.000000e+00, ptr %.6394, align 8
  br label %B4450

B4450:                                            ; preds = %B888.i9223, %B4134, %B580.if.i9145, %B4290, %B4426, %B4242
  %budget.7.4 = phi i64 [ %budget.5.29423, %B4242 ], [ 0, %B4290 ], [ %budget.5.29423, %B4426 ], [ %budget.5.29423, %B580.if.i9145 ], [ %budget.5.29423, %B4134 ], [ %budget.5.29423, %B888.i9223 ]
  %.6683 = load i64, ptr %.5669, align 8
  %.6684 = icmp sgt i64 %.6683, -1
  br i1 %.6684, label %B4488, label %B4745

B4488:                                            ; preds = %B4450
  %.6689 = add nsw i64 %active.5.29424, 1
  %.6798 = mul i64 %.6683, %arg.batch.3.3.5.1
  %.6802 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6798
  %.6803 = load i64, ptr %.6802, align 8
  %.6814.0 = and i64 %.6803, 127
  %.6844 = sub nsw i64 128, %.6814.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6844, i64 %.5806)
  %.6932 = getelementptr double, ptr %112, i64 %.5508.09421
  %.6933 = load double, ptr %.6932, align 8
  %.6935 = fcmp ogt double %.6933, 0.000000e+00
  %.6946 = sitofp i64 %.11.i to double
  %"$phi4658.1.2.5" = select i1 %.6935, double 1.000000e+00, double %.6946
  %.7009 = getelementptr double, ptr %113, i64 %.5508.09421
  store double %"$phi4658.1.2.5", ptr %.7009, align 8
  %.111.i5360 = getelementptr i64, ptr %114, i64 %.5508.09421
  %.112.i5361 = load i64, ptr %.111.i5360, align 8, !noalias !291
  %.169.i5410 = getelementptr double, ptr %115, i64 %.5508.09421
  %.170.i5411 = load double, ptr %.169.i5410, align 8, !noalias !291
  %.224.i5459 = getelementptr double, ptr %116, i64 %.5508.09421
  store double %.170.i5411, ptr %.224.i5459, align 8, !noalias !291
  %.237.i5467 = icmp slt i64 %.112.i5361, %arg.batch.2.5.0
  br i1 %.237.i5467, label %B134.i5472, label %B4745

B134.i5472:                                       ; preds = %B4488
  %.253.i5483 = icmp slt i64 %.112.i5361, 0
  %.254.i5484 = select i1 %.253.i5483, i64 %arg.batch.2.5.0, i64 0
  %369 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i5361
  %.268.i5498 = getelementptr double, ptr %369, i64 %.254.i5484
  %.269.i5499 = load double, ptr %.268.i5498, align 8, !noalias !291
  %.328.i5550 = load double, ptr %.169.i5410, align 8, !noalias !291
  %.10.i.i5557 = fcmp olt double %.328.i5550, %.269.i5499
  %.11.i.i5558 = select i1 %.10.i.i5557, double %.328.i5550, double %.269.i5499
  store double %.11.i.i5558, ptr %.224.i5459, align 8, !noalias !291
  br label %B4745

B4718:                                            ; preds = %B4745, %B3742
  %budget.4.2 = phi i64 [ %.1132, %B3742 ], [ %budget.6.3, %B4745 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3742 ], [ %active.6.3, %B4745 ]
  %.7087 = icmp sgt i64 %active.8.2, 0
  %.7101 = icmp sgt i64 %budget.4.2, 0
  %or.cond8890 = select i1 %.7087, i1 %.7101, i1 false
  br i1 %or.cond8890, label %B584, label %B4744

B4744:                                            ; preds = %B4718, %B556
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B556 ], [ %active.8.2, %B4718 ]
  br i1 %.794, label %B4744.endif, label %B80.if.i2040.lr.ph

B80.if.i2040.lr.ph:                               ; preds = %B4744
  %.idx = mul i64 %arg.batch.4.0.5.1, 208
  %370 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8824 = mul i64 %arg.batch.4.0.5.1, 216
  %371 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8824
  %.703.i1698 = add nsw i64 %arg.shape.2, -1
  %.idx8825 = mul i64 %arg.batch.4.0.5.1, 192
  %372 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8825
  br label %B80.if.i2040

B126.i1345:                                       ; preds = %B80.if.i2040
  %.318.i1392 = getelementptr double, ptr %370, i64 %.105.i1190.09431
  %.319.i1393 = load double, ptr %.318.i1392, align 8, !noalias !295
  %.5.i.i1394 = fptosi double %.319.i1393 to i64
  %.397.i1443 = getelementptr double, ptr %371, i64 %.105.i1190.09431
  %.398.i1444 = load double, ptr %.397.i1443, align 8, !noalias !295
  %.5.i1.i1445 = fptosi double %.398.i1444 to i64
  %.478.i1496 = mul i64 %.258.i1338, %arg.batch.3.3.5.1
  %.482.i1500 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.478.i1496
  %.483.i1501 = load i64, ptr %.482.i1500, align 8, !noalias !295
  %.485.i1503 = add nsw i64 %.483.i1501, %.5.i.i1394
  store i64 %.485.i1503, ptr %.482.i1500, align 8, !noalias !295
  %.591.i1598 = getelementptr i8, ptr %.482.i1500, i64 24
  %.592.i1599 = load i64, ptr %.591.i1598, align 8, !noalias !295
  %.594.i1601 = add nsw i64 %.592.i1599, %.5.i1.i1445
  store i64 %.594.i1601, ptr %.591.i1598, align 8, !noalias !295
  %.700.i1695 = getelementptr i8, ptr %.482.i1500, i64 8
  %.701.i1696 = load i64, ptr %.700.i1695, align 8, !noalias !295
  %.706.i1701 = add nsw i64 %.5.i1.i1445, %.5.i.i1394
  %.707.i1702 = mul nsw i64 %.706.i1701, %.703.i1698
  %..5.i.i1394 = select i1 %.625, i64 0, i64 %.5.i.i1394
  %.708.i1703 = add i64 %.707.i1702, %..5.i.i1394
  %.841.i1808 = add i64 %.708.i1703, %.701.i1696
  store i64 %.841.i1808, ptr %.700.i1695, align 8, !noalias !295
  store double 0.000000e+00, ptr %.318.i1392, align 8, !noalias !295
  store double 0.000000e+00, ptr %.397.i1443, align 8, !noalias !295
  %.1072.i1986 = getelementptr double, ptr %372, i64 %.105.i1190.09431
  %.1073.i1987 = load double, ptr %.1072.i1986, align 8, !noalias !295
  %.1081.i1993 = sitofp i64 %.706.i1701 to double
  %.1082.i1994 = fsub double %.1073.i1987, %.1081.i1993
  store double %.1082.i1994, ptr %.1072.i1986, align 8, !noalias !295
  br label %B568.i1342

B568.i1342:                                       ; preds = %B126.i1345, %B80.if.i2040
  %.163.i1271 = icmp sgt i64 %.108.i1191.09432, 1
  br i1 %.163.i1271, label %B80.if.i2040, label %B4744.endif

B80.if.i2040:                                     ; preds = %B80.if.i2040.lr.ph, %B568.i1342
  %.108.i1191.09432 = phi i64 [ %storemerge, %B80.if.i2040.lr.ph ], [ %.172.i2044, %B568.i1342 ]
  %.105.i1190.09431 = phi i64 [ 0, %B80.if.i2040.lr.ph ], [ %.176.i2047, %B568.i1342 ]
  %.172.i2044 = add nsw i64 %.108.i1191.09432, -1
  %.176.i2047 = add nsw i64 %.105.i1190.09431, 1
  %373 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1190.09431
  %.258.i1338 = load i64, ptr %373, align 8, !noalias !295
  %.263.i1341 = icmp sgt i64 %.258.i1338, -1
  br i1 %.263.i1341, label %B126.i1345, label %B568.i1342

B4745:                                            ; preds = %B4488, %B134.i5472, %B4450, %B3784.if
  %budget.6.3 = phi i64 [ %budget.5.29423, %B3784.if ], [ %budget.7.4, %B4450 ], [ %budget.7.4, %B134.i5472 ], [ %budget.7.4, %B4488 ]
  %active.6.3 = phi i64 [ %active.5.29424, %B3784.if ], [ %active.5.29424, %B4450 ], [ %.6689, %B134.i5472 ], [ %.6689, %B4488 ]
  %.5571 = icmp sgt i64 %.5511.09422, 1
  br i1 %.5571, label %B3784.if, label %B4718

common.ret:                                       ; preds = %B3418.if, %B3372.if, %B3318.endif.if, %B2766.endif.if, %B4744.endif
  %common.ret.op = phi i32 [ %.4830, %B3318.endif.if ], [ %.4227, %B2766.endif.if ], [ 0, %B4744.endif ], [ %common.ret.op.i8968, %B3418.if ], [ %common.ret.op.i, %B3372.if ]
  ret i32 %common.ret.op

B416.if:                                          ; preds = %B416.if.lr.ph, %B502
  %active.4.09250 = phi i64 [ 0, %B416.if.lr.ph ], [ %.1089, %B502 ]
  %.783.09249 = phi i64 [ %storemerge, %B416.if.lr.ph ], [ %.847, %B502 ]
  %.780.09248 = phi i64 [ 0, %B416.if.lr.ph ], [ %.851, %B502 ]
  %.847 = add nsw i64 %.783.09249, -1
  %.851 = add nsw i64 %.780.09248, 1
  %374 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.09248
  %.933 = load i64, ptr %374, align 8
  %.934 = icmp slt i64 %.933, 0
  br i1 %.934, label %B458, label %B502

B1534.if:                                         ; preds = %B1502, %B1726
  %.2165.09265 = phi i64 [ %.2234, %B1726 ], [ 1, %B1502 ]
  %.2234 = add i64 %.2165.09265, 1
  %375 = getelementptr i64, ptr %arg.code.4, i64 %.2165.09265
  %376 = getelementptr i8, ptr %375, i64 128
  %.2293 = load i64, ptr %376, align 8
  %.2338 = inttoptr i64 %.2293 to ptr
  tail call void %.2338(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2344 = add nsw i64 %.2165.09265, %.
  %.2346 = mul nsw i64 %.2344, %.463
  %.2391 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2346
  tail call void %.2392(ptr %.571, ptr %.2366, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2391)
  br i1 %or.cond9231.not, label %B68.if.lr.ph.i, label %B1726

B1870.if:                                         ; preds = %B1728, %B1956
  %looked.2.19271 = phi i1 [ %"$phi1956.1.2.2", %B1956 ], [ %spec.select8891, %B1728 ]
  %good.2.19270 = phi i1 [ %"$phi1914.1.2.2", %B1956 ], [ false, %B1728 ]
  %.2611.09269 = phi i64 [ %.2673, %B1956 ], [ %storemerge, %B1728 ]
  %.2608.09268 = phi i64 [ %.2677, %B1956 ], [ 0, %B1728 ]
  %.2673 = add nsw i64 %.2611.09269, -1
  %.2677 = add nsw i64 %.2608.09268, 1
  br i1 %good.2.19270, label %B1914, label %B1878

B2030.if:                                         ; preds = %B2030.preheader, %B2536
  %checked.3.29281 = phi i1 [ %checked.4.3, %B2536 ], [ false, %B2030.preheader ]
  %within.3.29280 = phi i1 [ %within.4.3, %B2536 ], [ false, %B2030.preheader ]
  %.2966.09279 = phi i64 [ %.3034, %B2536 ], [ %storemerge, %B2030.preheader ]
  %.2963.09278 = phi i64 [ %.3038, %B2536 ], [ 0, %B2030.preheader ]
  %.3034 = add nsw i64 %.2966.09279, -1
  %.3038 = add nsw i64 %.2963.09278, 1
  %.3123 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.09278
  %.3124 = load i64, ptr %.3123, align 8
  %.3178 = getelementptr i64, ptr %38, i64 %.2963.09278
  %.3179 = load i64, ptr %.3178, align 8
  %.3239 = getelementptr double, ptr %39, i64 %.2963.09278
  store double 0.000000e+00, ptr %.3239, align 8
  %.3242 = icmp sgt i64 %.3124, -1
  br i1 %.3242, label %B2130, label %B2536

B46.i:                                            ; preds = %B2168
  %.120.i2142 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2116
  %.121.i2143 = load i64, ptr %.120.i2142, align 8, !noalias !50
  %.122.i2144 = icmp eq i64 %.121.i2143, 0
  br i1 %.122.i2144, label %B80.i2148, label %B2268

B80.i2148:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i2142, align 8, !noalias !50
  br label %B2268

B2766.endif.if:                                   ; preds = %B2766
  %.4228 = load ptr, ptr %excinfo.9, align 8
  store ptr %.4228, ptr %excinfo, align 8
  br label %common.ret

B2946.if:                                         ; preds = %B2898
  %.4418 = load i64, ptr %118, align 8
  %.4463 = inttoptr i64 %.4418 to ptr
  tail call void %.4463(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4494 = load i64, ptr %arg.code.4, align 8
  %.4544 = inttoptr i64 %.4494 to ptr
  tail call void %.4544(ptr %.571, ptr %.4518, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4543)
  %.4418.1 = load i64, ptr %119, align 8
  %.4463.1 = inttoptr i64 %.4418.1 to ptr
  tail call void %.4463.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4494.1 = load i64, ptr %arg.code.4, align 8
  %.4544.1 = inttoptr i64 %.4494.1 to ptr
  tail call void %.4544.1(ptr %.571, ptr %.4518, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4543.1)
  %.4418.2 = load i64, ptr %120, align 8
  %.4463.2 = inttoptr i64 %.4418.2 to ptr
  tail call void %.4463.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4494.2 = load i64, ptr %arg.code.4, align 8
  %.4544.2 = inttoptr i64 %.4494.2 to ptr
  tail call void %.4544.2(ptr %.571, ptr %.4518, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4543.2)
  %.4582 = load i64, ptr %.4581, align 8
  %.4627 = inttoptr i64 %.4582 to ptr
  tail call void %.4627(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4659 = load i64, ptr %.4658, align 8
  %.4704 = inttoptr i64 %.4659 to ptr
  tail call void %.4704(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.794, label %B3314, label %B64.if.i3121

B3318.endif.if:                                   ; preds = %B3318
  %.4831 = load ptr, ptr %excinfo.11, align 8
  store ptr %.4831, ptr %excinfo, align 8
  br label %common.ret

B3318.endif.endif:                                ; preds = %B3318
  %.4840 = load i8, ptr %.4776, align 1
  %.4843.not = icmp eq i8 %.4840, 0
  br i1 %.4843.not, label %B3414, label %B3372

B3372.if:                                         ; preds = %_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.12.3, ptr %excinfo, align 8
  br label %common.ret

B3418.if:                                         ; preds = %_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.13.2, ptr %excinfo, align 8
  br label %common.ret

B3784.if:                                         ; preds = %B3742, %B4745
  %active.5.29424 = phi i64 [ %active.6.3, %B4745 ], [ 0, %B3742 ]
  %budget.5.29423 = phi i64 [ %budget.6.3, %B4745 ], [ %.1132, %B3742 ]
  %.5511.09422 = phi i64 [ %.5580, %B4745 ], [ %storemerge, %B3742 ]
  %.5508.09421 = phi i64 [ %.5584, %B4745 ], [ 0, %B3742 ]
  %.5580 = add nsw i64 %.5511.09422, -1
  %.5584 = add nsw i64 %.5508.09421, 1
  %.5669 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5508.09421
  %.5670 = load i64, ptr %.5669, align 8
  %.5675 = icmp slt i64 %.5670, 0
  br i1 %.5675, label %B4745, label %B3832

B4744.endif:                                      ; preds = %B568.i1342, %B4744
  store i64 %active.10.0, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

define internal fastcc range(i32 0, 2) i32 @_ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr noalias nonnull %retptr, ptr noalias nonnull %excinfo, ptr readonly %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.decided, ptr readonly %arg.times.4, i64 %arg.times.5.0, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0) unnamed_addr {
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
  %.5201292.not = icmp slt i64 %arg.shape.0, 1
  %factor.op.mul = mul i64 %arg.decided, 3
  %.idx1277 = mul i64 %arg.lane.0.5.1, 48
  %1 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1277
  %.idx1278 = shl i64 %arg.lane.0.5.1, 6
  %2 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1278
  %.287.i1289.not = icmp slt i64 %arg.shape.1, 1
  %.358.i = shl nsw i64 %arg.shape.1, 4
  %.644.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.706 = getelementptr i8, ptr %arg.code.4, i64 40
  %.747.idx = shl i64 %arg.lane.0.5.1, 6
  %.747 = getelementptr i8, ptr %arg.lane.0.4, i64 %.747.idx
  %.778 = mul i64 %arg.shape.1, %arg.shape.0
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6 = mul nsw i64 %arg.shape.1, 18
  br label %B246.if

B280.loopexit:                                    ; preds = %B122.if.i, %switch.end
  %exitcond1308.not = icmp eq i64 %arg.shape.0, %.533
  br i1 %exitcond1308.not, label %B348, label %B280.if

B348:                                             ; preds = %B280.loopexit, %B246.if
  %.634 = icmp ult i64 %.341.01295, 8
  %.1280 = select i1 %.634, i64 16, i64 17
  %.650 = mul i64 %.644.reass, %.341.01295
  %.707 = load i64, ptr %.706, align 8
  %.782 = mul i64 %.778, %.1280
  %.800 = getelementptr double, ptr %arg.arrays.0.4, i64 %.782
  %.825 = getelementptr double, ptr %arg.arrays.4.4, i64 %.650
  %.826 = inttoptr i64 %.707 to ptr
  tail call void %.826(ptr %.747, ptr %.800, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.825)
  %.399 = icmp sgt i64 %.344.01296, 1
  br i1 %.399, label %B246.if, label %B550

B550:                                             ; preds = %B348
  %.9341297 = icmp sgt i64 %arg.shape.0, 0
  br i1 %.9341297, label %B584.lr.ph, label %B1346

B584.lr.ph:                                       ; preds = %B550
  %.880.11300 = add nsw i64 %arg.shape.0, -1
  %.idx = mul i64 %arg.lane.0.5.1, 56
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx1266 = shl i64 %arg.lane.1.5.1, 5
  %4 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1266
  %.idx1267 = shl i64 %arg.lane.0.5.1, 6
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1267
  %.idx1268 = mul i64 %arg.lane.0.5.1, 40
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1268
  %.1281 = select i1 %.296, i64 0, i64 7
  %storemerge1269 = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.194.i79 = mul nsw i64 %arg.decided, %arg.shape.0
  %.idx1271 = mul i64 %arg.lane.0.5.1, 112
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1271
  %.idx1272 = mul i64 %arg.lane.0.5.1, 120
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1272
  %.idx1273 = mul i64 %arg.lane.0.5.1, 48
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1273
  %.1863 = fmul double %.258, 2.000000e+00
  %.28.i = mul i64 %arg.decided, %arg.shape.0
  %.30.i = mul i64 %.28.i, 3
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.454.i.i = mul i64 %.28.i, 6
  %.456.i.2.i = mul i64 %.28.i, 12
  %.456.i.3.i = mul i64 %.28.i, 18
  %.456.i.4.i = mul i64 %.28.i, 24
  %.190.i.1.i = mul i64 %.28.i, 9
  %.190.i.2.i = mul i64 %.28.i, 15
  %.190.i.3.i = mul i64 %.28.i, 21
  %.idx1275 = shl i64 %arg.lane.0.5.1, 5
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1275
  %11 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  br label %B584

B584:                                             ; preds = %B584.lr.ph, %B1342
  %.924.sroa.0.01305 = phi i64 [ 0, %B584.lr.ph ], [ %.924.sroa.0.0, %B1342 ]
  %.880.11304 = phi i64 [ %.880.11300, %B584.lr.ph ], [ %.880.1, %B1342 ]
  %.877.11303 = phi i64 [ 1, %B584.lr.ph ], [ %.877.1, %B1342 ]
  %some.2.01302 = phi i1 [ false, %B584.lr.ph ], [ %some.3.1, %B1342 ]
  %excinfo.3.01301 = phi ptr [ null, %B584.lr.ph ], [ %excinfo.3.1, %B1342 ]
  %.1009 = icmp slt i64 %.924.sroa.0.01305, 0
  %.1010 = select i1 %.1009, i64 %arg.lane.0.5.1, i64 0
  %.1011 = add i64 %.1010, %.924.sroa.0.01305
  %.1032 = getelementptr double, ptr %3, i64 %.1011
  %.1033 = load double, ptr %.1032, align 8
  %.1065 = select i1 %.1009, i64 %arg.lane.1.5.1, i64 0
  %.1066 = add i64 %.1065, %.924.sroa.0.01305
  %.1087 = getelementptr i64, ptr %4, i64 %.1066
  store i64 -1, ptr %.1087, align 8
  %.1142 = getelementptr double, ptr %5, i64 %.1011
  store double %.1033, ptr %.1142, align 8
  %.1197 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1066
  %.1198 = load i64, ptr %.1197, align 8
  %.1199 = icmp sgt i64 %.1198, -1
  br i1 %.1199, label %B702, label %B1342

B702:                                             ; preds = %B584
  %.1257 = getelementptr double, ptr %6, i64 %.1011
  %.1258 = load double, ptr %.1257, align 8
  %.1259 = fcmp ogt double %.1258, 5.000000e-01
  br i1 %.1259, label %B742, label %B1342

B742:                                             ; preds = %B702
  %.1349 = load i64, ptr %.1087, align 8
  %.1350 = icmp slt i64 %.1349, 0
  br i1 %.1350, label %B830, label %B958

B830:                                             ; preds = %B742, %B920
  %last.2.3 = phi i64 [ %.1356, %B920 ], [ %.1281, %B742 ]
  %.1356 = add nsw i64 %last.2.3, 1
  %.151.i51 = mul nsw i64 %.1356, 3
  %.153.i521270 = add nsw i64 %.151.i51, 1
  %.155.i = mul i64 %.153.i521270, %arg.decided
  br label %B34.i

B34.i:                                            ; preds = %B36.i, %B830
  %.51.i13.0 = phi i64 [ 0, %B830 ], [ %.122.i103, %B36.i ]
  %exitcond1309.not = icmp eq i64 %.51.i13.0, %storemerge1269
  br i1 %exitcond1309.not, label %B830.endif, label %B36.i

B36.i:                                            ; preds = %B34.i
  %.122.i103 = add i64 %.51.i13.0, 1
  %.157.i54 = add nsw i64 %.51.i13.0, %.155.i
  %.159.i = mul nsw i64 %.157.i54, %arg.shape.0
  %.161.i = add nsw i64 %.159.i, %.924.sroa.0.01305
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
  br i1 %.227.i94, label %B830.endif, label %B34.i

B920:                                             ; preds = %B830.endif
  %.1518 = icmp slt i64 %.1371.0, 0
  br i1 %.1518, label %B830, label %B958

B958:                                             ; preds = %B830.endif, %B920, %B742
  %last.3.2 = phi i64 [ %.1281, %B742 ], [ %.1356, %B920 ], [ 8, %B830.endif ]
  br i1 %.296, label %B966, label %B996

B966:                                             ; preds = %B958
  %14 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2
  %switch.gep = getelementptr i8, ptr %14, i64 64
  %switch.load = load double, ptr %switch.gep, align 8
  br label %B996

B996:                                             ; preds = %B966, %B958
  %"$phi996.1.2.2" = phi double [ 0.000000e+00, %B958 ], [ %switch.load, %B966 ]
  %.1630 = getelementptr double, ptr %7, i64 %.1011
  store double %"$phi996.1.2.2", ptr %.1630, align 8
  %15 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %last.3.2
  %switch.gep4 = getelementptr i8, ptr %15, i64 72
  %switch.load5 = load double, ptr %switch.gep4, align 8
  %.1722 = getelementptr double, ptr %8, i64 %.1011
  store double %switch.load5, ptr %.1722, align 8
  %.1778 = load i64, ptr %.1087, align 8
  %.1779 = icmp sgt i64 %.1778, -1
  %.1789 = sext i1 %.1779 to i64
  %"$phi1114.1.2.2" = add nsw i64 %last.3.2, %.1789
  br i1 %.296, label %B1122, label %B1300

B1122:                                            ; preds = %B996
  %.1860 = getelementptr double, ptr %9, i64 %.1011
  %.1861 = load double, ptr %.1860, align 8
  %.1864 = fcmp ogt double %.1861, %.1863
  br i1 %.1864, label %B1170, label %B1300

B1170:                                            ; preds = %B1122
  %16 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1114.1.2.2", i64 0)
  %storemerge306.i = tail call i64 @llvm.smin.i64(i64 %16, i64 7)
  %.310339.i = icmp sgt i64 %"$phi1114.1.2.2", 0
  %.253.1341.i = select i1 %.310339.i, i64 2, i64 1
  %.319342.i = sext i1 %.310339.i to i64
  %.256.1343.i = add nsw i64 %storemerge306.i, %.319342.i
  %.300.sroa.0.0344.i = zext i1 %.310339.i to i64
  br label %B50.i

B50.i:                                            ; preds = %B860.i, %B1170
  %.58.0.i = phi i64 [ 0, %B1170 ], [ %.130.i, %B860.i ]
  %exitcond.not.i = icmp eq i64 %.58.0.i, %storemerge.i
  br i1 %exitcond.not.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit, label %B52.if.i

B216.i:                                           ; preds = %B216.lr.ph.i, %B935.i
  %.300.sroa.0.0348.i = phi i64 [ %.300.sroa.0.0344.i, %B216.lr.ph.i ], [ %.300.sroa.0.0.i, %B935.i ]
  %.256.1347.i = phi i64 [ %.256.1343.i, %B216.lr.ph.i ], [ %.256.1.i, %B935.i ]
  %.253.1346.i = phi i64 [ %.253.1341.i, %B216.lr.ph.i ], [ %.253.1.i, %B935.i ]
  %nearest.3.1345.i = phi double [ 0x7FF0000000000000, %B216.lr.ph.i ], [ %nearest.4.2.i, %B935.i ]
  %.352.i = add nsw i64 %.300.sroa.0.0348.i, -1
  %.354.i = mul nsw i64 %.352.i, %.30.i
  %.356.i = add nsw i64 %.354.i, %.160.i
  %.370.i = icmp slt i64 %.356.i, 0
  %.371.i = select i1 %.370.i, i64 %arg.arrays.4.5.0, i64 0
  %17 = getelementptr double, ptr %arg.arrays.4.4, i64 %.356.i
  %.385.i = getelementptr double, ptr %17, i64 %.371.i
  %.386.i = load double, ptr %.385.i, align 8, !noalias !303
  %.389.i = mul nsw i64 %.300.sroa.0.0348.i, %.30.i
  %.391.i = add nsw i64 %.389.i, %.160.i
  %.405.i = icmp slt i64 %.391.i, 0
  %.406.i = select i1 %.405.i, i64 %arg.arrays.4.5.0, i64 0
  %18 = getelementptr double, ptr %arg.arrays.4.4, i64 %.391.i
  %.420.i = getelementptr double, ptr %18, i64 %.406.i
  %.421.i = load double, ptr %.420.i, align 8, !noalias !303
  %.423.i = add nsw i64 %.300.sroa.0.0348.i, 1
  %.425.i = mul nsw i64 %.423.i, %.30.i
  %.427.i = add nsw i64 %.425.i, %.160.i
  %.441.i = icmp slt i64 %.427.i, 0
  %.442.i = select i1 %.441.i, i64 %arg.arrays.4.5.0, i64 0
  %19 = getelementptr double, ptr %arg.arrays.4.4, i64 %.427.i
  %.456.i = getelementptr double, ptr %19, i64 %.442.i
  %.457.i = load double, ptr %.456.i, align 8, !noalias !303
  %.480.i1282 = fcmp olt double %.421.i, 0.000000e+00
  %.483.i = fneg double %.386.i
  %.487.i = fneg double %.421.i
  %.491.i = fneg double %.457.i
  %c.2.2.i = select i1 %.480.i1282, double %.491.i, double %.457.i
  %b.2.2.i = select i1 %.480.i1282, double %.487.i, double %.421.i
  %a.2.2.i = select i1 %.480.i1282, double %.483.i, double %.386.i
  %.508.i = icmp eq i64 %.300.sroa.0.0348.i, 1
  %.515.i = fcmp ogt double %a.2.2.i, 0.000000e+00
  %or.cond.i = select i1 %.508.i, i1 true, i1 %.515.i
  br i1 %or.cond.i, label %B368.i, label %B424.i

B368.i:                                           ; preds = %B216.i
  %.521.i = icmp eq i64 %.300.sroa.0.0348.i, %"$phi1114.1.2.2"
  %.527.i = fcmp ogt double %c.2.2.i, 0.000000e+00
  %or.cond307.i = select i1 %.521.i, i1 true, i1 %.527.i
  br i1 %or.cond307.i, label %B392.i, label %B424.i

B392.i:                                           ; preds = %B368.i
  %.10.i.i = fcmp olt double %b.2.2.i, %nearest.3.1345.i
  %.11.i.i = select i1 %.10.i.i, double %b.2.2.i, double %nearest.3.1345.i
  br label %B424.i

B424.i:                                           ; preds = %B392.i, %B368.i, %B216.i
  %nearest.6.3.i = phi double [ %.11.i.i, %B392.i ], [ %nearest.3.1345.i, %B368.i ], [ %nearest.3.1345.i, %B216.i ]
  %.572.i = icmp slt i64 %.300.sroa.0.0348.i, %"$phi1114.1.2.2"
  br i1 %.572.i, label %B436.i, label %B935.i

B436.i:                                           ; preds = %B424.i
  %.581.i = fsub double %a.2.2.i, %b.2.2.i
  %.582.i = tail call double @llvm.fabs.f64(double %.581.i)
  %.585.i = fsub double %c.2.2.i, %b.2.2.i
  %.586.i = tail call double @llvm.fabs.f64(double %.585.i)
  %.587.i = fadd double %.582.i, %.586.i
  %.588.i = fmul double %.587.i, 3.000000e+00
  %.589.i = fadd double %.578.i, %.588.i
  %.591.i = fcmp olt double %b.2.2.i, %.589.i
  br i1 %.591.i, label %B546.i, label %B935.i

B546.i:                                           ; preds = %B436.i
  %switch.tableidx6 = add i64 %.300.sroa.0.0348.i, 9
  %20 = icmp ult i64 %switch.tableidx6, 18
  br i1 %20, label %switch.lookup7, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

B752.i:                                           ; preds = %switch.lookup19
  %.800.i = fneg double %.741.i
  %.804.i = fmul double %.790.i, 5.000000e-01
  %.809.i = fdiv double %.804.i, %.773.i
  %.810.i = fcmp ogt double %.809.i, %.800.i
  %.820.i = fcmp olt double %.809.i, %.667.i
  %or.cond309.i = and i1 %.810.i, %.820.i
  br i1 %or.cond309.i, label %B792.i, label %B935.i

B792.i:                                           ; preds = %B752.i
  %.847.i = fmul double %.790.i, 2.500000e-01
  %.849.i = fmul double %.790.i, %.847.i
  %.856.i = fdiv double %.849.i, %.773.i
  %.860.i = fsub double %b.2.2.i, %.856.i
  %.10.i310.i = fcmp olt double %.860.i, %nearest.6.3.i
  %.11.i311.i = select i1 %.10.i310.i, double %.860.i, double %nearest.6.3.i
  br label %B935.i

B860.i:                                           ; preds = %B935.i, %B52.if.i
  %nearest.3.1.lcssa.i = phi double [ 0x7FF0000000000000, %B52.if.i ], [ %nearest.4.2.i, %B935.i ]
  %.929.i = add nsw i64 %.160.i, %.28.i
  %.945.i = icmp slt i64 %.929.i, 0
  %.946.i = select i1 %.945.i, i64 %arg.arrays.4.5.0, i64 0
  %21 = getelementptr double, ptr %arg.arrays.4.4, i64 %.929.i
  %.960.i = getelementptr double, ptr %21, i64 %.946.i
  %.961.i = load double, ptr %.960.i, align 8, !noalias !303
  %.963.i = fcmp ule double %.11.i.i.3.i, %.961.i
  %.966.i = fmul double %.11.i.i.3.i, 1.000000e+01
  %.970.i = fcmp ugt double %nearest.3.1.lcssa.i, %.966.i
  %or.cond308.i = select i1 %.963.i, i1 true, i1 %.970.i
  br i1 %or.cond308.i, label %B50.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

B935.i:                                           ; preds = %switch.lookup19, %B792.i, %B752.i, %B436.i, %B424.i
  %nearest.4.2.i = phi double [ %nearest.6.3.i, %B752.i ], [ %.11.i311.i, %B792.i ], [ %nearest.6.3.i, %B424.i ], [ %nearest.6.3.i, %switch.lookup19 ], [ %nearest.6.3.i, %B436.i ]
  %.310.i = icmp sgt i64 %.256.1347.i, 0
  %.323.i = zext i1 %.310.i to i64
  %.253.1.i = add i64 %.253.1346.i, %.323.i
  %.319.i = sext i1 %.310.i to i64
  %.256.1.i = add nsw i64 %.256.1347.i, %.319.i
  %.300.sroa.0.0.i = select i1 %.310.i, i64 %.253.1346.i, i64 0
  br i1 %.310.i, label %B216.i, label %B860.i

B52.if.i:                                         ; preds = %B50.i
  %.130.i = add i64 %.58.0.i, 1
  %.156.i = add nsw i64 %.58.0.i, %arg.decided
  %.158.i = mul nsw i64 %.156.i, %arg.shape.0
  %.160.i = add nsw i64 %.158.i, %.924.sroa.0.01305
  %.192.i.i = add nsw i64 %.160.i, %.30.i
  %.206.i.i = icmp slt i64 %.192.i.i, 0
  %.207.i.i = select i1 %.206.i.i, i64 %arg.arrays.4.5.0, i64 0
  %22 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.i
  %.221.i.i = getelementptr double, ptr %22, i64 %.207.i.i
  %.222.i.i = load double, ptr %.221.i.i, align 8, !noalias !307
  %.472.i.i = icmp slt i64 %.160.i, 0
  %.473.i.i = select i1 %.472.i.i, i64 %arg.arrays.4.5.0, i64 0
  %23 = getelementptr double, ptr %arg.arrays.4.4, i64 %.160.i
  %.487.i.i = getelementptr double, ptr %23, i64 %.473.i.i
  %.488.i.i = load double, ptr %.487.i.i, align 8, !noalias !307
  %.489.i.i = fmul double %.488.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i = fsub double %.222.i.i, %.489.i.i
  %.458.i.1.i = add nsw i64 %.160.i, %.454.i.i
  %.472.i.1.i = icmp slt i64 %.458.i.1.i, 0
  %.473.i.1.i = select i1 %.472.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %24 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.1.i
  %.487.i.1.i = getelementptr double, ptr %24, i64 %.473.i.1.i
  %.488.i.1.i = load double, ptr %.487.i.1.i, align 8, !noalias !307
  %.489.i.1.i = fmul double %.488.i.1.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i = fsub double %.491.i.i, %.489.i.1.i
  %.458.i.2.i = add nsw i64 %.160.i, %.456.i.2.i
  %.472.i.2.i = icmp slt i64 %.458.i.2.i, 0
  %.473.i.2.i = select i1 %.472.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %25 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.2.i
  %.487.i.2.i = getelementptr double, ptr %25, i64 %.473.i.2.i
  %.488.i.2.i = load double, ptr %.487.i.2.i, align 8, !noalias !307
  %.489.i.2.i = fmul double %.488.i.2.i, 0x3FE1306AA3D795F4
  %26 = fadd double %.491.i.1.i, %.489.i.2.i
  %.458.i.3.i = add nsw i64 %.160.i, %.456.i.3.i
  %.472.i.3.i = icmp slt i64 %.458.i.3.i, 0
  %.473.i.3.i = select i1 %.472.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %27 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.3.i
  %.487.i.3.i = getelementptr double, ptr %27, i64 %.473.i.3.i
  %.488.i.3.i = load double, ptr %.487.i.3.i, align 8, !noalias !307
  %.489.i.3.i = fmul double %.488.i.3.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i = fsub double %26, %.489.i.3.i
  %.458.i.4.i = add nsw i64 %.160.i, %.456.i.4.i
  %.472.i.4.i = icmp slt i64 %.458.i.4.i, 0
  %.473.i.4.i = select i1 %.472.i.4.i, i64 %arg.arrays.4.5.0, i64 0
  %28 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.4.i
  %.487.i.4.i = getelementptr double, ptr %28, i64 %.473.i.4.i
  %.488.i.4.i = load double, ptr %.487.i.4.i, align 8, !noalias !307
  %.489.i.4.i = fmul double %.488.i.4.i, 0x3FA4EAF2D6B11E79
  %29 = fadd double %.491.i.3.i, %.489.i.4.i
  %.502.i.i = tail call double @llvm.fabs.f64(double %29)
  %.10.i.i.i = fcmp ogt double %.502.i.i, 0.000000e+00
  %.11.i.i.i = select i1 %.10.i.i.i, double %.502.i.i, double 0.000000e+00
  %.192.i.1.i = add nsw i64 %.160.i, %.190.i.1.i
  %.206.i.1.i = icmp slt i64 %.192.i.1.i, 0
  %.207.i.1.i = select i1 %.206.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %30 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.1.i
  %.221.i.1.i = getelementptr double, ptr %30, i64 %.207.i.1.i
  %.222.i.1.i = load double, ptr %.221.i.1.i, align 8, !noalias !307
  %.489.i.1384.i = fmul double %.488.i.i, 0x3FA5118805F8B876
  %31 = fadd double %.222.i.1.i, %.489.i.1384.i
  %.489.i.1.1.i = fmul double %.488.i.1.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i = fsub double %31, %.489.i.1.1.i
  %.489.i.2.1.i = fmul double %.488.i.2.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i = fsub double %.491.i.1.1.i, %.489.i.2.1.i
  %.489.i.3.1.i = fmul double %.488.i.3.i, 0x3FC0DA0C684D1D67
  %32 = fadd double %.491.i.2.1.i, %.489.i.3.1.i
  %.489.i.4.1.i = fmul double %.488.i.4.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i = fsub double %32, %.489.i.4.1.i
  %.502.i.1.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i)
  %.10.i.i.1.i = fcmp ogt double %.502.i.1.i, %.11.i.i.i
  %.11.i.i.1.i = select i1 %.10.i.i.1.i, double %.502.i.1.i, double %.11.i.i.i
  %.192.i.2.i = add nsw i64 %.160.i, %.190.i.2.i
  %.206.i.2.i = icmp slt i64 %.192.i.2.i, 0
  %.207.i.2.i = select i1 %.206.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %33 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.2.i
  %.221.i.2.i = getelementptr double, ptr %33, i64 %.207.i.2.i
  %.222.i.2.i = load double, ptr %.221.i.2.i, align 8, !noalias !307
  %.489.i.2411.i = fmul double %.488.i.i, 0x3F9635A30F8F142F
  %.491.i.2412.i = fsub double %.222.i.2.i, %.489.i.2411.i
  %.489.i.1.2.i = fmul double %.488.i.1.i, 0x3FC1EAE0FF33D241
  %34 = fadd double %.491.i.2412.i, %.489.i.1.2.i
  %.489.i.2.2.i = fmul double %.488.i.2.i, 0x3FE1625D59218460
  %.491.i.2.2.i = fsub double %34, %.489.i.2.2.i
  %.489.i.3.2.i = fmul double %.488.i.3.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i = fsub double %.491.i.2.2.i, %.489.i.3.2.i
  %.489.i.4.2.i = fmul double %.488.i.4.i, 0x3FA55161A739EB34
  %35 = fadd double %.491.i.3.2.i, %.489.i.4.2.i
  %.502.i.2.i = tail call double @llvm.fabs.f64(double %35)
  %.10.i.i.2.i = fcmp ogt double %.502.i.2.i, %.11.i.i.1.i
  %.11.i.i.2.i = select i1 %.10.i.i.2.i, double %.502.i.2.i, double %.11.i.i.1.i
  %.192.i.3.i = add nsw i64 %.160.i, %.190.i.3.i
  %.206.i.3.i = icmp slt i64 %.192.i.3.i, 0
  %.207.i.3.i = select i1 %.206.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %36 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.3.i
  %.221.i.3.i = getelementptr double, ptr %36, i64 %.207.i.3.i
  %.222.i.3.i = load double, ptr %.221.i.3.i, align 8, !noalias !307
  %.489.i.3438.i = fmul double %.488.i.i, 0x3FA4F0C0BB579409
  %37 = fadd double %.222.i.3.i, %.489.i.3438.i
  %.489.i.1.3.i = fmul double %.488.i.1.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i = fsub double %37, %.489.i.1.3.i
  %.489.i.2.3.i = fmul double %.488.i.2.i, 0x3FE1F2DB6FEE3151
  %38 = fadd double %.491.i.1.3.i, %.489.i.2.3.i
  %.489.i.3.3.i = fmul double %.488.i.3.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i = fsub double %38, %.489.i.3.3.i
  %.489.i.4.3.i = fmul double %.488.i.4.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i = fsub double %.491.i.3.3.i, %.489.i.4.3.i
  %.502.i.3.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i)
  %.10.i.i.3.i = fcmp ogt double %.502.i.3.i, %.11.i.i.2.i
  %.11.i.i.3.i = select i1 %.10.i.i.3.i, double %.502.i.3.i, double %.11.i.i.2.i
  br i1 %.310339.i, label %B216.lr.ph.i, label %B860.i

B216.lr.ph.i:                                     ; preds = %B52.if.i
  %.578.i = fmul double %.11.i.i.3.i, 1.000000e+01
  br label %B216.i

switch.lookup7:                                   ; preds = %B546.i
  %switch.tableidx10 = add i64 %.300.sroa.0.0348.i, 8
  %39 = icmp ult i64 %switch.tableidx10, 18
  br i1 %39, label %switch.lookup11, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup11:                                  ; preds = %switch.lookup7
  %switch.gep8 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx6
  %switch.load9 = load double, ptr %switch.gep8, align 8
  %switch.gep12 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx10
  %switch.load13 = load double, ptr %switch.gep12, align 8
  %.667.i = fsub double %switch.load9, %switch.load13
  %switch.tableidx14 = add i64 %.300.sroa.0.0348.i, 10
  %40 = icmp ult i64 %switch.tableidx14, 18
  br i1 %40, label %switch.lookup15, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup15:                                  ; preds = %switch.lookup11
  %switch.tableidx18 = add i64 %.300.sroa.0.0348.i, 9
  %41 = icmp ult i64 %switch.tableidx18, 18
  br i1 %41, label %switch.lookup19, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup19:                                  ; preds = %switch.lookup15
  %switch.gep16 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx14
  %switch.load17 = load double, ptr %switch.gep16, align 8
  %switch.gep20 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.20, i64 %switch.tableidx18
  %switch.load21 = load double, ptr %switch.gep20, align 8
  %.741.i = fsub double %switch.load17, %switch.load21
  %.757.i = fdiv double %.585.i, %.741.i
  %.760.i = fsub double %b.2.2.i, %a.2.2.i
  %.765.i = fdiv double %.760.i, %.667.i
  %.766.i = fsub double %.757.i, %.765.i
  %.769.i = fadd double %.667.i, %.741.i
  %.773.i = fdiv double %.766.i, %.769.i
  %.789.i = fmul double %.667.i, %.773.i
  %.790.i = fadd double %.765.i, %.789.i
  %.795.i = fcmp ogt double %.773.i, 0.000000e+00
  br i1 %.795.i, label %B752.i, label %B935.i

_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B50.i, %B860.i, %B546.i, %switch.lookup7, %switch.lookup11, %switch.lookup15
  %.1897.not = phi i1 [ true, %B546.i ], [ true, %switch.lookup15 ], [ true, %switch.lookup11 ], [ true, %switch.lookup7 ], [ %exitcond.not.i, %B860.i ], [ %exitcond.not.i, %B50.i ]
  %excinfo.3.3 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %B546.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup15 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup11 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup7 ], [ %excinfo.3.01301, %B860.i ], [ %excinfo.3.01301, %B50.i ]
  %.1886.not = phi i1 [ false, %B546.i ], [ false, %switch.lookup15 ], [ false, %switch.lookup11 ], [ false, %switch.lookup7 ], [ true, %B860.i ], [ true, %B50.i ]
  %common.ret.op.i = phi i32 [ 1, %B546.i ], [ 1, %switch.lookup15 ], [ 1, %switch.lookup11 ], [ 1, %switch.lookup7 ], [ 0, %B860.i ], [ 0, %B50.i ]
  br i1 %.1886.not, label %B1170.endif.endif, label %B1170.endif.if, !prof !53

B1208:                                            ; preds = %B1170.endif.endif
  %.1972 = fmul double %.1861, 5.000000e-01
  store double 0.000000e+00, ptr %.1257, align 8, !noalias !311
  %.161.i230 = getelementptr double, ptr %10, i64 %.1011
  store double 0.000000e+00, ptr %.161.i230, align 8, !noalias !311
  %.214.i273 = getelementptr double, ptr %11, i64 %.1011
  store double %.1972, ptr %.214.i273, align 8, !noalias !311
  %.268.i313 = load i64, ptr %.1197, align 8, !noalias !311
  %.294.i = icmp slt i64 %.268.i313, 0
  %.295.i = select i1 %.294.i, i64 %arg.results.3.5.0, i64 0
  %.296.i324 = add i64 %.295.i, %.268.i313
  %.316.i333 = mul i64 %.296.i324, %arg.results.3.5.1
  %.320.i = getelementptr i64, ptr %arg.results.3.4, i64 %.316.i333
  %.321.i = load i64, ptr %.320.i, align 8, !noalias !311
  %.322.i336 = add nsw i64 %.321.i, -1
  store i64 %.322.i336, ptr %.320.i, align 8, !noalias !311
  %.426.i = load i64, ptr %.1197, align 8, !noalias !311
  %.452.i = icmp slt i64 %.426.i, 0
  %.453.i = select i1 %.452.i, i64 %arg.results.3.5.0, i64 0
  %.454.i = add i64 %.453.i, %.426.i
  %.474.i = mul i64 %.454.i, %arg.results.3.5.1
  %42 = getelementptr i64, ptr %arg.results.3.4, i64 %.474.i
  %.478.i = getelementptr i8, ptr %42, i64 24
  %.479.i = load i64, ptr %.478.i, align 8, !noalias !311
  %.480.i = add nsw i64 %.479.i, 1
  store i64 %.480.i, ptr %.478.i, align 8, !noalias !311
  store i64 -1, ptr %.1087, align 8
  br label %B1300

B1300:                                            ; preds = %B996, %B1208, %B1170.endif.endif, %B1122
  %excinfo.3.2 = phi ptr [ %excinfo.3.3, %B1170.endif.endif ], [ %excinfo.3.3, %B1208 ], [ %excinfo.3.01301, %B1122 ], [ %excinfo.3.01301, %B996 ]
  br i1 %some.2.01302, label %B1342, label %B1304

B1304:                                            ; preds = %B1300
  %.2136 = load i64, ptr %.1087, align 8
  %.2137 = icmp sgt i64 %.2136, -1
  br label %B1342

B1342:                                            ; preds = %B1300, %B1304, %B702, %B584
  %excinfo.3.1 = phi ptr [ %excinfo.3.2, %B1300 ], [ %excinfo.3.2, %B1304 ], [ %excinfo.3.01301, %B702 ], [ %excinfo.3.01301, %B584 ]
  %some.3.1 = phi i1 [ true, %B1300 ], [ %.2137, %B1304 ], [ %some.2.01302, %B702 ], [ %some.2.01302, %B584 ]
  %.934 = icmp sgt i64 %.880.11304, 0
  %.947 = zext i1 %.934 to i64
  %.877.1 = add i64 %.877.11303, %.947
  %.943 = sext i1 %.934 to i64
  %.880.1 = add nsw i64 %.880.11304, %.943
  %.924.sroa.0.0 = select i1 %.934, i64 %.877.11303, i64 0
  br i1 %.934, label %B584, label %B1346.loopexit

common.ret:                                       ; preds = %B1170.endif.if, %B1346
  %common.ret.op = phi i32 [ 0, %B1346 ], [ %common.ret.op.i, %B1170.endif.if ]
  ret i32 %common.ret.op

B1346.loopexit:                                   ; preds = %B1342
  %43 = zext i1 %some.3.1 to i8
  br label %B1346

B1346:                                            ; preds = %B1346.loopexit, %B550
  %some.2.0.lcssa = phi i8 [ 0, %B550 ], [ %43, %B1346.loopexit ]
  store i8 %some.2.0.lcssa, ptr %retptr, align 1
  br label %common.ret

B246.if:                                          ; preds = %entry, %B348
  %.344.01296 = phi i64 [ %.354, %entry ], [ %.408, %B348 ]
  %.341.01295 = phi i64 [ %., %entry ], [ %.412, %B348 ]
  %.408 = add nsw i64 %.344.01296, -1
  %.412 = add nsw i64 %.341.01295, 1
  br i1 %.5201292.not, label %B348, label %B280.if.preheader

B280.if.preheader:                                ; preds = %B246.if
  %44 = icmp ult i64 %.341.01295, 8
  %switch.gep23 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.21, i64 %.341.01295
  br label %B280.if

B280.if:                                          ; preds = %B280.if.preheader, %B280.loopexit
  %.464.01293 = phi i64 [ %.533, %B280.loopexit ], [ 0, %B280.if.preheader ]
  %.533 = add nsw i64 %.464.01293, 1
  br i1 %44, label %switch.lookup22, label %switch.end

switch.lookup22:                                  ; preds = %B280.if
  %switch.load24 = load double, ptr %switch.gep23, align 8
  br label %switch.end

switch.end:                                       ; preds = %B280.if, %switch.lookup22
  %.575 = phi double [ %switch.load24, %switch.lookup22 ], [ 1.000000e+00, %B280.if ]
  %.92.i = getelementptr double, ptr %arg.lane.0.4, i64 %.464.01293
  %.93.i = load double, ptr %.92.i, align 8, !noalias !314
  %.146.i = getelementptr double, ptr %1, i64 %.464.01293
  %.147.i = load double, ptr %.146.i, align 8, !noalias !314
  %.149.i = fmul double %.575, %.147.i
  %.150.i = fadd double %.93.i, %.149.i
  %.203.i = getelementptr double, ptr %2, i64 %.464.01293
  store double %.150.i, ptr %.203.i, align 8, !noalias !314
  br i1 %.287.i1289.not, label %B280.loopexit, label %B122.if.i.lr.ph

B122.if.i.lr.ph:                                  ; preds = %switch.end
  %.247.i.i = fsub double 1.000000e+00, %.575
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep27 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep29 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep31 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep33 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep35 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep37 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep39 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  %invariant.gep41 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01293
  br label %B122.if.i

B122.if.i:                                        ; preds = %B122.if.i.lr.ph, %B122.if.i
  %.229.i.01290 = phi i64 [ 0, %B122.if.i.lr.ph ], [ %.300.i, %B122.if.i ]
  %.157.i.i = add nsw i64 %.155.i.i, %.229.i.01290
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep, align 8, !noalias !318
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.575, %.193.i.i
  %.157.i.i.1 = add nsw i64 %.155.i.i.1, %.229.i.01290
  %.159.i.i.1 = mul nsw i64 %.157.i.i.1, %arg.shape.0
  %gep28 = getelementptr double, ptr %invariant.gep27, i64 %.159.i.i.1
  %.191.i.i.1 = load double, ptr %gep28, align 8, !noalias !318
  %.193.i.i.1 = fadd double %.253.i.i, %.191.i.i.1
  %.253.i.i.1 = fmul double %.247.i.i, %.193.i.i.1
  %.157.i.i.2 = add nsw i64 %.155.i.i.2, %.229.i.01290
  %.159.i.i.2 = mul nsw i64 %.157.i.i.2, %arg.shape.0
  %gep30 = getelementptr double, ptr %invariant.gep29, i64 %.159.i.i.2
  %.191.i.i.2 = load double, ptr %gep30, align 8, !noalias !318
  %.193.i.i.2 = fadd double %.253.i.i.1, %.191.i.i.2
  %.253.i.i.2 = fmul double %.575, %.193.i.i.2
  %.157.i.i.3 = add nsw i64 %.155.i.i.3, %.229.i.01290
  %.159.i.i.3 = mul nsw i64 %.157.i.i.3, %arg.shape.0
  %gep32 = getelementptr double, ptr %invariant.gep31, i64 %.159.i.i.3
  %.191.i.i.3 = load double, ptr %gep32, align 8, !noalias !318
  %.193.i.i.3 = fadd double %.253.i.i.2, %.191.i.i.3
  %.253.i.i.3 = fmul double %.247.i.i, %.193.i.i.3
  %.157.i.i.4 = add nsw i64 %.155.i.i.4, %.229.i.01290
  %.159.i.i.4 = mul nsw i64 %.157.i.i.4, %arg.shape.0
  %gep34 = getelementptr double, ptr %invariant.gep33, i64 %.159.i.i.4
  %.191.i.i.4 = load double, ptr %gep34, align 8, !noalias !318
  %.193.i.i.4 = fadd double %.253.i.i.3, %.191.i.i.4
  %.253.i.i.4 = fmul double %.575, %.193.i.i.4
  %.157.i.i.5 = add nsw i64 %.155.i.i.5, %.229.i.01290
  %.159.i.i.5 = mul nsw i64 %.157.i.i.5, %arg.shape.0
  %gep36 = getelementptr double, ptr %invariant.gep35, i64 %.159.i.i.5
  %.191.i.i.5 = load double, ptr %gep36, align 8, !noalias !318
  %.193.i.i.5 = fadd double %.253.i.i.4, %.191.i.i.5
  %.253.i.i.5 = fmul double %.247.i.i, %.193.i.i.5
  %.157.i.i.6 = add nsw i64 %.155.i.i.6, %.229.i.01290
  %.159.i.i.6 = mul nsw i64 %.157.i.i.6, %arg.shape.0
  %gep38 = getelementptr double, ptr %invariant.gep37, i64 %.159.i.i.6
  %.191.i.i.6 = load double, ptr %gep38, align 8, !noalias !318
  %.193.i.i.6 = fadd double %.253.i.i.5, %.191.i.i.6
  %.253.i.i.6 = fmul double %.575, %.193.i.i.6
  %.300.i = add nsw i64 %.229.i.01290, 1
  %.271.i.i = mul nsw i64 %.229.i.01290, %arg.shape.0
  %gep40 = getelementptr double, ptr %invariant.gep39, i64 %.271.i.i
  %.309.i.i = load double, ptr %gep40, align 8, !noalias !318
  %.313.i.i = fadd double %.253.i.i.6, %.309.i.i
  %.359.i = add nsw i64 %.229.i.01290, %.358.i
  %.361.i = mul nsw i64 %.359.i, %arg.shape.0
  %gep42 = getelementptr double, ptr %invariant.gep41, i64 %.361.i
  store double %.313.i.i, ptr %gep42, align 8, !noalias !314
  %exitcond.not = icmp eq i64 %arg.shape.1, %.300.i
  br i1 %exitcond.not, label %B280.loopexit, label %B122.if.i

B830.endif:                                       ; preds = %B36.i, %B34.i
  %.1371.0 = phi i64 [ %.51.i13.0, %B36.i ], [ -1, %B34.i ]
  store i64 %.1371.0, ptr %.1087, align 8
  %exitcond1310.not = icmp eq i64 %last.2.3, 7
  br i1 %exitcond1310.not, label %B958, label %B920

B1170.endif.if:                                   ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.3.3, ptr %excinfo, align 8
  br label %common.ret

B1170.endif.endif:                                ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1897.not, label %B1300, label %B1208
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
  br i1 %.281834.not, label %B794, label %B118.if.lr.ph

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
  %"$phi776.2.2.2.in.v" = select i1 %.1351, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4
  br label %B118.if

B116.loopexit:                                    ; preds = %B720.if, %B604
  %exitcond840.not = icmp eq i64 %.294, %arg.points.0.5.0
  br i1 %exitcond840.not, label %B794, label %B118.if

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
  br label %B358

B358:                                             ; preds = %B284, %B118.if
  %piece.3.1 = phi i64 [ %.417, %B284 ], [ %piece.2.0837, %B118.if ]
  br i1 %or.cond, label %B392, label %B604

B392:                                             ; preds = %B358
  %.822 = load i64, ptr %.821, align 8
  %.825 = mul nsw i64 %.222.0835, %arg.n
  %.844 = getelementptr double, ptr %arg.points.3.4, i64 %.825
  %.870 = inttoptr i64 %.822 to ptr
  tail call void %.870(ptr nonnull %arg.points.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br label %B496.if

B530:                                             ; preds = %B496.if
  %.1086 = load i64, ptr %.1085, align 8
  %.1134 = inttoptr i64 %.1086 to ptr
  tail call void %.1134(ptr nonnull %arg.points.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B604

B604:                                             ; preds = %B530, %B358
  %.1167 = load i64, ptr %.1166, align 8
  %.1170 = mul nsw i64 %.222.0835, %arg.n
  %.1189 = getelementptr double, ptr %arg.points.3.4, i64 %.1170
  %.1215 = inttoptr i64 %.1167 to ptr
  tail call void %.1215(ptr nonnull %arg.points.2.4, ptr %.1189, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br i1 %.1309831.not, label %B116.loopexit, label %B720.if.lr.ph

B720.if.lr.ph:                                    ; preds = %B604
  %.1471 = mul i64 %.222.0835, %arg.out.5.1
  %2 = getelementptr double, ptr %arg.out.4, i64 %.1471
  br label %B720.if

B794:                                             ; preds = %B116.loopexit, %entry
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
  br i1 %.419.not, label %B358, label %B168

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

B496.if:                                          ; preds = %B392, %B496.if
  %.896.0829 = phi i64 [ 0, %B392 ], [ %.965, %B496.if ]
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
  br i1 %exitcond838.not, label %B530, label %B496.if

B720.if:                                          ; preds = %B720.if.lr.ph, %B720.if
  %.1253.0832 = phi i64 [ 0, %B720.if.lr.ph ], [ %.1322, %B720.if ]
  %.1322 = add nsw i64 %.1253.0832, 1
  %"$phi776.2.2.2.in" = getelementptr double, ptr %"$phi776.2.2.2.in.v", i64 %.1253.0832
  %"$phi776.2.2.2" = load double, ptr %"$phi776.2.2.2.in", align 8
  %10 = getelementptr double, ptr %2, i64 %.1253.0832
  store double %"$phi776.2.2.2", ptr %10, align 8
  %exitcond839.not = icmp eq i64 %arg.out.5.1, %.1322
  br i1 %exitcond839.not, label %B116.loopexit, label %B720.if
}


!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = distinct !{!6, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!7 = !{!8, !10}
!8 = distinct !{!8, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!9 = distinct !{!9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!10 = distinct !{!10, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN12clpt_control6native9for_numba11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!13 = distinct !{!13, !"_ZN12clpt_control6native9for_numba11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!14 = distinct !{!14, !13, !"_ZN12clpt_control6native9for_numba11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!17 = distinct !{!17, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!18 = !{!19, !12, !14}
!19 = distinct !{!19, !20, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!20 = distinct !{!20, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!21 = !{!22, !24, !12, !14}
!22 = distinct !{!22, !23, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!23 = distinct !{!23, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!24 = distinct !{!24, !23, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!25 = !{!26}
!26 = distinct !{!26, !27, !"_ZN12clpt_control6native9for_numba9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!27 = distinct !{!27, !"_ZN12clpt_control6native9for_numba9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!28 = !{!29, !31, !26}
!29 = distinct !{!29, !30, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!30 = distinct !{!30, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!31 = distinct !{!31, !30, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!32 = !{!33, !35, !29, !31, !26}
!33 = distinct !{!33, !34, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!34 = distinct !{!34, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!35 = distinct !{!35, !34, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!36 = !{!37, !26}
!37 = distinct !{!37, !38, !"_ZN12clpt_control6native9for_numba6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN12clpt_control6native9for_numba6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!39 = !{!40, !42, !43}
!40 = distinct !{!40, !41, !"_ZN12clpt_control6native9for_numba5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!41 = distinct !{!41, !"_ZN12clpt_control6native9for_numba5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!42 = distinct !{!42, !41, !"_ZN12clpt_control6native9for_numba5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!43 = distinct !{!43, !44, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!43}
!46 = !{!47, !49}
!47 = distinct !{!47, !48, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!48 = distinct !{!48, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!49 = distinct !{!49, !48, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!52 = distinct !{!52, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!53 = !{!"branch_weights", i32 99, i32 1}
!54 = !{!55, !57}
!55 = distinct !{!55, !56, !"_ZN12clpt_control6native9for_numba17check_interpolantB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!56 = distinct !{!56, !"_ZN12clpt_control6native9for_numba17check_interpolantB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!57 = distinct !{!57, !56, !"_ZN12clpt_control6native9for_numba17check_interpolantB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!58 = !{!59, !55, !57}
!59 = distinct !{!59, !60, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!60 = distinct !{!60, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!61 = !{!62, !64}
!62 = distinct !{!62, !63, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!63 = distinct !{!63, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!64 = distinct !{!64, !63, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!65 = !{!66, !68, !62, !64}
!66 = distinct !{!66, !67, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!67 = distinct !{!67, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!68 = distinct !{!68, !67, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!69 = !{!70, !72, !66, !68, !62, !64}
!70 = distinct !{!70, !71, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!71 = distinct !{!71, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!72 = distinct !{!72, !71, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!73 = !{!74, !76, !66, !68, !62, !64}
!74 = distinct !{!74, !75, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!75 = distinct !{!75, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!76 = distinct !{!76, !75, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!77 = !{!78, !80, !66, !68, !62, !64}
!78 = distinct !{!78, !79, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!79 = distinct !{!79, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!80 = distinct !{!80, !79, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!81 = !{!82, !84, !62, !64}
!82 = distinct !{!82, !83, !"_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!83 = distinct !{!83, !"_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!84 = distinct !{!84, !83, !"_ZN12clpt_control6native9for_numba7bracketB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE28Literal_5bbool_5d_28False_29x8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!85 = !{!86, !88, !82, !84, !62, !64}
!86 = distinct !{!86, !87, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!87 = distinct !{!87, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!88 = distinct !{!88, !87, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!89 = !{!90, !92, !82, !84, !62, !64}
!90 = distinct !{!90, !91, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!92 = distinct !{!92, !91, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!93 = !{!"branch_weights", i32 1, i32 99}
!94 = !{!95, !97, !62, !64}
!95 = distinct !{!95, !96, !"_ZN12clpt_control6native9for_numba6narrowB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!96 = distinct !{!96, !"_ZN12clpt_control6native9for_numba6narrowB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!97 = distinct !{!97, !96, !"_ZN12clpt_control6native9for_numba6narrowB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!98 = !{!99, !101, !95, !97, !62, !64}
!99 = distinct !{!99, !100, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!100 = distinct !{!100, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!101 = distinct !{!101, !100, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!102 = !{!103, !105, !95, !97, !62, !64}
!103 = distinct !{!103, !104, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!104 = distinct !{!104, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!105 = distinct !{!105, !104, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!106 = !{!107, !109, !95, !97, !62, !64}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!109 = distinct !{!109, !108, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!110 = !{!111, !113, !107, !109, !95, !97, !62, !64}
!111 = distinct !{!111, !112, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!112 = distinct !{!112, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!113 = distinct !{!113, !112, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!114 = !{!115, !117, !95, !97, !62, !64}
!115 = distinct !{!115, !116, !"_ZN12clpt_control6native9for_numba7to_turnB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!116 = distinct !{!116, !"_ZN12clpt_control6native9for_numba7to_turnB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!117 = distinct !{!117, !116, !"_ZN12clpt_control6native9for_numba7to_turnB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!118 = !{!119, !121, !122, !124, !62, !64}
!119 = distinct !{!119, !120, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!120 = distinct !{!120, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!121 = distinct !{!121, !120, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!122 = distinct !{!122, !123, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!123 = distinct !{!123, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!124 = distinct !{!124, !123, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!125 = !{!122, !124, !62, !64}
!126 = !{!127, !129, !62, !64}
!127 = distinct !{!127, !128, !"_ZN12clpt_control6native9for_numba14measure_effectB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!128 = distinct !{!128, !"_ZN12clpt_control6native9for_numba14measure_effectB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!129 = distinct !{!129, !128, !"_ZN12clpt_control6native9for_numba14measure_effectB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!130 = !{!131, !133, !127, !129, !62, !64}
!131 = distinct !{!131, !132, !"_ZN12clpt_control6native9for_numba12first_passedB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!132 = distinct !{!132, !"_ZN12clpt_control6native9for_numba12first_passedB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!133 = distinct !{!133, !132, !"_ZN12clpt_control6native9for_numba12first_passedB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!134 = !{!135, !137, !127, !129, !62, !64}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!137 = distinct !{!137, !136, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!138 = !{!139, !141, !127, !129, !62, !64}
!139 = distinct !{!139, !140, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!140 = distinct !{!140, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!141 = distinct !{!141, !140, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!142 = !{!143, !145, !62, !64}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !144, !"_ZN12clpt_control6native9for_numba7bracketB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE27Literal_5bbool_5d_28True_2923Literal_5bint_5d_280_298UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!146 = !{!147, !149, !143, !145, !62, !64}
!147 = distinct !{!147, !148, !"_ZN12clpt_control6native9for_numba7to_turnB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN12clpt_control6native9for_numba7to_turnB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !148, !"_ZN12clpt_control6native9for_numba7to_turnB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!150 = !{!151, !153, !143, !145, !62, !64}
!151 = distinct !{!151, !152, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!153 = distinct !{!153, !152, !"_ZN12clpt_control6native9for_numba7to_turnB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!154 = !{!155, !157, !62, !64}
!155 = distinct !{!155, !156, !"_ZN12clpt_control6native9for_numba6narrowB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!156 = distinct !{!156, !"_ZN12clpt_control6native9for_numba6narrowB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!157 = distinct !{!157, !156, !"_ZN12clpt_control6native9for_numba6narrowB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEd5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!158 = !{!159, !161, !155, !157, !62, !64}
!159 = distinct !{!159, !160, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!160 = distinct !{!160, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!161 = distinct !{!161, !160, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!162 = !{!163, !165, !155, !157, !62, !64}
!163 = distinct !{!163, !164, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %retptr"}
!164 = distinct !{!164, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx"}
!165 = distinct !{!165, !164, !"_ZN12clpt_control6native9for_numba5triedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi2E1C7mutable7alignedEdx: %excinfo"}
!166 = !{!167, !169, !155, !157, !62, !64}
!167 = distinct !{!167, !168, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!168 = distinct !{!168, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!169 = distinct !{!169, !168, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!170 = !{!171, !173, !167, !169, !155, !157, !62, !64}
!171 = distinct !{!171, !172, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!172 = distinct !{!172, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!173 = distinct !{!173, !172, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!174 = !{!175, !177, !155, !157, !62, !64}
!175 = distinct !{!175, !176, !"_ZN12clpt_control6native9for_numba7to_turnB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!176 = distinct !{!176, !"_ZN12clpt_control6native9for_numba7to_turnB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!177 = distinct !{!177, !176, !"_ZN12clpt_control6native9for_numba7to_turnB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!178 = !{!179, !62, !64}
!179 = distinct !{!179, !180, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!180 = distinct !{!180, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!181 = !{!182, !184, !62, !64}
!182 = distinct !{!182, !183, !"_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!183 = distinct !{!183, !"_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE"}
!184 = distinct !{!184, !183, !"_ZN12clpt_control6native9for_numba8may_hideB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!185 = !{!186, !188, !182, !184, !62, !64}
!186 = distinct !{!186, !187, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!187 = distinct !{!187, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!188 = distinct !{!188, !187, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!189 = !{!190, !62, !64}
!190 = distinct !{!190, !191, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!191 = distinct !{!191, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!192 = !{!193, !195, !62, !64}
!193 = distinct !{!193, !194, !"_ZN12clpt_control6native9for_numba12first_passedB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!194 = distinct !{!194, !"_ZN12clpt_control6native9for_numba12first_passedB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE"}
!195 = distinct !{!195, !194, !"_ZN12clpt_control6native9for_numba12first_passedB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!196 = !{!197, !199, !62, !64}
!197 = distinct !{!197, !198, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!198 = distinct !{!198, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!199 = distinct !{!199, !198, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!200 = !{!201, !203, !197, !199, !62, !64}
!201 = distinct !{!201, !202, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!202 = distinct !{!202, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!203 = distinct !{!203, !202, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!204 = !{!205, !207}
!205 = distinct !{!205, !206, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!206 = distinct !{!206, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!207 = distinct !{!207, !206, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!208 = !{!209, !211, !205, !207}
!209 = distinct !{!209, !210, !"_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!210 = distinct !{!210, !"_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!211 = distinct !{!211, !210, !"_ZN12clpt_control6native9for_numba11mark_passedB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!212 = !{!213, !215, !209, !211, !205, !207}
!213 = distinct !{!213, !214, !"_ZN12clpt_control6native9for_numba12first_passedB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!214 = distinct !{!214, !"_ZN12clpt_control6native9for_numba12first_passedB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE"}
!215 = distinct !{!215, !214, !"_ZN12clpt_control6native9for_numba12first_passedB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!216 = !{!217, !219, !209, !211, !205, !207}
!217 = distinct !{!217, !218, !"_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!218 = distinct !{!218, !"_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE"}
!219 = distinct !{!219, !218, !"_ZN12clpt_control6native9for_numba8may_hideB3v54B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!220 = !{!221, !223, !217, !219, !209, !211, !205, !207}
!221 = distinct !{!221, !222, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!222 = distinct !{!222, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!223 = distinct !{!223, !222, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!224 = !{!225, !209, !211, !205, !207}
!225 = distinct !{!225, !226, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!226 = distinct !{!226, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!227 = !{!228, !230, !209, !211, !205, !207}
!228 = distinct !{!228, !229, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!229 = distinct !{!229, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!230 = distinct !{!230, !229, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!231 = !{!232, !234, !228, !230, !209, !211, !205, !207}
!232 = distinct !{!232, !233, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!233 = distinct !{!233, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!234 = distinct !{!234, !233, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!235 = !{!"branch_weights", i32 101, i32 99}
!236 = !{!"branch_weights", i32 301, i32 99}
!237 = !{!238, !205, !207}
!238 = distinct !{!238, !239, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!239 = distinct !{!239, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!240 = !{!241}
!241 = distinct !{!241, !242, !"_ZN12clpt_control6native9for_numba6sampleB3v55B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!242 = distinct !{!242, !"_ZN12clpt_control6native9for_numba6sampleB3v55B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!243 = !{!244, !246, !241}
!244 = distinct !{!244, !245, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!245 = distinct !{!245, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!246 = distinct !{!246, !245, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!247 = !{!248, !250}
!248 = distinct !{!248, !249, !"_ZN12clpt_control6native9for_numba11decide_anewB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!249 = distinct !{!249, !"_ZN12clpt_control6native9for_numba11decide_anewB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!250 = distinct !{!250, !249, !"_ZN12clpt_control6native9for_numba11decide_anewB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!251 = !{!252, !248, !250}
!252 = distinct !{!252, !253, !"_ZN12clpt_control6native9for_numba4failB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!253 = distinct !{!253, !"_ZN12clpt_control6native9for_numba4failB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!254 = !{!255, !257}
!255 = distinct !{!255, !256, !"_ZN12clpt_control6native9for_numba6at_endB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!256 = distinct !{!256, !"_ZN12clpt_control6native9for_numba6at_endB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!257 = distinct !{!257, !258, !"_ZN12clpt_control6native9for_numba4jumpB3v58B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!258 = distinct !{!258, !"_ZN12clpt_control6native9for_numba4jumpB3v58B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!259 = !{!257}
!260 = !{!261, !263, !257}
!261 = distinct !{!261, !262, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!262 = distinct !{!262, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!263 = distinct !{!263, !262, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!264 = !{!265, !257}
!265 = distinct !{!265, !266, !"_ZN12clpt_control6native9for_numba6at_endB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!266 = distinct !{!266, !"_ZN12clpt_control6native9for_numba6at_endB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!267 = !{!268, !257}
!268 = distinct !{!268, !269, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!269 = distinct !{!269, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!270 = !{!271, !257}
!271 = distinct !{!271, !272, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!272 = distinct !{!272, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!273 = !{!274}
!274 = distinct !{!274, !275, !"_ZN12clpt_control6native9for_numba4failB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!275 = distinct !{!275, !"_ZN12clpt_control6native9for_numba4failB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!276 = !{!277, !279}
!277 = distinct !{!277, !278, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!278 = distinct !{!278, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!279 = distinct !{!279, !278, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!280 = !{!281, !283, !277, !279}
!281 = distinct !{!281, !282, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!282 = distinct !{!282, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!283 = distinct !{!283, !282, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!284 = !{!285}
!285 = distinct !{!285, !286, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!286 = distinct !{!286, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!287 = !{!288, !290, !285}
!288 = distinct !{!288, !289, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!289 = distinct !{!289, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!290 = distinct !{!290, !289, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!291 = !{!292, !294}
!292 = distinct !{!292, !293, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!293 = distinct !{!293, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!294 = distinct !{!294, !293, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!295 = !{!296, !298}
!296 = distinct !{!296, !297, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!297 = distinct !{!297, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!298 = distinct !{!298, !297, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!299 = !{!300, !302}
!300 = distinct !{!300, !301, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!301 = distinct !{!301, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!302 = distinct !{!302, !301, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!303 = !{!304, !306}
!304 = distinct !{!304, !305, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!305 = distinct !{!305, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!306 = distinct !{!306, !305, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!307 = !{!308, !310, !304, !306}
!308 = distinct !{!308, !309, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!309 = distinct !{!309, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!310 = distinct !{!310, !309, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!311 = !{!312}
!312 = distinct !{!312, !313, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!313 = distinct !{!313, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!314 = !{!315, !317}
!315 = distinct !{!315, !316, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!316 = distinct !{!316, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!317 = distinct !{!317, !316, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!318 = !{!319, !321, !315, !317}
!319 = distinct !{!319, !320, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!320 = distinct !{!320, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!321 = distinct !{!321, !320, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}

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
