; sha256 8e78393eb73b67b442a0958f718cea39a11366cb45d442f37ba25d624c59afa1

@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.16 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.17 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.15 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.16, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.17, ptr null, i32 0 }
@switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.5 = private unnamed_addr constant [8 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8
@switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, i64 %arg.linear.3.0, i64 %arg.linear.3.1, i64 %arg.linear.3.2, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.4172 = alloca i8, align 1
  store i8 0, ptr %.4172, align 1
  %excinfo.9 = alloca ptr, align 8
  store ptr null, ptr %excinfo.9, align 8
  %.4774 = alloca i8, align 1
  store i8 0, ptr %.4774, align 1
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
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.27.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 224
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B416.if

B458:                                             ; preds = %B416.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i8927 = getelementptr double, ptr %0, i64 %.780.09192
  store double 0.000000e+00, ptr %.293.i8927, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B502, label %B132.i

B132.i:                                           ; preds = %B458
  %.359.i8928 = add nsw i64 %.236.i, 1
  store i64 %.359.i8928, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i8929 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i8930 = load i64, ptr %.453.i8929, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i8930, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i8930
  %.484.i8931 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i8932 = load i64, ptr %.484.i8931, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.09192
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.780.09192
  store i64 %.485.i8932, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.780.09192
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.780.09192
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep9357 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.780.09192
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i8934 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i8934, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i8935

B76.if.i.i8935:                                   ; preds = %B76.if.i.i8935, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i8935 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i8936 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i8936, %.780.09192
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i8935

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B502

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep9358 = getelementptr double, ptr %invariant.gep9357, i64 %.895.i
  store double %.893.i, ptr %gep9358, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i8935, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep9359 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.780.09192
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep9360 = getelementptr double, ptr %invariant.gep9359, i64 %.1207.i
  store double %.1205.i, ptr %gep9360, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.780.09192
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
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.780.09192
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i8927, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.780.09192
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.780.09192
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.780.09192
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B502, label %B888.i

B502:                                             ; preds = %B888.i, %B458, %B580.if.i, %B416.if
  %.1071 = load i64, ptr %265, align 8
  %.1072 = icmp sgt i64 %.1071, -1
  %.8904 = zext i1 %.1072 to i64
  %.1089 = add nsw i64 %active.4.09194, %.8904
  %.838 = icmp sgt i64 %.783.09193, 1
  br i1 %.838, label %B416.if, label %B556

B556:                                             ; preds = %B502, %B380
  %active.4.0.lcssa = phi i64 [ 0, %B380 ], [ %.1089, %B502 ]
  %.1106.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1122 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1106.not, i1 %.1122, i1 false
  br i1 %or.cond, label %B584.preheader, label %B4734

B584.preheader:                                   ; preds = %B556
  %.1166 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.1, 14
  %factor.op.mul9327 = mul i64 %arg.shape.1, 15
  %factor.op.mul9328 = shl i64 %arg.shape.1, 4
  %.1262 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1314 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8903 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8903
  %.537.i9195 = icmp slt i64 %arg.shape.6, 1
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
  %.idx8895 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8895
  %.idx8896 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8896
  %.idx8897 = mul i64 %arg.batch.4.0.5.1, 240
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8897
  %.8905 = select i1 %.612, i64 0, i64 2
  %.792.i = icmp ne i64 %arg.shape.2, 1
  %"$phi364.4.2.i.2" = zext i1 %.792.i to i64
  %.idx8898 = mul i64 %arg.batch.4.0.5.1, 96
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8898
  %.idx8899 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8899
  %.idx8900 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8900
  %.idx8901 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8901
  %.idx8902 = mul i64 %arg.batch.4.0.5.1, 160
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8902
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
  %.idx.i8942 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8942
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
  %.520.i8937 = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 152
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2178 = add i64 %arg.shape.2, -1
  %storemerge8849 = tail call i64 @llvm.smax.i64(i64 %.2178, i64 0)
  %.22219208.not = icmp slt i64 %.2178, 1
  %.2366.idx = mul i64 %.463, 136
  %.2366 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2366.idx
  %.2392 = inttoptr i64 %"$phi380.0.2.0" to ptr
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond9186.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i8943 = mul nsw i64 %arg.shape.1, 17
  %.idx.i8945 = mul i64 %arg.shape.1, 80
  %invariant.gep9204 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8945
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep9206 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2486 = getelementptr i8, ptr %arg.code.4, i64 72
  %.2563 = icmp sgt i64 %arg.shape.3, 0
  %.2568 = icmp sgt i64 %arg.shape.6, 0
  %.idx8893 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8893
  %.idx8894 = mul i64 %arg.batch.4.0.5.1, 176
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8894
  %.idx8890 = mul i64 %arg.batch.4.0.5.1, 184
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8890
  %.idx8891 = mul i64 %arg.batch.4.0.5.1, 192
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8891
  %.idx8892 = mul i64 %arg.batch.4.0.5.1, 168
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8892
  %.idx8884 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8884
  %.idx8885 = mul i64 %arg.batch.4.0.5.1, 200
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8885
  %.idx8886 = mul i64 %arg.batch.4.0.5.1, 80
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8886
  %.idx8887 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8887
  %.idx8888 = mul i64 %arg.batch.4.0.5.1, 224
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8888
  %.idx8889 = mul i64 %arg.batch.4.0.5.1, 56
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8889
  %44 = or i1 %.612, %.625
  %.3958.idx = mul i64 %.463, 136
  %.3958 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3958.idx
  %.3983.idx = mul i64 %.463, 104
  %.3983 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3983.idx
  %.4023 = getelementptr i8, ptr %arg.code.4, i64 128
  %.4117 = getelementptr i8, ptr %arg.code.4, i64 120
  %.4657.c = getelementptr i8, ptr %arg.code.4, i64 112
  %.4517.idx = mul i64 %.463, 136
  %.4517 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4517.idx
  %.4580 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4657 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx8877 = shl i64 %arg.batch.4.1.5.1, 4
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8877
  %.idx8878 = mul i64 %arg.batch.4.0.5.1, 40
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8878
  %.idx8879 = mul i64 %arg.batch.4.0.5.1, 56
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8879
  %.idx8880 = mul i64 %arg.batch.4.0.5.1, 208
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8880
  %.idx8881 = mul i64 %arg.batch.4.0.5.1, 48
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8881
  %.idx8882 = shl i64 %arg.batch.4.0.5.1, 5
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8882
  %51 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8883 = mul i64 %arg.batch.4.0.5.1, 216
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8883
  %53 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.221.i = getelementptr i8, ptr %53, i64 -8
  %.idx2926.i = mul i64 %arg.batch.4.0.5.1, 136
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2926.i
  %.idx2894.i = mul i64 %arg.batch.4.0.5.1, 48
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2894.i
  %.287.i.i2940.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i = shl i64 %arg.shape.1, 4
  %.685.i.i = getelementptr i8, ptr %arg.code.4, i64 40
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.944.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul.i.reass
  %.950.i.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.953.i.i = mul i64 %arg.shape.6, %arg.shape.0
  %.111.i49.i2946.not.i = icmp slt i64 %.953.i.i, 1
  %.1012.i.i = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul2958.i.reass = mul i64 %factor.op.mul9327, %arg.shape.0
  %.1271.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul2958.i.reass
  %.1831.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx2893.i = mul i64 %arg.batch.4.0.5.1, 136
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2893.i
  %.155.i.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx2922.i = shl i64 %arg.batch.4.1.5.1, 5
  %57 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2922.i
  %storemerge2924.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx2925.i = mul i64 %arg.batch.4.0.5.1, 104
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2925.i
  %.idx2917.i = mul i64 %arg.batch.4.0.5.1, 112
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2917.i
  %.idx2918.i = mul i64 %arg.batch.4.0.5.1, 120
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2918.i
  %.1254.reass.i = mul i64 %.358.i.i.i, %arg.shape.0
  %.1274.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1254.reass.i
  %.idx2912.i = shl i64 %arg.batch.4.1.5.1, 5
  %61 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2912.i
  %storemerge2916.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx2900.i = mul i64 %arg.batch.4.0.5.1, 56
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2900.i
  %.idx2902.i = shl i64 %arg.batch.4.1.5.1, 5
  %63 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2902.i
  %.idx2905.i = mul i64 %arg.batch.4.0.5.1, 112
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2905.i
  %.idx2909.i = mul i64 %arg.batch.4.0.5.1, 104
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2909.i
  %.idx2906.i = mul i64 %arg.batch.4.0.5.1, 120
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2906.i
  %.idx2907.i = mul i64 %arg.batch.4.0.5.1, 40
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2907.i
  %.idx2908.i = shl i64 %arg.batch.4.0.5.1, 5
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2908.i
  %69 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4944.not = icmp eq i64 %arg.shape.3, 0
  %.8914 = select i1 %.612, i64 1, i64 16
  %.524.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.595.i8979.reass = mul i64 %factor.op.mul9328, %arg.shape.0
  %.615.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.595.i8979.reass
  %.452.i = uitofp i64 %.8914 to double
  %.idx719.i = mul i64 %arg.batch.4.0.5.1, 48
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx719.i
  %.287.i725.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i = shl nsw i64 %arg.shape.1, 4
  %.idx.i8980 = mul i64 %arg.batch.4.0.5.1, 40
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8980
  %.idx717.i = mul i64 %arg.batch.4.0.5.1, 112
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx717.i
  %.idx718.i = mul i64 %arg.batch.4.0.5.1, 120
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx718.i
  %.155.i.i.i8984 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i8986 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i8987 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i8988 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i8989 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i8990 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i8991 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i9003 = shl i64 %arg.batch.4.1.5.1, 4
  %74 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i9003
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %76 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %77 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 216
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i9004 = mul nsw i64 %arg.shape.1, 17
  %79 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5180 = icmp sgt i64 %arg.shape.0, 1
  %.5234.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5234 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5234.idx
  %.5266 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx8870 = mul i64 %arg.batch.4.0.5.1, 104
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8870
  %.idx8871 = mul i64 %arg.batch.4.0.5.1, 40
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8871
  %.idx8872 = shl i64 %arg.batch.4.0.5.1, 7
  %82 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8872
  %.552.i35759305.not = icmp slt i64 %arg.shape.1, 1
  %.697.i3612 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %83 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i3642 = getelementptr i8, ptr %83, i64 -8
  %.idx8874 = mul i64 %arg.batch.4.1.5.1, 24
  %84 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8874
  %.idx8875 = mul i64 %arg.batch.4.1.5.1, 24
  %85 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8875
  %.idx8876 = mul i64 %arg.batch.4.0.5.1, 24
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8876
  %.5382.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %87 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %88 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %89 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i9021 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i9022 = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %90 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx8859 = mul i64 %arg.batch.4.0.5.1, 40
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8859
  %.idx8860 = shl i64 %arg.batch.4.0.5.1, 4
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8860
  %93 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8861 = mul i64 %arg.batch.4.0.5.1, 24
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8861
  %.175.i.i49729317.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8864 = shl i64 %arg.batch.4.1.5.1, 4
  %95 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8864
  %.idx.i9036 = mul i64 %arg.batch.4.0.5.1, 24
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i9036
  %.323.i9038 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %97 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i9058 = mul i64 %arg.batch.4.1.5.1, 24
  %98 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i9058
  %.8051131.not.i9060 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i9076 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i9095 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i9113 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i9117 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i9121 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i9123 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i9127 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i9129 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i9131 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9133 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9135 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9137 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9139 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9141 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9143 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9145 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9147 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9149 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9151 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9153 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9155 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9157 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9159 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9161 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9163 = mul i64 %arg.batch.4.0.5.1, 216
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i9113
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i9141
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.27.idx.i9163
  %.idx1130.i9178 = mul i64 %arg.batch.4.0.5.1, 224
  %102 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9178
  %.idx8863 = mul i64 %arg.batch.4.0.5.1, 224
  %103 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8863
  %.6450 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %104 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %105 = getelementptr i8, ptr %104, i64 -8
  %.6464 = getelementptr double, ptr %105, i64 %.6450
  %106 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8865 = mul i64 %arg.batch.4.0.5.1, 224
  %107 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8865
  %.idx8866 = mul i64 %arg.batch.4.0.5.1, 168
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8866
  %.idx8867 = shl i64 %arg.batch.4.1.5.1, 4
  %109 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8867
  %.idx8868 = shl i64 %arg.batch.4.0.5.1, 4
  %110 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8868
  %.idx8869 = mul i64 %arg.batch.4.0.5.1, 160
  %111 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8869
  %112 = shl i64 %arg.shape.0, 3
  %113 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4542.idx = mul i64 %.463, 112
  %.4542 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4542.idx
  %114 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4542.1.idx = mul i64 %.463, 120
  %.4542.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4542.1.idx
  %115 = getelementptr i8, ptr %arg.code.4, i64 248
  %.4542.2.idx = shl i64 %.463, 7
  %.4542.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4542.2.idx
  br label %B584

B584:                                             ; preds = %B584.preheader, %B4708
  %budget.3.1 = phi i64 [ %budget.4.2, %B4708 ], [ %arg.budget, %B584.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4708 ], [ %active.4.0.lcssa, %B584.preheader ]
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
  %.359.i = icmp sgt i64 %.304.i.09200, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B748
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B784

B194.if.i:                                        ; preds = %B748, %B324.i
  %.304.i.09200 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B748 ]
  %.301.i.09199 = phi i64 [ %.372.i, %B324.i ], [ 0, %B748 ]
  %.368.i = add nsw i64 %.304.i.09200, -1
  %.372.i = add nsw i64 %.301.i.09199, 1
  %116 = getelementptr double, ptr %19, i64 %.301.i.09199
  %.454.i = load double, ptr %116, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge9332 = select i1 %.455.i, i1 true, i1 %.537.i9195
  br i1 %brmerge9332, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep9361 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.09199
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.09196 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.09196, 1
  %.576.i = mul nsw i64 %.481.i.09196, %arg.shape.0
  %gep9362 = getelementptr double, ptr %invariant.gep9361, i64 %.576.i
  %.608.i = load double, ptr %gep9362, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.09196, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.09199
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %117 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %117, i64 %.629.i
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
  %.432.i191 = getelementptr double, ptr %21, i64 %.161.i.09202
  store double 0.000000e+00, ptr %.432.i191, align 8, !noalias !11
  %.487.i = getelementptr double, ptr %22, i64 %.161.i.09202
  store double 0.000000e+00, ptr %.487.i, align 8, !noalias !11
  %.542.i244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09202
  %.543.i245 = load i64, ptr %.542.i244, align 8, !noalias !11
  %.570.i = icmp slt i64 %.543.i245, 0
  %.571.i = select i1 %.570.i, i64 %arg.batch.3.3.5.0, i64 0
  %.572.i257 = add i64 %.571.i, %.543.i245
  %.592.i271 = mul i64 %.572.i257, %arg.batch.3.3.5.1
  %118 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.592.i271
  %.596.i = getelementptr i8, ptr %118, i64 8
  %.597.i275 = load i64, ptr %.596.i, align 8, !noalias !11
  %.620.i282 = add nsw i64 %.597.i275, %.8905
  store i64 %.620.i282, ptr %.596.i, align 8, !noalias !11
  %.736.i = load i64, ptr %.542.i244, align 8, !noalias !11
  %.763.i354 = icmp slt i64 %.736.i, 0
  %.764.i = select i1 %.763.i354, i64 %arg.batch.3.3.5.0, i64 0
  %.765.i355 = add i64 %.764.i, %.736.i
  %.785.i = mul i64 %.765.i355, %arg.batch.3.3.5.1
  %119 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.785.i
  %.789.i369 = getelementptr i8, ptr %119, i64 16
  %.790.i = load i64, ptr %.789.i369, align 8, !noalias !11
  %.813.i = add nsw i64 %.790.i, %"$phi364.4.2.i.2"
  store i64 %.813.i, ptr %.789.i369, align 8, !noalias !11
  %.928.i = getelementptr double, ptr %23, i64 %.161.i.09202
  %.929.i = load double, ptr %.928.i, align 8, !noalias !11
  %.930.i = fcmp une double %.929.i, 0.000000e+00
  br i1 %.930.i, label %B414.i, label %B460.i

B414.i:                                           ; preds = %B108.i
  %120 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09202
  %.84.i.i = load i64, ptr %120, align 8, !noalias !15
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
  %121 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.09202
  %.1000.i = load double, ptr %121, align 8, !noalias !11
  %.1002.i = fcmp olt double %.1000.i, -1.000000e-09
  br i1 %.1002.i, label %B500.i, label %B596.i

B500.i:                                           ; preds = %B464.i
  %122 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09202
  %.84.i63.i = load i64, ptr %122, align 8, !noalias !18
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
  %.1091.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i.09202
  %.1092.i = load double, ptr %.1091.i, align 8, !noalias !11
  %.1146.i = getelementptr double, ptr %24, i64 %.161.i.09202
  store double %.1092.i, ptr %.1146.i, align 8, !noalias !11
  br label %B596.i

B596.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B464.i, %B460.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.161.i.09202
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.161.i.09202
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.161.i.09202
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B630.i

B134.i.i:                                         ; preds = %B596.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %123 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %123, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B630.i

B630.i:                                           ; preds = %B134.i.i, %B596.i, %B64.if.i
  %.220.i = icmp sgt i64 %.164.i70.09203, 1
  br i1 %.220.i, label %B64.if.i, label %B1302

B64.if.i:                                         ; preds = %B1260, %B630.i
  %.164.i70.09203 = phi i64 [ %.229.i381, %B630.i ], [ %storemerge, %B1260 ]
  %.161.i.09202 = phi i64 [ %.233.i384, %B630.i ], [ 0, %B1260 ]
  %.229.i381 = add nsw i64 %.164.i70.09203, -1
  %.233.i384 = add nsw i64 %.161.i.09202, 1
  %.314.i134 = getelementptr double, ptr %20, i64 %.161.i.09202
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
  %124 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.990.i.i = getelementptr i64, ptr %124, i64 %.976.i.i
  %.991.i.i = load i64, ptr %.990.i.i, align 8, !noalias !28
  %.1007.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1008.i.i = select i1 %.1007.i.i, i64 %arg.linear.6.5.0, i64 0
  %125 = getelementptr i8, ptr %124, i64 8
  %.1022.i.i = getelementptr i64, ptr %125, i64 %.1008.i.i
  %.1023.i.i = load i64, ptr %.1022.i.i, align 8, !noalias !28
  %.1060.i.i = sub i64 %.1023.i.i, %.991.i.i
  %.1106.i2123.not.i = icmp slt i64 %.1060.i.i, 1
  br i1 %.1106.i2123.not.i, label %B702.i.i, label %B536.if.i.i

B544.i.i:                                         ; preds = %B536.if.i.i
  %.1173.i.i = icmp slt i64 %.1047.i.02124.i, 0
  %.1174.i.i = select i1 %.1173.i.i, i64 %arg.linear.7.5.0, i64 0
  %126 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1047.i.02124.i
  %.1188.i.i = getelementptr i64, ptr %126, i64 %.1174.i.i
  %.1189.i.i = load i64, ptr %.1188.i.i, align 8, !noalias !28
  %.1190.i.i = add nsw i64 %.1189.i.i, %.915.i.i
  %.1204.i.i = icmp slt i64 %.1190.i.i, 0
  %.1205.i.i = select i1 %.1204.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %127 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1190.i.i
  %.1219.i.i = getelementptr double, ptr %127, i64 %.1205.i.i
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
  %128 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.1.i
  %.906.i.i.1.i = load double, ptr %128, align 8, !noalias !32
  %129 = getelementptr double, ptr %128, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %129, align 8, !noalias !32
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %130 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %131 = getelementptr double, ptr %128, i64 %.944.i.i.i
  store double %130, ptr %131, align 8, !noalias !32
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
  %132 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %132, ptr %.571, align 8, !noalias !32
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !32
  br i1 %.317.i2117.not.i, label %B702.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %133 = getelementptr double, ptr %141, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %133, align 8, !noalias !32
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2111.i, ptr %143, align 8, !noalias !32
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B702.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B660.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B660.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02129.i, 1
  %134 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02129.i
  %.341.i.i.i = load double, ptr %134, align 8, !noalias !32
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %135 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %135, double 1.200000e-05
  %136 = getelementptr i64, ptr %arg.linear.5.4, i64 %.212.i.i.02129.i
  %.434.i.i.i = load i64, ptr %136, align 8, !noalias !32
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.537.i.sroa.0.02147.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %137 = getelementptr i8, ptr %134, i64 %.idx2162.i
  store double %"$phi230.1.2.i.i.1.i", ptr %137, align 8, !noalias !32
  %exitcond2154.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2154.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02131.i, 1
  %138 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.i
  %.906.i.i.i = load double, ptr %138, align 8, !noalias !32
  %139 = getelementptr double, ptr %138, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %139, align 8, !noalias !32
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %140 = getelementptr double, ptr %138, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %140, align 8, !noalias !32
  %exitcond2155.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2155.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02136.i, 1
  %141 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02136.i
  %.1445.i.i.i = load double, ptr %141, align 8, !noalias !32
  %142 = getelementptr i8, ptr %141, i64 %.933.i.idx.i
  store double %.1445.i.i.i, ptr %142, align 8, !noalias !32
  %143 = getelementptr i8, ptr %141, i64 %.idx2164.i
  %.1513.i.i.i = load double, ptr %143, align 8, !noalias !32
  %144 = getelementptr i8, ptr %141, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %144, align 8, !noalias !32
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B702.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B656.i.i, %B352.i.i
  %.1384.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.1385.i.i = select i1 %.1384.i.i, i64 %arg.linear.6.5.0, i64 0
  %145 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.1399.i.i = getelementptr i64, ptr %145, i64 %.1385.i.i
  %.1400.i.i = load i64, ptr %.1399.i.i, align 8, !noalias !28
  %.1418.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1419.i.i = select i1 %.1418.i.i, i64 %arg.linear.6.5.0, i64 0
  %146 = getelementptr i8, ptr %145, i64 8
  %.1433.i.i = getelementptr i64, ptr %146, i64 %.1419.i.i
  %.1434.i.i = load i64, ptr %.1433.i.i, align 8, !noalias !28
  %.1471.i.i = sub i64 %.1434.i.i, %.1400.i.i
  %.1514.i2138.not.i = icmp slt i64 %.1471.i.i, 1
  br i1 %.1514.i2138.not.i, label %B228.i.loopexit.i, label %B764.if.i.i

B920.i.i:                                         ; preds = %B764.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %147 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %147, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !28
  br label %B995.i.i

B966.i.i:                                         ; preds = %B764.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %148 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %148, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !28
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %149 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %149, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !28
  br label %B995.i.i

B995.i.i:                                         ; preds = %B966.i.i, %B920.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B764.if.i.i, label %B228.i.loopexit.i

B84.if.i.i:                                       ; preds = %B76.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B76.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %150 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %150, align 8, !noalias !28
  %151 = getelementptr i8, ptr %150, i64 %.idx2159.i
  store double %.384.i.i, ptr %151, align 8, !noalias !28
  %152 = getelementptr i8, ptr %150, i64 %.idx2160.i
  store double 0.000000e+00, ptr %152, align 8, !noalias !28
  %exitcond.not.i8941 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i8941, label %B166.i.i, label %B84.if.i.i

B286.if.i.i:                                      ; preds = %B250.i.i, %B286.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B286.if.i.i ], [ %storemerge2107.i, %B250.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B286.if.i.i ], [ 0, %B250.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %153 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %153, align 8, !noalias !28
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
  %154 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1458.i.02139.i
  %.1586.i.i = getelementptr i64, ptr %154, i64 %.1572.i.i
  %.1587.i.i = load i64, ptr %.1586.i.i, align 8, !noalias !28
  %.1588.i.i = add nsw i64 %.1587.i.i, %.915.i.i
  %.1602.i.i = icmp slt i64 %.1588.i.i, 0
  %.1603.i.i = select i1 %.1602.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1588.i.i
  %.1617.i.i = getelementptr double, ptr %155, i64 %.1603.i.i
  %.1618.i.i = load double, ptr %.1617.i.i, align 8, !noalias !28
  %.1636.i.i = select i1 %.1571.i.i, i64 %arg.linear.8.5.0, i64 0
  %156 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1458.i.02139.i
  %.1650.i.i = getelementptr i64, ptr %156, i64 %.1636.i.i
  %.1651.i.i = load i64, ptr %.1650.i.i, align 8, !noalias !28
  %.1652.i.i = add nsw i64 %.1651.i.i, %.597.i.i.i
  %.1666.i.i = icmp slt i64 %.1652.i.i, 0
  %.1667.i.i = select i1 %.1666.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %157 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1652.i.i
  %.1681.i.i = getelementptr double, ptr %157, i64 %.1667.i.i
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
  %158 = getelementptr double, ptr %arg.linear.1.4, i64 %.746.i
  %.777.i = getelementptr double, ptr %158, i64 %.763.i
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
  %159 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %159, align 8, !noalias !36
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i2114.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %160 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i2114.i
  %.576.i.i = getelementptr double, ptr %160, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !36
  %.610.i.i = load double, ptr %162, align 8, !noalias !36
  store double %.577.i.i, ptr %162, align 8, !noalias !36
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
  %.11.i.i.i8940 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %161 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i
  %162 = getelementptr double, ptr %161, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8940, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %162, align 8, !noalias !36
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
  %163 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %163, i64 %.430.i.i
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
  %164 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %164, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i.i, align 8, !noalias !36
  %.861.i.i = load double, ptr %162, align 8, !noalias !36
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i.i, align 8, !noalias !36
  %.759.i.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %165 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i.i = add nsw i64 %165, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %arg.linear.1.5.0, i64 0
  %166 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i.i
  %.1059.i.i = getelementptr double, ptr %166, i64 %.1045.i.i
  %.1060.i2115.i = load double, ptr %.1059.i.i, align 8, !noalias !36
  %.1068.i.i = add nsw i64 %165, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %167 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %167, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %165
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i.i = select i1 %.1310.i.i, i64 %arg.linear.1.5.0, i64 0
  %168 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %168, i64 %.1311.i.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !36
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %arg.linear.1.5.0, i64 0
  %169 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %169, i64 %.1343.i.i
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
  %.11.i.i8938 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i = add i64 %.520.i8937, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i8938
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B316.i, label %B262.if.lr.ph.i

B262.if.lr.ph.i:                                  ; preds = %B146.if.i
  %.670.i = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B262.if.i

B262.if.i:                                        ; preds = %B262.if.i, %B262.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B262.if.lr.ph.i ], [ %.639.i, %B262.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i8938, %B262.if.lr.ph.i ], [ %.643.i8939, %B262.if.i ]
  %.639.i = add nsw i64 %.577.02150.i, -1
  %.643.i8939 = add i64 %.574.02149.i, 1
  %.671.i = add nsw i64 %.574.02149.i, %.670.i
  %.685.i = icmp slt i64 %.671.i, 0
  %.686.i = select i1 %.685.i, i64 %arg.linear.0.5.0, i64 0
  %170 = getelementptr double, ptr %arg.linear.0.4, i64 %.671.i
  %.700.i = getelementptr double, ptr %170, i64 %.686.i
  %.701.i = load double, ptr %.700.i, align 8, !noalias !25
  %.702.i = fneg double %.701.i
  %.721.i = select i1 %.685.i, i64 %arg.linear.1.5.0, i64 0
  %171 = getelementptr double, ptr %arg.linear.1.4, i64 %.671.i
  %.735.i = getelementptr double, ptr %171, i64 %.721.i
  store double %.702.i, ptr %.735.i, align 8, !noalias !25
  %.630.i = icmp sgt i64 %.577.02150.i, 1
  br i1 %.630.i, label %B262.if.i, label %B316.i

B1502:                                            ; preds = %B34.loopexit.i.i, %B116.i, %B1458
  br i1 %.22219208.not, label %B1728, label %B1534.if

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
  %172 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0621.i
  %.202.i.i = load i64, ptr %172, align 8, !noalias !39
  %.204.i.i = add nsw i64 %.202.i.i, %.395.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %173 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %173, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !39
  %gep9207 = getelementptr double, ptr %invariant.gep9206, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep9207, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep9207, align 8, !noalias !39
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i8950 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8950, %.144.i.i
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
  %174 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %174, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !39
  %.522.i.i = add nsw i64 %.393.i.0618.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %175 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %175, i64 %.537.i.i
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
  %176 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i8951 = getelementptr double, ptr %176, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i8951, align 8, !noalias !39
  %.759.i.i8952 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8952, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %177 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %177, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !39
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i8951, align 8, !noalias !39
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
  %178 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %178, i64 %.1029.i.i
  %.1044.i.i8953 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i8952
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %179 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %179, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !39
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8953, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !39
  %.975.i.i8954 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i8954, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i8944 = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %180 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %180, i64 %.275.i8944
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %gep9205 = getelementptr double, ptr %invariant.gep9204, i64 %.160.0615.i
  %.323.i8946 = load double, ptr %gep9205, align 8, !noalias !45
  %.324.i8947 = fadd double %.290.i, %.323.i8946
  %181 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %181, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i8943
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i8948 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %182 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i = getelementptr double, ptr %182, i64 %.372.i8948
  store double %.324.i8947, ptr %.386.i, align 8, !noalias !45
  %exitcond.not.i8949 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i8949, label %B34.if.i.i, label %B68.if.i

B286.if.i:                                        ; preds = %B286.if.i, %B286.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B286.if.lr.ph.i ], [ %.533.i, %B286.if.i ]
  %.533.i = add nsw i64 %.464.0631.i, 1
  %183 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i = load i64, ptr %183, align 8, !noalias !45
  %.590.i = add nsw i64 %.589.i, %.395.i
  %.604.i = icmp slt i64 %.590.i, 0
  %.605.i = select i1 %.604.i, i64 %arg.batch.5.0.5.0, i64 0
  %184 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %184, i64 %.605.i
  %.620.i = load double, ptr %.619.i, align 8, !noalias !45
  %.625.i = add nsw i64 %.464.0631.i, %.624.i
  %.639.i8955 = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i8955, i64 %arg.batch.5.0.5.0, i64 0
  %185 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i8956 = getelementptr double, ptr %185, i64 %.640.i
  store double %.620.i, ptr %.654.i8956, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i
  br i1 %exitcond634.not.i, label %B1726, label %B286.if.i

B1726:                                            ; preds = %B286.if.i, %B1534.if
  %exitcond9345.not = icmp eq i64 %.2165.09209, %storemerge8849
  br i1 %exitcond9345.not, label %B1728, label %B1534.if

B1728:                                            ; preds = %B1726, %B1502
  %.2487 = load i64, ptr %.2486, align 8
  %.2532 = inttoptr i64 %.2487 to ptr
  tail call void %.2532(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1168, i1 true, i1 %.610
  %or.cond8906 = select i1 %brmerge, i1 true, i1 %.2563
  %spec.select8925 = select i1 %or.cond8906, i1 true, i1 %.2568
  br i1 %.794, label %B1960, label %B1870.if

B1878:                                            ; preds = %B1870.if
  %186 = getelementptr double, ptr %33, i64 %.2608.09212
  %.2767 = load double, ptr %186, align 8
  %.2768 = fcmp ogt double %.2767, 5.000000e-01
  br label %B1914

B1914:                                            ; preds = %B1878, %B1870.if
  %"$phi1914.1.2.2" = phi i1 [ true, %B1870.if ], [ %.2768, %B1878 ]
  br i1 %looked.2.19215, label %B1956, label %B1920

B1920:                                            ; preds = %B1914
  %187 = getelementptr double, ptr %34, i64 %.2608.09212
  %.2842 = load double, ptr %187, align 8
  %.2843 = fcmp ogt double %.2842, 5.000000e-01
  br label %B1956

B1956:                                            ; preds = %B1920, %B1914
  %"$phi1956.1.2.2" = phi i1 [ true, %B1914 ], [ %.2843, %B1920 ]
  %.2664 = icmp sgt i64 %.2611.09213, 1
  br i1 %.2664, label %B1870.if, label %B1960

B1960:                                            ; preds = %B1956, %B1728
  %good.2.1.lcssa = phi i1 [ false, %B1728 ], [ %"$phi1914.1.2.2", %B1956 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select8925, %B1728 ], [ %"$phi1956.1.2.2", %B1956 ]
  %looked.2.1.lcssa.not9349 = xor i1 %looked.2.1.lcssa, true
  %brmerge9350 = or i1 %.794, %looked.2.1.lcssa.not9349
  br i1 %brmerge9350, label %B2538, label %B80.if.i

B2030.preheader:                                  ; preds = %B568.i
  br i1 %.794, label %B2538, label %B2030.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i589 = getelementptr double, ptr %35, i64 %.105.i435.09219
  %.319.i = load double, ptr %.318.i589, align 8, !noalias !46
  %.5.i.i = fptosi double %.319.i to i64
  %.397.i634 = getelementptr double, ptr %36, i64 %.105.i435.09219
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
  %.1072.i = getelementptr double, ptr %37, i64 %.105.i435.09219
  %.1073.i1075 = load double, ptr %.1072.i, align 8, !noalias !46
  %.1081.i1080 = sitofp i64 %.706.i869 to double
  %.1082.i1081 = fsub double %.1073.i1075, %.1081.i1080
  store double %.1082.i1081, ptr %.1072.i, align 8, !noalias !46
  br label %B568.i

B568.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i493 = icmp sgt i64 %.108.i.09220, 1
  br i1 %.163.i493, label %B80.if.i, label %B2030.preheader

B80.if.i:                                         ; preds = %B1960, %B568.i
  %.108.i.09220 = phi i64 [ %.172.i1118, %B568.i ], [ %storemerge, %B1960 ]
  %.105.i435.09219 = phi i64 [ %.176.i1121, %B568.i ], [ 0, %B1960 ]
  %.172.i1118 = add nsw i64 %.108.i.09220, -1
  %.176.i1121 = add nsw i64 %.105.i435.09219, 1
  %188 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i435.09219
  %.258.i = load i64, ptr %188, align 8, !noalias !46
  %.263.i545 = icmp sgt i64 %.258.i, -1
  br i1 %.263.i545, label %B126.i, label %B568.i

B2130:                                            ; preds = %B2030.if
  %.3297 = getelementptr double, ptr %40, i64 %.2963.09222
  %.3298 = load double, ptr %.3297, align 8
  %.3299 = fcmp ogt double %.3298, 5.000000e-01
  br i1 %.3299, label %B2168, label %B2268

B2168:                                            ; preds = %B2130
  %.5.i = fptosi double %.3298 to i64
  %189 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.09222
  %.84.i2116 = load i64, ptr %189, align 8, !noalias !50
  %.89.i2119 = icmp sgt i64 %.84.i2116, -1
  br i1 %.89.i2119, label %B46.i, label %B2268

B2268:                                            ; preds = %B2130, %B46.i, %B2168, %B80.i2148
  %.3485 = getelementptr double, ptr %41, i64 %.2963.09222
  %.3486 = load double, ptr %.3485, align 8
  %.3487 = fcmp ogt double %.3486, 5.000000e-01
  br i1 %.3487, label %B2306, label %B2536

B2306:                                            ; preds = %B2268
  %spec.select = select i1 %within.3.29224, i1 true, i1 %.2563
  %.3563 = mul i64 %.3124, %arg.batch.3.3.5.1
  %.3567 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3563
  %.3568 = load i64, ptr %.3567, align 8
  %.3579.0 = and i64 %.3568, 127
  %.3609 = icmp eq i64 %.3579.0, 0
  br i1 %.3609, label %B2414, label %B2376

B2376:                                            ; preds = %B2306
  %.3670 = getelementptr double, ptr %42, i64 %.2963.09222
  %.3671 = load double, ptr %.3670, align 8
  %.3673 = fcmp ogt double %.3671, 0.000000e+00
  br i1 %.3673, label %B2414, label %B2444

B2414:                                            ; preds = %B2306, %B2376
  store double 1.000000e+00, ptr %.3239, align 8
  br label %B2444

B2444:                                            ; preds = %B2414, %B2376
  %checked.5.5 = phi i1 [ true, %B2414 ], [ %checked.3.29225, %B2376 ]
  %.3756 = icmp slt i64 %.3179, %arg.batch.2.5.0
  br i1 %.3756, label %B2482, label %B2536

B2482:                                            ; preds = %B2444
  %.3780 = icmp slt i64 %.3179, 0
  %.3781 = select i1 %.3780, i64 %arg.batch.2.5.0, i64 0
  %190 = getelementptr double, ptr %arg.batch.2.4, i64 %.3179
  %.3795 = getelementptr double, ptr %190, i64 %.3781
  %.3796 = load double, ptr %.3795, align 8
  %.3854 = getelementptr double, ptr %43, i64 %.2963.09222
  %.3855 = load double, ptr %.3854, align 8
  %.3856 = fcmp olt double %.3796, %.3855
  br i1 %.3856, label %B2532, label %B2536

B2532:                                            ; preds = %B2482
  br label %B2536

B2536:                                            ; preds = %B2030.if, %B2532, %B2482, %B2444, %B2268
  %within.4.3 = phi i1 [ true, %B2532 ], [ %spec.select, %B2482 ], [ %spec.select, %B2444 ], [ %within.3.29224, %B2268 ], [ %within.3.29224, %B2030.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2532 ], [ %checked.5.5, %B2482 ], [ %checked.5.5, %B2444 ], [ %checked.3.29225, %B2268 ], [ %checked.3.29225, %B2030.if ]
  %.3025 = icmp sgt i64 %.2966.09223, 1
  br i1 %.3025, label %B2030.if, label %B2538

B2538:                                            ; preds = %B2536, %B1960, %B2030.preheader
  %within.5.1 = phi i1 [ false, %B1960 ], [ false, %B2030.preheader ], [ %within.4.3, %B2536 ]
  %checked.2.1 = phi i1 [ false, %B1960 ], [ false, %B2030.preheader ], [ %checked.4.3, %B2536 ]
  %good.2.1.not = xor i1 %good.2.1.lcssa, true
  %brmerge8908 = select i1 %good.2.1.not, i1 true, i1 %44
  br i1 %brmerge8908, label %B2666, label %B2550

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
  %brmerge8911.not = and i1 %.2568, %good.2.1.lcssa
  br i1 %brmerge8911.not, label %B2766, label %B2874

B2766:                                            ; preds = %B2746
  %.4118 = load i64, ptr %.4117, align 8
  %.4163 = inttoptr i64 %.4118 to ptr
  tail call void %.4163(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  store i8 0, ptr %.4172, align 1
  %.4226 = call fastcc i32 @_ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4172, ptr %excinfo.9, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4228.not = icmp eq i32 %.4226, 0
  %.4236 = load i8, ptr %.4172, align 1
  %.4239 = icmp ne i8 %.4236, 0
  br i1 %.4228.not, label %B2874, label %B2766.endif.if, !prof !53

B2874:                                            ; preds = %B2766, %B2746
  %beyond.2.1 = phi i1 [ false, %B2746 ], [ %.4239, %B2766 ]
  %brmerge8912 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8912, label %B2884, label %B3448

B2884:                                            ; preds = %B2874
  br i1 %.614, label %B2932.if, label %B3300.critedge

B140.i:                                           ; preds = %B64.if.i3121
  %.409.i2505 = getelementptr double, ptr %46, i64 %.138.i2278.09232
  %.410.i2506 = load double, ptr %.409.i2505, align 8, !noalias !54
  %.411.i2507 = fcmp uge double %.410.i2506, 5.000000e-01
  %.424.i2515.not = icmp slt i64 %.346.i2456, %arg.batch.2.5.0
  %or.cond8913 = select i1 %.411.i2507, i1 %.424.i2515.not, i1 false
  br i1 %or.cond8913, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i = icmp slt i64 %.346.i2456, 0
  %.441.i2526 = select i1 %.440.i, i64 %arg.batch.2.5.0, i64 0
  %191 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i2456
  %.455.i2540 = getelementptr double, ptr %191, i64 %.441.i2526
  %.456.i2541 = load double, ptr %.455.i2540, align 8, !noalias !54
  %.510.i2588 = getelementptr double, ptr %47, i64 %.138.i2278.09232
  %.511.i2589 = load double, ptr %.510.i2588, align 8, !noalias !54
  %.512.i2590 = fcmp ult double %.456.i2541, %.511.i2589
  br i1 %.512.i2590, label %B268.i2591, label %B453.i

B268.i2591:                                       ; preds = %B216.i
  %.574.i2637 = getelementptr double, ptr %48, i64 %.138.i2278.09232
  %.575.i2638 = load double, ptr %.574.i2637, align 8, !noalias !54
  %.576.i2639 = fcmp ogt double %.575.i2638, 1.000000e+00
  br i1 %.576.i2639, label %B306.i, label %B453.i

B306.i:                                           ; preds = %B268.i2591
  %.632.i = getelementptr double, ptr %49, i64 %.138.i2278.09232
  %.633.i2689 = load double, ptr %.632.i, align 8, !noalias !54
  store double 0.000000e+00, ptr %.409.i2505, align 8, !noalias !58
  %.161.i.i2846 = getelementptr double, ptr %50, i64 %.138.i2278.09232
  store double 0.000000e+00, ptr %.161.i.i2846, align 8, !noalias !58
  %.214.i.i2874 = getelementptr double, ptr %51, i64 %.138.i2278.09232
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
  %192 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %192, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !58
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !58
  %.705.i2981 = load double, ptr %.455.i2540, align 8, !noalias !54
  %.763.i3027 = getelementptr double, ptr %52, i64 %.138.i2278.09232
  store double %.705.i2981, ptr %.763.i3027, align 8, !noalias !54
  %.816.i3071 = mul i64 %.291.i2410, %arg.batch.3.3.5.1
  %193 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i3071
  %.820.i3075 = getelementptr i8, ptr %193, i64 8
  %.821.i3076 = load i64, ptr %.820.i3075, align 8, !noalias !54
  %.822.i3077 = add nsw i64 %.821.i3076, 3
  store i64 %.822.i3077, ptr %.820.i3075, align 8, !noalias !54
  br label %B453.i

B453.i:                                           ; preds = %B268.i2591, %B306.i, %B64.if.i3121, %B140.i, %B216.i
  %.196.i2346 = icmp sgt i64 %.141.i2279.09231, 1
  br i1 %.196.i2346, label %B64.if.i3121, label %B3300

B64.if.i3121:                                     ; preds = %B2932.if, %B453.i
  %.138.i2278.09232 = phi i64 [ %.209.i3128, %B453.i ], [ 0, %B2932.if ]
  %.141.i2279.09231 = phi i64 [ %.205.i3125, %B453.i ], [ %storemerge, %B2932.if ]
  %.205.i3125 = add nsw i64 %.141.i2279.09231, -1
  %.209.i3128 = add nsw i64 %.138.i2278.09232, 1
  %.290.i2409 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2278.09232
  %.291.i2410 = load i64, ptr %.290.i2409, align 8, !noalias !54
  %.345.i2455 = getelementptr i64, ptr %45, i64 %.138.i2278.09232
  %.346.i2456 = load i64, ptr %.345.i2455, align 8, !noalias !54
  %.354.i2460 = icmp slt i64 %.291.i2410, 0
  br i1 %.354.i2460, label %B453.i, label %B140.i

B3300.critedge:                                   ; preds = %B2884
  %.4658.c = load i64, ptr %.4657.c, align 8
  %.4703.c = inttoptr i64 %.4658.c to ptr
  tail call void %.4703.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3300

B3300:                                            ; preds = %B453.i, %B2932.if, %B3300.critedge
  br i1 %beyond.2.1, label %B3304, label %B3386

B3304:                                            ; preds = %B3300
  store i8 0, ptr %.4774, align 1
  %.4828 = call fastcc i32 @_ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr %.4774, ptr %excinfo.11, ptr %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.6, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0)
  %.4830.not = icmp eq i32 %.4828, 0
  br i1 %.4830.not, label %B3304.endif.endif, label %B3304.endif.if, !prof !53

B3344:                                            ; preds = %B3304.endif.endif
  %.222.i = load double, ptr %.221.i, align 8, !noalias !61
  %.251.i = load double, ptr %arg.batch.2.4, align 8, !noalias !61
  %.252.i = fsub double %.222.i, %.251.i
  %.253.i = fmul double %.252.i, 1.000000e-13
  br i1 %.794, label %B150.if.i.i.preheader, label %B70.if.i.i.preheader

B70.if.i.i.preheader:                             ; preds = %B3344
  tail call void @llvm.memset.p0.i64(ptr align 8 %54, i8 0, i64 %112, i1 false), !noalias !64
  br label %B150.if.i.i.preheader

B150.if.i.i.preheader:                            ; preds = %B70.if.i.i.preheader, %B3344
  br label %B150.if.i.i

B148.i.loopexit.i:                                ; preds = %B934.i.loopexit.i, %B300.endif.endif.i.i
  %exitcond2993.not.i = icmp eq i64 %.417.i.i, 9
  br i1 %exitcond2993.not.i, label %B220.preheader.i, label %B150.if.i.i

B184.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %switch.end.i.i
  %exitcond2988.not.i = icmp eq i64 %arg.shape.0, %.538.i.i
  br i1 %exitcond2988.not.i, label %B252.i.i, label %B184.if.i.i

B252.i.i:                                         ; preds = %B184.i.loopexit.i, %B150.if.i.i
  %.639.i.i = icmp ult i64 %.347.i.02959.i, 8
  %..i8961 = select i1 %.639.i.i, i64 16, i64 17
  %.656.i.i = mul i64 %..i8961, %.463
  %.686.i.i = load i64, ptr %.685.i.i, align 8, !noalias !64
  %.772.i.i8962 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.656.i.i
  %.798.i.i8963 = inttoptr i64 %.686.i.i to ptr
  tail call void %.798.i.i8963(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  %.829.i.i = load i64, ptr %arg.code.4, align 8, !noalias !64
  %.945.i.i = inttoptr i64 %.829.i.i to ptr
  tail call void %.945.i.i(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.944.i.i), !noalias !64
  br i1 %.111.i49.i2946.not.i, label %B300.endif.endif.i.i.critedge, label %B34.if.i.i.i

B34.if.i.i.i:                                     ; preds = %B252.i.i, %B34.if.i.i.i
  %.53.i17.i.02947.i = phi i64 [ %.124.i128.i.i, %B34.if.i.i.i ], [ 0, %B252.i.i ]
  %.124.i128.i.i = add nsw i64 %.53.i17.i.02947.i, 1
  %194 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.53.i17.i.02947.i
  %.178.i74.i.i = load double, ptr %194, align 8, !noalias !68
  %.180.i76.i.i = add nsw i64 %.53.i17.i.02947.i, %.950.i.i
  %.194.i84.i.i = icmp slt i64 %.180.i76.i.i, 0
  %.195.i85.i.i = select i1 %.194.i84.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %195 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.180.i76.i.i
  %.209.i.i.i = getelementptr double, ptr %195, i64 %.195.i85.i.i
  %.210.i.i.i = load double, ptr %.209.i.i.i, align 8, !noalias !68
  store double %.178.i74.i.i, ptr %.209.i.i.i, align 8, !noalias !68
  store double %.210.i.i.i, ptr %194, align 8, !noalias !68
  %exitcond2989.not.i = icmp eq i64 %.953.i.i, %.124.i128.i.i
  br i1 %exitcond2989.not.i, label %B300.endif.i.i, label %B34.if.i.i.i

B934.i.loopexit.i:                                ; preds = %B968.if.i.i, %B934.if.i.i
  %exitcond2992.not.i = icmp eq i64 %arg.shape.0, %.1547.i.i
  br i1 %exitcond2992.not.i, label %B148.i.loopexit.i, label %B934.if.i.i

B150.if.i.i:                                      ; preds = %B150.if.i.i.preheader, %B148.i.loopexit.i
  %.347.i.02959.i = phi i64 [ %.417.i.i, %B148.i.loopexit.i ], [ 1, %B150.if.i.i.preheader ]
  %.417.i.i = add nsw i64 %.347.i.02959.i, 1
  br i1 %.794, label %B252.i.i, label %B184.if.i.i.preheader

B184.if.i.i.preheader:                            ; preds = %B150.if.i.i
  %196 = icmp ult i64 %.347.i.02959.i, 8
  %switch.gep = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.5, i64 %.347.i.02959.i
  br label %B184.if.i.i

B184.if.i.i:                                      ; preds = %B184.if.i.i.preheader, %B184.i.loopexit.i
  %.469.i.02944.i = phi i64 [ %.538.i.i, %B184.i.loopexit.i ], [ 0, %B184.if.i.i.preheader ]
  %.538.i.i = add nsw i64 %.469.i.02944.i, 1
  br i1 %196, label %switch.lookup, label %switch.end.i.i

switch.lookup:                                    ; preds = %B184.if.i.i
  %switch.load = load double, ptr %switch.gep, align 8
  br label %switch.end.i.i

switch.end.i.i:                                   ; preds = %B184.if.i.i, %switch.lookup
  %.580.i.i = phi double [ %switch.load, %switch.lookup ], [ 1.000000e+00, %B184.if.i.i ]
  %.92.i.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.469.i.02944.i
  %.93.i.i.i = load double, ptr %.92.i.i.i, align 8, !noalias !72
  %.146.i.i.i = getelementptr double, ptr %55, i64 %.469.i.02944.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !72
  %.149.i.i.i = fmul double %.580.i.i, %.147.i.i.i
  %.150.i.i.i8960 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.469.i.02944.i
  store double %.150.i.i.i8960, ptr %.203.i.i.i, align 8, !noalias !72
  br i1 %.287.i.i2940.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.lr.ph.i

B122.if.i.i.lr.ph.i:                              ; preds = %switch.end.i.i
  %.247.i.i.i.i = fsub double 1.000000e+00, %.580.i.i
  %invariant.gep9233 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9235 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9237 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9239 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9241 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9243 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9245 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9247 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  %invariant.gep9249 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02944.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.lr.ph.i
  %.229.i.i.02941.i = phi i64 [ 0, %B122.if.i.i.lr.ph.i ], [ %.300.i.i.i, %B122.if.i.i.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep9234 = getelementptr double, ptr %invariant.gep9233, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep9234, align 8, !noalias !76
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.580.i.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep9236 = getelementptr double, ptr %invariant.gep9235, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep9236, align 8, !noalias !76
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep9238 = getelementptr double, ptr %invariant.gep9237, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep9238, align 8, !noalias !76
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.580.i.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep9240 = getelementptr double, ptr %invariant.gep9239, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep9240, align 8, !noalias !76
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep9242 = getelementptr double, ptr %invariant.gep9241, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep9242, align 8, !noalias !76
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.580.i.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep9244 = getelementptr double, ptr %invariant.gep9243, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep9244, align 8, !noalias !76
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i.i.02941.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep9246 = getelementptr double, ptr %invariant.gep9245, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep9246, align 8, !noalias !76
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.580.i.i, %.193.i.i.i.6.i
  %.300.i.i.i = add nsw i64 %.229.i.i.02941.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i.i.02941.i, %arg.shape.0
  %gep9248 = getelementptr double, ptr %invariant.gep9247, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep9248, align 8, !noalias !76
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i.i.i = add nsw i64 %.229.i.i.02941.i, %.358.i.i.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep9250 = getelementptr double, ptr %invariant.gep9249, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep9250, align 8, !noalias !72
  %exitcond2987.not.i = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond2987.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.i

B300.endif.i.i:                                   ; preds = %B34.if.i.i.i
  %.1013.i.i = load i64, ptr %.1012.i.i, align 8, !noalias !64
  %.1125.i.i = inttoptr i64 %.1013.i.i to ptr
  tail call void %.1125.i.i(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  %.1156.i.i = load i64, ptr %arg.code.4, align 8, !noalias !64
  %.1272.i.i = inttoptr i64 %.1156.i.i to ptr
  tail call void %.1272.i.i(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1271.i.i), !noalias !64
  br label %B34.if.i321.i.i

B34.if.i321.i.i:                                  ; preds = %B300.endif.i.i, %B34.if.i321.i.i
  %.53.i162.i.02950.i = phi i64 [ %.124.i328.i.i, %B34.if.i321.i.i ], [ 0, %B300.endif.i.i ]
  %.124.i328.i.i = add nsw i64 %.53.i162.i.02950.i, 1
  %197 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.53.i162.i.02950.i
  %.178.i253.i.i = load double, ptr %197, align 8, !noalias !80
  %.180.i255.i.i = add nsw i64 %.53.i162.i.02950.i, %.950.i.i
  %.194.i264.i.i = icmp slt i64 %.180.i255.i.i, 0
  %.195.i265.i.i = select i1 %.194.i264.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %198 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.180.i255.i.i
  %.209.i275.i.i = getelementptr double, ptr %198, i64 %.195.i265.i.i
  %.210.i276.i.i = load double, ptr %.209.i275.i.i, align 8, !noalias !80
  store double %.178.i253.i.i, ptr %.209.i275.i.i, align 8, !noalias !80
  store double %.210.i276.i.i, ptr %197, align 8, !noalias !80
  %exitcond2990.not.i = icmp eq i64 %.953.i.i, %.124.i328.i.i
  br i1 %exitcond2990.not.i, label %B300.endif.endif.i.i, label %B34.if.i321.i.i

B300.endif.endif.i.i.critedge:                    ; preds = %B252.i.i
  %.1013.i.i.c = load i64, ptr %.1012.i.i, align 8, !noalias !64
  %.1125.i.i.c = inttoptr i64 %.1013.i.i.c to ptr
  tail call void %.1125.i.i.c(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  %.1156.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !64
  %.1272.i.i.c = inttoptr i64 %.1156.i.i.c to ptr
  tail call void %.1272.i.i.c(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1271.i.i), !noalias !64
  br label %B300.endif.endif.i.i

B300.endif.endif.i.i:                             ; preds = %B34.if.i321.i.i, %B300.endif.endif.i.i.critedge
  %.1340.i.i = load i64, ptr %.1012.i.i, align 8, !noalias !64
  %.1452.i.i = inttoptr i64 %.1340.i.i to ptr
  tail call void %.1452.i.i(ptr %.571, ptr %.772.i.i8962, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  br i1 %.794, label %B148.i.loopexit.i, label %B934.if.i.i

B934.if.i.i:                                      ; preds = %B300.endif.endif.i.i, %B934.i.loopexit.i
  %.1478.i.02956.i = phi i64 [ %.1547.i.i, %B934.i.loopexit.i ], [ 0, %B300.endif.endif.i.i ]
  %.1547.i.i = add nsw i64 %.1478.i.02956.i, 1
  br i1 %.287.i.i2940.not.i, label %B934.i.loopexit.i, label %B968.if.i.lr.ph.i

B968.if.i.lr.ph.i:                                ; preds = %B934.if.i.i
  %.1919.i.i = getelementptr double, ptr %55, i64 %.1478.i.02956.i
  %.2002.i.i = getelementptr double, ptr %56, i64 %.1478.i.02956.i
  br label %B968.if.i.i

B968.if.i.i:                                      ; preds = %B968.if.i.i, %B968.if.i.lr.ph.i
  %.1599.i.02953.i = phi i64 [ 0, %B968.if.i.lr.ph.i ], [ %.1668.i.i, %B968.if.i.i ]
  %.1668.i.i = add nsw i64 %.1599.i.02953.i, 1
  %199 = mul nsw i64 %.1599.i.02953.i, %arg.shape.0
  %.1696.i.i = add nsw i64 %199, %.1478.i.02956.i
  %200 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1696.i.i
  %.1726.i.i = load double, ptr %200, align 8, !noalias !64
  %.1735.i.i = add nsw i64 %.1696.i.i, %factor.op.mul2958.i.reass
  %.1749.i.i = icmp slt i64 %.1735.i.i, 0
  %.1750.i.i = select i1 %.1749.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %201 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1735.i.i
  %.1764.i.i = getelementptr double, ptr %201, i64 %.1750.i.i
  %.1765.i.i = load double, ptr %.1764.i.i, align 8, !noalias !64
  %.1770.i.i = add nsw i64 %.1696.i.i, %factor.op.mul.i.reass
  %.1784.i.i = icmp slt i64 %.1770.i.i, 0
  %.1785.i.i = select i1 %.1784.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %202 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1770.i.i
  %.1799.i.i = getelementptr double, ptr %202, i64 %.1785.i.i
  %.1800.i.i = load double, ptr %.1799.i.i, align 8, !noalias !64
  %.1801.i.i = fsub double %.1765.i.i, %.1800.i.i
  %.1802.i.i = tail call double @llvm.fabs.f64(double %.1801.i.i)
  %.1832.i.i8964 = load double, ptr %.1831.i.i, align 8, !noalias !64
  %.1862.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !64
  %.1863.i.i = tail call double @llvm.fabs.f64(double %.1726.i.i)
  %.1864.i.i8965 = fmul double %.1863.i.i, %.1862.i.i
  %.1865.i.i8966 = fadd double %.1832.i.i8964, %.1864.i.i8965
  %.1920.i.i = load double, ptr %.1919.i.i, align 8, !noalias !64
  %.1921.i.i = fmul double %.1802.i.i, %.1920.i.i
  %.1925.i.i = fdiv double %.1921.i.i, %.1865.i.i8966
  %.1931.i.i = fsub double %.1925.i.i, %.1925.i.i
  %.1932.i.i = fcmp oeq double %.1931.i.i, 0.000000e+00
  %.1925.i..i = select i1 %.1932.i.i, double %.1925.i.i, double 0x7FF0000000000000
  %.2003.i.i = load double, ptr %.2002.i.i, align 8, !noalias !64
  %.10.i.i.i8967 = fcmp ogt double %.1925.i..i, %.2003.i.i
  %.11.i.i.i8968 = select i1 %.10.i.i.i8967, double %.1925.i..i, double %.2003.i.i
  store double %.11.i.i.i8968, ptr %.2002.i.i, align 8, !noalias !64
  %exitcond2991.not.i = icmp eq i64 %arg.shape.1, %.1668.i.i
  br i1 %exitcond2991.not.i, label %B934.i.loopexit.i, label %B968.if.i.i

B220.preheader.i:                                 ; preds = %B148.i.loopexit.i
  br i1 %.794, label %B480.preheader.i, label %B220.if.i

B480.preheader.i:                                 ; preds = %B1561.i, %B220.preheader.i
  %halvings.2.0.lcssa.i = phi i64 [ 0, %B220.preheader.i ], [ %halvings.3.1.i, %B1561.i ]
  %.8492979.i = icmp sgt i64 %halvings.2.0.lcssa.i, 0
  br i1 %.8492979.i, label %B482.if.i, label %B1062.preheader.i

B262.i:                                           ; preds = %B220.if.i
  %203 = getelementptr double, ptr %56, i64 %.377.02963.i
  %.585.i = load double, ptr %203, align 8, !noalias !61
  %.586.i = fcmp ogt double %.585.i, 1.000000e-01
  %.mux.i = select i1 %.586.i, i64 50, i64 %halvings.2.02965.i
  br i1 %.586.i, label %B1561.i, label %B34.i.i

B34.i.i:                                          ; preds = %B262.i, %B34.if.i.i8977
  %.51.i.0.i = phi i64 [ %.122.i81.i, %B34.if.i.i8977 ], [ 0, %B262.i ]
  %exitcond2994.not.i = icmp eq i64 %.51.i.0.i, %storemerge2924.i
  br i1 %exitcond2994.not.i, label %B364.endif.i, label %B34.if.i.i8977

B128.i.i:                                         ; preds = %B34.if.i.i8977
  %204 = icmp sgt i64 %.51.i.0.i, -1
  %205 = select i1 %204, double 1.000000e+00, double 0.000000e+00
  br label %B364.endif.i

B34.if.i.i8977:                                   ; preds = %B34.i.i
  %.122.i81.i = add i64 %.51.i.0.i, 1
  %.157.i.i = add nsw i64 %.51.i.0.i, %arg.shape.6
  %.159.i40.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %.161.i.i8978 = add nsw i64 %.159.i40.i, %.377.02963.i
  %.175.i44.i = icmp slt i64 %.161.i.i8978, 0
  %.176.i.i = select i1 %.175.i44.i, i64 %arg.batch.5.4.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i8978
  %.190.i52.i = getelementptr double, ptr %206, i64 %.176.i.i
  %.191.i53.i = load double, ptr %.190.i52.i, align 8, !noalias !84
  %.195.i55.i = add nsw i64 %.161.i.i8978, %.953.i.i
  %.209.i.i = icmp slt i64 %.195.i55.i, 0
  %.210.i64.i = select i1 %.209.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %207 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i55.i
  %.224.i70.i = getelementptr double, ptr %207, i64 %.210.i64.i
  %.225.i71.i = load double, ptr %.224.i70.i, align 8, !noalias !84
  %.226.i72.i = fneg double %.225.i71.i
  %.227.i73.i = fcmp olt double %.191.i53.i, %.226.i72.i
  br i1 %.227.i73.i, label %B128.i.i, label %B34.i.i

B480.loopexit.i.critedge:                         ; preds = %B482.if.i
  %.1184.i.c = load i64, ptr %.685.i.i, align 8, !noalias !61
  %.1300.i.c = inttoptr i64 %.1184.i.c to ptr
  tail call void %.1300.i.c(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !61
  br label %B480.loopexit.i

B480.loopexit.i:                                  ; preds = %B1562.i, %B480.loopexit.i.critedge
  %.849.i = icmp sgt i64 %.795.02980.i, 1
  br i1 %.849.i, label %B482.if.i, label %B1062.preheader.i

B1062.preheader.i:                                ; preds = %B480.loopexit.i, %B480.preheader.i
  br i1 %.794, label %B3386, label %B1062.if.lr.ph.i

B1062.if.lr.ph.i:                                 ; preds = %B1062.preheader.i
  %.2389.i = fmul double %.253.i, 2.000000e+00
  br label %B1062.if.i

B516.loopexit.i:                                  ; preds = %B122.if.i.i, %B516.if.i
  %exitcond2998.not.i = icmp eq i64 %arg.shape.0, %.980.i
  br i1 %exitcond2998.not.i, label %B630.i8976, label %B516.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i310.02970.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i635.i, %B122.if.i.i ]
  %.157.i.i569.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.i
  %.159.i.i571.i = mul nsw i64 %.157.i.i569.i, %arg.shape.0
  %gep9252 = getelementptr double, ptr %invariant.gep9251, i64 %.159.i.i571.i
  %.191.i.i591.i = load double, ptr %gep9252, align 8, !noalias !88
  %.193.i.i593.i = fadd double %.191.i.i591.i, 0.000000e+00
  %.253.i.i608.i = fmul double %.1114.i, %.193.i.i593.i
  %.157.i.i569.1.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.1.i
  %.159.i.i571.1.i = mul nsw i64 %.157.i.i569.1.i, %arg.shape.0
  %gep9254 = getelementptr double, ptr %invariant.gep9253, i64 %.159.i.i571.1.i
  %.191.i.i591.1.i = load double, ptr %gep9254, align 8, !noalias !88
  %.193.i.i593.1.i = fadd double %.191.i.i591.1.i, %.253.i.i608.i
  %.253.i.i608.1.i = fmul double %.247.i.i.i, %.193.i.i593.1.i
  %.157.i.i569.2.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.2.i
  %.159.i.i571.2.i = mul nsw i64 %.157.i.i569.2.i, %arg.shape.0
  %gep9256 = getelementptr double, ptr %invariant.gep9255, i64 %.159.i.i571.2.i
  %.191.i.i591.2.i = load double, ptr %gep9256, align 8, !noalias !88
  %.193.i.i593.2.i = fadd double %.191.i.i591.2.i, %.253.i.i608.1.i
  %.253.i.i608.2.i = fmul double %.1114.i, %.193.i.i593.2.i
  %.157.i.i569.3.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.3.i
  %.159.i.i571.3.i = mul nsw i64 %.157.i.i569.3.i, %arg.shape.0
  %gep9258 = getelementptr double, ptr %invariant.gep9257, i64 %.159.i.i571.3.i
  %.191.i.i591.3.i = load double, ptr %gep9258, align 8, !noalias !88
  %.193.i.i593.3.i = fadd double %.191.i.i591.3.i, %.253.i.i608.2.i
  %.253.i.i608.3.i = fmul double %.247.i.i.i, %.193.i.i593.3.i
  %.157.i.i569.4.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.4.i
  %.159.i.i571.4.i = mul nsw i64 %.157.i.i569.4.i, %arg.shape.0
  %gep9260 = getelementptr double, ptr %invariant.gep9259, i64 %.159.i.i571.4.i
  %.191.i.i591.4.i = load double, ptr %gep9260, align 8, !noalias !88
  %.193.i.i593.4.i = fadd double %.191.i.i591.4.i, %.253.i.i608.3.i
  %.253.i.i608.4.i = fmul double %.1114.i, %.193.i.i593.4.i
  %.157.i.i569.5.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.5.i
  %.159.i.i571.5.i = mul nsw i64 %.157.i.i569.5.i, %arg.shape.0
  %gep9262 = getelementptr double, ptr %invariant.gep9261, i64 %.159.i.i571.5.i
  %.191.i.i591.5.i = load double, ptr %gep9262, align 8, !noalias !88
  %.193.i.i593.5.i = fadd double %.191.i.i591.5.i, %.253.i.i608.4.i
  %.253.i.i608.5.i = fmul double %.247.i.i.i, %.193.i.i593.5.i
  %.157.i.i569.6.i = add nsw i64 %.229.i310.02970.i, %.155.i.i.6.i
  %.159.i.i571.6.i = mul nsw i64 %.157.i.i569.6.i, %arg.shape.0
  %gep9264 = getelementptr double, ptr %invariant.gep9263, i64 %.159.i.i571.6.i
  %.191.i.i591.6.i = load double, ptr %gep9264, align 8, !noalias !88
  %.193.i.i593.6.i = fadd double %.191.i.i591.6.i, %.253.i.i608.5.i
  %.253.i.i608.6.i = fmul double %.1114.i, %.193.i.i593.6.i
  %.300.i635.i = add nsw i64 %.229.i310.02970.i, 1
  %.271.i.i519.i = mul nsw i64 %.229.i310.02970.i, %arg.shape.0
  %gep9266 = getelementptr double, ptr %invariant.gep9265, i64 %.271.i.i519.i
  %.309.i.i.i = load double, ptr %gep9266, align 8, !noalias !88
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i608.6.i
  %.359.i.i = add nsw i64 %.229.i310.02970.i, %.358.i.i.i
  %.361.i545.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep9268 = getelementptr double, ptr %invariant.gep9267, i64 %.361.i545.i
  store double %.313.i.i.i, ptr %gep9268, align 8, !noalias !95
  %exitcond2997.not.i = icmp eq i64 %arg.shape.1, %.300.i635.i
  br i1 %exitcond2997.not.i, label %B516.loopexit.i, label %B122.if.i.i

B630.i8976:                                       ; preds = %B516.loopexit.i
  %.1184.i = load i64, ptr %.685.i.i, align 8, !noalias !61
  %.1300.i = inttoptr i64 %.1184.i to ptr
  tail call void %.1300.i(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !61
  br label %B772.if.i

B814.i:                                           ; preds = %B772.if.i
  %.1533.i = getelementptr double, ptr %56, i64 %.1326.02976.i
  %.1534.i = load double, ptr %.1533.i, align 8, !noalias !61
  %.1535.i = fcmp ogt double %.1534.i, 1.000000e-01
  br i1 %.1535.i, label %B862.i, label %B1562.i

B862.i:                                           ; preds = %B814.i
  %.1590.i = getelementptr double, ptr %59, i64 %.1326.02976.i
  %.1591.i = load double, ptr %.1590.i, align 8, !noalias !61
  %.1645.i = getelementptr double, ptr %60, i64 %.1326.02976.i
  %.1646.i = load double, ptr %.1645.i, align 8, !noalias !61
  %.1647.i = fadd double %.1591.i, %.1646.i
  %.1648.i = fmul double %.1647.i, 5.000000e-01
  br label %B34.i150.i

B34.i150.i:                                       ; preds = %B34.if.i250.i, %B862.i
  %.51.i107.0.i = phi i64 [ 0, %B862.i ], [ %.122.i258.i, %B34.if.i250.i ]
  %exitcond2999.not.i = icmp eq i64 %.51.i107.0.i, %storemerge2916.i
  br i1 %exitcond2999.not.i, label %B1002.i, label %B34.if.i250.i

B128.i241.i:                                      ; preds = %B34.if.i250.i
  %208 = icmp sgt i64 %.51.i107.0.i, -1
  br i1 %208, label %B976.i, label %B1002.i

B34.if.i250.i:                                    ; preds = %B34.i150.i
  %.122.i258.i = add i64 %.51.i107.0.i, 1
  %.157.i180.i = add nsw i64 %.51.i107.0.i, %arg.shape.6
  %.159.i182.i = mul nsw i64 %.157.i180.i, %arg.shape.0
  %.161.i184.i = add nsw i64 %.159.i182.i, %.1326.02976.i
  %.175.i194.i = icmp slt i64 %.161.i184.i, 0
  %.176.i195.i = select i1 %.175.i194.i, i64 %arg.batch.5.4.5.0, i64 0
  %209 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i184.i
  %.190.i207.i = getelementptr double, ptr %209, i64 %.176.i195.i
  %.191.i208.i = load double, ptr %.190.i207.i, align 8, !noalias !96
  %.195.i212.i = add nsw i64 %.161.i184.i, %.953.i.i
  %.209.i222.i = icmp slt i64 %.195.i212.i, 0
  %.210.i223.i = select i1 %.209.i222.i, i64 %arg.batch.5.4.5.0, i64 0
  %210 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i212.i
  %.224.i235.i = getelementptr double, ptr %210, i64 %.210.i223.i
  %.225.i236.i = load double, ptr %.224.i235.i, align 8, !noalias !96
  %.226.i237.i = fneg double %.225.i236.i
  %.227.i238.i = fcmp olt double %.191.i208.i, %.226.i237.i
  br i1 %.227.i238.i, label %B128.i241.i, label %B34.i150.i

B976.i:                                           ; preds = %B128.i241.i
  store double %.1648.i, ptr %.1645.i, align 8, !noalias !61
  br label %B1562.i

B1002.i:                                          ; preds = %B34.i150.i, %B128.i241.i
  store double %.1648.i, ptr %.1590.i, align 8, !noalias !61
  br label %B1562.i

B1154.i:                                          ; preds = %B1062.if.i
  %.2178.i = getelementptr double, ptr %56, i64 %.1861.02982.i
  %.2179.i = load double, ptr %.2178.i, align 8, !noalias !61
  %.2180.i = fcmp ogt double %.2179.i, 1.000000e-01
  br i1 %.2180.i, label %B1202.i, label %B1563.i

B1202.i:                                          ; preds = %B1154.i
  %.2235.i = getelementptr double, ptr %55, i64 %.1861.02982.i
  %.2236.i = load double, ptr %.2235.i, align 8, !noalias !61
  %.2292.i = load double, ptr %.2011.i, align 8, !noalias !61
  %.2293.i = tail call double @llvm.fabs.f64(double %.2292.i)
  %.2294.i = fmul double %.2293.i, 2.000000e-12
  %.2351.i = getelementptr double, ptr %64, i64 %.1861.02982.i
  %.2352.i = load double, ptr %.2351.i, align 8, !noalias !61
  %.2357.i = fmul double %.2236.i, 0x3D719799812DEA11
  %.10.i.i8969 = fcmp ogt double %.2294.i, %.2357.i
  %.11.i.i8970 = select i1 %.10.i.i8969, double %.2294.i, double %.2357.i
  %.2353.i = fsub double 1.000000e+00, %.2352.i
  %.2355.i = fmul double %.2236.i, %.2353.i
  %.2386.i = fcmp ugt double %.2355.i, %.11.i.i8970
  %.2391.i = fcmp ugt double %.2236.i, %.2389.i
  %or.cond.i = select i1 %.2386.i, i1 %.2391.i, i1 false
  br i1 %or.cond.i, label %B1462.i, label %B1426.i

B1426.i:                                          ; preds = %B1202.i
  %.2450.i = getelementptr double, ptr %65, i64 %.1861.02982.i
  store double 1.000000e+00, ptr %.2450.i, align 8, !noalias !61
  br label %B1563.i

B1462.i:                                          ; preds = %B1202.i
  %.2507.i = getelementptr double, ptr %66, i64 %.1861.02982.i
  %.2508.i = load double, ptr %.2507.i, align 8, !noalias !61
  %.2510.i = fmul double %.2236.i, %.2508.i
  %.10.i2927.i = fcmp ogt double %.253.i, %.2510.i
  %.11.i2928.i = select i1 %.10.i2927.i, double %.253.i, double %.2510.i
  %.108.i735.i = getelementptr double, ptr %67, i64 %.1861.02982.i
  store double 0.000000e+00, ptr %.108.i735.i, align 8, !noalias !100
  %.161.i780.i = getelementptr double, ptr %68, i64 %.1861.02982.i
  store double 0.000000e+00, ptr %.161.i780.i, align 8, !noalias !100
  %.214.i825.i = getelementptr double, ptr %69, i64 %.1861.02982.i
  store double %.11.i2928.i, ptr %.214.i825.i, align 8, !noalias !100
  %.267.i866.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1861.02982.i
  %.268.i867.i = load i64, ptr %.267.i866.i, align 8, !noalias !100
  %.294.i886.i = icmp slt i64 %.268.i867.i, 0
  %.295.i887.i = select i1 %.294.i886.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i888.i = add i64 %.295.i887.i, %.268.i867.i
  %.316.i903.i = mul i64 %.296.i888.i, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i903.i
  %.321.i906.i = load i64, ptr %.320.i.i, align 8, !noalias !100
  %.322.i907.i = add nsw i64 %.321.i906.i, -1
  store i64 %.322.i907.i, ptr %.320.i.i, align 8, !noalias !100
  %.426.i.i = load i64, ptr %.267.i866.i, align 8, !noalias !100
  %.452.i.i8971 = icmp slt i64 %.426.i.i, 0
  %.453.i985.i = select i1 %.452.i.i8971, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i8972 = add i64 %.453.i985.i, %.426.i.i
  %.474.i.i8973 = mul i64 %.454.i.i8972, %arg.batch.3.3.5.1
  %211 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i8973
  %.478.i997.i = getelementptr i8, ptr %211, i64 24
  %.479.i.i8974 = load i64, ptr %.478.i997.i, align 8, !noalias !100
  %.480.i998.i = add nsw i64 %.479.i.i8974, 1
  store i64 %.480.i998.i, ptr %.478.i997.i, align 8, !noalias !100
  br label %B1563.i

B1561.i:                                          ; preds = %B364.endif.i, %B220.if.i, %B262.i
  %halvings.3.1.i = phi i64 [ %.mux.i, %B262.i ], [ %halvings.2.02965.i, %B364.endif.i ], [ %halvings.2.02965.i, %B220.if.i ]
  %exitcond2995.not.i = icmp eq i64 %arg.shape.0, %.446.i
  br i1 %exitcond2995.not.i, label %B480.preheader.i, label %B220.if.i

B1562.i:                                          ; preds = %B772.if.i, %B1002.i, %B976.i, %B814.i
  %exitcond3000.not.i = icmp eq i64 %arg.shape.0, %.1395.i
  br i1 %exitcond3000.not.i, label %B480.loopexit.i, label %B772.if.i

B1563.i:                                          ; preds = %B1062.if.i, %B1462.i, %B1426.i, %B1154.i
  %exitcond3001.not.i = icmp eq i64 %arg.shape.0, %.1930.i
  br i1 %exitcond3001.not.i, label %B3386, label %B1062.if.i

B220.if.i:                                        ; preds = %B220.preheader.i, %B1561.i
  %halvings.2.02965.i = phi i64 [ %halvings.3.1.i, %B1561.i ], [ 0, %B220.preheader.i ]
  %.377.02963.i = phi i64 [ %.446.i, %B1561.i ], [ 0, %B220.preheader.i ]
  %.446.i = add nsw i64 %.377.02963.i, 1
  %212 = getelementptr i64, ptr %57, i64 %.377.02963.i
  %.528.i = load i64, ptr %212, align 8, !noalias !61
  %.529.i = icmp sgt i64 %.528.i, -1
  br i1 %.529.i, label %B262.i, label %B1561.i

B364.endif.i:                                     ; preds = %B34.i.i, %B128.i.i
  %.658.0.i = phi double [ %205, %B128.i.i ], [ 0.000000e+00, %B34.i.i ]
  %213 = getelementptr double, ptr %58, i64 %.377.02963.i
  store double %.658.0.i, ptr %213, align 8, !noalias !61
  br label %B1561.i

B482.if.i:                                        ; preds = %B480.preheader.i, %B480.loopexit.i
  %.795.02980.i = phi i64 [ %.858.i, %B480.loopexit.i ], [ %halvings.2.0.lcssa.i, %B480.preheader.i ]
  %.858.i = add nsw i64 %.795.02980.i, -1
  br i1 %.794, label %B480.loopexit.i.critedge, label %B516.if.i

B516.if.i:                                        ; preds = %B482.if.i, %B516.loopexit.i
  %.911.02973.i = phi i64 [ %.980.i, %B516.loopexit.i ], [ 0, %B482.if.i ]
  %.980.i = add nsw i64 %.911.02973.i, 1
  %.1057.i = getelementptr double, ptr %59, i64 %.911.02973.i
  %.1058.i = load double, ptr %.1057.i, align 8, !noalias !61
  %.1111.i = getelementptr double, ptr %60, i64 %.911.02973.i
  %.1112.i = load double, ptr %.1111.i, align 8, !noalias !61
  %.1113.i = fadd double %.1058.i, %.1112.i
  %.1114.i = fmul double %.1113.i, 5.000000e-01
  %.92.i354.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.911.02973.i
  %.93.i355.i = load double, ptr %.92.i354.i, align 8, !noalias !95
  %.146.i387.i = getelementptr double, ptr %55, i64 %.911.02973.i
  %.147.i.i = load double, ptr %.146.i387.i, align 8, !noalias !95
  %.149.i.i = fmul double %.1114.i, %.147.i.i
  %.150.i389.i = fadd double %.93.i355.i, %.149.i.i
  %.203.i431.i = getelementptr double, ptr %.571, i64 %.911.02973.i
  store double %.150.i389.i, ptr %.203.i431.i, align 8, !noalias !95
  br i1 %.287.i.i2940.not.i, label %B516.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B516.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %.1114.i
  %invariant.gep9251 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9253 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9255 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9257 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9259 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9261 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9263 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9265 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  %invariant.gep9267 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02973.i
  br label %B122.if.i.i

B772.if.i:                                        ; preds = %B630.i8976, %B1562.i
  %.1326.02976.i = phi i64 [ %.1395.i, %B1562.i ], [ 0, %B630.i8976 ]
  %.1395.i = add nsw i64 %.1326.02976.i, 1
  %214 = getelementptr i64, ptr %61, i64 %.1326.02976.i
  %.1477.i = load i64, ptr %214, align 8, !noalias !61
  %.1478.i = icmp sgt i64 %.1477.i, -1
  br i1 %.1478.i, label %B814.i, label %B1562.i

B1062.if.i:                                       ; preds = %B1563.i, %B1062.if.lr.ph.i
  %.1861.02982.i = phi i64 [ 0, %B1062.if.lr.ph.i ], [ %.1930.i, %B1563.i ]
  %.1930.i = add nsw i64 %.1861.02982.i, 1
  %.2011.i = getelementptr double, ptr %62, i64 %.1861.02982.i
  %.2012.i = load double, ptr %.2011.i, align 8, !noalias !61
  %.2066.i = getelementptr double, ptr %.571, i64 %.1861.02982.i
  store double %.2012.i, ptr %.2066.i, align 8, !noalias !61
  %.2121.i = getelementptr i64, ptr %63, i64 %.1861.02982.i
  %.2122.i = load i64, ptr %.2121.i, align 8, !noalias !61
  %.2123.i = icmp sgt i64 %.2122.i, -1
  br i1 %.2123.i, label %B1154.i, label %B1563.i

B3386:                                            ; preds = %B1563.i, %B1062.preheader.i, %B3304.endif.endif, %B3300
  br i1 %.4944.not, label %B3448, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.525.i.c = load i64, ptr %.524.i, align 8, !noalias !103
  %.641.i.c = inttoptr i64 %.525.i.c to ptr
  tail call void %.641.i.c(ptr %.571, ptr %.615.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !103
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B564.i, %B120.loopexit.i.critedge
  %exitcond738.not.i = icmp eq i64 %.231.0734.i, %.8914
  br i1 %exitcond738.not.i, label %B3448, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i8985, %B154.if.i
  %exitcond736.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond736.not.i, label %B206.i, label %B154.if.i

B206.i:                                           ; preds = %B154.loopexit.i
  %.525.i = load i64, ptr %.524.i, align 8, !noalias !103
  %.641.i = inttoptr i64 %.525.i to ptr
  tail call void %.641.i(ptr %.571, ptr %.615.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !103
  %.945.i = add nsw i64 %.231.0734.i, -1
  %.947.i = sitofp i64 %.945.i to double
  %.952.i = fdiv double %.947.i, %.452.i
  %.955.i = uitofp i64 %.231.0734.i to double
  %.960.i = fdiv double %.955.i, %.452.i
  br label %B348.if.i

B390.i:                                           ; preds = %B348.if.i
  %215 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.667.0732.i
  %.851.i = load double, ptr %215, align 8, !noalias !103
  %.853.i = fcmp olt double %.851.i, -1.000000e-09
  br i1 %.853.i, label %B426.i, label %B564.i

B426.i:                                           ; preds = %B390.i
  %216 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.667.0732.i
  %.84.i51.i = load i64, ptr %216, align 8, !noalias !106
  %.89.i.i8999 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i8999, label %B46.i.i9000, label %B426.endif.i

B46.i.i9000:                                      ; preds = %B426.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !106
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i9001, label %B426.endif.i

B80.i.i9001:                                      ; preds = %B46.i.i9000
  store i64 4, ptr %.120.i73.i, align 8, !noalias !106
  br label %B426.endif.i

B564.i:                                           ; preds = %B426.endif.i, %B348.if.i, %B390.i
  %exitcond737.not.i = icmp eq i64 %arg.shape.0, %.736.i8996
  br i1 %exitcond737.not.i, label %B120.loopexit.i, label %B348.if.i

B120.if.i:                                        ; preds = %B3386, %B120.loopexit.i
  %.231.0734.i = phi i64 [ %.302.i, %B120.loopexit.i ], [ 1, %B3386 ]
  %.302.i = add nsw i64 %.231.0734.i, 1
  br i1 %.794, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %.451.i = uitofp i64 %.231.0734.i to double
  %.456.i = fdiv double %.451.i, %.452.i
  %.247.i.i.i8981 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0729.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0729.i, 1
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0729.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !109
  %.146.i.i = getelementptr double, ptr %70, i64 %.354.0729.i
  %.147.i.i8982 = load double, ptr %.146.i.i, align 8, !noalias !109
  %.149.i.i8983 = fmul double %.456.i, %.147.i.i8982
  %.150.i.i = fadd double %.93.i.i, %.149.i.i8983
  %.203.i.i = getelementptr double, ptr %.571, i64 %.354.0729.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !109
  br i1 %.287.i725.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep9269 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9271 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9273 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9275 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9277 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9279 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9281 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9283 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep9285 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  br label %B122.if.i.i8985

B122.if.i.i8985:                                  ; preds = %B122.if.i.i8985, %B122.if.i.preheader.i
  %.229.i.0726.i = phi i64 [ %.300.i.i, %B122.if.i.i8985 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i = add nsw i64 %.229.i.0726.i, %.155.i.i.i8984
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9270 = getelementptr double, ptr %invariant.gep9269, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9270, align 8, !noalias !113
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.456.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.0726.i, %.155.i.i.1.i8986
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9272 = getelementptr double, ptr %invariant.gep9271, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9272, align 8, !noalias !113
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i8981, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.0726.i, %.155.i.i.2.i8987
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9274 = getelementptr double, ptr %invariant.gep9273, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9274, align 8, !noalias !113
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.456.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.0726.i, %.155.i.i.3.i8988
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9276 = getelementptr double, ptr %invariant.gep9275, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9276, align 8, !noalias !113
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i8981, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.0726.i, %.155.i.i.4.i8989
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9278 = getelementptr double, ptr %invariant.gep9277, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9278, align 8, !noalias !113
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.456.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.0726.i, %.155.i.i.5.i8990
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9280 = getelementptr double, ptr %invariant.gep9279, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9280, align 8, !noalias !113
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i8981, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.0726.i, %.155.i.i.6.i8991
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9282 = getelementptr double, ptr %invariant.gep9281, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9282, align 8, !noalias !113
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.456.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.0726.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.0726.i, %arg.shape.0
  %gep9284 = getelementptr double, ptr %invariant.gep9283, i64 %.271.i.i.i
  %.309.i.i.i8992 = load double, ptr %gep9284, align 8, !noalias !113
  %.313.i.i.i8993 = fadd double %.309.i.i.i8992, %.253.i.i.6.i
  %.359.i.i8994 = add nsw i64 %.229.i.0726.i, %.358.i.i
  %.361.i.i = mul nsw i64 %.359.i.i8994, %arg.shape.0
  %gep9286 = getelementptr double, ptr %invariant.gep9285, i64 %.361.i.i
  store double %.313.i.i.i8993, ptr %gep9286, align 8, !noalias !109
  %exitcond.not.i8995 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i8995, label %B154.loopexit.i, label %B122.if.i.i8985

B348.if.i:                                        ; preds = %B564.i, %B206.i
  %.667.0732.i = phi i64 [ 0, %B206.i ], [ %.736.i8996, %B564.i ]
  %.736.i8996 = add nsw i64 %.667.0732.i, 1
  %.817.i = getelementptr double, ptr %71, i64 %.667.0732.i
  %.818.i8997 = load double, ptr %.817.i, align 8, !noalias !103
  %.819.i = fcmp ogt double %.818.i8997, 5.000000e-01
  br i1 %.819.i, label %B390.i, label %B564.i

B426.endif.i:                                     ; preds = %B80.i.i9001, %B46.i.i9000, %B426.i
  store double 0.000000e+00, ptr %.817.i, align 8, !noalias !103
  %.1014.i = getelementptr double, ptr %72, i64 %.667.0732.i
  store double %.952.i, ptr %.1014.i, align 8, !noalias !103
  %.1071.i = getelementptr double, ptr %73, i64 %.667.0732.i
  store double %.960.i, ptr %.1071.i, align 8, !noalias !103
  br label %B564.i

B3448:                                            ; preds = %B120.loopexit.i, %B2874, %B3386
  %brmerge8916.not = and i1 %good.2.1.lcssa, %looked.2.1.lcssa
  br i1 %brmerge8916.not, label %B3456, label %B3508

B3456:                                            ; preds = %B3448
  %brmerge8917.not = select i1 %within.5.1, i1 %.614, i1 false
  %"$phi3492.7.2.2" = select i1 %brmerge8917.not, i64 3, i64 0
  br i1 %.794, label %B3508, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i9006 = getelementptr double, ptr %75, i64 %.180.0654.i
  %.453.i9007 = load double, ptr %.452.i9006, align 8, !noalias !117
  %.454.i9008 = fcmp olt double %.453.i9007, 5.000000e-01
  br i1 %.454.i9008, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i9009 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i9009, align 8, !noalias !117
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %217 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %217, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !117
  %.556.i = add nsw i64 %.554.i, %"$phi3492.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !117
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i = load double, ptr %.662.i, align 8, !noalias !117
  %.717.i = getelementptr double, ptr %76, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !117
  %.772.i = getelementptr double, ptr %77, i64 %.180.0654.i
  %.773.i = load double, ptr %.772.i, align 8, !noalias !117
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i9010 = icmp slt i64 %.389.i, 0
  %.818.i9011 = select i1 %.817.i9010, i64 %arg.batch.2.5.0, i64 0
  %218 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i9012 = getelementptr double, ptr %218, i64 %.818.i9011
  %.833.i9013 = load double, ptr %.832.i9012, align 8, !noalias !117
  %.837.i = fcmp ugt double %.833.i9013, %.773.i
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %78, i64 %.180.0654.i
  %219 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9287 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9289 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9291 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9293 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9295 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9297 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9299 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9301 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9303 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i = icmp slt i64 %done.2.3.i, 0
  %.980.i9014 = select i1 %.979.i, i64 %arg.batch.2.5.0, i64 0
  %220 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i = getelementptr double, ptr %220, i64 %.980.i9014
  %.1220.i = select i1 %.979.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %221 = getelementptr double, ptr %219, i64 %.1250.i
  br label %B474.if.i

B502.i:                                           ; preds = %B474.if.i
  %.1002.i9019 = add nsw i64 %.868.0650.i, %.1000.i9004
  %.1004.i = mul nsw i64 %.1002.i9019, %arg.shape.0
  %gep9304 = getelementptr double, ptr %invariant.gep9303, i64 %.1004.i
  %.1036.i = load double, ptr %gep9304, align 8, !noalias !117
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !117
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %79
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %222 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %222, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !117
  %.1379.i = fcmp ugt double %.1375.i, %.773.i
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !117
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i9005, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3508, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i ]
  %223 = getelementptr double, ptr %221, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %223, align 8, !noalias !117
  %exitcond.not.i9018 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i9018, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3456, %B789.i
  %.180.0654.i = phi i64 [ %.252.i9005, %B789.i ], [ 0, %B3456 ]
  %.252.i9005 = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !117
  %.388.i = getelementptr i64, ptr %74, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !117
  %.397.i = icmp slt i64 %.334.i, 0
  br i1 %.397.i, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i = load double, ptr %.994.i, align 8, !noalias !117
  %.997.i = fcmp oeq double %.995.i, %.773.i
  br i1 %.997.i, label %B502.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i, %.663.i
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i9015 = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i9015, %arg.shape.0
  %gep9288 = getelementptr double, ptr %invariant.gep9287, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep9288, align 8, !noalias !120
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i9016 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9290 = getelementptr double, ptr %invariant.gep9289, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9290, align 8, !noalias !120
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i9016
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9292 = getelementptr double, ptr %invariant.gep9291, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9292, align 8, !noalias !120
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9294 = getelementptr double, ptr %invariant.gep9293, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9294, align 8, !noalias !120
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9296 = getelementptr double, ptr %invariant.gep9295, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9296, align 8, !noalias !120
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9298 = getelementptr double, ptr %invariant.gep9297, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9298, align 8, !noalias !120
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9300 = getelementptr double, ptr %invariant.gep9299, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9300, align 8, !noalias !120
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i9017 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep9302 = getelementptr double, ptr %invariant.gep9301, i64 %.271.i.i9017
  %.309.i.i = load double, ptr %gep9302, align 8, !noalias !120
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3508:                                            ; preds = %B789.i, %B3456, %B3448
  br i1 %.5180, label %B3558, label %B3520

B3520:                                            ; preds = %B3508
  %.5235 = load double, ptr %.5234, align 8
  %.5236 = fcmp ogt double %.5235, 5.000000e-01
  br i1 %.5236, label %B3558, label %B3626

B3558:                                            ; preds = %B3520, %B3508
  %.5267 = load i64, ptr %.5266, align 8
  %.5312 = inttoptr i64 %.5267 to ptr
  tail call void %.5312(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3626

B3626:                                            ; preds = %B3558, %B3520
  %brmerge8911.not.not = xor i1 %brmerge8911.not, true
  %brmerge9334 = or i1 %.794, %brmerge8911.not.not
  br i1 %brmerge9334, label %B3682, label %B80.if.i4162

B134.i:                                           ; preds = %B80.if.i4162
  %.351.i3436 = getelementptr double, ptr %81, i64 %.141.i3231.09312
  %.352.i3437 = load double, ptr %.351.i3436, align 8, !noalias !124
  %.353.i3438 = fcmp ogt double %.352.i3437, 5.000000e-01
  br i1 %.353.i3438, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i3486 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3231.09312
  %.409.i3487 = load double, ptr %.408.i3486, align 8, !noalias !124
  %.463.i3535 = getelementptr double, ptr %82, i64 %.141.i3231.09312
  %.464.i3536 = load double, ptr %.463.i3535, align 8, !noalias !124
  %.465.i3537 = fsub double %.409.i3487, %.464.i3536
  br i1 %.552.i35759305.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep9363 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3231.09312
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i3587 = fmul double %.465.i3537, %fastest.2.i.2.lcssa
  %.698.i3613 = load double, ptr %.697.i3612, align 8, !noalias !124
  %.699.i3614 = fcmp ogt double %.666.i3587, %.698.i3613
  %.8921 = select i1 %.699.i3614, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i3643 = load double, ptr %.742.i3642, align 8, !noalias !124
  %.773.i3668 = load double, ptr %arg.batch.2.4, align 8, !noalias !124
  %.774.i3669 = fsub double %.743.i3643, %.773.i3668
  %.776.i3671 = fmul double %.8921, %.774.i3669
  %.780.i3674 = fcmp olt double %.465.i3537, %.776.i3671
  br i1 %.780.i3674, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %224 = getelementptr i64, ptr %84, i64 %.141.i3231.09312
  %.838.i4098 = load i64, ptr %224, align 8, !noalias !124
  %.839.i4099 = add nsw i64 %.838.i4098, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i4099, %B490.i ], [ 0, %B380.i ]
  %225 = getelementptr i64, ptr %85, i64 %.141.i3231.09312
  store i64 %"$phi528.1.2.i.2", ptr %225, align 8, !noalias !124
  %.959.i3769 = load double, ptr %.408.i3486, align 8, !noalias !124
  store double %.959.i3769, ptr %.463.i3535, align 8, !noalias !124
  %.1068.i3850 = getelementptr double, ptr %86, i64 %.141.i3231.09312
  store double 1.000000e+00, ptr %.1068.i3850, align 8, !noalias !124
  store i64 1, ptr %.1166, align 8, !noalias !124
  %.1154.i = load i64, ptr %225, align 8, !noalias !124
  %.1155.i = icmp sgt i64 %.1154.i, 1000
  br i1 %.1155.i, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %226 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3231.09312
  %.84.i.i3993 = load i64, ptr %226, align 8, !noalias !128
  %.89.i.i3996 = icmp sgt i64 %.84.i.i3993, -1
  br i1 %.89.i.i3996, label %B46.i.i4001, label %B740.i

B46.i.i4001:                                      ; preds = %B694.i
  %.120.i.i4021 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i3993
  %.121.i.i4022 = load i64, ptr %.120.i.i4021, align 8, !noalias !128
  %.122.i.i4023 = icmp eq i64 %.121.i.i4022, 0
  br i1 %.122.i.i4023, label %B80.i.i4028, label %B740.i

B80.i.i4028:                                      ; preds = %B46.i.i4001
  store i64 6, ptr %.120.i.i4021, align 8, !noalias !128
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i4028, %B694.i, %B46.i.i4001, %B528.i, %B134.i, %B80.if.i4162
  store double 0.000000e+00, ptr %.294.i3376, align 8, !noalias !124
  %.200.i3317 = icmp sgt i64 %.144.i3232.09311, 1
  br i1 %.200.i3317, label %B80.if.i4162, label %B3682

B80.if.i4162:                                     ; preds = %B3626, %B740.i
  %.141.i3231.09312 = phi i64 [ %.213.i4170, %B740.i ], [ 0, %B3626 ]
  %.144.i3232.09311 = phi i64 [ %.209.i4167, %B740.i ], [ %storemerge, %B3626 ]
  %.209.i4167 = add nsw i64 %.144.i3232.09311, -1
  %.213.i4170 = add nsw i64 %.141.i3231.09312, 1
  %.294.i3376 = getelementptr double, ptr %80, i64 %.141.i3231.09312
  %.295.i3377 = load double, ptr %.294.i3376, align 8, !noalias !124
  %.296.i3378 = fcmp oeq double %.295.i3377, 1.000000e+00
  br i1 %.296.i3378, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.29308 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i3248.09307 = phi i64 [ %.565.i4154, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i4154 = add nsw i64 %.496.i3248.09307, 1
  %.592.i4106 = add nsw i64 %.496.i3248.09307, %arg.shape.1
  %.594.i4108 = mul nsw i64 %.592.i4106, %arg.shape.0
  %gep9364 = getelementptr double, ptr %invariant.gep9363, i64 %.594.i4108
  %.626.i4136 = load double, ptr %gep9364, align 8, !noalias !124
  %.627.i4137 = tail call double @llvm.fabs.f64(double %.626.i4136)
  %.10.i.i = fcmp ogt double %.627.i4137, %fastest.2.i.29308
  %.11.i.i = select i1 %.10.i.i, double %.627.i4137, double %fastest.2.i.29308
  %exitcond9347.not = icmp eq i64 %arg.shape.1, %.565.i4154
  br i1 %exitcond9347.not, label %B380.i, label %B270.if.i

B3682:                                            ; preds = %B740.i, %B3626
  %brmerge8923.not = and i1 %.5382.not, %looked.2.1.lcssa
  %brmerge8923.not.not = xor i1 %brmerge8923.not, true
  %brmerge9333 = or i1 %.794, %brmerge8923.not.not
  br i1 %brmerge9333, label %B3732, label %B114.if.i

B46.i.i9020:                                      ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !131
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i9027, label %B228.i

B80.i.i9027:                                      ; preds = %B46.i.i9020
  %.196.i.i = getelementptr double, ptr %87, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !131
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i9027
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !131
  %.321.i.i = getelementptr double, ptr %88, i64 %.302.01639.i
  %.322.i.i9028 = load double, ptr %.321.i.i, align 8, !noalias !131
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i9028
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i9029

B76.if.i.lr.ph.i9029:                             ; preds = %B122.i.i
  %227 = getelementptr i64, ptr %89, i64 %.302.01639.i
  %.513.i = load i64, ptr %227, align 8, !noalias !136
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %228 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i9030

B76.if.i.i9030:                                   ; preds = %B76.if.i.i9030, %B76.if.i.lr.ph.i9029
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i9029 ], [ %.188.i390.i, %B76.if.i.i9030 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %229 = getelementptr double, ptr %228, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %229, align 8, !noalias !137
  %230 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %230, align 8, !noalias !137
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %231 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %231, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !137
  %exitcond.not.i9031 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i9031, label %B228.i, label %B76.if.i.i9030

B228.i:                                           ; preds = %B76.if.i.i9030, %B114.if.i, %B122.i.i, %B80.i.i9027, %B46.i.i9020
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i ], [ %some.2.01641.i, %B80.i.i9027 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i9020 ], [ true, %B76.if.i.i9030 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3732

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !136
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !136
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !136
  %.896.i = inttoptr i64 %.780.i to ptr
  tail call void %.896.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i9021), !noalias !136
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i9022, align 8, !noalias !136
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i9021, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !136
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !141
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %87, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !141
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !141
  %.321.i223.i = getelementptr double, ptr %88, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !141
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %90, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !136
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %232 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %232, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !136
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
  %233 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %234 = getelementptr double, ptr %233, i64 %.1743.i
  %invariant.gep9313 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep9315 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %235 = getelementptr double, ptr %234, i64 %.1488.01643.i
  store double %.1622.i, ptr %235, align 8, !noalias !136
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %236 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %236, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %239, align 8, !noalias !144
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !144
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !144
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %237 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %237, align 8, !noalias !136
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %239, align 8, !noalias !147
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !147
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !147
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i9025 = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i9025, label %B598.if.i, label %B3732

B114.if.i:                                        ; preds = %B3682, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3682 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3682 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %238 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %238, align 8, !noalias !131
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i9020

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i9024, %B1076.i ], [ %storemerge.i, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i9024 = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %239 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %239, align 8, !noalias !141
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i9026 = mul nsw i64 %.1588.i, %arg.shape.0
  %gep9314 = getelementptr double, ptr %invariant.gep9313, i64 %.1590.i9026
  %.1622.i = load double, ptr %gep9314, align 8, !noalias !136
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep9316 = getelementptr double, ptr %invariant.gep9315, i64 %.1637.i
  store double %.1622.i, ptr %gep9316, align 8, !noalias !136
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3732:                                            ; preds = %B1076.i, %B3682, %B230.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge9335 = or i1 %.794, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9335, label %B4708, label %B3774.if

B3822:                                            ; preds = %B3774.if
  %.5767 = mul i64 %.5694, %arg.batch.3.3.5.1
  %.5771 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5767
  %.5772 = load i64, ptr %.5771, align 8
  %.5828 = getelementptr i8, ptr %.5771, i64 24
  %.5829 = load i64, ptr %.5828, align 8
  %240 = add i64 %.5772, %.5829
  %.5830 = sub i64 %arg.most, %240
  %.5835 = icmp slt i64 %.5830, 1
  br i1 %.5835, label %B3902, label %B3948

B3902:                                            ; preds = %B3822
  %241 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5532.09321
  %.84.i4251 = load i64, ptr %241, align 8, !noalias !150
  %.89.i4254 = icmp sgt i64 %.84.i4251, -1
  br i1 %.89.i4254, label %B46.i4259, label %B3948

B46.i4259:                                        ; preds = %B3902
  %.120.i4285 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i4251
  %.121.i4286 = load i64, ptr %.120.i4285, align 8, !noalias !150
  %.122.i4287 = icmp eq i64 %.121.i4286, 0
  br i1 %.122.i4287, label %B80.i4292, label %B3948

B80.i4292:                                        ; preds = %B46.i4259
  store i64 5, ptr %.120.i4285, align 8, !noalias !150
  br label %B3948

B3948:                                            ; preds = %B80.i4292, %B3902, %B46.i4259, %B3822
  %.5925 = getelementptr double, ptr %91, i64 %.5532.09321
  %.5926 = load double, ptr %.5925, align 8
  %.5927 = fcmp ogt double %.5926, 5.000000e-01
  br i1 %.5927, label %B3986, label %B4090

B3986:                                            ; preds = %B3948
  %.5982 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5532.09321
  %.5983 = load double, ptr %.5982, align 8
  %.6037 = getelementptr double, ptr %92, i64 %.5532.09321
  %.6038 = load double, ptr %.6037, align 8
  %.6039 = fcmp oeq double %.5983, %.6038
  br i1 %.6039, label %B4050, label %B4090

B4050:                                            ; preds = %B3986
  %.192.i4518 = load i64, ptr %.5693, align 8, !noalias !153
  %.248.i4566 = getelementptr i64, ptr %93, i64 %.5532.09321
  %.249.i4567 = load i64, ptr %.248.i4566, align 8, !noalias !153
  %.250.i4568 = add nsw i64 %.249.i4567, 1
  store i64 %.250.i4568, ptr %.248.i4566, align 8, !noalias !153
  %.373.i4673 = icmp slt i64 %.249.i4567, -1
  %.374.i4674 = select i1 %.373.i4673, i64 %arg.batch.1.2.5.0, i64 0
  %242 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i4568
  %.388.i4688 = getelementptr double, ptr %242, i64 %.374.i4674
  %.389.i4689 = load double, ptr %.388.i4688, align 8, !noalias !153
  %.390.i4690 = fcmp oeq double %.389.i4689, 0x7FF0000000000000
  br i1 %.390.i4690, label %B182.i, label %B240.i

B182.i:                                           ; preds = %B4050
  %.424.i5207 = icmp slt i64 %.192.i4518, 0
  %.425.i5208 = select i1 %.424.i5207, i64 %arg.batch.3.1.5.0, i64 0
  %243 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i4518
  %.439.i5222 = getelementptr i64, ptr %243, i64 %.425.i5208
  %.440.i5223 = load i64, ptr %.439.i5222, align 8, !noalias !153
  %.441.i5224 = icmp eq i64 %.440.i5223, 0
  br i1 %.441.i5224, label %B216.i5228, label %B4090

B216.i5228:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i5222, align 8, !noalias !153
  br label %B4090

B240.i:                                           ; preds = %B4050
  store double %.389.i4689, ptr %.6037, align 8, !noalias !153
  %.592.i4780 = select i1 %.373.i4673, i64 %arg.batch.1.4.5.0, i64 0
  %244 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i4568
  %.606.i4794 = getelementptr i64, ptr %244, i64 %.592.i4780
  %.607.i4795 = load i64, ptr %.606.i4794, align 8, !noalias !153
  %.610.i4797 = icmp eq i64 %.607.i4795, 0
  br i1 %.610.i4797, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i
  %.665.i5161 = getelementptr double, ptr %94, i64 %.5532.09321
  store double 1.000000e+00, ptr %.665.i5161, align 8, !noalias !153
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i
  %.733.i4823 = load i64, ptr %.1166, align 8, !noalias !153
  %.734.i4824 = icmp eq i64 %.733.i4823, 0
  br i1 %.734.i4824, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.1166, align 8, !noalias !153
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i49729317.not, label %B4090, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i5018 = select i1 %.373.i4673, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i5019 = add i64 %.237.i.i5018, %.250.i4568
  %.258.i.i5035 = mul i64 %.238.i.i5019, %arg.batch.1.3.5.1
  %245 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i5035
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4329.09319 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i5082, %B76.if.i.i ]
  %.188.i.i5082 = add nsw i64 %.117.i.i4329.09319, 1
  %246 = getelementptr double, ptr %245, i64 %.117.i.i4329.09319
  %.263.i.i5038 = load double, ptr %246, align 8, !noalias !157
  %247 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4329.09319
  %.293.i.i5054 = load i64, ptr %247, align 8, !noalias !157
  %.295.i.i5056 = mul nsw i64 %.293.i.i5054, %arg.shape.0
  %.297.i.i5058 = add nsw i64 %.295.i.i5056, %.5532.09321
  %.311.i.i5065 = icmp slt i64 %.297.i.i5058, 0
  %.312.i.i5066 = select i1 %.311.i.i5065, i64 %arg.batch.5.1.5.0, i64 0
  %248 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i5058
  %.326.i.i5076 = getelementptr double, ptr %248, i64 %.312.i.i5066
  store double %.263.i.i5038, ptr %.326.i.i5076, align 8, !noalias !157
  %exitcond9348.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i5082
  br i1 %exitcond9348.not, label %B4090, label %B76.if.i.i

B4090:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i5228, %B182.i, %B3986, %B3948
  %.6128 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5694
  %.6129 = load i64, ptr %.6128, align 8
  %.6130.not = icmp eq i64 %.6129, 0
  br i1 %.6130.not, label %B4232, label %B4124

B4124:                                            ; preds = %B4090
  %.6191 = getelementptr i64, ptr %95, i64 %.5532.09321
  %.6192 = load i64, ptr %.6191, align 8
  %.6222 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5694
  store i64 %.6192, ptr %.6222, align 8
  store i64 -1, ptr %.5693, align 8
  %.236.i9032 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !161
  %.293.i9037 = getelementptr double, ptr %96, i64 %.5532.09321
  store double 0.000000e+00, ptr %.293.i9037, align 8, !noalias !161
  %.324.i9039 = load i64, ptr %.323.i9038, align 8, !noalias !161
  %.326.i9040 = icmp eq i64 %.236.i9032, %.324.i9039
  br i1 %.326.i9040, label %B4440, label %B132.i9041

B132.i9041:                                       ; preds = %B4124
  %.359.i9042 = add nsw i64 %.236.i9032, 1
  store i64 %.359.i9042, ptr %arg.batch.4.2.4, align 8, !noalias !161
  store i64 1, ptr %.1166, align 8, !noalias !161
  %.438.i9044 = icmp slt i64 %.236.i9032, 0
  %.439.i9045 = select i1 %.438.i9044, i64 %arg.batch.0.2.5.0, i64 0
  %249 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i9032
  %.453.i9046 = getelementptr i64, ptr %249, i64 %.439.i9045
  %.454.i9047 = load i64, ptr %.453.i9046, align 8, !noalias !161
  %.469.i9048 = icmp slt i64 %.454.i9047, 0
  %.470.i9049 = select i1 %.469.i9048, i64 %arg.batch.1.0.5.0, i64 0
  %250 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i9047
  %.484.i9050 = getelementptr i64, ptr %250, i64 %.470.i9049
  %.485.i9051 = load i64, ptr %.484.i9050, align 8, !noalias !161
  store i64 %.236.i9032, ptr %.5693, align 8, !noalias !161
  %.595.i9055 = getelementptr i64, ptr %97, i64 %.5532.09321
  store i64 %.485.i9051, ptr %.595.i9055, align 8, !noalias !161
  store i64 1, ptr %.6191, align 8, !noalias !161
  %.709.i9059 = getelementptr i64, ptr %98, i64 %.5532.09321
  store i64 0, ptr %.709.i9059, align 8, !noalias !161
  br i1 %.8051131.not.i9060, label %B402.i9075, label %B358.if.lr.ph.i9061

B358.if.lr.ph.i9061:                              ; preds = %B132.i9041
  %.867.i9062 = select i1 %.438.i9044, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i9063 = add i64 %.867.i9062, %.236.i9032
  %.888.i9064 = mul i64 %.868.i9063, %arg.batch.0.1.5.1
  %251 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i9064
  %invariant.gep9365 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5532.09321
  br label %B358.if.i9065

B402.i9075:                                       ; preds = %B358.if.i9065, %B132.i9041
  br i1 %.175.i1134.not.i9076, label %B402.endif.i9094, label %B76.if.i.lr.ph.i9077

B76.if.i.lr.ph.i9077:                             ; preds = %B402.i9075
  %.990.i9078 = load i64, ptr %.595.i9055, align 8, !noalias !161
  %.236.i.i9079 = icmp slt i64 %.990.i9078, 0
  %.237.i.i9080 = select i1 %.236.i.i9079, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i9081 = add i64 %.237.i.i9080, %.990.i9078
  %.258.i.i9082 = mul i64 %.238.i.i9081, %arg.batch.1.3.5.1
  %252 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9082
  br label %B76.if.i.i9083

B76.if.i.i9083:                                   ; preds = %B76.if.i.i9083, %B76.if.i.lr.ph.i9077
  %.117.i.01135.i9084 = phi i64 [ 0, %B76.if.i.lr.ph.i9077 ], [ %.188.i.i9085, %B76.if.i.i9083 ]
  %.188.i.i9085 = add nsw i64 %.117.i.01135.i9084, 1
  %253 = getelementptr double, ptr %252, i64 %.117.i.01135.i9084
  %.263.i.i9086 = load double, ptr %253, align 8, !noalias !164
  %254 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i9084
  %.293.i.i9087 = load i64, ptr %254, align 8, !noalias !164
  %.295.i.i9088 = mul nsw i64 %.293.i.i9087, %arg.shape.0
  %.297.i.i9089 = add nsw i64 %.295.i.i9088, %.5532.09321
  %.311.i.i9090 = icmp slt i64 %.297.i.i9089, 0
  %.312.i.i9091 = select i1 %.311.i.i9090, i64 %arg.batch.5.1.5.0, i64 0
  %255 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i9089
  %.326.i.i9092 = getelementptr double, ptr %255, i64 %.312.i.i9091
  store double %.263.i.i9086, ptr %.326.i.i9092, align 8, !noalias !164
  %exitcond1142.not.i9093 = icmp eq i64 %.188.i.i9085, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i9093, label %B402.endif.i9094, label %B76.if.i.i9083

B888.i9182:                                       ; preds = %B580.if.i9110
  store double 0.000000e+00, ptr %.1877.i9179, align 8, !noalias !161
  br label %B4440

B358.if.i9065:                                    ; preds = %B358.if.i9065, %B358.if.lr.ph.i9061
  %.747.01132.i9066 = phi i64 [ 0, %B358.if.lr.ph.i9061 ], [ %.818.i9067, %B358.if.i9065 ]
  %.818.i9067 = add nsw i64 %.747.01132.i9066, 1
  %256 = getelementptr double, ptr %251, i64 %.747.01132.i9066
  %.893.i9068 = load double, ptr %256, align 8, !noalias !161
  %.895.i9069 = mul nsw i64 %.747.01132.i9066, %arg.shape.0
  %gep9366 = getelementptr double, ptr %invariant.gep9365, i64 %.895.i9069
  store double %.893.i9068, ptr %gep9366, align 8, !noalias !161
  %exitcond.not.i9074 = icmp eq i64 %.818.i9067, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i9074, label %B402.i9075, label %B358.if.i9065

B402.endif.i9094:                                 ; preds = %B76.if.i.i9083, %B402.i9075
  br i1 %.11171137.not.i9095, label %B580.if.i9110, label %B496.if.lr.ph.i9096

B496.if.lr.ph.i9096:                              ; preds = %B402.endif.i9094
  %.1179.i9097 = select i1 %.438.i9044, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i9098 = add i64 %.1179.i9097, %.236.i9032
  %.1200.i9099 = mul i64 %.1180.i9098, %arg.batch.0.0.5.1
  %257 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i9099
  %invariant.gep9367 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5532.09321
  br label %B496.if.i9100

B496.if.i9100:                                    ; preds = %B496.if.i9100, %B496.if.lr.ph.i9096
  %.1061.01138.i9101 = phi i64 [ 0, %B496.if.lr.ph.i9096 ], [ %.1130.i9102, %B496.if.i9100 ]
  %.1130.i9102 = add nsw i64 %.1061.01138.i9101, 1
  %258 = getelementptr double, ptr %257, i64 %.1061.01138.i9101
  %.1205.i9103 = load double, ptr %258, align 8, !noalias !161
  %.1207.i9104 = mul nsw i64 %.1061.01138.i9101, %arg.shape.0
  %gep9368 = getelementptr double, ptr %invariant.gep9367, i64 %.1207.i9104
  store double %.1205.i9103, ptr %gep9368, align 8, !noalias !161
  %exitcond1143.not.i9109 = icmp eq i64 %.1130.i9102, %arg.shape.1
  br i1 %exitcond1143.not.i9109, label %B580.if.i9110, label %B496.if.i9100

B580.if.i9110:                                    ; preds = %B496.if.i9100, %B402.endif.i9094
  %invariant.gep.i9111 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5532.09321
  store double 0.000000e+00, ptr %invariant.gep.i9111, align 8, !noalias !161
  %gep.1.i9112 = getelementptr double, ptr %invariant.gep.i9111, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i9112, align 8, !noalias !161
  %gep.2.i9114 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.2.idx.i9113
  store double 0.000000e+00, ptr %gep.2.i9114, align 8, !noalias !161
  %gep.3.i9116 = getelementptr i8, ptr %invariant.gep.i9111, i64 %.idx.i9036
  store double 0.000000e+00, ptr %gep.3.i9116, align 8, !noalias !161
  %gep.4.i9118 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.4.idx.i9117
  store double 0.000000e+00, ptr %gep.4.i9118, align 8, !noalias !161
  %gep.5.i9120 = getelementptr i8, ptr %invariant.gep.i9111, i64 %.idx8859
  store double 0.000000e+00, ptr %gep.5.i9120, align 8, !noalias !161
  %gep.6.i9122 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.6.idx.i9121
  store double 0.000000e+00, ptr %gep.6.i9122, align 8, !noalias !161
  %gep.7.i9124 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.7.idx.i9123
  store double 0.000000e+00, ptr %gep.7.i9124, align 8, !noalias !161
  %gep.8.i9126 = getelementptr i8, ptr %invariant.gep.i9111, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i9126, align 8, !noalias !161
  %gep.9.i9128 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.9.idx.i9127
  store double 0.000000e+00, ptr %gep.9.i9128, align 8, !noalias !161
  %gep.10.i9130 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.10.idx.i9129
  store double 0.000000e+00, ptr %gep.10.i9130, align 8, !noalias !161
  %gep.11.i9132 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.11.idx.i9131
  store double 0.000000e+00, ptr %gep.11.i9132, align 8, !noalias !161
  %gep.12.i9134 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.12.idx.i9133
  store double 0.000000e+00, ptr %gep.12.i9134, align 8, !noalias !161
  %gep.13.i9136 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.13.idx.i9135
  store double 0.000000e+00, ptr %gep.13.i9136, align 8, !noalias !161
  %gep.14.i9138 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.14.idx.i9137
  store double 0.000000e+00, ptr %gep.14.i9138, align 8, !noalias !161
  %gep.15.i9140 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.15.idx.i9139
  store double 0.000000e+00, ptr %gep.15.i9140, align 8, !noalias !161
  %gep.16.i9142 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.16.idx.i9141
  store double 0.000000e+00, ptr %gep.16.i9142, align 8, !noalias !161
  %gep.17.i9144 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.17.idx.i9143
  store double 0.000000e+00, ptr %gep.17.i9144, align 8, !noalias !161
  %gep.18.i9146 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.18.idx.i9145
  store double 0.000000e+00, ptr %gep.18.i9146, align 8, !noalias !161
  %gep.19.i9148 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.19.idx.i9147
  store double 0.000000e+00, ptr %gep.19.i9148, align 8, !noalias !161
  %gep.20.i9150 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.20.idx.i9149
  store double 0.000000e+00, ptr %gep.20.i9150, align 8, !noalias !161
  %gep.21.i9152 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.21.idx.i9151
  store double 0.000000e+00, ptr %gep.21.i9152, align 8, !noalias !161
  %gep.22.i9154 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.22.idx.i9153
  store double 0.000000e+00, ptr %gep.22.i9154, align 8, !noalias !161
  %gep.23.i9156 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.23.idx.i9155
  store double 0.000000e+00, ptr %gep.23.i9156, align 8, !noalias !161
  %gep.24.i9158 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.24.idx.i9157
  store double 0.000000e+00, ptr %gep.24.i9158, align 8, !noalias !161
  %gep.25.i9160 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.25.idx.i9159
  store double 0.000000e+00, ptr %gep.25.i9160, align 8, !noalias !161
  %gep.26.i9162 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.26.idx.i9161
  store double 0.000000e+00, ptr %gep.26.i9162, align 8, !noalias !161
  %gep.27.i9164 = getelementptr i8, ptr %invariant.gep.i9111, i64 %gep.27.idx.i9163
  store double 0.000000e+00, ptr %gep.27.i9164, align 8, !noalias !161
  %.1455.i9165 = load double, ptr %arg.batch.2.4, align 8, !noalias !161
  %.1516.i9166 = load i64, ptr %.595.i9055, align 8, !noalias !161
  %.1531.i9167 = icmp slt i64 %.1516.i9166, 0
  %.1532.i9168 = select i1 %.1531.i9167, i64 %arg.batch.1.2.5.0, i64 0
  %259 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i9166
  %.1546.i9169 = getelementptr double, ptr %259, i64 %.1532.i9168
  %.1547.i9170 = load double, ptr %.1546.i9169, align 8, !noalias !161
  store double %.1455.i9165, ptr %invariant.gep.i9111, align 8, !noalias !161
  %.1656.i9173 = getelementptr double, ptr %99, i64 %.5532.09321
  store double %.1547.i9170, ptr %.1656.i9173, align 8, !noalias !161
  store double 1.000000e+00, ptr %.293.i9037, align 8, !noalias !161
  %.1767.i9175 = getelementptr double, ptr %100, i64 %.5532.09321
  store double 0xFFF0000000000000, ptr %.1767.i9175, align 8, !noalias !161
  %.1822.i9177 = getelementptr double, ptr %101, i64 %.5532.09321
  store double 0x7FF0000000000000, ptr %.1822.i9177, align 8, !noalias !161
  %.1877.i9179 = getelementptr double, ptr %102, i64 %.5532.09321
  %.1878.i9180 = load double, ptr %.1877.i9179, align 8, !noalias !161
  %.1880.i9181 = fcmp ueq double %.1878.i9180, 0xFFF0000000000000
  br i1 %.1880.i9181, label %B4440, label %B888.i9182

B4232:                                            ; preds = %B4090
  %.6418 = getelementptr double, ptr %103, i64 %.5532.09321
  %.6419 = load double, ptr %.6418, align 8
  %.6421 = fcmp ult double %.6419, 1.500000e+01
  br i1 %.6421, label %B4440, label %B4280

B4280:                                            ; preds = %B4232
  %.6465 = load double, ptr %.6464, align 8
  %.6519 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5532.09321
  %.6520 = load double, ptr %.6519, align 8
  %.6521 = fsub double %.6465, %.6520
  %.6575 = getelementptr double, ptr %106, i64 %.5532.09321
  %.6576 = load double, ptr %.6575, align 8
  %.6578 = fmul double %.6576, 5.000000e+03
  %.6579 = fcmp ogt double %.6521, %.6578
  br i1 %.6579, label %B4440, label %B4416

B4416:                                            ; preds = %B4280
  store double 0.000000e+00, ptr %.6418, align 8
  br label %B4440

B4440:                                            ; preds = %B888.i9182, %B4124, %B580.if.i9110, %B4280, %B4416, %B4232
  %budget.7.4 = phi i64 [ %budget.5.29323, %B4232 ], [ 0, %B4280 ], [ %budget.5.29323, %B4416 ], [ %budget.5.29323, %B580.if.i9110 ], [ %budget.5.29323, %B4124 ], [ %budget.5.29323, %B888.i9182 ]
  %.6707 = load i64, ptr %.5693, align 8
  %.6708 = icmp sgt i64 %.6707, -1
  br i1 %.6708, label %B4478, label %B4735

B4478:                                            ; preds = %B4440
  %.6713 = add nsw i64 %active.5.29324, 1
  %.6822 = mul i64 %.6707, %arg.batch.3.3.5.1
  %.6826 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6822
  %.6827 = load i64, ptr %.6826, align 8
  %.6838.0 = and i64 %.6827, 127
  %.6868 = sub nsw i64 128, %.6838.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6868, i64 %.5830)
  %.6956 = getelementptr double, ptr %107, i64 %.5532.09321
  %.6957 = load double, ptr %.6956, align 8
  %.6959 = fcmp ogt double %.6957, 0.000000e+00
  %.6970 = sitofp i64 %.11.i to double
  %"$phi4648.1.2.5" = select i1 %.6959, double 1.000000e+00, double %.6970
  %.7033 = getelementptr double, ptr %108, i64 %.5532.09321
  store double %"$phi4648.1.2.5", ptr %.7033, align 8
  %.111.i5361 = getelementptr i64, ptr %109, i64 %.5532.09321
  %.112.i5362 = load i64, ptr %.111.i5361, align 8, !noalias !168
  %.169.i5411 = getelementptr double, ptr %110, i64 %.5532.09321
  %.170.i5412 = load double, ptr %.169.i5411, align 8, !noalias !168
  %.224.i5460 = getelementptr double, ptr %111, i64 %.5532.09321
  store double %.170.i5412, ptr %.224.i5460, align 8, !noalias !168
  %.237.i5468 = icmp slt i64 %.112.i5362, %arg.batch.2.5.0
  br i1 %.237.i5468, label %B134.i5473, label %B4735

B134.i5473:                                       ; preds = %B4478
  %.253.i5484 = icmp slt i64 %.112.i5362, 0
  %.254.i5485 = select i1 %.253.i5484, i64 %arg.batch.2.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i5362
  %.268.i5499 = getelementptr double, ptr %260, i64 %.254.i5485
  %.269.i5500 = load double, ptr %.268.i5499, align 8, !noalias !168
  %.328.i5551 = load double, ptr %.169.i5411, align 8, !noalias !168
  %.10.i.i5558 = fcmp olt double %.328.i5551, %.269.i5500
  %.11.i.i5559 = select i1 %.10.i.i5558, double %.328.i5551, double %.269.i5500
  store double %.11.i.i5559, ptr %.224.i5460, align 8, !noalias !168
  br label %B4735

B4708:                                            ; preds = %B4735, %B3732
  %budget.4.2 = phi i64 [ %.1132, %B3732 ], [ %budget.6.3, %B4735 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3732 ], [ %active.6.3, %B4735 ]
  %.7111 = icmp sgt i64 %active.8.2, 0
  %.7125 = icmp sgt i64 %budget.4.2, 0
  %or.cond8924 = select i1 %.7111, i1 %.7125, i1 false
  br i1 %or.cond8924, label %B584, label %B4734

B4734:                                            ; preds = %B4708, %B556
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B556 ], [ %active.8.2, %B4708 ]
  br i1 %.794, label %B4734.endif, label %B80.if.i2040.lr.ph

B80.if.i2040.lr.ph:                               ; preds = %B4734
  %.idx = mul i64 %arg.batch.4.0.5.1, 184
  %261 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8857 = mul i64 %arg.batch.4.0.5.1, 192
  %262 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8857
  %.703.i1698 = add nsw i64 %arg.shape.2, -1
  %.idx8858 = mul i64 %arg.batch.4.0.5.1, 168
  %263 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8858
  br label %B80.if.i2040

B126.i1345:                                       ; preds = %B80.if.i2040
  %.318.i1392 = getelementptr double, ptr %261, i64 %.105.i1190.09331
  %.319.i1393 = load double, ptr %.318.i1392, align 8, !noalias !172
  %.5.i.i1394 = fptosi double %.319.i1393 to i64
  %.397.i1443 = getelementptr double, ptr %262, i64 %.105.i1190.09331
  %.398.i1444 = load double, ptr %.397.i1443, align 8, !noalias !172
  %.5.i1.i1445 = fptosi double %.398.i1444 to i64
  %.478.i1496 = mul i64 %.258.i1338, %arg.batch.3.3.5.1
  %.482.i1500 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.478.i1496
  %.483.i1501 = load i64, ptr %.482.i1500, align 8, !noalias !172
  %.485.i1503 = add nsw i64 %.483.i1501, %.5.i.i1394
  store i64 %.485.i1503, ptr %.482.i1500, align 8, !noalias !172
  %.591.i1598 = getelementptr i8, ptr %.482.i1500, i64 24
  %.592.i1599 = load i64, ptr %.591.i1598, align 8, !noalias !172
  %.594.i1601 = add nsw i64 %.592.i1599, %.5.i1.i1445
  store i64 %.594.i1601, ptr %.591.i1598, align 8, !noalias !172
  %.700.i1695 = getelementptr i8, ptr %.482.i1500, i64 8
  %.701.i1696 = load i64, ptr %.700.i1695, align 8, !noalias !172
  %.706.i1701 = add nsw i64 %.5.i1.i1445, %.5.i.i1394
  %.707.i1702 = mul nsw i64 %.706.i1701, %.703.i1698
  %..5.i.i1394 = select i1 %.625, i64 0, i64 %.5.i.i1394
  %.708.i1703 = add i64 %.707.i1702, %..5.i.i1394
  %.841.i1808 = add i64 %.708.i1703, %.701.i1696
  store i64 %.841.i1808, ptr %.700.i1695, align 8, !noalias !172
  store double 0.000000e+00, ptr %.318.i1392, align 8, !noalias !172
  store double 0.000000e+00, ptr %.397.i1443, align 8, !noalias !172
  %.1072.i1986 = getelementptr double, ptr %263, i64 %.105.i1190.09331
  %.1073.i1987 = load double, ptr %.1072.i1986, align 8, !noalias !172
  %.1081.i1993 = sitofp i64 %.706.i1701 to double
  %.1082.i1994 = fsub double %.1073.i1987, %.1081.i1993
  store double %.1082.i1994, ptr %.1072.i1986, align 8, !noalias !172
  br label %B568.i1342

B568.i1342:                                       ; preds = %B126.i1345, %B80.if.i2040
  %.163.i1271 = icmp sgt i64 %.108.i1191.09330, 1
  br i1 %.163.i1271, label %B80.if.i2040, label %B4734.endif

B80.if.i2040:                                     ; preds = %B80.if.i2040.lr.ph, %B568.i1342
  %.105.i1190.09331 = phi i64 [ 0, %B80.if.i2040.lr.ph ], [ %.176.i2047, %B568.i1342 ]
  %.108.i1191.09330 = phi i64 [ %storemerge, %B80.if.i2040.lr.ph ], [ %.172.i2044, %B568.i1342 ]
  %.172.i2044 = add nsw i64 %.108.i1191.09330, -1
  %.176.i2047 = add nsw i64 %.105.i1190.09331, 1
  %264 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1190.09331
  %.258.i1338 = load i64, ptr %264, align 8, !noalias !172
  %.263.i1341 = icmp sgt i64 %.258.i1338, -1
  br i1 %.263.i1341, label %B126.i1345, label %B568.i1342

B4735:                                            ; preds = %B4478, %B134.i5473, %B4440, %B3774.if
  %budget.6.3 = phi i64 [ %budget.5.29323, %B3774.if ], [ %budget.7.4, %B4440 ], [ %budget.7.4, %B134.i5473 ], [ %budget.7.4, %B4478 ]
  %active.6.3 = phi i64 [ %active.5.29324, %B3774.if ], [ %active.5.29324, %B4440 ], [ %.6713, %B134.i5473 ], [ %.6713, %B4478 ]
  %.5595 = icmp sgt i64 %.5535.09322, 1
  br i1 %.5595, label %B3774.if, label %B4708

common.ret:                                       ; preds = %B3304.endif.if, %B2766.endif.if, %B4734.endif
  %common.ret.op = phi i32 [ %.4226, %B2766.endif.if ], [ %.4828, %B3304.endif.if ], [ 0, %B4734.endif ]
  ret i32 %common.ret.op

B416.if:                                          ; preds = %B416.if.lr.ph, %B502
  %active.4.09194 = phi i64 [ 0, %B416.if.lr.ph ], [ %.1089, %B502 ]
  %.783.09193 = phi i64 [ %storemerge, %B416.if.lr.ph ], [ %.847, %B502 ]
  %.780.09192 = phi i64 [ 0, %B416.if.lr.ph ], [ %.851, %B502 ]
  %.847 = add nsw i64 %.783.09193, -1
  %.851 = add nsw i64 %.780.09192, 1
  %265 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.09192
  %.933 = load i64, ptr %265, align 8
  %.934 = icmp slt i64 %.933, 0
  br i1 %.934, label %B458, label %B502

B1534.if:                                         ; preds = %B1502, %B1726
  %.2165.09209 = phi i64 [ %.2234, %B1726 ], [ 1, %B1502 ]
  %.2234 = add i64 %.2165.09209, 1
  %266 = getelementptr i64, ptr %arg.code.4, i64 %.2165.09209
  %267 = getelementptr i8, ptr %266, i64 128
  %.2293 = load i64, ptr %267, align 8
  %.2338 = inttoptr i64 %.2293 to ptr
  tail call void %.2338(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2344 = add nsw i64 %.2165.09209, %.
  %.2346 = mul nsw i64 %.2344, %.463
  %.2391 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2346
  tail call void %.2392(ptr %.571, ptr %.2366, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2391)
  br i1 %or.cond9186.not, label %B68.if.lr.ph.i, label %B1726

B1870.if:                                         ; preds = %B1728, %B1956
  %looked.2.19215 = phi i1 [ %"$phi1956.1.2.2", %B1956 ], [ %spec.select8925, %B1728 ]
  %good.2.19214 = phi i1 [ %"$phi1914.1.2.2", %B1956 ], [ false, %B1728 ]
  %.2611.09213 = phi i64 [ %.2673, %B1956 ], [ %storemerge, %B1728 ]
  %.2608.09212 = phi i64 [ %.2677, %B1956 ], [ 0, %B1728 ]
  %.2673 = add nsw i64 %.2611.09213, -1
  %.2677 = add nsw i64 %.2608.09212, 1
  br i1 %good.2.19214, label %B1914, label %B1878

B2030.if:                                         ; preds = %B2030.preheader, %B2536
  %checked.3.29225 = phi i1 [ %checked.4.3, %B2536 ], [ false, %B2030.preheader ]
  %within.3.29224 = phi i1 [ %within.4.3, %B2536 ], [ false, %B2030.preheader ]
  %.2966.09223 = phi i64 [ %.3034, %B2536 ], [ %storemerge, %B2030.preheader ]
  %.2963.09222 = phi i64 [ %.3038, %B2536 ], [ 0, %B2030.preheader ]
  %.3034 = add nsw i64 %.2966.09223, -1
  %.3038 = add nsw i64 %.2963.09222, 1
  %.3123 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.09222
  %.3124 = load i64, ptr %.3123, align 8
  %.3178 = getelementptr i64, ptr %38, i64 %.2963.09222
  %.3179 = load i64, ptr %.3178, align 8
  %.3239 = getelementptr double, ptr %39, i64 %.2963.09222
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
  %.4227 = load ptr, ptr %excinfo.9, align 8
  store ptr %.4227, ptr %excinfo, align 8
  br label %common.ret

B2932.if:                                         ; preds = %B2884
  %.4417 = load i64, ptr %113, align 8
  %.4462 = inttoptr i64 %.4417 to ptr
  tail call void %.4462(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4493 = load i64, ptr %arg.code.4, align 8
  %.4543 = inttoptr i64 %.4493 to ptr
  tail call void %.4543(ptr %.571, ptr %.4517, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4542)
  %.4417.1 = load i64, ptr %114, align 8
  %.4462.1 = inttoptr i64 %.4417.1 to ptr
  tail call void %.4462.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4493.1 = load i64, ptr %arg.code.4, align 8
  %.4543.1 = inttoptr i64 %.4493.1 to ptr
  tail call void %.4543.1(ptr %.571, ptr %.4517, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4542.1)
  %.4417.2 = load i64, ptr %115, align 8
  %.4462.2 = inttoptr i64 %.4417.2 to ptr
  tail call void %.4462.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4493.2 = load i64, ptr %arg.code.4, align 8
  %.4543.2 = inttoptr i64 %.4493.2 to ptr
  tail call void %.4543.2(ptr %.571, ptr %.4517, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4542.2)
  %.4581 = load i64, ptr %.4580, align 8
  %.4626 = inttoptr i64 %.4581 to ptr
  tail call void %.4626(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4658 = load i64, ptr %.4657, align 8
  %.4703 = inttoptr i64 %.4658 to ptr
  tail call void %.4703(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.794, label %B3300, label %B64.if.i3121

B3304.endif.if:                                   ; preds = %B3304
  %.4829 = load ptr, ptr %excinfo.11, align 8
  store ptr %.4829, ptr %excinfo, align 8
  br label %common.ret

B3304.endif.endif:                                ; preds = %B3304
  %.4838 = load i8, ptr %.4774, align 1
  %.4841.not = icmp eq i8 %.4838, 0
  br i1 %.4841.not, label %B3386, label %B3344

B3774.if:                                         ; preds = %B3732, %B4735
  %active.5.29324 = phi i64 [ %active.6.3, %B4735 ], [ 0, %B3732 ]
  %budget.5.29323 = phi i64 [ %budget.6.3, %B4735 ], [ %.1132, %B3732 ]
  %.5535.09322 = phi i64 [ %.5604, %B4735 ], [ %storemerge, %B3732 ]
  %.5532.09321 = phi i64 [ %.5608, %B4735 ], [ 0, %B3732 ]
  %.5604 = add nsw i64 %.5535.09322, -1
  %.5608 = add nsw i64 %.5532.09321, 1
  %.5693 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5532.09321
  %.5694 = load i64, ptr %.5693, align 8
  %.5699 = icmp slt i64 %.5694, 0
  br i1 %.5699, label %B4735, label %B3822

B4734.endif:                                      ; preds = %B568.i1342, %B4734
  store i64 %active.10.0, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

define internal fastcc range(i32 0, 2) i32 @_ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE(ptr noalias nonnull %retptr, ptr noalias nonnull %excinfo, ptr readonly %arg.code.4, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.6, ptr readonly %arg.times.4, i64 %arg.times.5.0, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0) unnamed_addr {
entry:
  %0 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.223 = getelementptr i8, ptr %0, i64 -8
  %.224 = load double, ptr %.223, align 8
  %.253 = load double, ptr %arg.times.4, align 8
  %.254 = fsub double %.224, %.253
  %.255 = fmul double %.254, 1.000000e-13
  %.4961274.not = icmp slt i64 %arg.shape.0, 1
  %factor.op.mul = mul i64 %arg.shape.6, 3
  %.idx1261 = mul i64 %arg.lane.0.5.1, 48
  %1 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1261
  %.idx1262 = shl i64 %arg.lane.0.5.1, 6
  %2 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1262
  %.287.i1271.not = icmp slt i64 %arg.shape.1, 1
  %.358.i = shl nsw i64 %arg.shape.1, 4
  %.623.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.658 = getelementptr i8, ptr %arg.code.4, i64 40
  %.699.idx = shl i64 %arg.lane.0.5.1, 6
  %.699 = getelementptr i8, ptr %arg.lane.0.4, i64 %.699.idx
  %.729 = mul i64 %arg.shape.1, %arg.shape.0
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6 = mul nsw i64 %arg.shape.1, 18
  br label %B204.if

B238.loopexit:                                    ; preds = %B122.if.i, %switch.end
  %exitcond1289.not = icmp eq i64 %arg.shape.0, %.509
  br i1 %exitcond1289.not, label %B306, label %B238.if

B306:                                             ; preds = %B238.loopexit, %B204.if
  %.610 = icmp ult i64 %.317.01277, 8
  %. = select i1 %.610, i64 16, i64 17
  %.629 = mul i64 %.623.reass, %.317.01277
  %.659 = load i64, ptr %.658, align 8
  %.731 = mul i64 %.729, %.
  %.749 = getelementptr double, ptr %arg.arrays.0.4, i64 %.731
  %.774 = getelementptr double, ptr %arg.arrays.4.4, i64 %.629
  %.775 = inttoptr i64 %.659 to ptr
  tail call void %.775(ptr %.699, ptr %.749, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.774)
  %exitcond1290.not = icmp eq i64 %.388, 9
  br i1 %exitcond1290.not, label %B482, label %B204.if

B482:                                             ; preds = %B306
  %.8811279 = icmp sgt i64 %arg.shape.0, 0
  br i1 %.8811279, label %B516.lr.ph, label %B1238

B516.lr.ph:                                       ; preds = %B482
  %.827.11282 = add nsw i64 %arg.shape.0, -1
  %.idx = mul i64 %arg.lane.0.5.1, 56
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx1251 = shl i64 %arg.lane.1.5.1, 5
  %4 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1251
  %.idx1252 = shl i64 %arg.lane.0.5.1, 6
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1252
  %.idx1253 = mul i64 %arg.lane.0.5.1, 40
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1253
  %storemerge1254 = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.194.i79 = mul nsw i64 %arg.shape.6, %arg.shape.0
  %.idx1256 = mul i64 %arg.lane.0.5.1, 112
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1256
  %.idx1257 = mul i64 %arg.lane.0.5.1, 120
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1257
  %.idx1258 = mul i64 %arg.lane.0.5.1, 48
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1258
  %.1777 = fmul double %.255, 2.000000e+00
  %.28.i = mul i64 %arg.shape.6, %arg.shape.0
  %.30.i = mul i64 %.28.i, 3
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.598.i = mul i64 %.28.i, 6
  %.600.2.i = mul i64 %.28.i, 12
  %.600.3.i = mul i64 %.28.i, 18
  %.600.4.i = mul i64 %.28.i, 24
  %.334.1.i = mul i64 %.28.i, 9
  %.334.2.i = mul i64 %.28.i, 15
  %.334.3.i = mul i64 %.28.i, 21
  %.idx1259 = shl i64 %arg.lane.0.5.1, 5
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1259
  %11 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  br label %B516

B516:                                             ; preds = %B516.lr.ph, %B1234
  %.871.sroa.0.01287 = phi i64 [ 0, %B516.lr.ph ], [ %.871.sroa.0.0, %B1234 ]
  %.827.11286 = phi i64 [ %.827.11282, %B516.lr.ph ], [ %.827.1, %B1234 ]
  %.824.11285 = phi i64 [ 1, %B516.lr.ph ], [ %.824.1, %B1234 ]
  %some.2.01284 = phi i1 [ false, %B516.lr.ph ], [ %some.3.1, %B1234 ]
  %excinfo.3.01283 = phi ptr [ null, %B516.lr.ph ], [ %excinfo.3.1, %B1234 ]
  %.956 = icmp slt i64 %.871.sroa.0.01287, 0
  %.957 = select i1 %.956, i64 %arg.lane.0.5.1, i64 0
  %.958 = add i64 %.957, %.871.sroa.0.01287
  %.979 = getelementptr double, ptr %3, i64 %.958
  %.980 = load double, ptr %.979, align 8
  %.1012 = select i1 %.956, i64 %arg.lane.1.5.1, i64 0
  %.1013 = add i64 %.1012, %.871.sroa.0.01287
  %.1034 = getelementptr i64, ptr %4, i64 %.1013
  store i64 -1, ptr %.1034, align 8
  %.1089 = getelementptr double, ptr %5, i64 %.958
  store double %.980, ptr %.1089, align 8
  %.1144 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1013
  %.1145 = load i64, ptr %.1144, align 8
  %.1146 = icmp sgt i64 %.1145, -1
  br i1 %.1146, label %B634, label %B1234

B634:                                             ; preds = %B516
  %.1204 = getelementptr double, ptr %6, i64 %.958
  %.1205 = load double, ptr %.1204, align 8
  %.1206 = fcmp ogt double %.1205, 5.000000e-01
  br i1 %.1206, label %B674, label %B1234

B674:                                             ; preds = %B634
  %.1283 = load i64, ptr %.1034, align 8
  %.1284 = icmp slt i64 %.1283, 0
  br i1 %.1284, label %B738, label %B866

B738:                                             ; preds = %B674, %B738.endif
  %last.2.2 = phi i64 [ %.1290, %B738.endif ], [ 0, %B674 ]
  %.1290 = add nsw i64 %last.2.2, 1
  %.151.i51 = mul nsw i64 %.1290, 3
  %.153.i521255 = add nsw i64 %.151.i51, 1
  %.155.i = mul i64 %.153.i521255, %arg.shape.6
  br label %B34.i

B34.i:                                            ; preds = %B36.i, %B738
  %.51.i13.0 = phi i64 [ 0, %B738 ], [ %.122.i103, %B36.i ]
  %exitcond1291.not = icmp eq i64 %.51.i13.0, %storemerge1254
  br i1 %exitcond1291.not, label %B738.endif, label %B36.i

B36.i:                                            ; preds = %B34.i
  %.122.i103 = add i64 %.51.i13.0, 1
  %.157.i54 = add nsw i64 %.51.i13.0, %.155.i
  %.159.i = mul nsw i64 %.157.i54, %arg.shape.0
  %.161.i = add nsw i64 %.159.i, %.871.sroa.0.01287
  %.175.i63 = icmp slt i64 %.161.i, 0
  %.176.i64 = select i1 %.175.i63, i64 %arg.arrays.4.5.0, i64 0
  %12 = getelementptr double, ptr %arg.arrays.4.4, i64 %.161.i
  %.190.i = getelementptr double, ptr %12, i64 %.176.i64
  %.191.i = load double, ptr %.190.i, align 8, !noalias !176
  %.195.i80 = add nsw i64 %.161.i, %.194.i79
  %.209.i = icmp slt i64 %.195.i80, 0
  %.210.i = select i1 %.209.i, i64 %arg.arrays.4.5.0, i64 0
  %13 = getelementptr double, ptr %arg.arrays.4.4, i64 %.195.i80
  %.224.i91 = getelementptr double, ptr %13, i64 %.210.i
  %.225.i92 = load double, ptr %.224.i91, align 8, !noalias !176
  %.226.i93 = fneg double %.225.i92
  %.227.i94 = fcmp olt double %.191.i, %.226.i93
  br i1 %.227.i94, label %B738.endif, label %B34.i

B866:                                             ; preds = %B738.endif, %B674
  %last.3.3 = phi i64 [ 0, %B674 ], [ %.1290, %B738.endif ]
  %switch.tableidx = add i64 %last.3.3, 8
  %14 = icmp ult i64 %switch.tableidx, 18
  br i1 %14, label %switch.lookup, label %switch.else.1

B1062:                                            ; preds = %switch.lookup22
  %.1698 = load i64, ptr %.1034, align 8
  %.1699 = icmp sgt i64 %.1698, -1
  %.1473 = sext i1 %.1699 to i64
  %"$phi1016.1.2.2" = add nsw i64 %last.3.3, %.1473
  %15 = tail call i64 @llvm.smax.i64(i64 %"$phi1016.1.2.2", i64 0)
  %storemerge336.i = tail call i64 @llvm.smin.i64(i64 %15, i64 7)
  %.800356.not.i = icmp slt i64 %"$phi1016.1.2.2", 1
  %.951.i = add i64 %"$phi1016.1.2.2", -1
  %storemerge337.i = tail call i64 @llvm.smax.i64(i64 %.951.i, i64 0)
  %.995360.i = icmp sgt i64 %.951.i, 0
  %.938.1362.i = select i1 %.995360.i, i64 2, i64 1
  %.1004363.i = sext i1 %.995360.i to i64
  %.941.1364.i = add nsw i64 %storemerge337.i, %.1004363.i
  %.985.sroa.0.0365.i = zext i1 %.995360.i to i64
  br label %B50.i

B50.i:                                            ; preds = %B1088.i, %B1062
  %.58.0.i = phi i64 [ 0, %B1062 ], [ %.130.i, %B1088.i ]
  %exitcond.not.i = icmp eq i64 %.58.0.i, %storemerge.i
  br i1 %exitcond.not.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit, label %B52.if.i

B532.i:                                           ; preds = %B470.if.i, %B52.if.i
  %nearest.3.1.lcssa.i = phi double [ 0x7FF0000000000000, %B52.if.i ], [ %.11.i343.i, %B470.if.i ]
  br i1 %.995360.i, label %B568.lr.ph.i, label %B1088.i

B568.lr.ph.i:                                     ; preds = %B532.i
  %.1157.i = fmul double %.11.i.3.i, 1.000000e+01
  br label %B568.i

B568.i:                                           ; preds = %B1163.i, %B568.lr.ph.i
  %.985.sroa.0.0369.i = phi i64 [ %.985.sroa.0.0365.i, %B568.lr.ph.i ], [ %.985.sroa.0.0.i, %B1163.i ]
  %.941.1368.i = phi i64 [ %.941.1364.i, %B568.lr.ph.i ], [ %.941.1.i, %B1163.i ]
  %.938.1367.i = phi i64 [ %.938.1362.i, %B568.lr.ph.i ], [ %.938.1.i, %B1163.i ]
  %nearest.4.1366.i = phi double [ %nearest.3.1.lcssa.i, %B568.lr.ph.i ], [ %nearest.5.2.i, %B1163.i ]
  %.1041.i = add nsw i64 %.985.sroa.0.0369.i, -1
  %.1043.i = mul nsw i64 %.1041.i, %.30.i
  %.1045.i = add nsw i64 %.1043.i, %.160.i
  %.1059.i = icmp slt i64 %.1045.i, 0
  %.1060.i = select i1 %.1059.i, i64 %arg.arrays.4.5.0, i64 0
  %16 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1045.i
  %.1074.i = getelementptr double, ptr %16, i64 %.1060.i
  %.1075.i = load double, ptr %.1074.i, align 8, !noalias !180
  %.1078.i = mul nsw i64 %.985.sroa.0.0369.i, %.30.i
  %.1080.i = add nsw i64 %.1078.i, %.160.i
  %.1094.i = icmp slt i64 %.1080.i, 0
  %.1095.i = select i1 %.1094.i, i64 %arg.arrays.4.5.0, i64 0
  %17 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1080.i
  %.1109.i = getelementptr double, ptr %17, i64 %.1095.i
  %.1110.i = load double, ptr %.1109.i, align 8, !noalias !180
  %.1112.i = add nsw i64 %.985.sroa.0.0369.i, 1
  %.1114.i = mul nsw i64 %.1112.i, %.30.i
  %.1116.i = add nsw i64 %.1114.i, %.160.i
  %.1130.i = icmp slt i64 %.1116.i, 0
  %.1131.i = select i1 %.1130.i, i64 %arg.arrays.4.5.0, i64 0
  %18 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1116.i
  %.1145.i = getelementptr double, ptr %18, i64 %.1131.i
  %.1146.i = load double, ptr %.1145.i, align 8, !noalias !180
  %.1160.i = fsub double %.1075.i, %.1110.i
  %.1161.i = tail call double @llvm.fabs.f64(double %.1160.i)
  %.1164.i = fsub double %.1146.i, %.1110.i
  %.1165.i = tail call double @llvm.fabs.f64(double %.1164.i)
  %.1166.i = fadd double %.1161.i, %.1165.i
  %.1167.i = fmul double %.1166.i, 3.000000e+00
  %.1168.i = fadd double %.1157.i, %.1167.i
  %.1170.i = fcmp olt double %.1110.i, %.1168.i
  br i1 %.1170.i, label %B776.i, label %B1163.i

B776.i:                                           ; preds = %B568.i
  %switch.tableidx2 = add i64 %.985.sroa.0.0369.i, 9
  %19 = icmp ult i64 %switch.tableidx2, 18
  br i1 %19, label %switch.lookup3, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

B982.i:                                           ; preds = %switch.lookup15
  %.1379.i = fneg double %.1320.i
  %.1383.i = fmul double %.1369.i, 5.000000e-01
  %.1388.i = fdiv double %.1383.i, %.1352.i
  %.1389.i = fcmp ogt double %.1388.i, %.1379.i
  %.1399.i = fcmp olt double %.1388.i, %.1246.i
  %or.cond338.i = and i1 %.1389.i, %.1399.i
  br i1 %or.cond338.i, label %B1022.i, label %B1163.i

B1022.i:                                          ; preds = %B982.i
  %.1426.i = fmul double %.1369.i, 2.500000e-01
  %.1428.i = fmul double %.1369.i, %.1426.i
  %.1435.i = fdiv double %.1428.i, %.1352.i
  %.1439.i = fsub double %.1110.i, %.1435.i
  %.10.i340.i = fcmp olt double %.1439.i, %nearest.4.1366.i
  %.11.i341.i = select i1 %.10.i340.i, double %.1439.i, double %nearest.4.1366.i
  br label %B1163.i

B1088.i:                                          ; preds = %B1163.i, %B532.i
  %nearest.4.1.lcssa.i = phi double [ %nearest.3.1.lcssa.i, %B532.i ], [ %nearest.5.2.i, %B1163.i ]
  %.1508.i = add nsw i64 %.160.i, %.28.i
  %.1524.i = icmp slt i64 %.1508.i, 0
  %.1525.i = select i1 %.1524.i, i64 %arg.arrays.4.5.0, i64 0
  %20 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1508.i
  %.1539.i = getelementptr double, ptr %20, i64 %.1525.i
  %.1540.i = load double, ptr %.1539.i, align 8, !noalias !180
  %.1542.i = fcmp ule double %.11.i.3.i, %.1540.i
  %.1545.i = fmul double %.11.i.3.i, 1.000000e+01
  %.1549.i = fcmp ugt double %nearest.4.1.lcssa.i, %.1545.i
  %or.cond.i = select i1 %.1542.i, i1 true, i1 %.1549.i
  br i1 %or.cond.i, label %B50.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

B1163.i:                                          ; preds = %switch.lookup15, %B1022.i, %B982.i, %B568.i
  %nearest.5.2.i = phi double [ %nearest.4.1366.i, %B982.i ], [ %.11.i341.i, %B1022.i ], [ %nearest.4.1366.i, %B568.i ], [ %nearest.4.1366.i, %switch.lookup15 ]
  %.995.i = icmp sgt i64 %.941.1368.i, 0
  %.1008.i = zext i1 %.995.i to i64
  %.938.1.i = add i64 %.938.1367.i, %.1008.i
  %.1004.i = sext i1 %.995.i to i64
  %.941.1.i = add nsw i64 %.941.1368.i, %.1004.i
  %.985.sroa.0.0.i = select i1 %.995.i, i64 %.938.1367.i, i64 0
  br i1 %.995.i, label %B568.i, label %B1088.i

B52.if.i:                                         ; preds = %B50.i
  %.130.i = add i64 %.58.0.i, 1
  %.156.i = add nsw i64 %.58.0.i, %arg.shape.6
  %.158.i = mul nsw i64 %.156.i, %arg.shape.0
  %.160.i = add nsw i64 %.158.i, %.871.sroa.0.01287
  %.336.i = add nsw i64 %.160.i, %.30.i
  %.350.i = icmp slt i64 %.336.i, 0
  %.351.i = select i1 %.350.i, i64 %arg.arrays.4.5.0, i64 0
  %21 = getelementptr double, ptr %arg.arrays.4.4, i64 %.336.i
  %.365.i = getelementptr double, ptr %21, i64 %.351.i
  %.366.i = load double, ptr %.365.i, align 8, !noalias !180
  %.616.i = icmp slt i64 %.160.i, 0
  %.617.i = select i1 %.616.i, i64 %arg.arrays.4.5.0, i64 0
  %22 = getelementptr double, ptr %arg.arrays.4.4, i64 %.160.i
  %.631.i = getelementptr double, ptr %22, i64 %.617.i
  %.632.i = load double, ptr %.631.i, align 8, !noalias !180
  %.633.i = fmul double %.632.i, 0x3FDDF27AAAADCB3A
  %.635.i = fsub double %.366.i, %.633.i
  %.602.1.i = add nsw i64 %.160.i, %.598.i
  %.616.1.i = icmp slt i64 %.602.1.i, 0
  %.617.1.i = select i1 %.616.1.i, i64 %arg.arrays.4.5.0, i64 0
  %23 = getelementptr double, ptr %arg.arrays.4.4, i64 %.602.1.i
  %.631.1.i = getelementptr double, ptr %23, i64 %.617.1.i
  %.632.1.i = load double, ptr %.631.1.i, align 8, !noalias !180
  %.633.1.i = fmul double %.632.1.i, 0x3FEC575F1EBC4F2F
  %.635.1.i = fsub double %.635.i, %.633.1.i
  %.602.2.i = add nsw i64 %.160.i, %.600.2.i
  %.616.2.i = icmp slt i64 %.602.2.i, 0
  %.617.2.i = select i1 %.616.2.i, i64 %arg.arrays.4.5.0, i64 0
  %24 = getelementptr double, ptr %arg.arrays.4.4, i64 %.602.2.i
  %.631.2.i = getelementptr double, ptr %24, i64 %.617.2.i
  %.632.2.i = load double, ptr %.631.2.i, align 8, !noalias !180
  %.633.2.i = fmul double %.632.2.i, 0x3FE1306AA3D795F4
  %25 = fadd double %.635.1.i, %.633.2.i
  %.602.3.i = add nsw i64 %.160.i, %.600.3.i
  %.616.3.i = icmp slt i64 %.602.3.i, 0
  %.617.3.i = select i1 %.616.3.i, i64 %arg.arrays.4.5.0, i64 0
  %26 = getelementptr double, ptr %arg.arrays.4.4, i64 %.602.3.i
  %.631.3.i = getelementptr double, ptr %26, i64 %.617.3.i
  %.632.3.i = load double, ptr %.631.3.i, align 8, !noalias !180
  %.633.3.i = fmul double %.632.3.i, 0x3FCCB9F574BDCC3A
  %.635.3.i = fsub double %25, %.633.3.i
  %.602.4.i = add nsw i64 %.160.i, %.600.4.i
  %.616.4.i = icmp slt i64 %.602.4.i, 0
  %.617.4.i = select i1 %.616.4.i, i64 %arg.arrays.4.5.0, i64 0
  %27 = getelementptr double, ptr %arg.arrays.4.4, i64 %.602.4.i
  %.631.4.i = getelementptr double, ptr %27, i64 %.617.4.i
  %.632.4.i = load double, ptr %.631.4.i, align 8, !noalias !180
  %.633.4.i = fmul double %.632.4.i, 0x3FA4EAF2D6B11E79
  %28 = fadd double %.635.3.i, %.633.4.i
  %.646.i = tail call double @llvm.fabs.f64(double %28)
  %.10.i.i = fcmp ogt double %.646.i, 0.000000e+00
  %.11.i.i = select i1 %.10.i.i, double %.646.i, double 0.000000e+00
  %.336.1.i = add nsw i64 %.160.i, %.334.1.i
  %.350.1.i = icmp slt i64 %.336.1.i, 0
  %.351.1.i = select i1 %.350.1.i, i64 %arg.arrays.4.5.0, i64 0
  %29 = getelementptr double, ptr %arg.arrays.4.4, i64 %.336.1.i
  %.365.1.i = getelementptr double, ptr %29, i64 %.351.1.i
  %.366.1.i = load double, ptr %.365.1.i, align 8, !noalias !180
  %.633.1431.i = fmul double %.632.i, 0x3FA5118805F8B876
  %30 = fadd double %.366.1.i, %.633.1431.i
  %.633.1.1.i = fmul double %.632.1.i, 0x3FE51326698BC5BD
  %.635.1.1.i = fsub double %30, %.633.1.1.i
  %.633.2.1.i = fmul double %.632.2.i, 0x3FDF97DED30D4572
  %.635.2.1.i = fsub double %.635.1.1.i, %.633.2.1.i
  %.633.3.1.i = fmul double %.632.3.i, 0x3FC0DA0C684D1D67
  %31 = fadd double %.635.2.1.i, %.633.3.1.i
  %.633.4.1.i = fmul double %.632.4.i, 0x3F9510B8EC0D4D92
  %.635.4.1.i = fsub double %31, %.633.4.1.i
  %.646.1.i = tail call double @llvm.fabs.f64(double %.635.4.1.i)
  %.10.i.1.i = fcmp ogt double %.646.1.i, %.11.i.i
  %.11.i.1.i = select i1 %.10.i.1.i, double %.646.1.i, double %.11.i.i
  %.336.2.i = add nsw i64 %.160.i, %.334.2.i
  %.350.2.i = icmp slt i64 %.336.2.i, 0
  %.351.2.i = select i1 %.350.2.i, i64 %arg.arrays.4.5.0, i64 0
  %32 = getelementptr double, ptr %arg.arrays.4.4, i64 %.336.2.i
  %.365.2.i = getelementptr double, ptr %32, i64 %.351.2.i
  %.366.2.i = load double, ptr %.365.2.i, align 8, !noalias !180
  %.633.2458.i = fmul double %.632.i, 0x3F9635A30F8F142F
  %.635.2459.i = fsub double %.366.2.i, %.633.2458.i
  %.633.1.2.i = fmul double %.632.1.i, 0x3FC1EAE0FF33D241
  %33 = fadd double %.635.2459.i, %.633.1.2.i
  %.633.2.2.i = fmul double %.632.2.i, 0x3FE1625D59218460
  %.635.2.2.i = fsub double %33, %.633.2.2.i
  %.633.3.2.i = fmul double %.632.3.i, 0x3FE3BBC3E8A29641
  %.635.3.2.i = fsub double %.635.2.2.i, %.633.3.2.i
  %.633.4.2.i = fmul double %.632.4.i, 0x3FA55161A739EB34
  %34 = fadd double %.635.3.2.i, %.633.4.2.i
  %.646.2.i = tail call double @llvm.fabs.f64(double %34)
  %.10.i.2.i = fcmp ogt double %.646.2.i, %.11.i.1.i
  %.11.i.2.i = select i1 %.10.i.2.i, double %.646.2.i, double %.11.i.1.i
  %.336.3.i = add nsw i64 %.160.i, %.334.3.i
  %.350.3.i = icmp slt i64 %.336.3.i, 0
  %.351.3.i = select i1 %.350.3.i, i64 %arg.arrays.4.5.0, i64 0
  %35 = getelementptr double, ptr %arg.arrays.4.4, i64 %.336.3.i
  %.365.3.i = getelementptr double, ptr %35, i64 %.351.3.i
  %.366.3.i = load double, ptr %.365.3.i, align 8, !noalias !180
  %.633.3485.i = fmul double %.632.i, 0x3FA4F0C0BB579409
  %36 = fadd double %.366.3.i, %.633.3485.i
  %.633.1.3.i = fmul double %.632.1.i, 0x3FCD2266FBC0D976
  %.635.1.3.i = fsub double %36, %.633.1.3.i
  %.633.2.3.i = fmul double %.632.2.i, 0x3FE1F2DB6FEE3151
  %37 = fadd double %.635.1.3.i, %.633.2.3.i
  %.633.3.3.i = fmul double %.632.3.i, 0x3FF0C05015964CBE
  %.635.3.3.i = fsub double %37, %.633.3.3.i
  %.633.4.3.i = fmul double %.632.4.i, 0x3FD4F15B230DB570
  %.635.4.3.i = fsub double %.635.3.3.i, %.633.4.3.i
  %.646.3.i = tail call double @llvm.fabs.f64(double %.635.4.3.i)
  %.10.i.3.i = fcmp ogt double %.646.3.i, %.11.i.2.i
  %.11.i.3.i = select i1 %.10.i.3.i, double %.646.3.i, double %.11.i.2.i
  br i1 %.800356.not.i, label %B532.i, label %B470.if.i

B470.if.i:                                        ; preds = %B52.if.i, %B470.if.i
  %nearest.3.1359.i = phi double [ %.11.i343.i, %B470.if.i ], [ 0x7FF0000000000000, %B52.if.i ]
  %.747.0358.i = phi i64 [ %.809.i, %B470.if.i ], [ %storemerge336.i, %B52.if.i ]
  %.744.0357.i = phi i64 [ %.813.i, %B470.if.i ], [ 1, %B52.if.i ]
  %.809.i = add nsw i64 %.747.0358.i, -1
  %.813.i = add nsw i64 %.744.0357.i, 1
  %38 = mul nsw i64 %.744.0357.i, %.30.i
  %.841.i = add nsw i64 %38, %.160.i
  %.855.i = icmp slt i64 %.841.i, 0
  %.856.i = select i1 %.855.i, i64 %arg.arrays.4.5.0, i64 0
  %39 = getelementptr double, ptr %arg.arrays.4.4, i64 %.841.i
  %.870.i = getelementptr double, ptr %39, i64 %.856.i
  %.871.i = load double, ptr %.870.i, align 8, !noalias !180
  %.10.i342.i = fcmp olt double %.871.i, %nearest.3.1359.i
  %.11.i343.i = select i1 %.10.i342.i, double %.871.i, double %nearest.3.1359.i
  %.800.i = icmp sgt i64 %.747.0358.i, 1
  br i1 %.800.i, label %B470.if.i, label %B532.i

switch.lookup3:                                   ; preds = %B776.i
  %switch.tableidx6 = add i64 %.985.sroa.0.0369.i, 8
  %40 = icmp ult i64 %switch.tableidx6, 18
  br i1 %40, label %switch.lookup7, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup7:                                   ; preds = %switch.lookup3
  %switch.gep4 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6, i64 %switch.tableidx2
  %switch.load5 = load double, ptr %switch.gep4, align 8
  %switch.gep8 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6, i64 %switch.tableidx6
  %switch.load9 = load double, ptr %switch.gep8, align 8
  %.1246.i = fsub double %switch.load5, %switch.load9
  %switch.tableidx10 = add i64 %.985.sroa.0.0369.i, 10
  %41 = icmp ult i64 %switch.tableidx10, 18
  br i1 %41, label %switch.lookup11, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup11:                                  ; preds = %switch.lookup7
  %switch.tableidx14 = add i64 %.985.sroa.0.0369.i, 9
  %42 = icmp ult i64 %switch.tableidx14, 18
  br i1 %42, label %switch.lookup15, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup15:                                  ; preds = %switch.lookup11
  %switch.gep12 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6, i64 %switch.tableidx10
  %switch.load13 = load double, ptr %switch.gep12, align 8
  %switch.gep16 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6, i64 %switch.tableidx14
  %switch.load17 = load double, ptr %switch.gep16, align 8
  %.1320.i = fsub double %switch.load13, %switch.load17
  %.1336.i = fdiv double %.1164.i, %.1320.i
  %.1339.i = fsub double %.1110.i, %.1075.i
  %.1344.i = fdiv double %.1339.i, %.1246.i
  %.1345.i = fsub double %.1336.i, %.1344.i
  %.1348.i = fadd double %.1246.i, %.1320.i
  %.1352.i = fdiv double %.1345.i, %.1348.i
  %.1368.i = fmul double %.1246.i, %.1352.i
  %.1369.i = fadd double %.1344.i, %.1368.i
  %.1374.i = fcmp ogt double %.1352.i, 0.000000e+00
  br i1 %.1374.i, label %B982.i, label %B1163.i

_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B50.i, %B1088.i, %B776.i, %switch.lookup3, %switch.lookup7, %switch.lookup11
  %.1805.not = phi i1 [ true, %B776.i ], [ true, %switch.lookup11 ], [ true, %switch.lookup7 ], [ true, %switch.lookup3 ], [ %exitcond.not.i, %B1088.i ], [ %exitcond.not.i, %B50.i ]
  %excinfo.3.3 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.15, %B776.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.15, %switch.lookup11 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.15, %switch.lookup7 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.15, %switch.lookup3 ], [ %excinfo.3.01283, %B1088.i ], [ %excinfo.3.01283, %B50.i ]
  %.1794.not = phi i1 [ false, %B776.i ], [ false, %switch.lookup11 ], [ false, %switch.lookup7 ], [ false, %switch.lookup3 ], [ true, %B1088.i ], [ true, %B50.i ]
  %common.ret.op.i = phi i32 [ 1, %B776.i ], [ 1, %switch.lookup11 ], [ 1, %switch.lookup7 ], [ 1, %switch.lookup3 ], [ 0, %B1088.i ], [ 0, %B50.i ]
  br i1 %.1794.not, label %B1062.endif.endif, label %B1062.endif.if, !prof !53

B1100:                                            ; preds = %B1062.endif.endif
  %.1880 = fmul double %.1775, 5.000000e-01
  store double 0.000000e+00, ptr %.1204, align 8, !noalias !184
  %.161.i230 = getelementptr double, ptr %10, i64 %.958
  store double 0.000000e+00, ptr %.161.i230, align 8, !noalias !184
  %.214.i273 = getelementptr double, ptr %11, i64 %.958
  store double %.1880, ptr %.214.i273, align 8, !noalias !184
  %.268.i313 = load i64, ptr %.1144, align 8, !noalias !184
  %.294.i = icmp slt i64 %.268.i313, 0
  %.295.i = select i1 %.294.i, i64 %arg.results.3.5.0, i64 0
  %.296.i324 = add i64 %.295.i, %.268.i313
  %.316.i333 = mul i64 %.296.i324, %arg.results.3.5.1
  %.320.i = getelementptr i64, ptr %arg.results.3.4, i64 %.316.i333
  %.321.i = load i64, ptr %.320.i, align 8, !noalias !184
  %.322.i336 = add nsw i64 %.321.i, -1
  store i64 %.322.i336, ptr %.320.i, align 8, !noalias !184
  %.426.i = load i64, ptr %.1144, align 8, !noalias !184
  %.452.i = icmp slt i64 %.426.i, 0
  %.453.i = select i1 %.452.i, i64 %arg.results.3.5.0, i64 0
  %.454.i = add i64 %.453.i, %.426.i
  %.474.i = mul i64 %.454.i, %arg.results.3.5.1
  %43 = getelementptr i64, ptr %arg.results.3.4, i64 %.474.i
  %.478.i = getelementptr i8, ptr %43, i64 24
  %.479.i = load i64, ptr %.478.i, align 8, !noalias !184
  %.480.i = add nsw i64 %.479.i, 1
  store i64 %.480.i, ptr %.478.i, align 8, !noalias !184
  store i64 -1, ptr %.1034, align 8
  br label %B1192

B1192:                                            ; preds = %B1100, %B1062.endif.endif, %switch.lookup22
  %excinfo.3.2 = phi ptr [ %excinfo.3.3, %B1062.endif.endif ], [ %excinfo.3.3, %B1100 ], [ %excinfo.3.01283, %switch.lookup22 ]
  br i1 %some.2.01284, label %B1234, label %B1196

B1196:                                            ; preds = %B1192
  %.2044 = load i64, ptr %.1034, align 8
  %.2045 = icmp sgt i64 %.2044, -1
  br label %B1234

B1234:                                            ; preds = %B1192, %B1196, %B634, %B516
  %excinfo.3.1 = phi ptr [ %excinfo.3.2, %B1192 ], [ %excinfo.3.2, %B1196 ], [ %excinfo.3.01283, %B634 ], [ %excinfo.3.01283, %B516 ]
  %some.3.1 = phi i1 [ true, %B1192 ], [ %.2045, %B1196 ], [ %some.2.01284, %B634 ], [ %some.2.01284, %B516 ]
  %.881 = icmp sgt i64 %.827.11286, 0
  %.894 = zext i1 %.881 to i64
  %.824.1 = add i64 %.824.11285, %.894
  %.890 = sext i1 %.881 to i64
  %.827.1 = add nsw i64 %.827.11286, %.890
  %.871.sroa.0.0 = select i1 %.881, i64 %.824.11285, i64 0
  br i1 %.881, label %B516, label %B1238.loopexit

common.ret:                                       ; preds = %B1062.endif.if, %switch.else.2, %switch.else.1, %B1238
  %common.ret.op = phi i32 [ 0, %B1238 ], [ 1, %switch.else.1 ], [ 1, %switch.else.2 ], [ %common.ret.op.i, %B1062.endif.if ]
  ret i32 %common.ret.op

B1238.loopexit:                                   ; preds = %B1234
  %44 = zext i1 %some.3.1 to i8
  br label %B1238

B1238:                                            ; preds = %B1238.loopexit, %B482
  %some.2.0.lcssa = phi i8 [ 0, %B482 ], [ %44, %B1238.loopexit ]
  store i8 %some.2.0.lcssa, ptr %retptr, align 1
  br label %common.ret

B204.if:                                          ; preds = %entry, %B306
  %.317.01277 = phi i64 [ 0, %entry ], [ %.388, %B306 ]
  %.388 = add nsw i64 %.317.01277, 1
  br i1 %.4961274.not, label %B306, label %B238.if.preheader

B238.if.preheader:                                ; preds = %B204.if
  %45 = icmp ult i64 %.317.01277, 8
  %switch.gep19 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.5, i64 %.317.01277
  br label %B238.if

B238.if:                                          ; preds = %B238.if.preheader, %B238.loopexit
  %.440.01275 = phi i64 [ %.509, %B238.loopexit ], [ 0, %B238.if.preheader ]
  %.509 = add nsw i64 %.440.01275, 1
  br i1 %45, label %switch.lookup18, label %switch.end

switch.lookup18:                                  ; preds = %B238.if
  %switch.load20 = load double, ptr %switch.gep19, align 8
  br label %switch.end

switch.end:                                       ; preds = %B238.if, %switch.lookup18
  %.551 = phi double [ %switch.load20, %switch.lookup18 ], [ 1.000000e+00, %B238.if ]
  %.92.i = getelementptr double, ptr %arg.lane.0.4, i64 %.440.01275
  %.93.i = load double, ptr %.92.i, align 8, !noalias !187
  %.146.i = getelementptr double, ptr %1, i64 %.440.01275
  %.147.i = load double, ptr %.146.i, align 8, !noalias !187
  %.149.i = fmul double %.551, %.147.i
  %.150.i = fadd double %.93.i, %.149.i
  %.203.i = getelementptr double, ptr %2, i64 %.440.01275
  store double %.150.i, ptr %.203.i, align 8, !noalias !187
  br i1 %.287.i1271.not, label %B238.loopexit, label %B122.if.i.lr.ph

B122.if.i.lr.ph:                                  ; preds = %switch.end
  %.247.i.i = fsub double 1.000000e+00, %.551
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep27 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep29 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep31 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep33 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep35 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep37 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep39 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  %invariant.gep41 = getelementptr double, ptr %arg.arrays.0.4, i64 %.440.01275
  br label %B122.if.i

B122.if.i:                                        ; preds = %B122.if.i.lr.ph, %B122.if.i
  %.229.i.01272 = phi i64 [ 0, %B122.if.i.lr.ph ], [ %.300.i, %B122.if.i ]
  %.157.i.i = add nsw i64 %.155.i.i, %.229.i.01272
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep, align 8, !noalias !191
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.551, %.193.i.i
  %.157.i.i.1 = add nsw i64 %.155.i.i.1, %.229.i.01272
  %.159.i.i.1 = mul nsw i64 %.157.i.i.1, %arg.shape.0
  %gep28 = getelementptr double, ptr %invariant.gep27, i64 %.159.i.i.1
  %.191.i.i.1 = load double, ptr %gep28, align 8, !noalias !191
  %.193.i.i.1 = fadd double %.253.i.i, %.191.i.i.1
  %.253.i.i.1 = fmul double %.247.i.i, %.193.i.i.1
  %.157.i.i.2 = add nsw i64 %.155.i.i.2, %.229.i.01272
  %.159.i.i.2 = mul nsw i64 %.157.i.i.2, %arg.shape.0
  %gep30 = getelementptr double, ptr %invariant.gep29, i64 %.159.i.i.2
  %.191.i.i.2 = load double, ptr %gep30, align 8, !noalias !191
  %.193.i.i.2 = fadd double %.253.i.i.1, %.191.i.i.2
  %.253.i.i.2 = fmul double %.551, %.193.i.i.2
  %.157.i.i.3 = add nsw i64 %.155.i.i.3, %.229.i.01272
  %.159.i.i.3 = mul nsw i64 %.157.i.i.3, %arg.shape.0
  %gep32 = getelementptr double, ptr %invariant.gep31, i64 %.159.i.i.3
  %.191.i.i.3 = load double, ptr %gep32, align 8, !noalias !191
  %.193.i.i.3 = fadd double %.253.i.i.2, %.191.i.i.3
  %.253.i.i.3 = fmul double %.247.i.i, %.193.i.i.3
  %.157.i.i.4 = add nsw i64 %.155.i.i.4, %.229.i.01272
  %.159.i.i.4 = mul nsw i64 %.157.i.i.4, %arg.shape.0
  %gep34 = getelementptr double, ptr %invariant.gep33, i64 %.159.i.i.4
  %.191.i.i.4 = load double, ptr %gep34, align 8, !noalias !191
  %.193.i.i.4 = fadd double %.253.i.i.3, %.191.i.i.4
  %.253.i.i.4 = fmul double %.551, %.193.i.i.4
  %.157.i.i.5 = add nsw i64 %.155.i.i.5, %.229.i.01272
  %.159.i.i.5 = mul nsw i64 %.157.i.i.5, %arg.shape.0
  %gep36 = getelementptr double, ptr %invariant.gep35, i64 %.159.i.i.5
  %.191.i.i.5 = load double, ptr %gep36, align 8, !noalias !191
  %.193.i.i.5 = fadd double %.253.i.i.4, %.191.i.i.5
  %.253.i.i.5 = fmul double %.247.i.i, %.193.i.i.5
  %.157.i.i.6 = add nsw i64 %.155.i.i.6, %.229.i.01272
  %.159.i.i.6 = mul nsw i64 %.157.i.i.6, %arg.shape.0
  %gep38 = getelementptr double, ptr %invariant.gep37, i64 %.159.i.i.6
  %.191.i.i.6 = load double, ptr %gep38, align 8, !noalias !191
  %.193.i.i.6 = fadd double %.253.i.i.5, %.191.i.i.6
  %.253.i.i.6 = fmul double %.551, %.193.i.i.6
  %.300.i = add nsw i64 %.229.i.01272, 1
  %.271.i.i = mul nsw i64 %.229.i.01272, %arg.shape.0
  %gep40 = getelementptr double, ptr %invariant.gep39, i64 %.271.i.i
  %.309.i.i = load double, ptr %gep40, align 8, !noalias !191
  %.313.i.i = fadd double %.253.i.i.6, %.309.i.i
  %.359.i = add nsw i64 %.229.i.01272, %.358.i
  %.361.i = mul nsw i64 %.359.i, %arg.shape.0
  %gep42 = getelementptr double, ptr %invariant.gep41, i64 %.361.i
  store double %.313.i.i, ptr %gep42, align 8, !noalias !187
  %exitcond.not = icmp eq i64 %arg.shape.1, %.300.i
  br i1 %exitcond.not, label %B238.loopexit, label %B122.if.i

B738.endif:                                       ; preds = %B36.i, %B34.i
  %.1305.0 = phi i64 [ %.51.i13.0, %B36.i ], [ -1, %B34.i ]
  store i64 %.1305.0, ptr %.1034, align 8
  %.1387 = icmp ult i64 %last.2.2, 7
  %.1452 = icmp slt i64 %.1305.0, 0
  %or.cond = and i1 %.1387, %.1452
  br i1 %or.cond, label %B738, label %B866

switch.else.1:                                    ; preds = %B866
  store ptr @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, ptr %excinfo, align 8, !numba_exception_output !195
  br label %common.ret

switch.lookup:                                    ; preds = %B866
  %switch.tableidx21 = add i64 %last.3.3, 9
  %46 = icmp ult i64 %switch.tableidx21, 18
  br i1 %46, label %switch.lookup22, label %switch.else.2

switch.else.2:                                    ; preds = %switch.lookup
  store ptr @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, ptr %excinfo, align 8, !numba_exception_output !195
  br label %common.ret

switch.lookup22:                                  ; preds = %switch.lookup
  %switch.gep = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6, i64 %switch.tableidx
  %switch.load = load double, ptr %switch.gep, align 8
  %switch.gep23 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.6, i64 %switch.tableidx21
  %switch.load24 = load double, ptr %switch.gep23, align 8
  %.1587 = getelementptr double, ptr %7, i64 %.958
  store double %switch.load, ptr %.1587, align 8
  %.1642 = getelementptr double, ptr %8, i64 %.958
  store double %switch.load24, ptr %.1642, align 8
  %.1774 = getelementptr double, ptr %9, i64 %.958
  %.1775 = load double, ptr %.1774, align 8
  %.1778 = fcmp ogt double %.1775, %.1777
  br i1 %.1778, label %B1062, label %B1192

B1062.endif.if:                                   ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.3.3, ptr %excinfo, align 8
  br label %common.ret

B1062.endif.endif:                                ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1805.not, label %B1192, label %B1100
}

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
!61 = !{!62}
!62 = distinct !{!62, !63, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!63 = distinct !{!63, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!64 = !{!65, !67, !62}
!65 = distinct !{!65, !66, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!66 = distinct !{!66, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!67 = distinct !{!67, !66, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!68 = !{!69, !71, !65, !67, !62}
!69 = distinct !{!69, !70, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = distinct !{!71, !70, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!72 = !{!73, !75, !65, !67, !62}
!73 = distinct !{!73, !74, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!74 = distinct !{!74, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!75 = distinct !{!75, !74, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!76 = !{!77, !79, !73, !75, !65, !67, !62}
!77 = distinct !{!77, !78, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!78 = distinct !{!78, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!79 = distinct !{!79, !78, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!80 = !{!81, !83, !65, !67, !62}
!81 = distinct !{!81, !82, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!83 = distinct !{!83, !82, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!84 = !{!85, !87, !62}
!85 = distinct !{!85, !86, !"_ZN12clpt_control6native9for_numba12first_passedB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!86 = distinct !{!86, !"_ZN12clpt_control6native9for_numba12first_passedB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!87 = distinct !{!87, !86, !"_ZN12clpt_control6native9for_numba12first_passedB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!88 = !{!89, !91, !92, !94, !62}
!89 = distinct !{!89, !90, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!90 = distinct !{!90, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!91 = distinct !{!91, !90, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!92 = distinct !{!92, !93, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!93 = distinct !{!93, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!94 = distinct !{!94, !93, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!95 = !{!92, !94, !62}
!96 = !{!97, !99, !62}
!97 = distinct !{!97, !98, !"_ZN12clpt_control6native9for_numba12first_passedB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!98 = distinct !{!98, !"_ZN12clpt_control6native9for_numba12first_passedB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!99 = distinct !{!99, !98, !"_ZN12clpt_control6native9for_numba12first_passedB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!100 = !{!101, !62}
!101 = distinct !{!101, !102, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!102 = distinct !{!102, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!103 = !{!104}
!104 = distinct !{!104, !105, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v38B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!105 = distinct !{!105, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v38B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!106 = !{!107, !104}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!109 = !{!110, !112, !104}
!110 = distinct !{!110, !111, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!111 = distinct !{!111, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!112 = distinct !{!112, !111, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!113 = !{!114, !116, !110, !112, !104}
!114 = distinct !{!114, !115, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!115 = distinct !{!115, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!116 = distinct !{!116, !115, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!117 = !{!118}
!118 = distinct !{!118, !119, !"_ZN12clpt_control6native9for_numba6sampleB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!119 = distinct !{!119, !"_ZN12clpt_control6native9for_numba6sampleB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!120 = !{!121, !123, !118}
!121 = distinct !{!121, !122, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!122 = distinct !{!122, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!123 = distinct !{!123, !122, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!124 = !{!125, !127}
!125 = distinct !{!125, !126, !"_ZN12clpt_control6native9for_numba11decide_anewB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!126 = distinct !{!126, !"_ZN12clpt_control6native9for_numba11decide_anewB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!127 = distinct !{!127, !126, !"_ZN12clpt_control6native9for_numba11decide_anewB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!128 = !{!129, !125, !127}
!129 = distinct !{!129, !130, !"_ZN12clpt_control6native9for_numba4failB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!130 = distinct !{!130, !"_ZN12clpt_control6native9for_numba4failB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!131 = !{!132, !134}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba6at_endB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba6at_endB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!134 = distinct !{!134, !135, !"_ZN12clpt_control6native9for_numba4jumpB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!135 = distinct !{!135, !"_ZN12clpt_control6native9for_numba4jumpB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!136 = !{!134}
!137 = !{!138, !140, !134}
!138 = distinct !{!138, !139, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!139 = distinct !{!139, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!140 = distinct !{!140, !139, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!141 = !{!142, !134}
!142 = distinct !{!142, !143, !"_ZN12clpt_control6native9for_numba6at_endB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!143 = distinct !{!143, !"_ZN12clpt_control6native9for_numba6at_endB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!144 = !{!145, !134}
!145 = distinct !{!145, !146, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!146 = distinct !{!146, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!147 = !{!148, !134}
!148 = distinct !{!148, !149, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!149 = distinct !{!149, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!150 = !{!151}
!151 = distinct !{!151, !152, !"_ZN12clpt_control6native9for_numba4failB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!152 = distinct !{!152, !"_ZN12clpt_control6native9for_numba4failB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!153 = !{!154, !156}
!154 = distinct !{!154, !155, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!155 = distinct !{!155, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!156 = distinct !{!156, !155, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!157 = !{!158, !160, !154, !156}
!158 = distinct !{!158, !159, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!159 = distinct !{!159, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!160 = distinct !{!160, !159, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!161 = !{!162}
!162 = distinct !{!162, !163, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!163 = distinct !{!163, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!164 = !{!165, !167, !162}
!165 = distinct !{!165, !166, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!166 = distinct !{!166, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!167 = distinct !{!167, !166, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!168 = !{!169, !171}
!169 = distinct !{!169, !170, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!170 = distinct !{!170, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!171 = distinct !{!171, !170, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!172 = !{!173, !175}
!173 = distinct !{!173, !174, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!174 = distinct !{!174, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!175 = distinct !{!175, !174, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!176 = !{!177, !179}
!177 = distinct !{!177, !178, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!178 = distinct !{!178, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!179 = distinct !{!179, !178, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!180 = !{!181, !183}
!181 = distinct !{!181, !182, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!182 = distinct !{!182, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!183 = distinct !{!183, !182, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!184 = !{!185}
!185 = distinct !{!185, !186, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!186 = distinct !{!186, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!187 = !{!188, !190}
!188 = distinct !{!188, !189, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!189 = distinct !{!189, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!190 = distinct !{!190, !189, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!191 = !{!192, !194, !188, !190}
!192 = distinct !{!192, !193, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!193 = distinct !{!193, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!194 = distinct !{!194, !193, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!195 = !{i1 true}

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
