; sha256 1573c24911a8cb8b1b9c8f889caea3465f6af3182848aaf5e46115b51cd8e105

@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17.101 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18.102 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.100 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.17.101, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.18.102, ptr null, i32 0 }
@switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.13 = private unnamed_addr constant [8 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01], align 8

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
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.27.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 224
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B416.if

B458:                                             ; preds = %B416.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i8893 = getelementptr double, ptr %0, i64 %.780.09169
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
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.09169
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.780.09169
  store i64 %.485.i8898, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.780.09169
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.780.09169
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep9382 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.780.09169
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
  %.297.i.i = add nsw i64 %.295.i.i8902, %.780.09169
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
  %gep9383 = getelementptr double, ptr %invariant.gep9382, i64 %.895.i
  store double %.893.i, ptr %gep9383, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i8901, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep9384 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.780.09169
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep9385 = getelementptr double, ptr %invariant.gep9384, i64 %.1207.i
  store double %.1205.i, ptr %gep9385, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.780.09169
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
  %.1656.i = getelementptr double, ptr %4, i64 %.780.09169
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i8893, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.780.09169
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.780.09169
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.780.09169
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B502, label %B888.i

B502:                                             ; preds = %B888.i, %B458, %B580.if.i, %B416.if
  %.1071 = load i64, ptr %332, align 8
  %.1072 = icmp sgt i64 %.1071, -1
  %.8871 = zext i1 %.1072 to i64
  %.1089 = add nsw i64 %active.4.09171, %.8871
  %.838 = icmp sgt i64 %.783.09170, 1
  br i1 %.838, label %B416.if, label %B556

B556:                                             ; preds = %B502, %B380
  %active.4.0.lcssa = phi i64 [ 0, %B380 ], [ %.1089, %B502 ]
  %.1106.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1122 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1106.not, i1 %.1122, i1 false
  br i1 %or.cond, label %B584.preheader, label %B4744

B584.preheader:                                   ; preds = %B556
  %.1166 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.6
  %factor.op.mul9322 = mul i64 %arg.shape.1, 14
  %factor.op.mul9323 = mul i64 %arg.shape.1, 15
  %.1262 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1314 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8870 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8870
  %.537.i9172 = icmp slt i64 %arg.shape.6, 1
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
  %.idx8864 = mul i64 %arg.batch.4.0.5.1, 240
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
  %.idx8869 = mul i64 %arg.batch.4.0.5.1, 160
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
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 152
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2178 = add i64 %arg.shape.2, -1
  %storemerge8816 = tail call i64 @llvm.smax.i64(i64 %.2178, i64 0)
  %.22219185.not = icmp slt i64 %.2178, 1
  %.2366.idx = mul i64 %.463, 136
  %.2366 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2366.idx
  %.2392 = inttoptr i64 %"$phi380.0.2.0" to ptr
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond9162.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i8909 = mul nsw i64 %arg.shape.1, 17
  %.idx.i8911 = mul i64 %arg.shape.1, 80
  %invariant.gep9181 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8911
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep9183 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2486 = getelementptr i8, ptr %arg.code.4, i64 72
  %.2563 = icmp sgt i64 %arg.shape.3, 0
  %.2568 = icmp sgt i64 %arg.shape.6, 0
  %.idx8860 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8860
  %.idx8861 = mul i64 %arg.batch.4.0.5.1, 176
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8861
  %.idx8857 = mul i64 %arg.batch.4.0.5.1, 184
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8857
  %.idx8858 = mul i64 %arg.batch.4.0.5.1, 192
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8858
  %.idx8859 = mul i64 %arg.batch.4.0.5.1, 168
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8859
  %.idx8851 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8851
  %.idx8852 = mul i64 %arg.batch.4.0.5.1, 200
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8852
  %.idx8853 = mul i64 %arg.batch.4.0.5.1, 80
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8853
  %.idx8854 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8854
  %.idx8855 = mul i64 %arg.batch.4.0.5.1, 224
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
  %.idx8847 = mul i64 %arg.batch.4.0.5.1, 208
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8847
  %.idx8848 = mul i64 %arg.batch.4.0.5.1, 48
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8848
  %.idx8849 = shl i64 %arg.batch.4.0.5.1, 5
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8849
  %51 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8850 = mul i64 %arg.batch.4.0.5.1, 216
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8850
  %53 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.230.i = getelementptr i8, ptr %53, i64 -8
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx4899.i = mul i64 %arg.batch.4.0.5.1, 136
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4899.i
  %.idx4896.i = mul i64 %arg.batch.4.0.5.1, 48
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4896.i
  %.287.i7034918.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i837.i = shl i64 %arg.shape.1, 4
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, 3
  %.174.i1053.i = mul i64 %arg.shape.6, %arg.shape.0
  %factor.op.mul4936.i.reass = mul i64 %factor.op.mul9322, %arg.shape.0
  %.321.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul4936.i.reass
  %.327.i1112.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.114.i.i11654924.not.i = icmp slt i64 %.174.i1053.i, 1
  %.388.i1198.i = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul4937.i.reass = mul i64 %factor.op.mul9323, %arg.shape.0
  %.647.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul4937.i.reass
  %.1216.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx4895.i = mul i64 %arg.batch.4.0.5.1, 136
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4895.i
  %.155.i.i874.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i874.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i874.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i874.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i874.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i874.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i874.6.i = mul nsw i64 %arg.shape.1, 18
  %.866.i = mul i64 %.174.i1053.i, 27
  %.idx4885.i = mul i64 %arg.batch.4.0.5.1, 120
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4885.i
  %.1245.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.1316.reass.i = mul i64 %.358.i837.i, %arg.shape.0
  %.1337.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1316.reass.i
  %.1362.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %.866.i
  %.idx4880.i = shl i64 %arg.batch.4.1.5.1, 5
  %58 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx4880.i
  %.idx4875.i = mul i64 %arg.batch.4.0.5.1, 112
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4875.i
  %storemerge4874.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i = mul nsw i64 %arg.shape.6, 28
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.155.i.i392.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i392.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i392.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i392.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i392.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i392.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i392.6.i = mul nsw i64 %arg.shape.1, 18
  %.26405009.i = icmp sgt i64 %arg.shape.0, 0
  %.2586.15012.i = add nsw i64 %storemerge.i, -1
  %.idx.i8934 = mul i64 %arg.batch.4.0.5.1, 56
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8934
  %.129.i36944995.not.i = icmp slt i64 %arg.shape.6, 1
  %.454.i.i.i = mul i64 %factor.op.mul, 6
  %.155.i4138.i = mul nsw i64 %arg.shape.6, 25
  %.idx4863.i = mul i64 %arg.batch.4.0.5.1, 104
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4863.i
  %.idx4864.i = mul i64 %arg.batch.4.0.5.1, 40
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4864.i
  %.idx4865.i = shl i64 %arg.batch.4.0.5.1, 5
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx4865.i
  %64 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.456.i.i.2.i = mul i64 %factor.op.mul, 12
  %.456.i.i.3.i = mul i64 %factor.op.mul, 18
  %.456.i.i.4.i = mul i64 %factor.op.mul, 24
  %.190.i.i3881.1.i = mul i64 %factor.op.mul, 9
  %.190.i.i3881.2.i = mul i64 %factor.op.mul, 15
  %.190.i.i3881.3.i = mul i64 %factor.op.mul, 21
  %.4946.not = icmp eq i64 %arg.shape.3, 0
  %.idx630.i = shl i64 %arg.shape.0, 4
  %invariant.gep9264 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx630.i
  %.idx631.i = mul i64 %arg.shape.0, 40
  %invariant.gep9266 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx631.i
  %.idx632.i = shl i64 %arg.shape.0, 6
  %invariant.gep9268 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx632.i
  %.idx633.i = mul i64 %arg.shape.0, 88
  %invariant.gep9270 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx633.i
  %.idx634.i = mul i64 %arg.shape.0, 112
  %invariant.gep9272 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx634.i
  %.idx635.i = mul i64 %arg.shape.0, 136
  %invariant.gep9274 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx635.i
  %.idx636.i = mul i64 %arg.shape.0, 160
  %invariant.gep9276 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx636.i
  %.idx637.i = mul i64 %arg.shape.0, 184
  %invariant.gep9278 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx637.i
  %.idx638.i = mul i64 %arg.shape.0, 208
  %invariant.gep9280 = getelementptr i8, ptr %arg.batch.5.4.4, i64 %.idx638.i
  %65 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.226.i.i = getelementptr i8, ptr %65, i64 -8
  %.296.i.i8945 = icmp sgt i64 %arg.shape.2, 4
  %..i.i = select i1 %.296.i.i8945, i64 0, i64 8
  %.354.i.i = sub nsw i64 9, %..i.i
  %.5201291.not.i.i = icmp slt i64 %arg.shape.0, 1
  %.idx1277.i.i = mul i64 %arg.batch.4.0.5.1, 48
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1277.i.i
  %.287.i1288.not.i.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i = shl nsw i64 %arg.shape.1, 4
  %.706.i.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.155.i.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i.i = mul nsw i64 %arg.shape.1, 18
  %.880.11299.i.i = add nsw i64 %arg.shape.0, -1
  %.idx.i.i = mul i64 %arg.batch.4.0.5.1, 56
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i.i
  %.idx1267.i.i = shl i64 %arg.batch.4.1.5.1, 5
  %68 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1267.i.i
  %.idx1269.i.i = mul i64 %arg.batch.4.0.5.1, 40
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1269.i.i
  %.1281.i.i = select i1 %.296.i.i8945, i64 0, i64 7
  %.idx1270.i.i = mul i64 %arg.batch.4.0.5.1, 112
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1270.i.i
  %.idx1271.i.i = mul i64 %arg.batch.4.0.5.1, 120
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1271.i.i
  %.30.i.i.i = mul nsw i64 %arg.shape.0, 3
  %.454.i.i.i.i = mul i64 %arg.shape.0, 6
  %.456.i.2.i.i.i = mul i64 %arg.shape.0, 12
  %.456.i.3.i.i.i = mul i64 %arg.shape.0, 18
  %.456.i.4.i.i.i = mul i64 %arg.shape.0, 24
  %.190.i.1.i.i.i = mul nsw i64 %arg.shape.0, 9
  %.190.i.2.i.i.i = mul nsw i64 %arg.shape.0, 15
  %.190.i.3.i.i.i = mul nsw i64 %arg.shape.0, 21
  %.idx1274.i.i = shl i64 %arg.batch.4.0.5.1, 5
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1274.i.i
  %73 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx.i8948 = shl i64 %arg.batch.4.1.5.1, 5
  %74 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8948
  %.idx600.i = mul i64 %arg.batch.4.0.5.1, 40
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx600.i
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i8978 = shl i64 %arg.batch.4.1.5.1, 4
  %76 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8978
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %77 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 216
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i8979 = mul nsw i64 %arg.shape.1, 17
  %81 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i8986 = mul nsw i64 %arg.shape.1, 24
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
  %82 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8837
  %.idx8838 = mul i64 %arg.batch.4.0.5.1, 40
  %83 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8838
  %.idx8839 = shl i64 %arg.batch.4.0.5.1, 7
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8839
  %.552.i35759300.not = icmp slt i64 %arg.shape.1, 1
  %.697.i3612 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %85 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i3642 = getelementptr i8, ptr %85, i64 -8
  %.idx8841 = mul i64 %arg.batch.4.1.5.1, 24
  %86 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8841
  %.idx8842 = mul i64 %arg.batch.4.1.5.1, 24
  %87 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8842
  %.idx8843 = mul i64 %arg.batch.4.0.5.1, 24
  %88 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8843
  %.5358.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i8993 = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %90 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %91 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i8995 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i8996 = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %92 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx8826 = mul i64 %arg.batch.4.0.5.1, 40
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8826
  %.idx8827 = shl i64 %arg.batch.4.0.5.1, 4
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8827
  %95 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8828 = mul i64 %arg.batch.4.0.5.1, 24
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8828
  %.175.i.i49729312.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8831 = shl i64 %arg.batch.4.1.5.1, 4
  %97 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8831
  %.idx.i9010 = mul i64 %arg.batch.4.0.5.1, 24
  %98 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i9010
  %.323.i9012 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %99 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i9032 = mul i64 %arg.batch.4.1.5.1, 24
  %100 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i9032
  %.8051131.not.i9034 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i9050 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i9069 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i9087 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i9091 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i9095 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i9097 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i9101 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i9103 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i9105 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9107 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9109 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9111 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9113 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9115 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9117 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9119 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9121 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9123 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9125 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9127 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9129 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9131 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9133 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9135 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9137 = mul i64 %arg.batch.4.0.5.1, 216
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i9087
  %102 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i9115
  %103 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.27.idx.i9137
  %.idx1130.i9152 = mul i64 %arg.batch.4.0.5.1, 224
  %104 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9152
  %.idx8830 = mul i64 %arg.batch.4.0.5.1, 224
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8830
  %.6426 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %106 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %107 = getelementptr i8, ptr %106, i64 -8
  %.6440 = getelementptr double, ptr %107, i64 %.6426
  %108 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8832 = mul i64 %arg.batch.4.0.5.1, 224
  %109 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8832
  %.idx8833 = mul i64 %arg.batch.4.0.5.1, 168
  %110 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8833
  %.idx8834 = shl i64 %arg.batch.4.1.5.1, 4
  %111 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8834
  %.idx8835 = shl i64 %arg.batch.4.0.5.1, 4
  %112 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8835
  %.idx8836 = mul i64 %arg.batch.4.0.5.1, 160
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8836
  %114 = shl i64 %arg.shape.0, 3
  %115 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4543.idx = mul i64 %.463, 112
  %.4543 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4543.idx
  %116 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4543.1.idx = mul i64 %.463, 120
  %.4543.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4543.1.idx
  %117 = getelementptr i8, ptr %arg.code.4, i64 248
  %.4543.2.idx = shl i64 %.463, 7
  %.4543.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4543.2.idx
  br label %B584

B584:                                             ; preds = %B584.preheader, %B4718
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
  %.359.i = icmp sgt i64 %.304.i.09177, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B748
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B784

B194.if.i:                                        ; preds = %B748, %B324.i
  %.304.i.09177 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B748 ]
  %.301.i.09176 = phi i64 [ %.372.i, %B324.i ], [ 0, %B748 ]
  %.368.i = add nsw i64 %.304.i.09177, -1
  %.372.i = add nsw i64 %.301.i.09176, 1
  %118 = getelementptr double, ptr %19, i64 %.301.i.09176
  %.454.i = load double, ptr %118, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge9327 = select i1 %.455.i, i1 true, i1 %.537.i9172
  br i1 %brmerge9327, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep9386 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.09176
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.09173 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.09173, 1
  %.576.i = mul nsw i64 %.481.i.09173, %arg.shape.0
  %gep9387 = getelementptr double, ptr %invariant.gep9386, i64 %.576.i
  %.608.i = load double, ptr %gep9387, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.09173, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.09176
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %119 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %119, i64 %.629.i
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
  %.432.i191 = getelementptr double, ptr %21, i64 %.161.i.09179
  store double 0.000000e+00, ptr %.432.i191, align 8, !noalias !11
  %.487.i = getelementptr double, ptr %22, i64 %.161.i.09179
  store double 0.000000e+00, ptr %.487.i, align 8, !noalias !11
  %.542.i244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09179
  %.543.i245 = load i64, ptr %.542.i244, align 8, !noalias !11
  %.570.i = icmp slt i64 %.543.i245, 0
  %.571.i = select i1 %.570.i, i64 %arg.batch.3.3.5.0, i64 0
  %.572.i257 = add i64 %.571.i, %.543.i245
  %.592.i271 = mul i64 %.572.i257, %arg.batch.3.3.5.1
  %120 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.592.i271
  %.596.i = getelementptr i8, ptr %120, i64 8
  %.597.i275 = load i64, ptr %.596.i, align 8, !noalias !11
  %.620.i282 = add nsw i64 %.597.i275, %.8872
  store i64 %.620.i282, ptr %.596.i, align 8, !noalias !11
  %.736.i = load i64, ptr %.542.i244, align 8, !noalias !11
  %.763.i354 = icmp slt i64 %.736.i, 0
  %.764.i = select i1 %.763.i354, i64 %arg.batch.3.3.5.0, i64 0
  %.765.i355 = add i64 %.764.i, %.736.i
  %.785.i = mul i64 %.765.i355, %arg.batch.3.3.5.1
  %121 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.785.i
  %.789.i369 = getelementptr i8, ptr %121, i64 16
  %.790.i = load i64, ptr %.789.i369, align 8, !noalias !11
  %.813.i = add nsw i64 %.790.i, %"$phi364.4.2.i.2"
  store i64 %.813.i, ptr %.789.i369, align 8, !noalias !11
  %.928.i = getelementptr double, ptr %23, i64 %.161.i.09179
  %.929.i = load double, ptr %.928.i, align 8, !noalias !11
  %.930.i = fcmp une double %.929.i, 0.000000e+00
  br i1 %.930.i, label %B414.i, label %B460.i

B414.i:                                           ; preds = %B108.i
  %122 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09179
  %.84.i.i = load i64, ptr %122, align 8, !noalias !15
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
  %123 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.09179
  %.1000.i = load double, ptr %123, align 8, !noalias !11
  %.1002.i = fcmp olt double %.1000.i, -1.000000e-09
  br i1 %.1002.i, label %B500.i, label %B596.i

B500.i:                                           ; preds = %B464.i
  %124 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.09179
  %.84.i63.i = load i64, ptr %124, align 8, !noalias !18
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
  %.1091.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i.09179
  %.1092.i = load double, ptr %.1091.i, align 8, !noalias !11
  %.1146.i = getelementptr double, ptr %24, i64 %.161.i.09179
  store double %.1092.i, ptr %.1146.i, align 8, !noalias !11
  br label %B596.i

B596.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B464.i, %B460.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.161.i.09179
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.161.i.09179
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.161.i.09179
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B630.i

B134.i.i:                                         ; preds = %B596.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %125 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %125, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B630.i

B630.i:                                           ; preds = %B134.i.i, %B596.i, %B64.if.i
  %.220.i = icmp sgt i64 %.164.i70.09180, 1
  br i1 %.220.i, label %B64.if.i, label %B1302

B64.if.i:                                         ; preds = %B1260, %B630.i
  %.164.i70.09180 = phi i64 [ %.229.i381, %B630.i ], [ %storemerge, %B1260 ]
  %.161.i.09179 = phi i64 [ %.233.i384, %B630.i ], [ 0, %B1260 ]
  %.229.i381 = add nsw i64 %.164.i70.09180, -1
  %.233.i384 = add nsw i64 %.161.i.09179, 1
  %.314.i134 = getelementptr double, ptr %20, i64 %.161.i.09179
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
  %126 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.990.i.i = getelementptr i64, ptr %126, i64 %.976.i.i
  %.991.i.i = load i64, ptr %.990.i.i, align 8, !noalias !28
  %.1007.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1008.i.i = select i1 %.1007.i.i, i64 %arg.linear.6.5.0, i64 0
  %127 = getelementptr i8, ptr %126, i64 8
  %.1022.i.i = getelementptr i64, ptr %127, i64 %.1008.i.i
  %.1023.i.i = load i64, ptr %.1022.i.i, align 8, !noalias !28
  %.1060.i.i = sub i64 %.1023.i.i, %.991.i.i
  %.1106.i2123.not.i = icmp slt i64 %.1060.i.i, 1
  br i1 %.1106.i2123.not.i, label %B702.i.i, label %B536.if.i.i

B544.i.i:                                         ; preds = %B536.if.i.i
  %.1173.i.i = icmp slt i64 %.1047.i.02124.i, 0
  %.1174.i.i = select i1 %.1173.i.i, i64 %arg.linear.7.5.0, i64 0
  %128 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1047.i.02124.i
  %.1188.i.i = getelementptr i64, ptr %128, i64 %.1174.i.i
  %.1189.i.i = load i64, ptr %.1188.i.i, align 8, !noalias !28
  %.1190.i.i = add nsw i64 %.1189.i.i, %.915.i.i
  %.1204.i.i = icmp slt i64 %.1190.i.i, 0
  %.1205.i.i = select i1 %.1204.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %129 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1190.i.i
  %.1219.i.i = getelementptr double, ptr %129, i64 %.1205.i.i
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
  %130 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.1.i
  %.906.i.i.1.i = load double, ptr %130, align 8, !noalias !32
  %131 = getelementptr double, ptr %130, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %131, align 8, !noalias !32
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %132 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %133 = getelementptr double, ptr %130, i64 %.944.i.i.i
  store double %132, ptr %133, align 8, !noalias !32
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
  %134 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %134, ptr %.571, align 8, !noalias !32
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !32
  br i1 %.317.i2117.not.i, label %B702.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %135 = getelementptr double, ptr %143, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %135, align 8, !noalias !32
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2111.i, ptr %145, align 8, !noalias !32
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B702.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B660.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B660.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02129.i, 1
  %136 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02129.i
  %.341.i.i.i = load double, ptr %136, align 8, !noalias !32
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %137 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %137, double 1.200000e-05
  %138 = getelementptr i64, ptr %arg.linear.5.4, i64 %.212.i.i.02129.i
  %.434.i.i.i = load i64, ptr %138, align 8, !noalias !32
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.537.i.sroa.0.02147.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %139 = getelementptr i8, ptr %136, i64 %.idx2162.i
  store double %"$phi230.1.2.i.i.1.i", ptr %139, align 8, !noalias !32
  %exitcond2154.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2154.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02131.i, 1
  %140 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.i
  %.906.i.i.i = load double, ptr %140, align 8, !noalias !32
  %141 = getelementptr double, ptr %140, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %141, align 8, !noalias !32
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %142 = getelementptr double, ptr %140, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %142, align 8, !noalias !32
  %exitcond2155.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2155.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02136.i, 1
  %143 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02136.i
  %.1445.i.i.i = load double, ptr %143, align 8, !noalias !32
  %144 = getelementptr i8, ptr %143, i64 %.933.i.idx.i
  store double %.1445.i.i.i, ptr %144, align 8, !noalias !32
  %145 = getelementptr i8, ptr %143, i64 %.idx2164.i
  %.1513.i.i.i = load double, ptr %145, align 8, !noalias !32
  %146 = getelementptr i8, ptr %143, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %146, align 8, !noalias !32
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B702.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B656.i.i, %B352.i.i
  %.1384.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.1385.i.i = select i1 %.1384.i.i, i64 %arg.linear.6.5.0, i64 0
  %147 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.1399.i.i = getelementptr i64, ptr %147, i64 %.1385.i.i
  %.1400.i.i = load i64, ptr %.1399.i.i, align 8, !noalias !28
  %.1418.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1419.i.i = select i1 %.1418.i.i, i64 %arg.linear.6.5.0, i64 0
  %148 = getelementptr i8, ptr %147, i64 8
  %.1433.i.i = getelementptr i64, ptr %148, i64 %.1419.i.i
  %.1434.i.i = load i64, ptr %.1433.i.i, align 8, !noalias !28
  %.1471.i.i = sub i64 %.1434.i.i, %.1400.i.i
  %.1514.i2138.not.i = icmp slt i64 %.1471.i.i, 1
  br i1 %.1514.i2138.not.i, label %B228.i.loopexit.i, label %B764.if.i.i

B920.i.i:                                         ; preds = %B764.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %149 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %149, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !28
  br label %B995.i.i

B966.i.i:                                         ; preds = %B764.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %150 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %150, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !28
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %151 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %151, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !28
  br label %B995.i.i

B995.i.i:                                         ; preds = %B966.i.i, %B920.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B764.if.i.i, label %B228.i.loopexit.i

B84.if.i.i:                                       ; preds = %B76.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B76.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %152 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %152, align 8, !noalias !28
  %153 = getelementptr i8, ptr %152, i64 %.idx2159.i
  store double %.384.i.i, ptr %153, align 8, !noalias !28
  %154 = getelementptr i8, ptr %152, i64 %.idx2160.i
  store double 0.000000e+00, ptr %154, align 8, !noalias !28
  %exitcond.not.i8907 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i8907, label %B166.i.i, label %B84.if.i.i

B286.if.i.i:                                      ; preds = %B250.i.i, %B286.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B286.if.i.i ], [ %storemerge2107.i, %B250.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B286.if.i.i ], [ 0, %B250.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %155 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %155, align 8, !noalias !28
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
  %156 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1458.i.02139.i
  %.1586.i.i = getelementptr i64, ptr %156, i64 %.1572.i.i
  %.1587.i.i = load i64, ptr %.1586.i.i, align 8, !noalias !28
  %.1588.i.i = add nsw i64 %.1587.i.i, %.915.i.i
  %.1602.i.i = icmp slt i64 %.1588.i.i, 0
  %.1603.i.i = select i1 %.1602.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %157 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1588.i.i
  %.1617.i.i = getelementptr double, ptr %157, i64 %.1603.i.i
  %.1618.i.i = load double, ptr %.1617.i.i, align 8, !noalias !28
  %.1636.i.i = select i1 %.1571.i.i, i64 %arg.linear.8.5.0, i64 0
  %158 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1458.i.02139.i
  %.1650.i.i = getelementptr i64, ptr %158, i64 %.1636.i.i
  %.1651.i.i = load i64, ptr %.1650.i.i, align 8, !noalias !28
  %.1652.i.i = add nsw i64 %.1651.i.i, %.597.i.i.i
  %.1666.i.i = icmp slt i64 %.1652.i.i, 0
  %.1667.i.i = select i1 %.1666.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %159 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1652.i.i
  %.1681.i.i = getelementptr double, ptr %159, i64 %.1667.i.i
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
  %160 = getelementptr double, ptr %arg.linear.1.4, i64 %.746.i
  %.777.i = getelementptr double, ptr %160, i64 %.763.i
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
  %161 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %161, align 8, !noalias !36
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i2114.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %162 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i2114.i
  %.576.i.i = getelementptr double, ptr %162, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !36
  %.610.i.i = load double, ptr %164, align 8, !noalias !36
  store double %.577.i.i, ptr %164, align 8, !noalias !36
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
  %163 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i
  %164 = getelementptr double, ptr %163, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8906, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %164, align 8, !noalias !36
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
  %165 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %165, i64 %.430.i.i
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
  %166 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %166, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i.i, align 8, !noalias !36
  %.861.i.i = load double, ptr %164, align 8, !noalias !36
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i.i, align 8, !noalias !36
  %.759.i.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %167 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i.i = add nsw i64 %167, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %arg.linear.1.5.0, i64 0
  %168 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i.i
  %.1059.i.i = getelementptr double, ptr %168, i64 %.1045.i.i
  %.1060.i2115.i = load double, ptr %.1059.i.i, align 8, !noalias !36
  %.1068.i.i = add nsw i64 %167, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %169 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %169, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %167
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i.i = select i1 %.1310.i.i, i64 %arg.linear.1.5.0, i64 0
  %170 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %170, i64 %.1311.i.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !36
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %arg.linear.1.5.0, i64 0
  %171 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %171, i64 %.1343.i.i
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
  %172 = getelementptr double, ptr %arg.linear.0.4, i64 %.671.i
  %.700.i = getelementptr double, ptr %172, i64 %.686.i
  %.701.i = load double, ptr %.700.i, align 8, !noalias !25
  %.702.i = fneg double %.701.i
  %.721.i = select i1 %.685.i, i64 %arg.linear.1.5.0, i64 0
  %173 = getelementptr double, ptr %arg.linear.1.4, i64 %.671.i
  %.735.i = getelementptr double, ptr %173, i64 %.721.i
  store double %.702.i, ptr %.735.i, align 8, !noalias !25
  %.630.i = icmp sgt i64 %.577.02150.i, 1
  br i1 %.630.i, label %B262.if.i, label %B316.i

B1502:                                            ; preds = %B34.loopexit.i.i, %B116.i, %B1458
  br i1 %.22219185.not, label %B1728, label %B1534.if

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
  %174 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0621.i
  %.202.i.i = load i64, ptr %174, align 8, !noalias !39
  %.204.i.i = add nsw i64 %.202.i.i, %.395.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %175 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %175, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !39
  %gep9184 = getelementptr double, ptr %invariant.gep9183, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep9184, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep9184, align 8, !noalias !39
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
  %176 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %176, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !39
  %.522.i.i = add nsw i64 %.393.i.0618.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %177 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %177, i64 %.537.i.i
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
  %178 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i8917 = getelementptr double, ptr %178, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i8917, align 8, !noalias !39
  %.759.i.i8918 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8918, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %179 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %179, i64 %.776.i.i
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
  %180 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %180, i64 %.1029.i.i
  %.1044.i.i8919 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i8918
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %181 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %181, i64 %.1063.i.i
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
  %182 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %182, i64 %.275.i8910
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %gep9182 = getelementptr double, ptr %invariant.gep9181, i64 %.160.0615.i
  %.323.i8912 = load double, ptr %gep9182, align 8, !noalias !45
  %.324.i8913 = fadd double %.290.i, %.323.i8912
  %183 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %183, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i8909
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i8914 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %184 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i = getelementptr double, ptr %184, i64 %.372.i8914
  store double %.324.i8913, ptr %.386.i, align 8, !noalias !45
  %exitcond.not.i8915 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i8915, label %B34.if.i.i, label %B68.if.i

B286.if.i:                                        ; preds = %B286.if.i, %B286.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B286.if.lr.ph.i ], [ %.533.i, %B286.if.i ]
  %.533.i = add nsw i64 %.464.0631.i, 1
  %185 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i = load i64, ptr %185, align 8, !noalias !45
  %.590.i = add nsw i64 %.589.i, %.395.i
  %.604.i = icmp slt i64 %.590.i, 0
  %.605.i = select i1 %.604.i, i64 %arg.batch.5.0.5.0, i64 0
  %186 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %186, i64 %.605.i
  %.620.i = load double, ptr %.619.i, align 8, !noalias !45
  %.625.i = add nsw i64 %.464.0631.i, %.624.i
  %.639.i8921 = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i8921, i64 %arg.batch.5.0.5.0, i64 0
  %187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i8922 = getelementptr double, ptr %187, i64 %.640.i
  store double %.620.i, ptr %.654.i8922, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i
  br i1 %exitcond634.not.i, label %B1726, label %B286.if.i

B1726:                                            ; preds = %B286.if.i, %B1534.if
  %exitcond9341.not = icmp eq i64 %.2165.09186, %storemerge8816
  br i1 %exitcond9341.not, label %B1728, label %B1534.if

B1728:                                            ; preds = %B1726, %B1502
  %.2487 = load i64, ptr %.2486, align 8
  %.2532 = inttoptr i64 %.2487 to ptr
  tail call void %.2532(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1168, i1 true, i1 %.610
  %or.cond8873 = select i1 %brmerge, i1 true, i1 %.2563
  %spec.select8891 = select i1 %or.cond8873, i1 true, i1 %.2568
  br i1 %.794, label %B1960, label %B1870.if

B1878:                                            ; preds = %B1870.if
  %188 = getelementptr double, ptr %33, i64 %.2608.09189
  %.2767 = load double, ptr %188, align 8
  %.2768 = fcmp ogt double %.2767, 5.000000e-01
  br label %B1914

B1914:                                            ; preds = %B1878, %B1870.if
  %"$phi1914.1.2.2" = phi i1 [ true, %B1870.if ], [ %.2768, %B1878 ]
  br i1 %looked.2.19192, label %B1956, label %B1920

B1920:                                            ; preds = %B1914
  %189 = getelementptr double, ptr %34, i64 %.2608.09189
  %.2842 = load double, ptr %189, align 8
  %.2843 = fcmp ogt double %.2842, 5.000000e-01
  br label %B1956

B1956:                                            ; preds = %B1920, %B1914
  %"$phi1956.1.2.2" = phi i1 [ true, %B1914 ], [ %.2843, %B1920 ]
  %.2664 = icmp sgt i64 %.2611.09190, 1
  br i1 %.2664, label %B1870.if, label %B1960

B1960:                                            ; preds = %B1956, %B1728
  %good.2.1.lcssa = phi i1 [ false, %B1728 ], [ %"$phi1914.1.2.2", %B1956 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select8891, %B1728 ], [ %"$phi1956.1.2.2", %B1956 ]
  %looked.2.1.lcssa.not9345 = xor i1 %looked.2.1.lcssa, true
  %brmerge9346 = or i1 %.794, %looked.2.1.lcssa.not9345
  br i1 %brmerge9346, label %B2538, label %B80.if.i

B2030.preheader:                                  ; preds = %B568.i
  br i1 %.794, label %B2538, label %B2030.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i589 = getelementptr double, ptr %35, i64 %.105.i435.09196
  %.319.i = load double, ptr %.318.i589, align 8, !noalias !46
  %.5.i.i = fptosi double %.319.i to i64
  %.397.i634 = getelementptr double, ptr %36, i64 %.105.i435.09196
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
  %.700.i864 = getelementptr i8, ptr %.482.i, i64 8
  %.701.i865 = load i64, ptr %.700.i864, align 8, !noalias !46
  %.706.i870 = add nsw i64 %.5.i1.i, %.5.i.i
  %.707.i871 = mul nsw i64 %.706.i870, %.2178
  %..5.i.i = select i1 %.625, i64 0, i64 %.5.i.i
  %.708.i872 = add i64 %.707.i871, %..5.i.i
  %.841.i959 = add i64 %.708.i872, %.701.i865
  store i64 %.841.i959, ptr %.700.i864, align 8, !noalias !46
  store double 0.000000e+00, ptr %.318.i589, align 8, !noalias !46
  store double 0.000000e+00, ptr %.397.i634, align 8, !noalias !46
  %.1072.i = getelementptr double, ptr %37, i64 %.105.i435.09196
  %.1073.i1076 = load double, ptr %.1072.i, align 8, !noalias !46
  %.1081.i1081 = sitofp i64 %.706.i870 to double
  %.1082.i1082 = fsub double %.1073.i1076, %.1081.i1081
  store double %.1082.i1082, ptr %.1072.i, align 8, !noalias !46
  br label %B568.i

B568.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i493 = icmp sgt i64 %.108.i.09197, 1
  br i1 %.163.i493, label %B80.if.i, label %B2030.preheader

B80.if.i:                                         ; preds = %B1960, %B568.i
  %.108.i.09197 = phi i64 [ %.172.i1119, %B568.i ], [ %storemerge, %B1960 ]
  %.105.i435.09196 = phi i64 [ %.176.i1122, %B568.i ], [ 0, %B1960 ]
  %.172.i1119 = add nsw i64 %.108.i.09197, -1
  %.176.i1122 = add nsw i64 %.105.i435.09196, 1
  %190 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i435.09196
  %.258.i = load i64, ptr %190, align 8, !noalias !46
  %.263.i545 = icmp sgt i64 %.258.i, -1
  br i1 %.263.i545, label %B126.i, label %B568.i

B2130:                                            ; preds = %B2030.if
  %.3297 = getelementptr double, ptr %40, i64 %.2963.09199
  %.3298 = load double, ptr %.3297, align 8
  %.3299 = fcmp ogt double %.3298, 5.000000e-01
  br i1 %.3299, label %B2168, label %B2268

B2168:                                            ; preds = %B2130
  %.5.i = fptosi double %.3298 to i64
  %191 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.09199
  %.84.i2117 = load i64, ptr %191, align 8, !noalias !50
  %.89.i2120 = icmp sgt i64 %.84.i2117, -1
  br i1 %.89.i2120, label %B46.i, label %B2268

B2268:                                            ; preds = %B2130, %B46.i, %B2168, %B80.i2149
  %.3485 = getelementptr double, ptr %41, i64 %.2963.09199
  %.3486 = load double, ptr %.3485, align 8
  %.3487 = fcmp ogt double %.3486, 5.000000e-01
  br i1 %.3487, label %B2306, label %B2536

B2306:                                            ; preds = %B2268
  %spec.select = select i1 %within.3.29201, i1 true, i1 %.2563
  %.3563 = mul i64 %.3124, %arg.batch.3.3.5.1
  %.3567 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3563
  %.3568 = load i64, ptr %.3567, align 8
  %.3579.0 = and i64 %.3568, 127
  %.3609 = icmp eq i64 %.3579.0, 0
  br i1 %.3609, label %B2414, label %B2376

B2376:                                            ; preds = %B2306
  %.3670 = getelementptr double, ptr %42, i64 %.2963.09199
  %.3671 = load double, ptr %.3670, align 8
  %.3673 = fcmp ogt double %.3671, 0.000000e+00
  br i1 %.3673, label %B2414, label %B2444

B2414:                                            ; preds = %B2306, %B2376
  store double 1.000000e+00, ptr %.3239, align 8
  br label %B2444

B2444:                                            ; preds = %B2414, %B2376
  %checked.5.5 = phi i1 [ true, %B2414 ], [ %checked.3.29202, %B2376 ]
  %.3756 = icmp slt i64 %.3179, %arg.batch.2.5.0
  br i1 %.3756, label %B2482, label %B2536

B2482:                                            ; preds = %B2444
  %.3780 = icmp slt i64 %.3179, 0
  %.3781 = select i1 %.3780, i64 %arg.batch.2.5.0, i64 0
  %192 = getelementptr double, ptr %arg.batch.2.4, i64 %.3179
  %.3795 = getelementptr double, ptr %192, i64 %.3781
  %.3796 = load double, ptr %.3795, align 8
  %.3854 = getelementptr double, ptr %43, i64 %.2963.09199
  %.3855 = load double, ptr %.3854, align 8
  %.3856 = fcmp olt double %.3796, %.3855
  br i1 %.3856, label %B2532, label %B2536

B2532:                                            ; preds = %B2482
  br label %B2536

B2536:                                            ; preds = %B2030.if, %B2532, %B2482, %B2444, %B2268
  %within.4.3 = phi i1 [ true, %B2532 ], [ %spec.select, %B2482 ], [ %spec.select, %B2444 ], [ %within.3.29201, %B2268 ], [ %within.3.29201, %B2030.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2532 ], [ %checked.5.5, %B2482 ], [ %checked.5.5, %B2444 ], [ %checked.3.29202, %B2268 ], [ %checked.3.29202, %B2030.if ]
  %.3025 = icmp sgt i64 %.2966.09200, 1
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
  %.409.i2506 = getelementptr double, ptr %46, i64 %.138.i2279.09209
  %.410.i2507 = load double, ptr %.409.i2506, align 8, !noalias !54
  %.411.i2508 = fcmp uge double %.410.i2507, 5.000000e-01
  %.424.i2516.not = icmp slt i64 %.346.i2457, %arg.batch.2.5.0
  %or.cond8880 = select i1 %.411.i2508, i1 %.424.i2516.not, i1 false
  br i1 %or.cond8880, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i = icmp slt i64 %.346.i2457, 0
  %.441.i2527 = select i1 %.440.i, i64 %arg.batch.2.5.0, i64 0
  %193 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i2457
  %.455.i2541 = getelementptr double, ptr %193, i64 %.441.i2527
  %.456.i2542 = load double, ptr %.455.i2541, align 8, !noalias !54
  %.510.i2589 = getelementptr double, ptr %47, i64 %.138.i2279.09209
  %.511.i2590 = load double, ptr %.510.i2589, align 8, !noalias !54
  %.512.i2591 = fcmp ult double %.456.i2542, %.511.i2590
  br i1 %.512.i2591, label %B268.i2592, label %B453.i

B268.i2592:                                       ; preds = %B216.i
  %.574.i2638 = getelementptr double, ptr %48, i64 %.138.i2279.09209
  %.575.i2639 = load double, ptr %.574.i2638, align 8, !noalias !54
  %.576.i2640 = fcmp ogt double %.575.i2639, 1.000000e+00
  br i1 %.576.i2640, label %B306.i, label %B453.i

B306.i:                                           ; preds = %B268.i2592
  %.632.i = getelementptr double, ptr %49, i64 %.138.i2279.09209
  %.633.i2689 = load double, ptr %.632.i, align 8, !noalias !54
  store double 0.000000e+00, ptr %.409.i2506, align 8, !noalias !58
  %.161.i.i2846 = getelementptr double, ptr %50, i64 %.138.i2279.09209
  store double 0.000000e+00, ptr %.161.i.i2846, align 8, !noalias !58
  %.214.i.i2874 = getelementptr double, ptr %51, i64 %.138.i2279.09209
  store double %.633.i2689, ptr %.214.i.i2874, align 8, !noalias !58
  %.268.i.i2896 = load i64, ptr %.290.i2410, align 8, !noalias !58
  %.294.i.i2906 = icmp slt i64 %.268.i.i2896, 0
  %.295.i.i = select i1 %.294.i.i2906, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i = add i64 %.295.i.i, %.268.i.i2896
  %.316.i.i2918 = mul i64 %.296.i.i, %arg.batch.3.3.5.1
  %.320.i.i2919 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i2918
  %.321.i.i2920 = load i64, ptr %.320.i.i2919, align 8, !noalias !58
  %.322.i.i = add nsw i64 %.321.i.i2920, -1
  store i64 %.322.i.i, ptr %.320.i.i2919, align 8, !noalias !58
  %.426.i.i2952 = load i64, ptr %.290.i2410, align 8, !noalias !58
  %.452.i.i = icmp slt i64 %.426.i.i2952, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i2952
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %194 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %194, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !58
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !58
  %.705.i2981 = load double, ptr %.455.i2541, align 8, !noalias !54
  %.763.i3027 = getelementptr double, ptr %52, i64 %.138.i2279.09209
  store double %.705.i2981, ptr %.763.i3027, align 8, !noalias !54
  %.816.i3071 = mul i64 %.291.i2411, %arg.batch.3.3.5.1
  %195 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i3071
  %.820.i3075 = getelementptr i8, ptr %195, i64 8
  %.821.i3076 = load i64, ptr %.820.i3075, align 8, !noalias !54
  %.822.i3077 = add nsw i64 %.821.i3076, 3
  store i64 %.822.i3077, ptr %.820.i3075, align 8, !noalias !54
  br label %B453.i

B453.i:                                           ; preds = %B268.i2592, %B306.i, %B64.if.i3121, %B140.i, %B216.i
  %.196.i2347 = icmp sgt i64 %.141.i2280.09208, 1
  br i1 %.196.i2347, label %B64.if.i3121, label %B3314

B64.if.i3121:                                     ; preds = %B2946.if, %B453.i
  %.138.i2279.09209 = phi i64 [ %.209.i3128, %B453.i ], [ 0, %B2946.if ]
  %.141.i2280.09208 = phi i64 [ %.205.i3125, %B453.i ], [ %storemerge, %B2946.if ]
  %.205.i3125 = add nsw i64 %.141.i2280.09208, -1
  %.209.i3128 = add nsw i64 %.138.i2279.09209, 1
  %.290.i2410 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2279.09209
  %.291.i2411 = load i64, ptr %.290.i2410, align 8, !noalias !54
  %.345.i2456 = getelementptr i64, ptr %45, i64 %.138.i2279.09209
  %.346.i2457 = load i64, ptr %.345.i2456, align 8, !noalias !54
  %.354.i2461 = icmp slt i64 %.291.i2411, 0
  br i1 %.354.i2461, label %B453.i, label %B140.i

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
  br i1 %.794, label %B256.if.i.preheader, label %B178.if.i.preheader

B178.if.i.preheader:                              ; preds = %B3372
  tail call void @llvm.memset.p0.i64(ptr align 8 %54, i8 0, i64 %114, i1 false), !noalias !61
  br label %B256.if.i.preheader

B256.if.i.preheader:                              ; preds = %B178.if.i.preheader, %B3372
  br label %B256.if.i

B256.loopexit.i:                                  ; preds = %B656.i.loopexit.i, %B88.endif.endif.i.i
  %exitcond5027.not.i = icmp eq i64 %.573.i, 9
  br i1 %exitcond5027.not.i, label %B478.if.i, label %B256.if.i

B290.loopexit.i:                                  ; preds = %B122.if.i949.i, %switch.end.i
  %exitcond5022.not.i = icmp eq i64 %arg.shape.0, %.694.i
  br i1 %exitcond5022.not.i, label %B358.i, label %B290.if.i

B358.i:                                           ; preds = %B290.loopexit.i, %B256.if.i
  %.148.i1042.not.i = icmp eq i64 %.504.04938.i, 8
  %..i8927 = select i1 %.148.i1042.not.i, i64 17, i64 16
  %.163.i.i = mul i64 %..i8927, %.463
  %.171.i.i = mul i64 %.504.04938.i, %factor.op.mul.i.reass
  %.206.i1073.i = load i64, ptr %arg.code.4, align 8, !noalias !64
  %.296.i1106.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.163.i.i
  %.322.i1109.i = inttoptr i64 %.206.i1073.i to ptr
  tail call void %.322.i1109.i(ptr %.571, ptr %.296.i1106.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.321.i.i), !noalias !64
  br i1 %.114.i.i11654924.not.i, label %B88.endif.endif.i.i.critedge, label %B34.if.i.i.i

B34.if.i.i.i:                                     ; preds = %B358.i, %B34.if.i.i.i
  %.56.i.i969.04925.i = phi i64 [ %.127.i.i1259.i, %B34.if.i.i.i ], [ 0, %B358.i ]
  %.127.i.i1259.i = add nsw i64 %.56.i.i969.04925.i, 1
  %.153.i.i1210.i = add nsw i64 %.56.i.i969.04925.i, %.171.i.i
  %.167.i.i1215.i = icmp slt i64 %.153.i.i1210.i, 0
  %.168.i.i.i = select i1 %.167.i.i1215.i, i64 %arg.batch.5.4.5.0, i64 0
  %196 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i1210.i
  %.182.i.i.i = getelementptr double, ptr %196, i64 %.168.i.i.i
  %.183.i.i1224.i = load double, ptr %.182.i.i.i, align 8, !noalias !68
  %.185.i.i1226.i = add nsw i64 %.56.i.i969.04925.i, %.327.i1112.i
  %.199.i.i.i = icmp slt i64 %.185.i.i1226.i, 0
  %.200.i.i.i = select i1 %.199.i.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %197 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i.i1226.i
  %.214.i.i1232.i = getelementptr double, ptr %197, i64 %.200.i.i.i
  %.215.i.i1233.i = load double, ptr %.214.i.i1232.i, align 8, !noalias !68
  store double %.183.i.i1224.i, ptr %.214.i.i1232.i, align 8, !noalias !68
  store double %.215.i.i1233.i, ptr %.182.i.i.i, align 8, !noalias !68
  %exitcond5023.not.i = icmp eq i64 %.174.i1053.i, %.127.i.i1259.i
  br i1 %exitcond5023.not.i, label %B88.endif.i.i, label %B34.if.i.i.i

B656.i.loopexit.i:                                ; preds = %B690.if.i.i, %B656.if.i.i
  %exitcond5026.not.i = icmp eq i64 %arg.shape.0, %.932.i.i8928
  br i1 %exitcond5026.not.i, label %B256.loopexit.i, label %B656.if.i.i

B88.endif.i.i:                                    ; preds = %B34.if.i.i.i
  %.389.i1199.i = load i64, ptr %.388.i1198.i, align 8, !noalias !64
  %.501.i.i = inttoptr i64 %.389.i1199.i to ptr
  tail call void %.501.i.i(ptr %.571, ptr %.296.i1106.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  %.532.i.i = load i64, ptr %arg.code.4, align 8, !noalias !64
  %.648.i.i = inttoptr i64 %.532.i.i to ptr
  tail call void %.648.i.i(ptr %.571, ptr %.296.i1106.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.647.i.i), !noalias !64
  br label %B34.if.i179.i.i

B34.if.i179.i.i:                                  ; preds = %B88.endif.i.i, %B34.if.i179.i.i
  %.56.i27.i.04928.i = phi i64 [ %.127.i185.i.i, %B34.if.i179.i.i ], [ 0, %B88.endif.i.i ]
  %.127.i185.i.i = add nsw i64 %.56.i27.i.04928.i, 1
  %.153.i94.i.i = add nsw i64 %.56.i27.i.04928.i, %.171.i.i
  %.167.i102.i.i = icmp slt i64 %.153.i94.i.i, 0
  %.168.i103.i.i = select i1 %.167.i102.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %198 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i94.i.i
  %.182.i113.i.i = getelementptr double, ptr %198, i64 %.168.i103.i.i
  %.183.i114.i.i = load double, ptr %.182.i113.i.i, align 8, !noalias !72
  %.185.i116.i.i = add nsw i64 %.56.i27.i.04928.i, %.327.i1112.i
  %.199.i124.i.i = icmp slt i64 %.185.i116.i.i, 0
  %.200.i125.i.i = select i1 %.199.i124.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %199 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i116.i.i
  %.214.i135.i.i = getelementptr double, ptr %199, i64 %.200.i125.i.i
  %.215.i136.i.i = load double, ptr %.214.i135.i.i, align 8, !noalias !72
  store double %.183.i114.i.i, ptr %.214.i135.i.i, align 8, !noalias !72
  store double %.215.i136.i.i, ptr %.182.i113.i.i, align 8, !noalias !72
  %exitcond5024.not.i = icmp eq i64 %.174.i1053.i, %.127.i185.i.i
  br i1 %exitcond5024.not.i, label %B88.endif.endif.i.i, label %B34.if.i179.i.i

B88.endif.endif.i.i.critedge:                     ; preds = %B358.i
  %.389.i1199.i.c = load i64, ptr %.388.i1198.i, align 8, !noalias !64
  %.501.i.i.c = inttoptr i64 %.389.i1199.i.c to ptr
  tail call void %.501.i.i.c(ptr %.571, ptr %.296.i1106.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  %.532.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !64
  %.648.i.i.c = inttoptr i64 %.532.i.i.c to ptr
  tail call void %.648.i.i.c(ptr %.571, ptr %.296.i1106.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.647.i.i), !noalias !64
  br label %B88.endif.endif.i.i

B88.endif.endif.i.i:                              ; preds = %B34.if.i179.i.i, %B88.endif.endif.i.i.critedge
  %.715.i.i = load i64, ptr %.388.i1198.i, align 8, !noalias !64
  %.829.i.i = inttoptr i64 %.715.i.i to ptr
  tail call void %.829.i.i(ptr %.571, ptr %.296.i1106.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !64
  br i1 %.794, label %B256.loopexit.i, label %B656.if.i.i

B656.if.i.i:                                      ; preds = %B88.endif.endif.i.i, %B656.i.loopexit.i
  %.863.i.04934.i = phi i64 [ %.932.i.i8928, %B656.i.loopexit.i ], [ 0, %B88.endif.endif.i.i ]
  %.932.i.i8928 = add nsw i64 %.863.i.04934.i, 1
  br i1 %.287.i7034918.not.i, label %B656.i.loopexit.i, label %B690.if.i.lr.ph.i

B690.if.i.lr.ph.i:                                ; preds = %B656.if.i.i
  %.1304.i.i = getelementptr double, ptr %55, i64 %.863.i.04934.i
  %.1387.i.i = getelementptr double, ptr %56, i64 %.863.i.04934.i
  br label %B690.if.i.i

B690.if.i.i:                                      ; preds = %B690.if.i.i, %B690.if.i.lr.ph.i
  %.984.i.04931.i = phi i64 [ 0, %B690.if.i.lr.ph.i ], [ %.1053.i.i, %B690.if.i.i ]
  %.1053.i.i = add nsw i64 %.984.i.04931.i, 1
  %200 = mul nsw i64 %.984.i.04931.i, %arg.shape.0
  %.1081.i.i8929 = add nsw i64 %200, %.863.i.04934.i
  %201 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1081.i.i8929
  %.1111.i.i = load double, ptr %201, align 8, !noalias !64
  %.1120.i.i = add nsw i64 %.1081.i.i8929, %factor.op.mul4937.i.reass
  %.1134.i.i = icmp slt i64 %.1120.i.i, 0
  %.1135.i.i = select i1 %.1134.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %202 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1120.i.i
  %.1149.i.i = getelementptr double, ptr %202, i64 %.1135.i.i
  %.1150.i.i = load double, ptr %.1149.i.i, align 8, !noalias !64
  %.1155.i.i = add nsw i64 %.1081.i.i8929, %factor.op.mul4936.i.reass
  %.1169.i.i = icmp slt i64 %.1155.i.i, 0
  %.1170.i.i = select i1 %.1169.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %203 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1155.i.i
  %.1184.i.i = getelementptr double, ptr %203, i64 %.1170.i.i
  %.1185.i.i = load double, ptr %.1184.i.i, align 8, !noalias !64
  %.1186.i.i = fsub double %.1150.i.i, %.1185.i.i
  %.1187.i.i = tail call double @llvm.fabs.f64(double %.1186.i.i)
  %.1217.i.i = load double, ptr %.1216.i.i, align 8, !noalias !64
  %.1247.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !64
  %.1248.i.i = tail call double @llvm.fabs.f64(double %.1111.i.i)
  %.1249.i.i = fmul double %.1248.i.i, %.1247.i.i
  %.1250.i.i = fadd double %.1217.i.i, %.1249.i.i
  %.1305.i.i = load double, ptr %.1304.i.i, align 8, !noalias !64
  %.1306.i.i = fmul double %.1187.i.i, %.1305.i.i
  %.1310.i.i8930 = fdiv double %.1306.i.i, %.1250.i.i
  %.1316.i.i = fsub double %.1310.i.i8930, %.1310.i.i8930
  %.1317.i.i = fcmp oeq double %.1316.i.i, 0.000000e+00
  %.1310.i..i = select i1 %.1317.i.i, double %.1310.i.i8930, double 0x7FF0000000000000
  %.1388.i.i = load double, ptr %.1387.i.i, align 8, !noalias !64
  %.10.i.i.i8931 = fcmp ogt double %.1310.i..i, %.1388.i.i
  %.11.i.i.i8932 = select i1 %.10.i.i.i8931, double %.1310.i..i, double %.1388.i.i
  store double %.11.i.i.i8932, ptr %.1387.i.i, align 8, !noalias !64
  %exitcond5025.not.i = icmp eq i64 %arg.shape.1, %.1053.i.i
  br i1 %exitcond5025.not.i, label %B656.i.loopexit.i, label %B690.if.i.i

B476.loopexit.i.critedge:                         ; preds = %B902.i
  %.2015.i.c = load i64, ptr %.1245.i, align 8, !noalias !61
  %.2132.i.c = inttoptr i64 %.2015.i.c to ptr
  tail call void %.2132.i.c(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1362.i), !noalias !61
  br label %B476.loopexit.i

B476.loopexit.i:                                  ; preds = %B2306.i, %B476.loopexit.i.critedge
  %exitcond5041.not.i = icmp eq i64 %.966.i, 50
  br i1 %exitcond5041.not.i, label %B1372.i, label %B478.if.i

B534.loopexit.i:                                  ; preds = %B122.if.i.i, %B534.if.i
  %exitcond5030.not.i = icmp eq i64 %arg.shape.0, %.1092.i8941
  br i1 %exitcond5030.not.i, label %B606.i, label %B534.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.04944.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.04944.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9229 = getelementptr double, ptr %invariant.gep9228, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9229, align 8, !noalias !76
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.1171.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.04944.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9231 = getelementptr double, ptr %invariant.gep9230, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9231, align 8, !noalias !76
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.04944.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9233 = getelementptr double, ptr %invariant.gep9232, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9233, align 8, !noalias !76
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.1171.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.04944.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9235 = getelementptr double, ptr %invariant.gep9234, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9235, align 8, !noalias !76
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.04944.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9237 = getelementptr double, ptr %invariant.gep9236, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9237, align 8, !noalias !76
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.1171.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.04944.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9239 = getelementptr double, ptr %invariant.gep9238, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9239, align 8, !noalias !76
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.04944.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9241 = getelementptr double, ptr %invariant.gep9240, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9241, align 8, !noalias !76
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.1171.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.04944.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.04944.i, %arg.shape.0
  %gep9243 = getelementptr double, ptr %invariant.gep9242, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep9243, align 8, !noalias !76
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.359.i.i = add nsw i64 %.229.i.04944.i, %.358.i837.i
  %.361.i.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep9245 = getelementptr double, ptr %invariant.gep9244, i64 %.361.i.i
  store double %.313.i.i.i, ptr %gep9245, align 8, !noalias !83
  %exitcond5029.not.i = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond5029.not.i, label %B534.loopexit.i, label %B122.if.i.i

B606.i:                                           ; preds = %B534.loopexit.i, %B534.preheader.i
  %.1246.i = load i64, ptr %.1245.i, align 8, !noalias !61
  %.1363.i = inttoptr i64 %.1246.i to ptr
  tail call void %.1363.i(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1362.i), !noalias !61
  %.205.i1536.i = load i64, ptr %arg.code.4, align 8, !noalias !84
  %.321.i1606.i = inttoptr i64 %.205.i1536.i to ptr
  tail call void %.321.i1606.i(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.321.i.i), !noalias !84
  br i1 %.114.i.i11654924.not.i, label %B88.endif.endif.i1934.i.critedge, label %B34.if.i.i2510.i

B34.if.i.i2510.i:                                 ; preds = %B606.i, %B34.if.i.i2510.i
  %.56.i.i1297.04950.i = phi i64 [ %.127.i.i2516.i, %B34.if.i.i2510.i ], [ 0, %B606.i ]
  %.127.i.i2516.i = add nsw i64 %.56.i.i1297.04950.i, 1
  %.153.i.i2425.i = add nsw i64 %.56.i.i1297.04950.i, %.866.i
  %.167.i.i2433.i = icmp slt i64 %.153.i.i2425.i, 0
  %.168.i.i2434.i = select i1 %.167.i.i2433.i, i64 %arg.batch.5.4.5.0, i64 0
  %204 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i2425.i
  %.182.i.i2444.i = getelementptr double, ptr %204, i64 %.168.i.i2434.i
  %.183.i.i2445.i = load double, ptr %.182.i.i2444.i, align 8, !noalias !88
  %.185.i.i2447.i = add nsw i64 %.56.i.i1297.04950.i, %.327.i1112.i
  %.199.i.i2455.i = icmp slt i64 %.185.i.i2447.i, 0
  %.200.i.i2456.i = select i1 %.199.i.i2455.i, i64 %arg.batch.5.1.5.0, i64 0
  %205 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i.i2447.i
  %.214.i.i2466.i = getelementptr double, ptr %205, i64 %.200.i.i2456.i
  %.215.i.i2467.i = load double, ptr %.214.i.i2466.i, align 8, !noalias !88
  store double %.183.i.i2445.i, ptr %.214.i.i2466.i, align 8, !noalias !88
  store double %.215.i.i2467.i, ptr %.182.i.i2444.i, align 8, !noalias !88
  %exitcond5031.not.i = icmp eq i64 %.174.i1053.i, %.127.i.i2516.i
  br i1 %exitcond5031.not.i, label %B88.endif.i1707.i, label %B34.if.i.i2510.i

B656.i2013.loopexit.i:                            ; preds = %B690.if.i2284.i, %B656.if.i2295.i
  %exitcond5034.not.i = icmp eq i64 %arg.shape.0, %.931.i2299.i
  br i1 %exitcond5034.not.i, label %B798.if.i, label %B656.if.i2295.i

B88.endif.i1707.i:                                ; preds = %B34.if.i.i2510.i
  %.388.i1730.i = load i64, ptr %.388.i1198.i, align 8, !noalias !84
  %.500.i.i = inttoptr i64 %.388.i1730.i to ptr
  tail call void %.500.i.i(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !84
  %.531.i.i = load i64, ptr %arg.code.4, align 8, !noalias !84
  %.647.i1837.i = inttoptr i64 %.531.i.i to ptr
  tail call void %.647.i1837.i(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.647.i.i), !noalias !84
  br label %B34.if.i179.i2400.i

B34.if.i179.i2400.i:                              ; preds = %B88.endif.i1707.i, %B34.if.i179.i2400.i
  %.56.i27.i1277.04953.i = phi i64 [ %.127.i185.i2406.i, %B34.if.i179.i2400.i ], [ 0, %B88.endif.i1707.i ]
  %.127.i185.i2406.i = add nsw i64 %.56.i27.i1277.04953.i, 1
  %.153.i94.i2315.i = add nsw i64 %.56.i27.i1277.04953.i, %.866.i
  %.167.i102.i2323.i = icmp slt i64 %.153.i94.i2315.i, 0
  %.168.i103.i2324.i = select i1 %.167.i102.i2323.i, i64 %arg.batch.5.4.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i94.i2315.i
  %.182.i113.i2334.i = getelementptr double, ptr %206, i64 %.168.i103.i2324.i
  %.183.i114.i2335.i = load double, ptr %.182.i113.i2334.i, align 8, !noalias !92
  %.185.i116.i2337.i = add nsw i64 %.56.i27.i1277.04953.i, %.327.i1112.i
  %.199.i124.i2345.i = icmp slt i64 %.185.i116.i2337.i, 0
  %.200.i125.i2346.i = select i1 %.199.i124.i2345.i, i64 %arg.batch.5.1.5.0, i64 0
  %207 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.185.i116.i2337.i
  %.214.i135.i2356.i = getelementptr double, ptr %207, i64 %.200.i125.i2346.i
  %.215.i136.i2357.i = load double, ptr %.214.i135.i2356.i, align 8, !noalias !92
  store double %.183.i114.i2335.i, ptr %.214.i135.i2356.i, align 8, !noalias !92
  store double %.215.i136.i2357.i, ptr %.182.i113.i2334.i, align 8, !noalias !92
  %exitcond5032.not.i = icmp eq i64 %.174.i1053.i, %.127.i185.i2406.i
  br i1 %exitcond5032.not.i, label %B88.endif.endif.i1934.i, label %B34.if.i179.i2400.i

B88.endif.endif.i1934.i.critedge:                 ; preds = %B606.i
  %.388.i1730.i.c = load i64, ptr %.388.i1198.i, align 8, !noalias !84
  %.500.i.i.c = inttoptr i64 %.388.i1730.i.c to ptr
  tail call void %.500.i.i.c(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !84
  %.531.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !84
  %.647.i1837.i.c = inttoptr i64 %.531.i.i.c to ptr
  tail call void %.647.i1837.i.c(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.647.i.i), !noalias !84
  br label %B88.endif.endif.i1934.i

B88.endif.endif.i1934.i:                          ; preds = %B34.if.i179.i2400.i, %B88.endif.endif.i1934.i.critedge
  %.714.i1949.i = load i64, ptr %.388.i1198.i, align 8, !noalias !84
  %.828.i.i8942 = inttoptr i64 %.714.i1949.i to ptr
  tail call void %.828.i.i8942(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !84
  br i1 %.794, label %B894.i, label %B656.if.i2295.i

B656.if.i2295.i:                                  ; preds = %B88.endif.endif.i1934.i, %B656.i2013.loopexit.i
  %.862.i1453.04959.i = phi i64 [ %.931.i2299.i, %B656.i2013.loopexit.i ], [ 0, %B88.endif.endif.i1934.i ]
  %.931.i2299.i = add nsw i64 %.862.i1453.04959.i, 1
  br i1 %.287.i7034918.not.i, label %B656.i2013.loopexit.i, label %B690.if.i2284.lr.ph.i

B690.if.i2284.lr.ph.i:                            ; preds = %B656.if.i2295.i
  %.1303.i2194.i = getelementptr double, ptr %55, i64 %.862.i1453.04959.i
  %.1386.i2238.i = getelementptr double, ptr %56, i64 %.862.i1453.04959.i
  br label %B690.if.i2284.i

B690.if.i2284.i:                                  ; preds = %B690.if.i2284.i, %B690.if.i2284.lr.ph.i
  %.983.i1462.04956.i = phi i64 [ 0, %B690.if.i2284.lr.ph.i ], [ %.1052.i2288.i, %B690.if.i2284.i ]
  %.1052.i2288.i = add nsw i64 %.983.i1462.04956.i, 1
  %208 = mul nsw i64 %.983.i1462.04956.i, %arg.shape.0
  %.1080.i2053.i = add nsw i64 %208, %.862.i1453.04959.i
  %209 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1080.i2053.i
  %.1110.i2072.i = load double, ptr %209, align 8, !noalias !84
  %.1119.i2081.i = add nsw i64 %.1080.i2053.i, %factor.op.mul4937.i.reass
  %.1133.i2088.i = icmp slt i64 %.1119.i2081.i, 0
  %.1134.i2089.i = select i1 %.1133.i2088.i, i64 %arg.batch.5.0.5.0, i64 0
  %210 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1119.i2081.i
  %.1148.i.i = getelementptr double, ptr %210, i64 %.1134.i2089.i
  %.1149.i2100.i = load double, ptr %.1148.i.i, align 8, !noalias !84
  %.1154.i2105.i = add nsw i64 %.1080.i2053.i, %factor.op.mul4936.i.reass
  %.1168.i2112.i = icmp slt i64 %.1154.i2105.i, 0
  %.1169.i2113.i = select i1 %.1168.i2112.i, i64 %arg.batch.5.0.5.0, i64 0
  %211 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1154.i2105.i
  %.1183.i.i = getelementptr double, ptr %211, i64 %.1169.i2113.i
  %.1184.i2124.i = load double, ptr %.1183.i.i, align 8, !noalias !84
  %.1185.i2125.i = fsub double %.1149.i2100.i, %.1184.i2124.i
  %.1186.i2126.i = tail call double @llvm.fabs.f64(double %.1185.i2125.i)
  %.1216.i2142.i = load double, ptr %.1216.i.i, align 8, !noalias !84
  %.1246.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !84
  %.1247.i2157.i = tail call double @llvm.fabs.f64(double %.1110.i2072.i)
  %.1248.i2158.i = fmul double %.1247.i2157.i, %.1246.i.i
  %.1249.i2159.i = fadd double %.1216.i2142.i, %.1248.i2158.i
  %.1304.i2195.i = load double, ptr %.1303.i2194.i, align 8, !noalias !84
  %.1305.i2196.i = fmul double %.1186.i2126.i, %.1304.i2195.i
  %.1309.i.i = fdiv double %.1305.i2196.i, %.1249.i2159.i
  %.1315.i2200.i = fsub double %.1309.i.i, %.1309.i.i
  %.1316.i2201.i = fcmp oeq double %.1315.i2200.i, 0.000000e+00
  %.1309.i..i = select i1 %.1316.i2201.i, double %.1309.i.i, double 0x7FF0000000000000
  %.1387.i2239.i = load double, ptr %.1386.i2238.i, align 8, !noalias !84
  %.10.i.i2244.i = fcmp ogt double %.1309.i..i, %.1387.i2239.i
  %.11.i.i2245.i = select i1 %.10.i.i2244.i, double %.1309.i..i, double %.1387.i2239.i
  store double %.11.i.i2245.i, ptr %.1386.i2238.i, align 8, !noalias !84
  %exitcond5033.not.i = icmp eq i64 %arg.shape.1, %.1052.i2288.i
  br i1 %exitcond5033.not.i, label %B656.i2013.loopexit.i, label %B690.if.i2284.i

B806.i:                                           ; preds = %B798.if.i
  %212 = getelementptr i64, ptr %58, i64 %.1449.04962.i
  %.1608.i = load i64, ptr %212, align 8, !noalias !61
  %.1609.i = icmp sgt i64 %.1608.i, -1
  br i1 %.1609.i, label %B844.i, label %B890.i

B844.i:                                           ; preds = %B806.i
  %213 = getelementptr double, ptr %56, i64 %.1449.04962.i
  %.1669.i = load double, ptr %213, align 8, !noalias !61
  %.1670.i = fcmp ogt double %.1669.i, 1.000000e-01
  br label %B890.i

B890.i:                                           ; preds = %B798.if.i, %B844.i, %B806.i
  %"$phi890.2.3.3.i" = phi i1 [ true, %B798.if.i ], [ %.1670.i, %B844.i ], [ false, %B806.i ]
  %exitcond5035.not.i = icmp eq i64 %arg.shape.0, %.1518.i
  br i1 %exitcond5035.not.i, label %B894.i, label %B798.if.i

B894.i:                                           ; preds = %B890.i, %B88.endif.endif.i1934.i
  %felt.2.2.lcssa.i = phi i1 [ %felt.3.04983.i, %B88.endif.endif.i1934.i ], [ %"$phi890.2.3.3.i", %B890.i ]
  br i1 %felt.2.2.lcssa.i, label %B902.i, label %B1372.i

B902.i:                                           ; preds = %B478.if.i, %B894.i
  %felt.4.1.i = phi i1 [ true, %B894.i ], [ %felt.3.04983.i, %B478.if.i ]
  br i1 %.794, label %B476.loopexit.i.critedge, label %B932.if.i

B932.loopexit.i:                                  ; preds = %B122.if.i467.i, %B932.if.i
  %exitcond5038.not.i = icmp eq i64 %arg.shape.0, %.1811.i
  br i1 %exitcond5038.not.i, label %B1046.i, label %B932.if.i

B122.if.i467.i:                                   ; preds = %B122.if.i467.lr.ph.i, %B122.if.i467.i
  %.229.i60.04969.i = phi i64 [ 0, %B122.if.i467.lr.ph.i ], [ %.300.i473.i, %B122.if.i467.i ]
  %.157.i.i394.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.i
  %.159.i.i396.i = mul nsw i64 %.157.i.i394.i, %arg.shape.0
  %gep9247 = getelementptr double, ptr %invariant.gep9246, i64 %.159.i.i396.i
  %.191.i.i418.i = load double, ptr %gep9247, align 8, !noalias !96
  %.193.i.i420.i = fadd double %.191.i.i418.i, 0.000000e+00
  %.253.i.i442.i = fmul double %.1945.i, %.193.i.i420.i
  %.157.i.i394.1.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.1.i
  %.159.i.i396.1.i = mul nsw i64 %.157.i.i394.1.i, %arg.shape.0
  %gep9249 = getelementptr double, ptr %invariant.gep9248, i64 %.159.i.i396.1.i
  %.191.i.i418.1.i = load double, ptr %gep9249, align 8, !noalias !96
  %.193.i.i420.1.i = fadd double %.191.i.i418.1.i, %.253.i.i442.i
  %.253.i.i442.1.i = fmul double %.247.i.i437.i, %.193.i.i420.1.i
  %.157.i.i394.2.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.2.i
  %.159.i.i396.2.i = mul nsw i64 %.157.i.i394.2.i, %arg.shape.0
  %gep9251 = getelementptr double, ptr %invariant.gep9250, i64 %.159.i.i396.2.i
  %.191.i.i418.2.i = load double, ptr %gep9251, align 8, !noalias !96
  %.193.i.i420.2.i = fadd double %.191.i.i418.2.i, %.253.i.i442.1.i
  %.253.i.i442.2.i = fmul double %.1945.i, %.193.i.i420.2.i
  %.157.i.i394.3.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.3.i
  %.159.i.i396.3.i = mul nsw i64 %.157.i.i394.3.i, %arg.shape.0
  %gep9253 = getelementptr double, ptr %invariant.gep9252, i64 %.159.i.i396.3.i
  %.191.i.i418.3.i = load double, ptr %gep9253, align 8, !noalias !96
  %.193.i.i420.3.i = fadd double %.191.i.i418.3.i, %.253.i.i442.2.i
  %.253.i.i442.3.i = fmul double %.247.i.i437.i, %.193.i.i420.3.i
  %.157.i.i394.4.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.4.i
  %.159.i.i396.4.i = mul nsw i64 %.157.i.i394.4.i, %arg.shape.0
  %gep9255 = getelementptr double, ptr %invariant.gep9254, i64 %.159.i.i396.4.i
  %.191.i.i418.4.i = load double, ptr %gep9255, align 8, !noalias !96
  %.193.i.i420.4.i = fadd double %.191.i.i418.4.i, %.253.i.i442.3.i
  %.253.i.i442.4.i = fmul double %.1945.i, %.193.i.i420.4.i
  %.157.i.i394.5.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.5.i
  %.159.i.i396.5.i = mul nsw i64 %.157.i.i394.5.i, %arg.shape.0
  %gep9257 = getelementptr double, ptr %invariant.gep9256, i64 %.159.i.i396.5.i
  %.191.i.i418.5.i = load double, ptr %gep9257, align 8, !noalias !96
  %.193.i.i420.5.i = fadd double %.191.i.i418.5.i, %.253.i.i442.4.i
  %.253.i.i442.5.i = fmul double %.247.i.i437.i, %.193.i.i420.5.i
  %.157.i.i394.6.i = add nsw i64 %.229.i60.04969.i, %.155.i.i392.6.i
  %.159.i.i396.6.i = mul nsw i64 %.157.i.i394.6.i, %arg.shape.0
  %gep9259 = getelementptr double, ptr %invariant.gep9258, i64 %.159.i.i396.6.i
  %.191.i.i418.6.i = load double, ptr %gep9259, align 8, !noalias !96
  %.193.i.i420.6.i = fadd double %.191.i.i418.6.i, %.253.i.i442.5.i
  %.253.i.i442.6.i = fmul double %.1945.i, %.193.i.i420.6.i
  %.300.i473.i = add nsw i64 %.229.i60.04969.i, 1
  %.271.i.i315.i = mul nsw i64 %.229.i60.04969.i, %arg.shape.0
  %gep9261 = getelementptr double, ptr %invariant.gep9260, i64 %.271.i.i315.i
  %.309.i.i340.i = load double, ptr %gep9261, align 8, !noalias !96
  %.313.i.i343.i = fadd double %.309.i.i340.i, %.253.i.i442.6.i
  %.359.i356.i = add nsw i64 %.229.i60.04969.i, %.358.i837.i
  %.361.i358.i = mul nsw i64 %.359.i356.i, %arg.shape.0
  %gep9263 = getelementptr double, ptr %invariant.gep9262, i64 %.361.i358.i
  store double %.313.i.i343.i, ptr %gep9263, align 8, !noalias !103
  %exitcond5037.not.i = icmp eq i64 %arg.shape.1, %.300.i473.i
  br i1 %exitcond5037.not.i, label %B932.loopexit.i, label %B122.if.i467.i

B1046.i:                                          ; preds = %B932.loopexit.i
  %.2015.i = load i64, ptr %.1245.i, align 8, !noalias !61
  %.2132.i = inttoptr i64 %.2015.i to ptr
  tail call void %.2132.i(ptr %.571, ptr %.1337.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1362.i), !noalias !61
  br label %B1188.if.i

B34.i.i:                                          ; preds = %B1188.if.i, %B34.if.i.i8933
  %.51.i2540.0.i = phi i64 [ 0, %B1188.if.i ], [ %.122.i2662.i, %B34.if.i.i8933 ]
  %exitcond5039.not.i = icmp eq i64 %.51.i2540.0.i, %storemerge4874.i
  br i1 %exitcond5039.not.i, label %B1342.i, label %B34.if.i.i8933

B128.i.i:                                         ; preds = %B34.if.i.i8933
  %214 = icmp sgt i64 %.51.i2540.0.i, -1
  br i1 %214, label %B1316.i, label %B1342.i

B34.if.i.i8933:                                   ; preds = %B34.i.i
  %.122.i2662.i = add i64 %.51.i2540.0.i, 1
  %.157.i2592.i = add nsw i64 %.51.i2540.0.i, %.155.i.i
  %.159.i2594.i = mul nsw i64 %.157.i2592.i, %arg.shape.0
  %.161.i2596.i = add nsw i64 %.159.i2594.i, %.2158.04975.i
  %.175.i2606.i = icmp slt i64 %.161.i2596.i, 0
  %.176.i2607.i = select i1 %.175.i2606.i, i64 %arg.batch.5.4.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i2596.i
  %.190.i.i = getelementptr double, ptr %215, i64 %.176.i2607.i
  %.191.i.i = load double, ptr %.190.i.i, align 8, !noalias !104
  %.195.i2624.i = add nsw i64 %.161.i2596.i, %.174.i1053.i
  %.209.i.i = icmp slt i64 %.195.i2624.i, 0
  %.210.i.i = select i1 %.209.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %216 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i2624.i
  %.224.i2645.i = getelementptr double, ptr %216, i64 %.210.i.i
  %.225.i2646.i = load double, ptr %.224.i2645.i, align 8, !noalias !104
  %.226.i2647.i = fneg double %.225.i2646.i
  %.227.i2648.i = fcmp olt double %.191.i.i, %.226.i2647.i
  br i1 %.227.i2648.i, label %B128.i.i, label %B34.i.i

B1316.i:                                          ; preds = %B128.i.i
  store double %.2366.i, ptr %.2363.i, align 8, !noalias !61
  br label %B2306.i

B1342.i:                                          ; preds = %B34.i.i, %B128.i.i
  store double %.2366.i, ptr %.2308.i, align 8, !noalias !61
  br label %B2306.i

B1372.i:                                          ; preds = %B894.i, %B476.loopexit.i
  br i1 %.26405009.i, label %B1406.lr.ph.i, label %B3414

B1406.lr.ph.i:                                    ; preds = %B1372.i
  %.3588.i = fmul double %.262.i, 2.000000e+00
  br label %B1406.i

B1406.i:                                          ; preds = %B2305.i, %B1406.lr.ph.i
  %.2630.sroa.0.05016.i = phi i64 [ 0, %B1406.lr.ph.i ], [ %.2630.sroa.0.0.i, %B2305.i ]
  %.2586.15015.i = phi i64 [ %.2586.15012.i, %B1406.lr.ph.i ], [ %.2586.1.i, %B2305.i ]
  %.2583.15014.i = phi i64 [ 1, %B1406.lr.ph.i ], [ %.2583.1.i, %B2305.i ]
  %.2711.i = icmp slt i64 %.2630.sroa.0.05016.i, 0
  %.2712.i = select i1 %.2711.i, i64 %arg.batch.4.0.5.1, i64 0
  %.2713.i = add i64 %.2712.i, %.2630.sroa.0.05016.i
  %.2734.i = getelementptr double, ptr %60, i64 %.2713.i
  %.2735.i = load double, ptr %.2734.i, align 8, !noalias !61
  %.2789.i = getelementptr double, ptr %.571, i64 %.2713.i
  store double %.2735.i, ptr %.2789.i, align 8, !noalias !61
  %.2822.i = select i1 %.2711.i, i64 %arg.batch.4.1.5.1, i64 0
  %.2823.i = add i64 %.2822.i, %.2630.sroa.0.05016.i
  %.2844.i = getelementptr i64, ptr %58, i64 %.2823.i
  %.2845.i = load i64, ptr %.2844.i, align 8, !noalias !61
  %.2846.i = icmp slt i64 %.2845.i, 0
  br i1 %.2846.i, label %B2305.i, label %B1498.i

B1498.i:                                          ; preds = %B1406.i
  %.2904.i = getelementptr double, ptr %55, i64 %.2713.i
  %.2905.i = load double, ptr %.2904.i, align 8, !noalias !61
  %.2959.i = getelementptr double, ptr %57, i64 %.2713.i
  %.2960.i = load double, ptr %.2959.i, align 8, !noalias !61
  %.3081.i = getelementptr double, ptr %56, i64 %.2713.i
  %.3082.i = load double, ptr %.3081.i, align 8, !noalias !61
  %.3083.i = fcmp ogt double %.3082.i, 1.000000e-01
  br i1 %.3083.i, label %B1684.i, label %B1908.i

B1684.i:                                          ; preds = %B1498.i
  %.3016.i = load double, ptr %.2734.i, align 8, !noalias !61
  %.3017.i = tail call double @llvm.fabs.f64(double %.3016.i)
  %.3018.i = fmul double %.3017.i, 2.000000e-12
  %.3138.i = getelementptr double, ptr %59, i64 %.2713.i
  %.3139.i = load double, ptr %.3138.i, align 8, !noalias !61
  %.3144.i = fmul double %.2905.i, 0x3D719799812DEA11
  %.10.i.i8939 = fcmp ogt double %.3018.i, %.3144.i
  %.11.i.i8940 = select i1 %.10.i.i8939, double %.3018.i, double %.3144.i
  %.3140.i = fsub double 1.000000e+00, %.3139.i
  %.3142.i = fmul double %.2905.i, %.3140.i
  %.3176.i = fcmp ugt double %.3142.i, %.11.i.i8940
  %.3181.i = fcmp ugt double %.2905.i, %.3588.i
  %or.cond.i = select i1 %.3176.i, i1 %.3181.i, i1 false
  br i1 %or.cond.i, label %B1836.i, label %B1800.i

B1800.i:                                          ; preds = %B1684.i
  %.3242.i = getelementptr double, ptr %61, i64 %.2713.i
  store double 1.000000e+00, ptr %.3242.i, align 8, !noalias !61
  br label %B2305.i

B1836.i:                                          ; preds = %B1684.i
  %.3248.i = fmul double %.2905.i, %.2960.i
  %.10.i4901.i = fcmp ogt double %.262.i, %.3248.i
  %.11.i4902.i = select i1 %.10.i4901.i, double %.262.i, double %.3248.i
  %.108.i3214.i = getelementptr double, ptr %62, i64 %.2713.i
  store double 0.000000e+00, ptr %.108.i3214.i, align 8, !noalias !108
  %.161.i3260.i = getelementptr double, ptr %63, i64 %.2713.i
  store double 0.000000e+00, ptr %.161.i3260.i, align 8, !noalias !108
  %.214.i3306.i = getelementptr double, ptr %64, i64 %.2713.i
  store double %.11.i4902.i, ptr %.214.i3306.i, align 8, !noalias !108
  %.267.i3351.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2823.i
  %.268.i3352.i = load i64, ptr %.267.i3351.i, align 8, !noalias !108
  %.294.i3374.i = icmp slt i64 %.268.i3352.i, 0
  %.295.i3375.i = select i1 %.294.i3374.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i3376.i = add i64 %.295.i3375.i, %.268.i3352.i
  %.316.i3396.i = mul i64 %.296.i3376.i, %arg.batch.3.3.5.1
  %.320.i3400.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i3396.i
  %.321.i3401.i = load i64, ptr %.320.i3400.i, align 8, !noalias !108
  %.322.i3402.i = add nsw i64 %.321.i3401.i, -1
  store i64 %.322.i3402.i, ptr %.320.i3400.i, align 8, !noalias !108
  %.426.i3493.i = load i64, ptr %.267.i3351.i, align 8, !noalias !108
  %.452.i3515.i = icmp slt i64 %.426.i3493.i, 0
  %.453.i3516.i = select i1 %.452.i3515.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i3517.i = add i64 %.453.i3516.i, %.426.i3493.i
  %.474.i3536.i = mul i64 %.454.i3517.i, %arg.batch.3.3.5.1
  %217 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i3536.i
  %.478.i3540.i = getelementptr i8, ptr %217, i64 24
  %.479.i3541.i = load i64, ptr %.478.i3540.i, align 8, !noalias !108
  %.480.i3542.i = add nsw i64 %.479.i3541.i, 1
  store i64 %.480.i3542.i, ptr %.478.i3540.i, align 8, !noalias !108
  br label %B2305.i

B1908.i:                                          ; preds = %B1498.i
  %.3401.i = fcmp olt double %.2960.i, 7.500000e-01
  br i1 %.3401.i, label %B1982.i, label %B2068.i

B1982.i:                                          ; preds = %B1908.i
  %.3385.i = add nsw i64 %.2845.i, %arg.shape.6
  %.3387.i = mul nsw i64 %.3385.i, %arg.shape.0
  %.3389.i = add nsw i64 %.3387.i, %.2630.sroa.0.05016.i
  %.3422.i = icmp slt i64 %.3389.i, 0
  %.3423.i = select i1 %.3422.i, i64 %arg.batch.5.4.5.0, i64 0
  %218 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.3389.i
  %.3437.i = getelementptr double, ptr %218, i64 %.3423.i
  %.3438.i = load double, ptr %.3437.i, align 8, !noalias !61
  %.3443.i = add nsw i64 %.3389.i, %.174.i1053.i
  %.3459.i = icmp slt i64 %.3443.i, 0
  %.3460.i = select i1 %.3459.i, i64 %arg.batch.5.4.5.0, i64 0
  %219 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.3443.i
  %.3474.i = getelementptr double, ptr %219, i64 %.3460.i
  %.3475.i = load double, ptr %.3474.i, align 8, !noalias !61
  %.3476.i = fcmp ogt double %.3438.i, %.3475.i
  br i1 %.3476.i, label %B2030.i, label %B2068.i

B2030.i:                                          ; preds = %B1982.i
  %.3479.i = fmul double %.2960.i, 5.000000e-01
  %.3487.i = fmul double %.3479.i, 0x4002AAAAAAAAAAAA
  br label %B2068.i

B2068.i:                                          ; preds = %B2030.i, %B1982.i, %B1908.i
  %share.5.2.i = phi double [ %.3487.i, %B2030.i ], [ 1.000000e+00, %B1982.i ], [ 1.000000e+00, %B1908.i ]
  br i1 %.129.i36944995.not.i, label %B2068.endif.endif.i, label %B82.if.i.i

B392.i.i:                                         ; preds = %B82.if.i.i
  %.10.i3.i.i = fcmp ogt double %.488.i.i.i, 0xFFF0000000000000
  %.11.i4.i.i8938 = select i1 %.10.i3.i.i, double %.488.i.i.i, double 0xFFF0000000000000
  %.10.i3.i.1.i = fcmp ogt double %.222.i.i.i, %.11.i4.i.i8938
  %.11.i4.i.1.i = select i1 %.10.i3.i.1.i, double %.222.i.i.i, double %.11.i4.i.i8938
  %.10.i3.i.2.i = fcmp ogt double %.488.i.i.1.i, %.11.i4.i.1.i
  %.11.i4.i.2.i = select i1 %.10.i3.i.2.i, double %.488.i.i.1.i, double %.11.i4.i.1.i
  %.10.i3.i.3.i = fcmp ogt double %.222.i.i.1.i, %.11.i4.i.2.i
  %.11.i4.i.3.i = select i1 %.10.i3.i.3.i, double %.222.i.i.1.i, double %.11.i4.i.2.i
  %.10.i3.i.4.i = fcmp ogt double %.488.i.i.2.i, %.11.i4.i.3.i
  %.11.i4.i.4.i = select i1 %.10.i3.i.4.i, double %.488.i.i.2.i, double %.11.i4.i.3.i
  %.10.i3.i.5.i = fcmp ogt double %.222.i.i.2.i, %.11.i4.i.4.i
  %.11.i4.i.5.i = select i1 %.10.i3.i.5.i, double %.222.i.i.2.i, double %.11.i4.i.4.i
  %.10.i3.i.6.i = fcmp ogt double %.488.i.i.3.i, %.11.i4.i.5.i
  %.11.i4.i.6.i = select i1 %.10.i3.i.6.i, double %.488.i.i.3.i, double %.11.i4.i.5.i
  %.10.i3.i.7.i = fcmp ogt double %.222.i.i.3.i, %.11.i4.i.6.i
  %.11.i4.i.7.i = select i1 %.10.i3.i.7.i, double %.222.i.i.3.i, double %.11.i4.i.6.i
  %.10.i3.i.8.i = fcmp ogt double %.488.i.i.4.i, %.11.i4.i.7.i
  %.11.i4.i.8.i = select i1 %.10.i3.i.8.i, double %.488.i.i.4.i, double %.11.i4.i.7.i
  %.10.i.i3969.i = fcmp olt double %.488.i.i.i, 0x7FF0000000000000
  %.11.i.i3970.i = select i1 %.10.i.i3969.i, double %.488.i.i.i, double 0x7FF0000000000000
  %.10.i.i3969.1.i = fcmp olt double %.222.i.i.i, %.11.i.i3970.i
  %.11.i.i3970.1.i = select i1 %.10.i.i3969.1.i, double %.222.i.i.i, double %.11.i.i3970.i
  %.10.i.i3969.2.i = fcmp olt double %.488.i.i.1.i, %.11.i.i3970.1.i
  %.11.i.i3970.2.i = select i1 %.10.i.i3969.2.i, double %.488.i.i.1.i, double %.11.i.i3970.1.i
  %.10.i.i3969.3.i = fcmp olt double %.222.i.i.1.i, %.11.i.i3970.2.i
  %.11.i.i3970.3.i = select i1 %.10.i.i3969.3.i, double %.222.i.i.1.i, double %.11.i.i3970.2.i
  %.10.i.i3969.4.i = fcmp olt double %.488.i.i.2.i, %.11.i.i3970.3.i
  %.11.i.i3970.4.i = select i1 %.10.i.i3969.4.i, double %.488.i.i.2.i, double %.11.i.i3970.3.i
  %.10.i.i3969.5.i = fcmp olt double %.222.i.i.2.i, %.11.i.i3970.4.i
  %.11.i.i3970.5.i = select i1 %.10.i.i3969.5.i, double %.222.i.i.2.i, double %.11.i.i3970.4.i
  %.10.i.i3969.6.i = fcmp olt double %.488.i.i.3.i, %.11.i.i3970.5.i
  %.11.i.i3970.6.i = select i1 %.10.i.i3969.6.i, double %.488.i.i.3.i, double %.11.i.i3970.5.i
  %.10.i.i3969.7.i = fcmp olt double %.222.i.i.3.i, %.11.i.i3970.6.i
  %.11.i.i3970.7.i = select i1 %.10.i.i3969.7.i, double %.222.i.i.3.i, double %.11.i.i3970.6.i
  %.10.i.i3969.8.i = fcmp olt double %.488.i.i.4.i, %.11.i.i3970.7.i
  %.11.i.i3970.8.i = select i1 %.10.i.i3969.8.i, double %.488.i.i.4.i, double %.11.i.i3970.7.i
  %.511.i3860.i = fsub double %.11.i4.i.8.i, %.11.i.i3970.8.i
  %.516.i3863.i = fmul double %.511.i3860.i, 1.000000e-02
  %.518.i3864.i = fcmp ogt double %.11.i.i.i.3.i, %.516.i3863.i
  br i1 %.518.i3864.i, label %B2068.endif.endif.i, label %B432.i.i

B432.i.i:                                         ; preds = %B82.if.i.i, %B392.i.i
  %exitcond5126.not.i = icmp eq i64 %arg.shape.6, %.142.i4035.i
  br i1 %exitcond5126.not.i, label %B2068.endif.endif.i, label %B82.if.i.i

B82.if.i.i:                                       ; preds = %B2068.i, %B432.i.i
  %.71.i3624.04996.i = phi i64 [ %.142.i4035.i, %B432.i.i ], [ 0, %B2068.i ]
  %.168.i3712.i = add nsw i64 %.71.i3624.04996.i, %arg.shape.6
  %.170.i3714.i = mul nsw i64 %.168.i3712.i, %arg.shape.0
  %.172.i3716.i = add nsw i64 %.170.i3714.i, %.2630.sroa.0.05016.i
  %.142.i4035.i = add nsw i64 %.71.i3624.04996.i, 1
  %.192.i.i3883.i = add nsw i64 %.172.i3716.i, %factor.op.mul.i.reass
  %.206.i.i3891.i = icmp slt i64 %.192.i.i3883.i, 0
  %.207.i.i3892.i = select i1 %.206.i.i3891.i, i64 %arg.batch.5.4.5.0, i64 0
  %220 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i3883.i
  %.221.i.i.i = getelementptr double, ptr %220, i64 %.207.i.i3892.i
  %.222.i.i.i = load double, ptr %.221.i.i.i, align 8, !noalias !111
  %.472.i.i.i = icmp slt i64 %.172.i3716.i, 0
  %.473.i.i.i = select i1 %.472.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %221 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.172.i3716.i
  %.487.i.i.i = getelementptr double, ptr %221, i64 %.473.i.i.i
  %.488.i.i.i = load double, ptr %.487.i.i.i, align 8, !noalias !111
  %.489.i.i.i = fmul double %.488.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i = fsub double %.222.i.i.i, %.489.i.i.i
  %.458.i.i.1.i = add nsw i64 %.172.i3716.i, %.454.i.i.i
  %.472.i.i.1.i = icmp slt i64 %.458.i.i.1.i, 0
  %.473.i.i.1.i = select i1 %.472.i.i.1.i, i64 %arg.batch.5.4.5.0, i64 0
  %222 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.i.1.i
  %.487.i.i.1.i = getelementptr double, ptr %222, i64 %.473.i.i.1.i
  %.488.i.i.1.i = load double, ptr %.487.i.i.1.i, align 8, !noalias !111
  %.489.i.i.1.i = fmul double %.488.i.i.1.i, 0x3FEC575F1EBC4F2F
  %.491.i.i.1.i = fsub double %.491.i.i.i, %.489.i.i.1.i
  %.458.i.i.2.i = add nsw i64 %.172.i3716.i, %.456.i.i.2.i
  %.472.i.i.2.i = icmp slt i64 %.458.i.i.2.i, 0
  %.473.i.i.2.i = select i1 %.472.i.i.2.i, i64 %arg.batch.5.4.5.0, i64 0
  %223 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.i.2.i
  %.487.i.i.2.i = getelementptr double, ptr %223, i64 %.473.i.i.2.i
  %.488.i.i.2.i = load double, ptr %.487.i.i.2.i, align 8, !noalias !111
  %.489.i.i.2.i = fmul double %.488.i.i.2.i, 0x3FE1306AA3D795F4
  %224 = fadd double %.491.i.i.1.i, %.489.i.i.2.i
  %.458.i.i.3.i = add nsw i64 %.172.i3716.i, %.456.i.i.3.i
  %.472.i.i.3.i = icmp slt i64 %.458.i.i.3.i, 0
  %.473.i.i.3.i = select i1 %.472.i.i.3.i, i64 %arg.batch.5.4.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.i.3.i
  %.487.i.i.3.i = getelementptr double, ptr %225, i64 %.473.i.i.3.i
  %.488.i.i.3.i = load double, ptr %.487.i.i.3.i, align 8, !noalias !111
  %.489.i.i.3.i = fmul double %.488.i.i.3.i, 0x3FCCB9F574BDCC3A
  %.491.i.i.3.i = fsub double %224, %.489.i.i.3.i
  %.458.i.i.4.i = add nsw i64 %.172.i3716.i, %.456.i.i.4.i
  %.472.i.i.4.i = icmp slt i64 %.458.i.i.4.i, 0
  %.473.i.i.4.i = select i1 %.472.i.i.4.i, i64 %arg.batch.5.4.5.0, i64 0
  %226 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.i.4.i
  %.487.i.i.4.i = getelementptr double, ptr %226, i64 %.473.i.i.4.i
  %.488.i.i.4.i = load double, ptr %.487.i.i.4.i, align 8, !noalias !111
  %.489.i.i.4.i = fmul double %.488.i.i.4.i, 0x3FA4EAF2D6B11E79
  %227 = fadd double %.491.i.i.3.i, %.489.i.i.4.i
  %.502.i.i.i = tail call double @llvm.fabs.f64(double %227)
  %.10.i.i.i.i8935 = fcmp ogt double %.502.i.i.i, 0.000000e+00
  %.11.i.i.i.i8936 = select i1 %.10.i.i.i.i8935, double %.502.i.i.i, double 0.000000e+00
  %.192.i.i3883.1.i = add nsw i64 %.172.i3716.i, %.190.i.i3881.1.i
  %.206.i.i3891.1.i = icmp slt i64 %.192.i.i3883.1.i, 0
  %.207.i.i3892.1.i = select i1 %.206.i.i3891.1.i, i64 %arg.batch.5.4.5.0, i64 0
  %228 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i3883.1.i
  %.221.i.i.1.i = getelementptr double, ptr %228, i64 %.207.i.i3892.1.i
  %.222.i.i.1.i = load double, ptr %.221.i.i.1.i, align 8, !noalias !111
  %.489.i.i.15069.i = fmul double %.488.i.i.i, 0x3FA5118805F8B876
  %229 = fadd double %.222.i.i.1.i, %.489.i.i.15069.i
  %.489.i.i.1.1.i = fmul double %.488.i.i.1.i, 0x3FE51326698BC5BD
  %.491.i.i.1.1.i = fsub double %229, %.489.i.i.1.1.i
  %.489.i.i.2.1.i = fmul double %.488.i.i.2.i, 0x3FDF97DED30D4572
  %.491.i.i.2.1.i = fsub double %.491.i.i.1.1.i, %.489.i.i.2.1.i
  %.489.i.i.3.1.i = fmul double %.488.i.i.3.i, 0x3FC0DA0C684D1D67
  %230 = fadd double %.491.i.i.2.1.i, %.489.i.i.3.1.i
  %.489.i.i.4.1.i = fmul double %.488.i.i.4.i, 0x3F9510B8EC0D4D92
  %.491.i.i.4.1.i = fsub double %230, %.489.i.i.4.1.i
  %.502.i.i.1.i = tail call double @llvm.fabs.f64(double %.491.i.i.4.1.i)
  %.10.i.i.i.1.i = fcmp ogt double %.502.i.i.1.i, %.11.i.i.i.i8936
  %.11.i.i.i.1.i = select i1 %.10.i.i.i.1.i, double %.502.i.i.1.i, double %.11.i.i.i.i8936
  %.192.i.i3883.2.i = add nsw i64 %.172.i3716.i, %.190.i.i3881.2.i
  %.206.i.i3891.2.i = icmp slt i64 %.192.i.i3883.2.i, 0
  %.207.i.i3892.2.i = select i1 %.206.i.i3891.2.i, i64 %arg.batch.5.4.5.0, i64 0
  %231 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i3883.2.i
  %.221.i.i.2.i = getelementptr double, ptr %231, i64 %.207.i.i3892.2.i
  %.222.i.i.2.i = load double, ptr %.221.i.i.2.i, align 8, !noalias !111
  %.489.i.i.25096.i = fmul double %.488.i.i.i, 0x3F9635A30F8F142F
  %.491.i.i.25097.i = fsub double %.222.i.i.2.i, %.489.i.i.25096.i
  %.489.i.i.1.2.i = fmul double %.488.i.i.1.i, 0x3FC1EAE0FF33D241
  %232 = fadd double %.491.i.i.25097.i, %.489.i.i.1.2.i
  %.489.i.i.2.2.i = fmul double %.488.i.i.2.i, 0x3FE1625D59218460
  %.491.i.i.2.2.i = fsub double %232, %.489.i.i.2.2.i
  %.489.i.i.3.2.i = fmul double %.488.i.i.3.i, 0x3FE3BBC3E8A29641
  %.491.i.i.3.2.i = fsub double %.491.i.i.2.2.i, %.489.i.i.3.2.i
  %.489.i.i.4.2.i = fmul double %.488.i.i.4.i, 0x3FA55161A739EB34
  %233 = fadd double %.491.i.i.3.2.i, %.489.i.i.4.2.i
  %.502.i.i.2.i = tail call double @llvm.fabs.f64(double %233)
  %.10.i.i.i.2.i = fcmp ogt double %.502.i.i.2.i, %.11.i.i.i.1.i
  %.11.i.i.i.2.i = select i1 %.10.i.i.i.2.i, double %.502.i.i.2.i, double %.11.i.i.i.1.i
  %.192.i.i3883.3.i = add nsw i64 %.172.i3716.i, %.190.i.i3881.3.i
  %.206.i.i3891.3.i = icmp slt i64 %.192.i.i3883.3.i, 0
  %.207.i.i3892.3.i = select i1 %.206.i.i3891.3.i, i64 %arg.batch.5.4.5.0, i64 0
  %234 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i3883.3.i
  %.221.i.i.3.i = getelementptr double, ptr %234, i64 %.207.i.i3892.3.i
  %.222.i.i.3.i = load double, ptr %.221.i.i.3.i, align 8, !noalias !111
  %.489.i.i.35123.i = fmul double %.488.i.i.i, 0x3FA4F0C0BB579409
  %235 = fadd double %.222.i.i.3.i, %.489.i.i.35123.i
  %.489.i.i.1.3.i = fmul double %.488.i.i.1.i, 0x3FCD2266FBC0D976
  %.491.i.i.1.3.i = fsub double %235, %.489.i.i.1.3.i
  %.489.i.i.2.3.i = fmul double %.488.i.i.2.i, 0x3FE1F2DB6FEE3151
  %236 = fadd double %.491.i.i.1.3.i, %.489.i.i.2.3.i
  %.489.i.i.3.3.i = fmul double %.488.i.i.3.i, 0x3FF0C05015964CBE
  %.491.i.i.3.3.i = fsub double %236, %.489.i.i.3.3.i
  %.489.i.i.4.3.i = fmul double %.488.i.i.4.i, 0x3FD4F15B230DB570
  %.491.i.i.4.3.i = fsub double %.491.i.i.3.3.i, %.489.i.i.4.3.i
  %.502.i.i.3.i = tail call double @llvm.fabs.f64(double %.491.i.i.4.3.i)
  %.10.i.i.i.3.i = fcmp ogt double %.502.i.i.3.i, %.11.i.i.i.2.i
  %.11.i.i.i.3.i = select i1 %.10.i.i.i.3.i, double %.502.i.i.3.i, double %.11.i.i.i.2.i
  %.473.i3827.i = add nsw i64 %.172.i3716.i, %.174.i1053.i
  %.489.i.i = icmp slt i64 %.473.i3827.i, 0
  %.490.i.i = select i1 %.489.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %237 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.473.i3827.i
  %.504.i3851.i = getelementptr double, ptr %237, i64 %.490.i.i
  %.505.i3852.i = load double, ptr %.504.i3851.i, align 8, !noalias !118
  %.507.i3854.i = fcmp ogt double %.11.i.i.i.3.i, %.505.i3852.i
  br i1 %.507.i3854.i, label %B392.i.i, label %B432.i.i

B2164.i:                                          ; preds = %B2068.endif.endif.i
  %.3595.i = fmul double %.2905.i, %share.6.2.i
  %.108.i2766.i = getelementptr double, ptr %62, i64 %.2713.i
  store double 0.000000e+00, ptr %.108.i2766.i, align 8, !noalias !119
  %.161.i2811.i = getelementptr double, ptr %63, i64 %.2713.i
  store double 0.000000e+00, ptr %.161.i2811.i, align 8, !noalias !119
  %.214.i2857.i = getelementptr double, ptr %64, i64 %.2713.i
  store double %.3595.i, ptr %.214.i2857.i, align 8, !noalias !119
  %.267.i2901.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2823.i
  %.268.i2902.i = load i64, ptr %.267.i2901.i, align 8, !noalias !119
  %.294.i2923.i = icmp slt i64 %.268.i2902.i, 0
  %.295.i2924.i = select i1 %.294.i2923.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i2925.i = add i64 %.295.i2924.i, %.268.i2902.i
  %.316.i2943.i = mul i64 %.296.i2925.i, %arg.batch.3.3.5.1
  %.320.i2947.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i2943.i
  %.321.i2948.i = load i64, ptr %.320.i2947.i, align 8, !noalias !119
  %.322.i2949.i = add nsw i64 %.321.i2948.i, -1
  store i64 %.322.i2949.i, ptr %.320.i2947.i, align 8, !noalias !119
  %.426.i3036.i = load i64, ptr %.267.i2901.i, align 8, !noalias !119
  %.452.i3054.i = icmp slt i64 %.426.i3036.i, 0
  %.453.i3055.i = select i1 %.452.i3054.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i3056.i = add i64 %.453.i3055.i, %.426.i3036.i
  %.474.i3072.i = mul i64 %.454.i3056.i, %arg.batch.3.3.5.1
  %238 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i3072.i
  %.478.i.i8937 = getelementptr i8, ptr %238, i64 24
  %.479.i3075.i = load i64, ptr %.478.i.i8937, align 8, !noalias !119
  %.480.i3076.i = add nsw i64 %.479.i3075.i, 1
  store i64 %.480.i3076.i, ptr %.478.i.i8937, align 8, !noalias !119
  br label %B2305.i

B34.i4108.i:                                      ; preds = %B2068.endif.endif.i, %B34.if.i4214.i
  %.51.i4063.0.i = phi i64 [ %.122.i4222.i, %B34.if.i4214.i ], [ 0, %B2068.endif.endif.i ]
  %exitcond5127.not.i = icmp eq i64 %.51.i4063.0.i, %storemerge4874.i
  br i1 %exitcond5127.not.i, label %B2305.i, label %B34.if.i4214.i

B128.i4205.i:                                     ; preds = %B34.if.i4214.i
  %239 = icmp sgt i64 %.51.i4063.0.i, -1
  br i1 %239, label %B2266.i, label %B2305.i

B34.if.i4214.i:                                   ; preds = %B34.i4108.i
  %.122.i4222.i = add i64 %.51.i4063.0.i, 1
  %.157.i4140.i = add nsw i64 %.51.i4063.0.i, %.155.i4138.i
  %.159.i4142.i = mul nsw i64 %.157.i4140.i, %arg.shape.0
  %.161.i4144.i = add nsw i64 %.159.i4142.i, %.2630.sroa.0.05016.i
  %.175.i4154.i = icmp slt i64 %.161.i4144.i, 0
  %.176.i4155.i = select i1 %.175.i4154.i, i64 %arg.batch.5.4.5.0, i64 0
  %240 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i4144.i
  %.190.i4169.i = getelementptr double, ptr %240, i64 %.176.i4155.i
  %.191.i4170.i = load double, ptr %.190.i4169.i, align 8, !noalias !122
  %.195.i4174.i = add nsw i64 %.161.i4144.i, %.174.i1053.i
  %.209.i4184.i = icmp slt i64 %.195.i4174.i, 0
  %.210.i4185.i = select i1 %.209.i4184.i, i64 %arg.batch.5.4.5.0, i64 0
  %241 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i4174.i
  %.224.i4199.i = getelementptr double, ptr %241, i64 %.210.i4185.i
  %.225.i4200.i = load double, ptr %.224.i4199.i, align 8, !noalias !122
  %.226.i4201.i = fneg double %.225.i4200.i
  %.227.i4202.i = fcmp olt double %.191.i4170.i, %.226.i4201.i
  br i1 %.227.i4202.i, label %B128.i4205.i, label %B34.i4108.i

B2266.i:                                          ; preds = %B128.i4205.i
  %.3736.i = getelementptr double, ptr %61, i64 %.2713.i
  store double 1.000000e+00, ptr %.3736.i, align 8, !noalias !61
  br label %B2305.i

B2305.i:                                          ; preds = %B34.i4108.i, %B2266.i, %B128.i4205.i, %B2164.i, %B1836.i, %B1800.i, %B1406.i
  %.2640.i = icmp sgt i64 %.2586.15015.i, 0
  %.2653.i = zext i1 %.2640.i to i64
  %.2583.1.i = add i64 %.2583.15014.i, %.2653.i
  %.2649.i = sext i1 %.2640.i to i64
  %.2586.1.i = add nsw i64 %.2586.15015.i, %.2649.i
  %.2630.sroa.0.0.i = select i1 %.2640.i, i64 %.2583.15014.i, i64 0
  br i1 %.2640.i, label %B1406.i, label %B3414

B2306.i:                                          ; preds = %B1342.i, %B1316.i
  %exitcond5040.not.i = icmp eq i64 %arg.shape.0, %.2227.i
  br i1 %exitcond5040.not.i, label %B476.loopexit.i, label %B1188.if.i

B256.if.i:                                        ; preds = %B256.if.i.preheader, %B256.loopexit.i
  %.504.04938.i = phi i64 [ %.573.i, %B256.loopexit.i ], [ 1, %B256.if.i.preheader ]
  %.573.i = add nsw i64 %.504.04938.i, 1
  br i1 %.794, label %B358.i, label %B290.if.i.preheader

B290.if.i.preheader:                              ; preds = %B256.if.i
  %242 = icmp ult i64 %.504.04938.i, 8
  %switch.gep = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.13, i64 %.504.04938.i
  br label %B290.if.i

B290.if.i:                                        ; preds = %B290.if.i.preheader, %B290.loopexit.i
  %.625.04922.i = phi i64 [ %.694.i, %B290.loopexit.i ], [ 0, %B290.if.i.preheader ]
  %.694.i = add nsw i64 %.625.04922.i, 1
  br i1 %242, label %switch.lookup, label %switch.end.i

switch.lookup:                                    ; preds = %B290.if.i
  %switch.load = load double, ptr %switch.gep, align 8
  br label %switch.end.i

switch.end.i:                                     ; preds = %B290.if.i, %switch.lookup
  %.736.i8926 = phi double [ %switch.load, %switch.lookup ], [ 1.000000e+00, %B290.if.i ]
  %.92.i589.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.625.04922.i
  %.93.i590.i = load double, ptr %.92.i589.i, align 8, !noalias !126
  %.146.i626.i = getelementptr double, ptr %55, i64 %.625.04922.i
  %.147.i627.i = load double, ptr %.146.i626.i, align 8, !noalias !126
  %.149.i629.i = fmul double %.736.i8926, %.147.i627.i
  %.150.i630.i = fadd double %.93.i590.i, %.149.i629.i
  %.203.i666.i = getelementptr double, ptr %.571, i64 %.625.04922.i
  store double %.150.i630.i, ptr %.203.i666.i, align 8, !noalias !126
  br i1 %.287.i7034918.not.i, label %B290.loopexit.i, label %B122.if.i949.lr.ph.i

B122.if.i949.lr.ph.i:                             ; preds = %switch.end.i
  %.247.i.i919.i = fsub double 1.000000e+00, %.736.i8926
  %invariant.gep9210 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9212 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9214 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9216 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9218 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9220 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9222 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9224 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  %invariant.gep9226 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.04922.i
  br label %B122.if.i949.i

B122.if.i949.i:                                   ; preds = %B122.if.i949.i, %B122.if.i949.lr.ph.i
  %.229.i542.04919.i = phi i64 [ 0, %B122.if.i949.lr.ph.i ], [ %.300.i955.i, %B122.if.i949.i ]
  %.157.i.i876.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.i
  %.159.i.i878.i = mul nsw i64 %.157.i.i876.i, %arg.shape.0
  %gep9211 = getelementptr double, ptr %invariant.gep9210, i64 %.159.i.i878.i
  %.191.i.i900.i = load double, ptr %gep9211, align 8, !noalias !130
  %.193.i.i902.i = fadd double %.191.i.i900.i, 0.000000e+00
  %.253.i.i924.i = fmul double %.736.i8926, %.193.i.i902.i
  %.157.i.i876.1.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.1.i
  %.159.i.i878.1.i = mul nsw i64 %.157.i.i876.1.i, %arg.shape.0
  %gep9213 = getelementptr double, ptr %invariant.gep9212, i64 %.159.i.i878.1.i
  %.191.i.i900.1.i = load double, ptr %gep9213, align 8, !noalias !130
  %.193.i.i902.1.i = fadd double %.191.i.i900.1.i, %.253.i.i924.i
  %.253.i.i924.1.i = fmul double %.247.i.i919.i, %.193.i.i902.1.i
  %.157.i.i876.2.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.2.i
  %.159.i.i878.2.i = mul nsw i64 %.157.i.i876.2.i, %arg.shape.0
  %gep9215 = getelementptr double, ptr %invariant.gep9214, i64 %.159.i.i878.2.i
  %.191.i.i900.2.i = load double, ptr %gep9215, align 8, !noalias !130
  %.193.i.i902.2.i = fadd double %.191.i.i900.2.i, %.253.i.i924.1.i
  %.253.i.i924.2.i = fmul double %.736.i8926, %.193.i.i902.2.i
  %.157.i.i876.3.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.3.i
  %.159.i.i878.3.i = mul nsw i64 %.157.i.i876.3.i, %arg.shape.0
  %gep9217 = getelementptr double, ptr %invariant.gep9216, i64 %.159.i.i878.3.i
  %.191.i.i900.3.i = load double, ptr %gep9217, align 8, !noalias !130
  %.193.i.i902.3.i = fadd double %.191.i.i900.3.i, %.253.i.i924.2.i
  %.253.i.i924.3.i = fmul double %.247.i.i919.i, %.193.i.i902.3.i
  %.157.i.i876.4.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.4.i
  %.159.i.i878.4.i = mul nsw i64 %.157.i.i876.4.i, %arg.shape.0
  %gep9219 = getelementptr double, ptr %invariant.gep9218, i64 %.159.i.i878.4.i
  %.191.i.i900.4.i = load double, ptr %gep9219, align 8, !noalias !130
  %.193.i.i902.4.i = fadd double %.191.i.i900.4.i, %.253.i.i924.3.i
  %.253.i.i924.4.i = fmul double %.736.i8926, %.193.i.i902.4.i
  %.157.i.i876.5.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.5.i
  %.159.i.i878.5.i = mul nsw i64 %.157.i.i876.5.i, %arg.shape.0
  %gep9221 = getelementptr double, ptr %invariant.gep9220, i64 %.159.i.i878.5.i
  %.191.i.i900.5.i = load double, ptr %gep9221, align 8, !noalias !130
  %.193.i.i902.5.i = fadd double %.191.i.i900.5.i, %.253.i.i924.4.i
  %.253.i.i924.5.i = fmul double %.247.i.i919.i, %.193.i.i902.5.i
  %.157.i.i876.6.i = add nsw i64 %.229.i542.04919.i, %.155.i.i874.6.i
  %.159.i.i878.6.i = mul nsw i64 %.157.i.i876.6.i, %arg.shape.0
  %gep9223 = getelementptr double, ptr %invariant.gep9222, i64 %.159.i.i878.6.i
  %.191.i.i900.6.i = load double, ptr %gep9223, align 8, !noalias !130
  %.193.i.i902.6.i = fadd double %.191.i.i900.6.i, %.253.i.i924.5.i
  %.253.i.i924.6.i = fmul double %.736.i8926, %.193.i.i902.6.i
  %.300.i955.i = add nsw i64 %.229.i542.04919.i, 1
  %.271.i.i797.i = mul nsw i64 %.229.i542.04919.i, %arg.shape.0
  %gep9225 = getelementptr double, ptr %invariant.gep9224, i64 %.271.i.i797.i
  %.309.i.i822.i = load double, ptr %gep9225, align 8, !noalias !130
  %.313.i.i825.i = fadd double %.309.i.i822.i, %.253.i.i924.6.i
  %.359.i838.i = add nsw i64 %.229.i542.04919.i, %.358.i837.i
  %.361.i840.i = mul nsw i64 %.359.i838.i, %arg.shape.0
  %gep9227 = getelementptr double, ptr %invariant.gep9226, i64 %.361.i840.i
  store double %.313.i.i825.i, ptr %gep9227, align 8, !noalias !126
  %exitcond5021.not.i = icmp eq i64 %arg.shape.1, %.300.i955.i
  br i1 %exitcond5021.not.i, label %B290.loopexit.i, label %B122.if.i949.i

B478.if.i:                                        ; preds = %B256.loopexit.i, %B476.loopexit.i
  %felt.3.04983.i = phi i1 [ %felt.4.1.i, %B476.loopexit.i ], [ false, %B256.loopexit.i ]
  %.896.04981.i = phi i64 [ %.966.i, %B476.loopexit.i ], [ 0, %B256.loopexit.i ]
  %.966.i = add nsw i64 %.896.04981.i, 1
  %243 = icmp eq i64 %.896.04981.i, 12
  br i1 %243, label %B534.preheader.i, label %B902.i

B534.preheader.i:                                 ; preds = %B478.if.i
  br i1 %.794, label %B606.i, label %B534.if.i

B534.if.i:                                        ; preds = %B534.preheader.i, %B534.loopexit.i
  %.1023.04947.i = phi i64 [ %.1092.i8941, %B534.loopexit.i ], [ 0, %B534.preheader.i ]
  %.1092.i8941 = add nsw i64 %.1023.04947.i, 1
  %244 = getelementptr double, ptr %57, i64 %.1023.04947.i
  %.1171.i = load double, ptr %244, align 8, !noalias !61
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1023.04947.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !83
  %.146.i.i = getelementptr double, ptr %55, i64 %.1023.04947.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !83
  %.149.i.i = fmul double %.1171.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.571, i64 %.1023.04947.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !83
  br i1 %.287.i7034918.not.i, label %B534.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B534.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %.1171.i
  %invariant.gep9228 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9230 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9232 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9234 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9236 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9238 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9240 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9242 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  %invariant.gep9244 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1023.04947.i
  br label %B122.if.i.i

B798.if.i:                                        ; preds = %B656.i2013.loopexit.i, %B890.i
  %felt.2.24964.i = phi i1 [ %"$phi890.2.3.3.i", %B890.i ], [ %felt.3.04983.i, %B656.i2013.loopexit.i ]
  %.1449.04962.i = phi i64 [ %.1518.i, %B890.i ], [ 0, %B656.i2013.loopexit.i ]
  %.1518.i = add nsw i64 %.1449.04962.i, 1
  br i1 %felt.2.24964.i, label %B890.i, label %B806.i

B932.if.i:                                        ; preds = %B902.i, %B932.loopexit.i
  %.1742.04972.i = phi i64 [ %.1811.i, %B932.loopexit.i ], [ 0, %B902.i ]
  %.1811.i = add nsw i64 %.1742.04972.i, 1
  %.1888.i = getelementptr double, ptr %59, i64 %.1742.04972.i
  %.1889.i = load double, ptr %.1888.i, align 8, !noalias !61
  %.1942.i = getelementptr double, ptr %57, i64 %.1742.04972.i
  %.1943.i = load double, ptr %.1942.i, align 8, !noalias !61
  %.1944.i = fadd double %.1889.i, %.1943.i
  %.1945.i = fmul double %.1944.i, 5.000000e-01
  %.92.i107.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1742.04972.i
  %.93.i108.i = load double, ptr %.92.i107.i, align 8, !noalias !103
  %.146.i144.i = getelementptr double, ptr %55, i64 %.1742.04972.i
  %.147.i145.i = load double, ptr %.146.i144.i, align 8, !noalias !103
  %.149.i147.i = fmul double %.1945.i, %.147.i145.i
  %.150.i148.i = fadd double %.93.i108.i, %.149.i147.i
  %.203.i184.i = getelementptr double, ptr %.571, i64 %.1742.04972.i
  store double %.150.i148.i, ptr %.203.i184.i, align 8, !noalias !103
  br i1 %.287.i7034918.not.i, label %B932.loopexit.i, label %B122.if.i467.lr.ph.i

B122.if.i467.lr.ph.i:                             ; preds = %B932.if.i
  %.247.i.i437.i = fsub double 1.000000e+00, %.1945.i
  %invariant.gep9246 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9248 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9250 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9252 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9254 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9256 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9258 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9260 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  %invariant.gep9262 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.04972.i
  br label %B122.if.i467.i

B1188.if.i:                                       ; preds = %B1046.i, %B2306.i
  %.2158.04975.i = phi i64 [ %.2227.i, %B2306.i ], [ 0, %B1046.i ]
  %.2227.i = add nsw i64 %.2158.04975.i, 1
  %.2308.i = getelementptr double, ptr %59, i64 %.2158.04975.i
  %.2309.i = load double, ptr %.2308.i, align 8, !noalias !61
  %.2363.i = getelementptr double, ptr %57, i64 %.2158.04975.i
  %.2364.i = load double, ptr %.2363.i, align 8, !noalias !61
  %.2365.i = fadd double %.2309.i, %.2364.i
  %.2366.i = fmul double %.2365.i, 5.000000e-01
  br label %B34.i.i

B2068.endif.endif.i:                              ; preds = %B432.i.i, %B392.i.i, %B2068.i
  %.3531.i = phi i1 [ true, %B2068.i ], [ false, %B392.i.i ], [ true, %B432.i.i ]
  %.10.i4903.i = fcmp ogt double %share.5.2.i, 5.000000e-01
  %.11.i4904.i = select i1 %.10.i4903.i, double 5.000000e-01, double %share.5.2.i
  %share.6.2.i = select i1 %.3531.i, double %share.5.2.i, double %.11.i4904.i
  %.3585.i = fcmp olt double %share.6.2.i, 1.000000e+00
  %.3590.i = fcmp ogt double %.2905.i, %.3588.i
  %or.cond4900.i = select i1 %.3585.i, i1 %.3590.i, i1 false
  br i1 %or.cond4900.i, label %B2164.i, label %B34.i4108.i

B3414:                                            ; preds = %B2305.i, %B1372.i, %B3318.endif.endif, %B3314
  br i1 %.4946.not, label %B3458, label %B3418

B3418:                                            ; preds = %B3414
  br i1 %.794, label %B116.loopexit.8.i, label %B150.if.i

B150.if.1.i:                                      ; preds = %B150.if.i, %B150.if.1.i
  %.361.0604.1.i = phi i64 [ %.430.1.i, %B150.if.1.i ], [ 0, %B150.if.i ]
  %.430.1.i = add nsw i64 %.361.0604.1.i, 1
  %gep9267 = getelementptr double, ptr %invariant.gep9266, i64 %.361.0604.1.i
  store double 1.000000e-09, ptr %gep9267, align 8, !noalias !134
  %exitcond.1.not.i = icmp eq i64 %arg.shape.0, %.430.1.i
  br i1 %exitcond.1.not.i, label %B150.if.2.i, label %B150.if.1.i

B150.if.2.i:                                      ; preds = %B150.if.1.i, %B150.if.2.i
  %.361.0604.2.i = phi i64 [ %.430.2.i, %B150.if.2.i ], [ 0, %B150.if.1.i ]
  %.430.2.i = add nsw i64 %.361.0604.2.i, 1
  %gep9269 = getelementptr double, ptr %invariant.gep9268, i64 %.361.0604.2.i
  store double 1.000000e-09, ptr %gep9269, align 8, !noalias !134
  %exitcond.2.not.i = icmp eq i64 %arg.shape.0, %.430.2.i
  br i1 %exitcond.2.not.i, label %B150.if.3.i, label %B150.if.2.i

B150.if.3.i:                                      ; preds = %B150.if.2.i, %B150.if.3.i
  %.361.0604.3.i = phi i64 [ %.430.3.i, %B150.if.3.i ], [ 0, %B150.if.2.i ]
  %.430.3.i = add nsw i64 %.361.0604.3.i, 1
  %gep9271 = getelementptr double, ptr %invariant.gep9270, i64 %.361.0604.3.i
  store double 1.000000e-09, ptr %gep9271, align 8, !noalias !134
  %exitcond.3.not.i = icmp eq i64 %arg.shape.0, %.430.3.i
  br i1 %exitcond.3.not.i, label %B150.if.4.i, label %B150.if.3.i

B150.if.4.i:                                      ; preds = %B150.if.3.i, %B150.if.4.i
  %.361.0604.4.i = phi i64 [ %.430.4.i, %B150.if.4.i ], [ 0, %B150.if.3.i ]
  %.430.4.i = add nsw i64 %.361.0604.4.i, 1
  %gep9273 = getelementptr double, ptr %invariant.gep9272, i64 %.361.0604.4.i
  store double 1.000000e-09, ptr %gep9273, align 8, !noalias !134
  %exitcond.4.not.i = icmp eq i64 %arg.shape.0, %.430.4.i
  br i1 %exitcond.4.not.i, label %B150.if.5.i, label %B150.if.4.i

B150.if.5.i:                                      ; preds = %B150.if.4.i, %B150.if.5.i
  %.361.0604.5.i = phi i64 [ %.430.5.i, %B150.if.5.i ], [ 0, %B150.if.4.i ]
  %.430.5.i = add nsw i64 %.361.0604.5.i, 1
  %gep9275 = getelementptr double, ptr %invariant.gep9274, i64 %.361.0604.5.i
  store double 1.000000e-09, ptr %gep9275, align 8, !noalias !134
  %exitcond.5.not.i = icmp eq i64 %arg.shape.0, %.430.5.i
  br i1 %exitcond.5.not.i, label %B150.if.6.i, label %B150.if.5.i

B150.if.6.i:                                      ; preds = %B150.if.5.i, %B150.if.6.i
  %.361.0604.6.i = phi i64 [ %.430.6.i, %B150.if.6.i ], [ 0, %B150.if.5.i ]
  %.430.6.i = add nsw i64 %.361.0604.6.i, 1
  %gep9277 = getelementptr double, ptr %invariant.gep9276, i64 %.361.0604.6.i
  store double 1.000000e-09, ptr %gep9277, align 8, !noalias !134
  %exitcond.6.not.i = icmp eq i64 %arg.shape.0, %.430.6.i
  br i1 %exitcond.6.not.i, label %B150.if.7.i, label %B150.if.6.i

B150.if.7.i:                                      ; preds = %B150.if.6.i, %B150.if.7.i
  %.361.0604.7.i = phi i64 [ %.430.7.i, %B150.if.7.i ], [ 0, %B150.if.6.i ]
  %.430.7.i = add nsw i64 %.361.0604.7.i, 1
  %gep9279 = getelementptr double, ptr %invariant.gep9278, i64 %.361.0604.7.i
  store double 1.000000e-09, ptr %gep9279, align 8, !noalias !134
  %exitcond.7.not.i = icmp eq i64 %arg.shape.0, %.430.7.i
  br i1 %exitcond.7.not.i, label %B150.if.8.i, label %B150.if.7.i

B150.if.8.i:                                      ; preds = %B150.if.7.i, %B150.if.8.i
  %.361.0604.8.i = phi i64 [ %.430.8.i, %B150.if.8.i ], [ 0, %B150.if.7.i ]
  %.430.8.i = add nsw i64 %.361.0604.8.i, 1
  %gep9281 = getelementptr double, ptr %invariant.gep9280, i64 %.361.0604.8.i
  store double 1.000000e-09, ptr %gep9281, align 8, !noalias !134
  %exitcond.8.not.i = icmp eq i64 %arg.shape.0, %.430.8.i
  br i1 %exitcond.8.not.i, label %B116.loopexit.8.i, label %B150.if.8.i

B116.loopexit.8.i:                                ; preds = %B150.if.8.i, %B3418
  %.227.i.i = load double, ptr %.226.i.i, align 8, !noalias !138
  %.256.i.i = load double, ptr %arg.batch.2.4, align 8, !noalias !138
  br label %B246.if.i.i

B280.loopexit.i.i:                                ; preds = %B122.if.i.i.i, %switch.end.i.i
  %exitcond1307.not.i.i = icmp eq i64 %arg.shape.0, %.533.i.i
  br i1 %exitcond1307.not.i.i, label %B348.i.i8946, label %B280.if.i.i

B348.i.i8946:                                     ; preds = %B280.loopexit.i.i, %B246.if.i.i
  %.634.i.i = icmp ult i64 %.341.01294.i.i, 8
  %.1280.i.i = select i1 %.634.i.i, i64 16, i64 17
  %.644.i.i = mul nsw i64 %.341.01294.i.i, 3
  %.6501276.i.i = add nsw i64 %.644.i.i, 1
  %.672.i.i = mul i64 %.6501276.i.i, %arg.shape.0
  %.707.i.i = load i64, ptr %.706.i.i, align 8, !noalias !138
  %.782.i.i = mul i64 %.1280.i.i, %.463
  %.800.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.782.i.i
  %.825.i.i = getelementptr double, ptr %arg.batch.5.4.4, i64 %.672.i.i
  %.826.i.i = inttoptr i64 %.707.i.i to ptr
  tail call void %.826.i.i(ptr %.571, ptr %.800.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.825.i.i), !noalias !138
  %.399.i.i = icmp sgt i64 %.344.01295.i.i, 1
  br i1 %.399.i.i, label %B246.if.i.i, label %B550.i.i

B550.i.i:                                         ; preds = %B348.i.i8946
  br i1 %.5201291.not.i.i, label %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, label %B584.lr.ph.i.i

B584.lr.ph.i.i:                                   ; preds = %B550.i.i
  %.257.i.i = fsub double %.227.i.i, %.256.i.i
  %.258.i.i8959 = fmul double %.257.i.i, 1.000000e-13
  %.1863.i.i = fmul double %.258.i.i8959, 2.000000e+00
  br label %B584.i.i

B584.i.i:                                         ; preds = %B1342.i.i, %B584.lr.ph.i.i
  %.924.sroa.0.01304.i.i = phi i64 [ 0, %B584.lr.ph.i.i ], [ %.924.sroa.0.0.i.i, %B1342.i.i ]
  %.880.11303.i.i = phi i64 [ %.880.11299.i.i, %B584.lr.ph.i.i ], [ %.880.1.i.i, %B1342.i.i ]
  %.877.11302.i.i = phi i64 [ 1, %B584.lr.ph.i.i ], [ %.877.1.i.i, %B1342.i.i ]
  %some.2.01301.i.i = phi i1 [ false, %B584.lr.ph.i.i ], [ %some.3.1.i.i, %B1342.i.i ]
  %excinfo.3.01300.i.i = phi ptr [ null, %B584.lr.ph.i.i ], [ %excinfo.3.1.i.i, %B1342.i.i ]
  %.1009.i.i = icmp slt i64 %.924.sroa.0.01304.i.i, 0
  %.1010.i.i = select i1 %.1009.i.i, i64 %arg.batch.4.0.5.1, i64 0
  %.1011.i.i = add i64 %.1010.i.i, %.924.sroa.0.01304.i.i
  %.1032.i.i = getelementptr double, ptr %67, i64 %.1011.i.i
  %.1033.i.i = load double, ptr %.1032.i.i, align 8, !noalias !138
  %.1065.i.i = select i1 %.1009.i.i, i64 %arg.batch.4.1.5.1, i64 0
  %.1066.i.i = add i64 %.1065.i.i, %.924.sroa.0.01304.i.i
  %.1087.i.i = getelementptr i64, ptr %68, i64 %.1066.i.i
  store i64 -1, ptr %.1087.i.i, align 8, !noalias !138
  %.1142.i.i = getelementptr double, ptr %.571, i64 %.1011.i.i
  store double %.1033.i.i, ptr %.1142.i.i, align 8, !noalias !138
  %.1197.i.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1066.i.i
  %.1198.i.i = load i64, ptr %.1197.i.i, align 8, !noalias !138
  %.1199.i.i = icmp sgt i64 %.1198.i.i, -1
  br i1 %.1199.i.i, label %B702.i.i8960, label %B1342.i.i

B702.i.i8960:                                     ; preds = %B584.i.i
  %.1257.i.i = getelementptr double, ptr %69, i64 %.1011.i.i
  %.1258.i.i = load double, ptr %.1257.i.i, align 8, !noalias !138
  %.1259.i.i = fcmp ogt double %.1258.i.i, 5.000000e-01
  br i1 %.1259.i.i, label %B742.i.i, label %B1342.i.i

B742.i.i:                                         ; preds = %B702.i.i8960
  %.1349.i.i = load i64, ptr %.1087.i.i, align 8, !noalias !138
  %.1350.i.i = icmp slt i64 %.1349.i.i, 0
  br i1 %.1350.i.i, label %B830.i.i, label %B958.i.i

B830.i.i:                                         ; preds = %B742.i.i, %B830.i.i
  %last.2.3.i.i = phi i64 [ %.1356.i.i, %B830.i.i ], [ %.1281.i.i, %B742.i.i ]
  %.1356.i.i = add nsw i64 %last.2.3.i.i, 1
  %.151.i51.i.i = mul nsw i64 %.1356.i.i, 3
  %.155.i.i.i8971 = add nsw i64 %.151.i51.i.i, 1
  %.159.i.i.i8972 = mul nsw i64 %.155.i.i.i8971, %arg.shape.0
  %.161.i.i.i = add nsw i64 %.159.i.i.i8972, %.924.sroa.0.01304.i.i
  %.175.i63.i.i = icmp slt i64 %.161.i.i.i, 0
  %.176.i64.i.i = select i1 %.175.i63.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %245 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.i.i
  %.190.i.i.i = getelementptr double, ptr %245, i64 %.176.i64.i.i
  %.191.i.i.i8973 = load double, ptr %.190.i.i.i, align 8, !noalias !142
  %.195.i80.i.i = add nsw i64 %.161.i.i.i, %arg.shape.0
  %.209.i.i.i = icmp slt i64 %.195.i80.i.i, 0
  %.210.i.i.i = select i1 %.209.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %246 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.195.i80.i.i
  %.224.i91.i.i = getelementptr double, ptr %246, i64 %.210.i.i.i
  %.225.i92.i.i = load double, ptr %.224.i91.i.i, align 8, !noalias !142
  %.226.i93.i.i = fneg double %.225.i92.i.i
  %.227.i94.i.i = fcmp uge double %.191.i.i.i8973, %.226.i93.i.i
  %.1371.0.i.i = sext i1 %.227.i94.i.i to i64
  store i64 %.1371.0.i.i, ptr %.1087.i.i, align 8, !noalias !138
  %exitcond1309.not.i.i = icmp ne i64 %last.2.3.i.i, 7
  %brmerge.not.i.i = and i1 %exitcond1309.not.i.i, %.227.i94.i.i
  br i1 %brmerge.not.i.i, label %B830.i.i, label %B958.i.i

B958.i.i:                                         ; preds = %B830.i.i, %B742.i.i
  %last.3.2.i.i = phi i64 [ %.1281.i.i, %B742.i.i ], [ %.1356.i.i, %B830.i.i ]
  br i1 %.296.i.i8945, label %B966.i.i8970, label %B996.i.i

B966.i.i8970:                                     ; preds = %B958.i.i
  %247 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %last.3.2.i.i
  %switch.gep9351 = getelementptr i8, ptr %247, i64 64
  %switch.load9352 = load double, ptr %switch.gep9351, align 8
  br label %B996.i.i

B996.i.i:                                         ; preds = %B966.i.i8970, %B958.i.i
  %"$phi996.1.2.2.i.i" = phi double [ 0.000000e+00, %B958.i.i ], [ %switch.load9352, %B966.i.i8970 ]
  %.1630.i.i = getelementptr double, ptr %70, i64 %.1011.i.i
  store double %"$phi996.1.2.2.i.i", ptr %.1630.i.i, align 8, !noalias !138
  %248 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %last.3.2.i.i
  %switch.gep9355 = getelementptr i8, ptr %248, i64 72
  %switch.load9356 = load double, ptr %switch.gep9355, align 8
  %.1722.i.i = getelementptr double, ptr %71, i64 %.1011.i.i
  store double %switch.load9356, ptr %.1722.i.i, align 8, !noalias !138
  %.1778.i.i = load i64, ptr %.1087.i.i, align 8, !noalias !138
  %.1779.i.i = icmp sgt i64 %.1778.i.i, -1
  %.1789.i.i = sext i1 %.1779.i.i to i64
  %"$phi1114.1.2.2.i.i" = add nsw i64 %last.3.2.i.i, %.1789.i.i
  br i1 %.296.i.i8945, label %B1122.i.i, label %B1300.i.i

B1122.i.i:                                        ; preds = %B996.i.i
  %.1860.i.i = getelementptr double, ptr %66, i64 %.1011.i.i
  %.1861.i.i = load double, ptr %.1860.i.i, align 8, !noalias !138
  %.1864.i.i8962 = fcmp ogt double %.1861.i.i, %.1863.i.i
  br i1 %.1864.i.i8962, label %B1170.i.i, label %B1300.i.i

B1170.i.i:                                        ; preds = %B1122.i.i
  %249 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1114.1.2.2.i.i", i64 0)
  %storemerge.i.i.i = tail call i64 @llvm.smin.i64(i64 %249, i64 7)
  %.309379.not.i.i.i = icmp slt i64 %"$phi1114.1.2.2.i.i", 1
  %250 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1114.1.2.2.i.i", i64 1)
  %storemerge348.i.i.i = add nsw i64 %250, -1
  %.504383.i.i.i = icmp sgt i64 %"$phi1114.1.2.2.i.i", 1
  %.447.1385.i.i.i = select i1 %.504383.i.i.i, i64 2, i64 1
  %.513386.i.i.i = sext i1 %.504383.i.i.i to i64
  %.450.1387.i.i.i = add nsw i64 %storemerge348.i.i.i, %.513386.i.i.i
  %.494.sroa.0.0388.i.i.i = zext i1 %.504383.i.i.i to i64
  %.160.i.i.i = add nsw i64 %.924.sroa.0.01304.i.i, %arg.shape.0
  %.192.i.i.i.i = add nsw i64 %.160.i.i.i, %.30.i.i.i
  %.206.i.i.i.i = icmp slt i64 %.192.i.i.i.i, 0
  %.207.i.i.i.i = select i1 %.206.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %251 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.i.i.i
  %.221.i.i.i.i = getelementptr double, ptr %251, i64 %.207.i.i.i.i
  %.472.i.i.i.i = icmp slt i64 %.160.i.i.i, 0
  %.473.i.i.i.i = select i1 %.472.i.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %252 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.160.i.i.i
  %.487.i.i.i.i = getelementptr double, ptr %252, i64 %.473.i.i.i.i
  %.458.i.1.i.i.i = add nsw i64 %.160.i.i.i, %.454.i.i.i.i
  %.472.i.1.i.i.i = icmp slt i64 %.458.i.1.i.i.i, 0
  %.473.i.1.i.i.i = select i1 %.472.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %253 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.1.i.i.i
  %.487.i.1.i.i.i = getelementptr double, ptr %253, i64 %.473.i.1.i.i.i
  %.458.i.2.i.i.i = add nsw i64 %.160.i.i.i, %.456.i.2.i.i.i
  %.472.i.2.i.i.i = icmp slt i64 %.458.i.2.i.i.i, 0
  %.473.i.2.i.i.i = select i1 %.472.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %254 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.2.i.i.i
  %.487.i.2.i.i.i = getelementptr double, ptr %254, i64 %.473.i.2.i.i.i
  %.458.i.3.i.i.i = add nsw i64 %.160.i.i.i, %.456.i.3.i.i.i
  %.472.i.3.i.i.i = icmp slt i64 %.458.i.3.i.i.i, 0
  %.473.i.3.i.i.i = select i1 %.472.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %255 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.3.i.i.i
  %.487.i.3.i.i.i = getelementptr double, ptr %255, i64 %.473.i.3.i.i.i
  %.458.i.4.i.i.i = add nsw i64 %.160.i.i.i, %.456.i.4.i.i.i
  %.472.i.4.i.i.i = icmp slt i64 %.458.i.4.i.i.i, 0
  %.473.i.4.i.i.i = select i1 %.472.i.4.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %256 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.458.i.4.i.i.i
  %.487.i.4.i.i.i = getelementptr double, ptr %256, i64 %.473.i.4.i.i.i
  %.192.i.1.i.i.i = add nsw i64 %.160.i.i.i, %.190.i.1.i.i.i
  %.206.i.1.i.i.i = icmp slt i64 %.192.i.1.i.i.i, 0
  %.207.i.1.i.i.i = select i1 %.206.i.1.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %257 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.1.i.i.i
  %.221.i.1.i.i.i = getelementptr double, ptr %257, i64 %.207.i.1.i.i.i
  %.192.i.2.i.i.i = add nsw i64 %.160.i.i.i, %.190.i.2.i.i.i
  %.206.i.2.i.i.i = icmp slt i64 %.192.i.2.i.i.i, 0
  %.207.i.2.i.i.i = select i1 %.206.i.2.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %258 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.2.i.i.i
  %.221.i.2.i.i.i = getelementptr double, ptr %258, i64 %.207.i.2.i.i.i
  %.192.i.3.i.i.i = add nsw i64 %.160.i.i.i, %.190.i.3.i.i.i
  %.206.i.3.i.i.i = icmp slt i64 %.192.i.3.i.i.i, 0
  %.207.i.3.i.i.i = select i1 %.206.i.3.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %259 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.192.i.3.i.i.i
  %.221.i.3.i.i.i = getelementptr double, ptr %259, i64 %.207.i.3.i.i.i
  %.1017.i.i.i = add nsw i64 %.160.i.i.i, %arg.shape.0
  %.1033.i.i.i = icmp slt i64 %.1017.i.i.i, 0
  %.1034.i.i.i8963 = select i1 %.1033.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1017.i.i.i
  %.1048.i.i.i = getelementptr double, ptr %260, i64 %.1034.i.i.i8963
  br label %B50.i.i.i

B50.i.i.i:                                        ; preds = %B830.i.i.i, %B1170.i.i
  %exitcond.not.i.i.i = phi i1 [ false, %B1170.i.i ], [ true, %B830.i.i.i ]
  br i1 %exitcond.not.i.i.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B52.if.i.i.i

B274.i.i.i:                                       ; preds = %B212.if.i.i.i, %B52.if.i.i.i
  %nearest.3.1.lcssa.i.i.i = phi double [ 0x7FF0000000000000, %B52.if.i.i.i ], [ %.11.i352.i.i.i, %B212.if.i.i.i ]
  br i1 %.504383.i.i.i, label %B310.lr.ph.i.i.i, label %B830.i.i.i

B310.lr.ph.i.i.i:                                 ; preds = %B274.i.i.i
  %.666.i.i.i = fmul double %.11.i.i.3.i.i.i, 1.000000e+01
  br label %B310.i.i.i

B310.i.i.i:                                       ; preds = %B905.i.i.i, %B310.lr.ph.i.i.i
  %.494.sroa.0.0392.i.i.i = phi i64 [ %.494.sroa.0.0388.i.i.i, %B310.lr.ph.i.i.i ], [ %.494.sroa.0.0.i.i.i, %B905.i.i.i ]
  %.450.1391.i.i.i = phi i64 [ %.450.1387.i.i.i, %B310.lr.ph.i.i.i ], [ %.450.1.i.i.i, %B905.i.i.i ]
  %.447.1390.i.i.i = phi i64 [ %.447.1385.i.i.i, %B310.lr.ph.i.i.i ], [ %.447.1.i.i.i, %B905.i.i.i ]
  %nearest.4.1389.i.i.i = phi double [ %nearest.3.1.lcssa.i.i.i, %B310.lr.ph.i.i.i ], [ %nearest.5.2.i.i.i, %B905.i.i.i ]
  %.550.i.i.i = add nsw i64 %.494.sroa.0.0392.i.i.i, -1
  %.552.i.i.i = mul nsw i64 %.550.i.i.i, %.30.i.i.i
  %.554.i.i.i = add nsw i64 %.552.i.i.i, %.160.i.i.i
  %.568.i.i.i = icmp slt i64 %.554.i.i.i, 0
  %.569.i.i.i = select i1 %.568.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %261 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.554.i.i.i
  %.583.i.i.i = getelementptr double, ptr %261, i64 %.569.i.i.i
  %.584.i.i.i = load double, ptr %.583.i.i.i, align 8, !noalias !146
  %.587.i.i.i8966 = mul nsw i64 %.494.sroa.0.0392.i.i.i, %.30.i.i.i
  %.589.i.i.i = add nsw i64 %.587.i.i.i8966, %.160.i.i.i
  %.603.i.i.i = icmp slt i64 %.589.i.i.i, 0
  %.604.i.i.i = select i1 %.603.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %262 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.589.i.i.i
  %.618.i.i.i = getelementptr double, ptr %262, i64 %.604.i.i.i
  %.619.i.i.i = load double, ptr %.618.i.i.i, align 8, !noalias !146
  %.621.i.i.i = add nsw i64 %.494.sroa.0.0392.i.i.i, 1
  %.623.i.i.i = mul nsw i64 %.621.i.i.i, %.30.i.i.i
  %.625.i.i.i = add nsw i64 %.623.i.i.i, %.160.i.i.i
  %.639.i.i.i = icmp slt i64 %.625.i.i.i, 0
  %.640.i.i.i = select i1 %.639.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %263 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.625.i.i.i
  %.654.i.i.i = getelementptr double, ptr %263, i64 %.640.i.i.i
  %.655.i.i.i = load double, ptr %.654.i.i.i, align 8, !noalias !146
  %.669.i.i.i = fsub double %.584.i.i.i, %.619.i.i.i
  %.670.i.i.i = tail call double @llvm.fabs.f64(double %.669.i.i.i)
  %.673.i.i.i = fsub double %.655.i.i.i, %.619.i.i.i
  %.674.i.i.i = tail call double @llvm.fabs.f64(double %.673.i.i.i)
  %.675.i.i.i = fadd double %.670.i.i.i, %.674.i.i.i
  %.676.i.i.i = fmul double %.675.i.i.i, 3.000000e+00
  %.677.i.i.i = fadd double %.666.i.i.i, %.676.i.i.i
  %.679.i.i.i = fcmp olt double %.619.i.i.i, %.677.i.i.i
  br i1 %.679.i.i.i, label %B518.i.i.i, label %B905.i.i.i

B518.i.i.i:                                       ; preds = %B310.i.i.i
  %switch.tableidx9357 = add i64 %.494.sroa.0.0392.i.i.i, 9
  %264 = icmp ult i64 %switch.tableidx9357, 18
  br i1 %264, label %switch.lookup9358, label %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B724.i.i.i:                                       ; preds = %switch.lookup9370
  %.888.i.i.i = fneg double %.829.i.i.i
  %.892.i.i.i = fmul double %.878.i.i.i, 5.000000e-01
  %.897.i.i.i = fdiv double %.892.i.i.i, %.861.i.i.i
  %.898.i.i.i = fcmp ogt double %.897.i.i.i, %.888.i.i.i
  %.908.i.i.i = fcmp olt double %.897.i.i.i, %.755.i.i.i
  %or.cond349.i.i.i = and i1 %.898.i.i.i, %.908.i.i.i
  br i1 %or.cond349.i.i.i, label %B764.i.i.i, label %B905.i.i.i

B764.i.i.i:                                       ; preds = %B724.i.i.i
  %.935.i.i.i = fmul double %.878.i.i.i, 2.500000e-01
  %.937.i.i.i = fmul double %.878.i.i.i, %.935.i.i.i
  %.944.i.i.i8967 = fdiv double %.937.i.i.i, %.861.i.i.i
  %.948.i.i.i = fsub double %.619.i.i.i, %.944.i.i.i8967
  %.10.i.i.i.i8968 = fcmp olt double %.948.i.i.i, %nearest.4.1389.i.i.i
  %.11.i.i.i.i8969 = select i1 %.10.i.i.i.i8968, double %.948.i.i.i, double %nearest.4.1389.i.i.i
  br label %B905.i.i.i

B830.i.i.i:                                       ; preds = %B905.i.i.i, %B274.i.i.i
  %nearest.4.1.lcssa.i.i.i = phi double [ %nearest.3.1.lcssa.i.i.i, %B274.i.i.i ], [ %nearest.5.2.i.i.i, %B905.i.i.i ]
  %.1049.i.i.i = load double, ptr %.1048.i.i.i, align 8, !noalias !146
  %.1051.i.i.i = fcmp ule double %.11.i.i.3.i.i.i, %.1049.i.i.i
  %.1054.i.i.i = fmul double %.11.i.i.3.i.i.i, 1.000000e+01
  %.1058.i.i.i = fcmp ugt double %nearest.4.1.lcssa.i.i.i, %.1054.i.i.i
  %or.cond.i.i.i = select i1 %.1051.i.i.i, i1 true, i1 %.1058.i.i.i
  br i1 %or.cond.i.i.i, label %B50.i.i.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B905.i.i.i:                                       ; preds = %switch.lookup9370, %B764.i.i.i, %B724.i.i.i, %B310.i.i.i
  %nearest.5.2.i.i.i = phi double [ %nearest.4.1389.i.i.i, %B724.i.i.i ], [ %.11.i.i.i.i8969, %B764.i.i.i ], [ %nearest.4.1389.i.i.i, %B310.i.i.i ], [ %nearest.4.1389.i.i.i, %switch.lookup9370 ]
  %.504.i.i.i = icmp sgt i64 %.450.1391.i.i.i, 0
  %.517.i.i.i = zext i1 %.504.i.i.i to i64
  %.447.1.i.i.i = add i64 %.447.1390.i.i.i, %.517.i.i.i
  %.513.i.i.i = sext i1 %.504.i.i.i to i64
  %.450.1.i.i.i = add nsw i64 %.450.1391.i.i.i, %.513.i.i.i
  %.494.sroa.0.0.i.i.i = select i1 %.504.i.i.i, i64 %.447.1390.i.i.i, i64 0
  br i1 %.504.i.i.i, label %B310.i.i.i, label %B830.i.i.i

B52.if.i.i.i:                                     ; preds = %B50.i.i.i
  %.222.i.i.i.i = load double, ptr %.221.i.i.i.i, align 8, !noalias !150
  %.488.i.i.i.i = load double, ptr %.487.i.i.i.i, align 8, !noalias !150
  %.489.i.i.i.i = fmul double %.488.i.i.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i.i.i = fsub double %.222.i.i.i.i, %.489.i.i.i.i
  %.488.i.1.i.i.i = load double, ptr %.487.i.1.i.i.i, align 8, !noalias !150
  %.489.i.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i.i.i = fsub double %.491.i.i.i.i, %.489.i.1.i.i.i
  %.488.i.2.i.i.i = load double, ptr %.487.i.2.i.i.i, align 8, !noalias !150
  %.489.i.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1306AA3D795F4
  %265 = fadd double %.491.i.1.i.i.i, %.489.i.2.i.i.i
  %.488.i.3.i.i.i = load double, ptr %.487.i.3.i.i.i, align 8, !noalias !150
  %.489.i.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i.i.i = fsub double %265, %.489.i.3.i.i.i
  %.488.i.4.i.i.i = load double, ptr %.487.i.4.i.i.i, align 8, !noalias !150
  %.489.i.4.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA4EAF2D6B11E79
  %266 = fadd double %.491.i.3.i.i.i, %.489.i.4.i.i.i
  %.502.i.i.i.i = tail call double @llvm.fabs.f64(double %266)
  %.10.i.i.i.i.i = fcmp ogt double %.502.i.i.i.i, 0.000000e+00
  %.11.i.i.i.i.i = select i1 %.10.i.i.i.i.i, double %.502.i.i.i.i, double 0.000000e+00
  %.222.i.1.i.i.i = load double, ptr %.221.i.1.i.i.i, align 8, !noalias !150
  %.489.i.1429.i.i.i = fmul double %.488.i.i.i.i, 0x3FA5118805F8B876
  %267 = fadd double %.489.i.1429.i.i.i, %.222.i.1.i.i.i
  %.489.i.1.1.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i.i.i = fsub double %267, %.489.i.1.1.i.i.i
  %.489.i.2.1.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i.i.i = fsub double %.491.i.1.1.i.i.i, %.489.i.2.1.i.i.i
  %.489.i.3.1.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FC0DA0C684D1D67
  %268 = fadd double %.489.i.3.1.i.i.i, %.491.i.2.1.i.i.i
  %.489.i.4.1.i.i.i = fmul double %.488.i.4.i.i.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i.i.i = fsub double %268, %.489.i.4.1.i.i.i
  %.502.i.1.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i.i.i)
  %.10.i.i.1.i.i.i = fcmp ogt double %.502.i.1.i.i.i, %.11.i.i.i.i.i
  %.11.i.i.1.i.i.i = select i1 %.10.i.i.1.i.i.i, double %.502.i.1.i.i.i, double %.11.i.i.i.i.i
  %.222.i.2.i.i.i = load double, ptr %.221.i.2.i.i.i, align 8, !noalias !150
  %.489.i.2456.i.i.i = fmul double %.488.i.i.i.i, 0x3F9635A30F8F142F
  %.491.i.2457.i.i.i = fsub double %.222.i.2.i.i.i, %.489.i.2456.i.i.i
  %.489.i.1.2.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FC1EAE0FF33D241
  %269 = fadd double %.489.i.1.2.i.i.i, %.491.i.2457.i.i.i
  %.489.i.2.2.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1625D59218460
  %.491.i.2.2.i.i.i = fsub double %269, %.489.i.2.2.i.i.i
  %.489.i.3.2.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i.i.i = fsub double %.491.i.2.2.i.i.i, %.489.i.3.2.i.i.i
  %.489.i.4.2.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FA55161A739EB34
  %270 = fadd double %.489.i.4.2.i.i.i, %.491.i.3.2.i.i.i
  %.502.i.2.i.i.i = tail call double @llvm.fabs.f64(double %270)
  %.10.i.i.2.i.i.i = fcmp ogt double %.502.i.2.i.i.i, %.11.i.i.1.i.i.i
  %.11.i.i.2.i.i.i = select i1 %.10.i.i.2.i.i.i, double %.502.i.2.i.i.i, double %.11.i.i.1.i.i.i
  %.222.i.3.i.i.i = load double, ptr %.221.i.3.i.i.i, align 8, !noalias !150
  %.489.i.3483.i.i.i = fmul double %.488.i.i.i.i, 0x3FA4F0C0BB579409
  %271 = fadd double %.489.i.3483.i.i.i, %.222.i.3.i.i.i
  %.489.i.1.3.i.i.i = fmul double %.488.i.1.i.i.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i.i.i = fsub double %271, %.489.i.1.3.i.i.i
  %.489.i.2.3.i.i.i = fmul double %.488.i.2.i.i.i, 0x3FE1F2DB6FEE3151
  %272 = fadd double %.489.i.2.3.i.i.i, %.491.i.1.3.i.i.i
  %.489.i.3.3.i.i.i = fmul double %.488.i.3.i.i.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i.i.i = fsub double %272, %.489.i.3.3.i.i.i
  %.489.i.4.3.i.i.i = fmul double %.488.i.4.i.i.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i.i.i = fsub double %.491.i.3.3.i.i.i, %.489.i.4.3.i.i.i
  %.502.i.3.i.i.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i.i.i)
  %.10.i.i.3.i.i.i = fcmp ogt double %.502.i.3.i.i.i, %.11.i.i.2.i.i.i
  %.11.i.i.3.i.i.i = select i1 %.10.i.i.3.i.i.i, double %.502.i.3.i.i.i, double %.11.i.i.2.i.i.i
  br i1 %.309379.not.i.i.i, label %B274.i.i.i, label %B212.if.i.i.i

B212.if.i.i.i:                                    ; preds = %B52.if.i.i.i, %B212.if.i.i.i
  %nearest.3.1382.i.i.i = phi double [ %.11.i352.i.i.i, %B212.if.i.i.i ], [ 0x7FF0000000000000, %B52.if.i.i.i ]
  %.256.0381.i.i.i = phi i64 [ %.318.i.i.i, %B212.if.i.i.i ], [ %storemerge.i.i.i, %B52.if.i.i.i ]
  %.253.0380.i.i.i = phi i64 [ %.322.i.i.i, %B212.if.i.i.i ], [ 1, %B52.if.i.i.i ]
  %.318.i.i.i = add nsw i64 %.256.0381.i.i.i, -1
  %.322.i.i.i = add nsw i64 %.253.0380.i.i.i, 1
  %273 = mul nsw i64 %.253.0380.i.i.i, %.30.i.i.i
  %.350.i.i.i = add nsw i64 %273, %.160.i.i.i
  %.364.i.i.i = icmp slt i64 %.350.i.i.i, 0
  %.365.i.i.i = select i1 %.364.i.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %274 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.350.i.i.i
  %.379.i.i.i = getelementptr double, ptr %274, i64 %.365.i.i.i
  %.380.i.i.i = load double, ptr %.379.i.i.i, align 8, !noalias !146
  %.10.i351.i.i.i = fcmp olt double %.380.i.i.i, %nearest.3.1382.i.i.i
  %.11.i352.i.i.i = select i1 %.10.i351.i.i.i, double %.380.i.i.i, double %nearest.3.1382.i.i.i
  %.309.i.i.i8964 = icmp sgt i64 %.256.0381.i.i.i, 1
  br i1 %.309.i.i.i8964, label %B212.if.i.i.i, label %B274.i.i.i

switch.lookup9358:                                ; preds = %B518.i.i.i
  %switch.tableidx9361 = add i64 %.494.sroa.0.0392.i.i.i, 8
  %275 = icmp ult i64 %switch.tableidx9361, 18
  br i1 %275, label %switch.lookup9362, label %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9362:                                ; preds = %switch.lookup9358
  %switch.gep9359 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx9357
  %switch.load9360 = load double, ptr %switch.gep9359, align 8
  %switch.gep9363 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx9361
  %switch.load9364 = load double, ptr %switch.gep9363, align 8
  %.755.i.i.i = fsub double %switch.load9360, %switch.load9364
  %switch.tableidx9365 = add i64 %.494.sroa.0.0392.i.i.i, 10
  %276 = icmp ult i64 %switch.tableidx9365, 18
  br i1 %276, label %switch.lookup9366, label %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9366:                                ; preds = %switch.lookup9362
  %switch.tableidx9369 = add i64 %.494.sroa.0.0392.i.i.i, 9
  %277 = icmp ult i64 %switch.tableidx9369, 18
  br i1 %277, label %switch.lookup9370, label %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

switch.lookup9370:                                ; preds = %switch.lookup9366
  %switch.gep9367 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx9365
  %switch.load9368 = load double, ptr %switch.gep9367, align 8
  %switch.gep9371 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx9369
  %switch.load9372 = load double, ptr %switch.gep9371, align 8
  %.829.i.i.i = fsub double %switch.load9368, %switch.load9372
  %.845.i.i.i = fdiv double %.673.i.i.i, %.829.i.i.i
  %.848.i.i.i = fsub double %.619.i.i.i, %.584.i.i.i
  %.853.i.i.i = fdiv double %.848.i.i.i, %.755.i.i.i
  %.854.i.i.i = fsub double %.845.i.i.i, %.853.i.i.i
  %.857.i.i.i = fadd double %.755.i.i.i, %.829.i.i.i
  %.861.i.i.i = fdiv double %.854.i.i.i, %.857.i.i.i
  %.877.i.i.i = fmul double %.755.i.i.i, %.861.i.i.i
  %.878.i.i.i = fadd double %.853.i.i.i, %.877.i.i.i
  %.883.i.i.i = fcmp ogt double %.861.i.i.i, 0.000000e+00
  br i1 %.883.i.i.i, label %B724.i.i.i, label %B905.i.i.i

_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B830.i.i.i, %B50.i.i.i, %B518.i.i.i, %switch.lookup9358, %switch.lookup9362, %switch.lookup9366
  %.1897.not.i.i = phi i1 [ true, %B518.i.i.i ], [ true, %switch.lookup9366 ], [ true, %switch.lookup9362 ], [ true, %switch.lookup9358 ], [ %exitcond.not.i.i.i, %B50.i.i.i ], [ %exitcond.not.i.i.i, %B830.i.i.i ]
  %excinfo.3.3.i.i = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.100, %B518.i.i.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.100, %switch.lookup9366 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.100, %switch.lookup9362 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16.100, %switch.lookup9358 ], [ %excinfo.3.01300.i.i, %B50.i.i.i ], [ %excinfo.3.01300.i.i, %B830.i.i.i ]
  %.1886.not.i.i = phi i1 [ false, %B518.i.i.i ], [ false, %switch.lookup9366 ], [ false, %switch.lookup9362 ], [ false, %switch.lookup9358 ], [ true, %B50.i.i.i ], [ true, %B830.i.i.i ]
  br i1 %.1886.not.i.i, label %B1170.endif.endif.i.i, label %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, !prof !53

B1208.i.i:                                        ; preds = %B1170.endif.endif.i.i
  %.1972.i.i = fmul double %.1861.i.i, 5.000000e-01
  store double 0.000000e+00, ptr %.1257.i.i, align 8, !noalias !154
  %.161.i230.i.i = getelementptr double, ptr %72, i64 %.1011.i.i
  store double 0.000000e+00, ptr %.161.i230.i.i, align 8, !noalias !154
  %.214.i273.i.i = getelementptr double, ptr %73, i64 %.1011.i.i
  store double %.1972.i.i, ptr %.214.i273.i.i, align 8, !noalias !154
  %.268.i313.i.i = load i64, ptr %.1197.i.i, align 8, !noalias !154
  %.294.i.i.i = icmp slt i64 %.268.i313.i.i, 0
  %.295.i.i.i = select i1 %.294.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i324.i.i = add i64 %.295.i.i.i, %.268.i313.i.i
  %.316.i333.i.i = mul i64 %.296.i324.i.i, %arg.batch.3.3.5.1
  %.320.i.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i333.i.i
  %.321.i.i.i = load i64, ptr %.320.i.i.i, align 8, !noalias !154
  %.322.i336.i.i = add nsw i64 %.321.i.i.i, -1
  store i64 %.322.i336.i.i, ptr %.320.i.i.i, align 8, !noalias !154
  %.426.i.i.i = load i64, ptr %.1197.i.i, align 8, !noalias !154
  %.452.i.i.i = icmp slt i64 %.426.i.i.i, 0
  %.453.i.i.i = select i1 %.452.i.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i.i8965 = add i64 %.453.i.i.i, %.426.i.i.i
  %.474.i.i.i = mul i64 %.454.i.i.i8965, %arg.batch.3.3.5.1
  %278 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i.i
  %.478.i.i.i = getelementptr i8, ptr %278, i64 24
  %.479.i.i.i = load i64, ptr %.478.i.i.i, align 8, !noalias !154
  %.480.i.i.i = add nsw i64 %.479.i.i.i, 1
  store i64 %.480.i.i.i, ptr %.478.i.i.i, align 8, !noalias !154
  store i64 -1, ptr %.1087.i.i, align 8, !noalias !138
  br label %B1300.i.i

B1300.i.i:                                        ; preds = %B1170.endif.endif.i.i, %B996.i.i, %B1208.i.i, %B1122.i.i
  %excinfo.3.2.i.i = phi ptr [ %excinfo.3.3.i.i, %B1170.endif.endif.i.i ], [ %excinfo.3.3.i.i, %B1208.i.i ], [ %excinfo.3.01300.i.i, %B1122.i.i ], [ %excinfo.3.01300.i.i, %B996.i.i ]
  br i1 %some.2.01301.i.i, label %B1342.i.i, label %B1304.i.i

B1304.i.i:                                        ; preds = %B1300.i.i
  %.2136.i.i = load i64, ptr %.1087.i.i, align 8, !noalias !138
  %.2137.i.i = icmp sgt i64 %.2136.i.i, -1
  br label %B1342.i.i

B1342.i.i:                                        ; preds = %B1304.i.i, %B1300.i.i, %B702.i.i8960, %B584.i.i
  %excinfo.3.1.i.i = phi ptr [ %excinfo.3.2.i.i, %B1300.i.i ], [ %excinfo.3.2.i.i, %B1304.i.i ], [ %excinfo.3.01300.i.i, %B702.i.i8960 ], [ %excinfo.3.01300.i.i, %B584.i.i ]
  %some.3.1.i.i = phi i1 [ true, %B1300.i.i ], [ %.2137.i.i, %B1304.i.i ], [ %some.2.01301.i.i, %B702.i.i8960 ], [ %some.2.01301.i.i, %B584.i.i ]
  %.934.i.i = icmp sgt i64 %.880.11303.i.i, 0
  %.947.i.i = zext i1 %.934.i.i to i64
  %.877.1.i.i = add i64 %.877.11302.i.i, %.947.i.i
  %.943.i.i = sext i1 %.934.i.i to i64
  %.880.1.i.i = add nsw i64 %.880.11303.i.i, %.943.i.i
  %.924.sroa.0.0.i.i = select i1 %.934.i.i, i64 %.877.11302.i.i, i64 0
  br i1 %.934.i.i, label %B584.i.i, label %B1346.loopexit.i.i

B1346.loopexit.i.i:                               ; preds = %B1342.i.i
  %279 = xor i1 %some.3.1.i.i, true
  br label %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i

B246.if.i.i:                                      ; preds = %B348.i.i8946, %B116.loopexit.8.i
  %.344.01295.i.i = phi i64 [ %.354.i.i, %B116.loopexit.8.i ], [ %.408.i.i, %B348.i.i8946 ]
  %.341.01294.i.i = phi i64 [ %..i.i, %B116.loopexit.8.i ], [ %.412.i.i, %B348.i.i8946 ]
  %.408.i.i = add nsw i64 %.344.01295.i.i, -1
  %.412.i.i = add nsw i64 %.341.01294.i.i, 1
  br i1 %.5201291.not.i.i, label %B348.i.i8946, label %B280.if.i.i.preheader

B280.if.i.i.preheader:                            ; preds = %B246.if.i.i
  %280 = icmp ult i64 %.341.01294.i.i, 8
  %switch.gep9374 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.13, i64 %.341.01294.i.i
  br label %B280.if.i.i

B280.if.i.i:                                      ; preds = %B280.if.i.i.preheader, %B280.loopexit.i.i
  %.464.01292.i.i = phi i64 [ %.533.i.i, %B280.loopexit.i.i ], [ 0, %B280.if.i.i.preheader ]
  %.533.i.i = add nsw i64 %.464.01292.i.i, 1
  br i1 %280, label %switch.lookup9373, label %switch.end.i.i

switch.lookup9373:                                ; preds = %B280.if.i.i
  %switch.load9375 = load double, ptr %switch.gep9374, align 8
  br label %switch.end.i.i

switch.end.i.i:                                   ; preds = %B280.if.i.i, %switch.lookup9373
  %.575.i.i = phi double [ %switch.load9375, %switch.lookup9373 ], [ 1.000000e+00, %B280.if.i.i ]
  %.92.i.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.464.01292.i.i
  %.93.i.i.i = load double, ptr %.92.i.i.i, align 8, !noalias !157
  %.146.i.i.i = getelementptr double, ptr %66, i64 %.464.01292.i.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !157
  %.149.i.i.i = fmul double %.575.i.i, %.147.i.i.i
  %.150.i.i.i8974 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.464.01292.i.i
  store double %.150.i.i.i8974, ptr %.203.i.i.i, align 8, !noalias !157
  br i1 %.287.i1288.not.i.i, label %B280.loopexit.i.i, label %B122.if.i.lr.ph.i.i

B122.if.i.lr.ph.i.i:                              ; preds = %switch.end.i.i
  %.247.i.i.i.i = fsub double 1.000000e+00, %.575.i.i
  %invariant.gep.i8975 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.464.01292.i.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.lr.ph.i.i
  %.229.i.01289.i.i = phi i64 [ 0, %B122.if.i.lr.ph.i.i ], [ %.300.i.i.i, %B122.if.i.i.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep.i, align 8, !noalias !161
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.575.i.i, %.193.i.i.i.i
  %.157.i.i.1.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.1.i.i
  %.159.i.i.1.i.i = mul nsw i64 %.157.i.i.1.i.i, %arg.shape.0
  %gep609.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.1.i.i
  %.191.i.i.1.i.i = load double, ptr %gep609.i, align 8, !noalias !161
  %.193.i.i.1.i.i = fadd double %.191.i.i.1.i.i, %.253.i.i.i.i
  %.253.i.i.1.i.i = fmul double %.247.i.i.i.i, %.193.i.i.1.i.i
  %.157.i.i.2.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.2.i.i
  %.159.i.i.2.i.i = mul nsw i64 %.157.i.i.2.i.i, %arg.shape.0
  %gep611.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.2.i.i
  %.191.i.i.2.i.i = load double, ptr %gep611.i, align 8, !noalias !161
  %.193.i.i.2.i.i = fadd double %.191.i.i.2.i.i, %.253.i.i.1.i.i
  %.253.i.i.2.i.i = fmul double %.575.i.i, %.193.i.i.2.i.i
  %.157.i.i.3.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.3.i.i
  %.159.i.i.3.i.i = mul nsw i64 %.157.i.i.3.i.i, %arg.shape.0
  %gep613.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.3.i.i
  %.191.i.i.3.i.i = load double, ptr %gep613.i, align 8, !noalias !161
  %.193.i.i.3.i.i = fadd double %.191.i.i.3.i.i, %.253.i.i.2.i.i
  %.253.i.i.3.i.i = fmul double %.247.i.i.i.i, %.193.i.i.3.i.i
  %.157.i.i.4.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.4.i.i
  %.159.i.i.4.i.i = mul nsw i64 %.157.i.i.4.i.i, %arg.shape.0
  %gep615.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.4.i.i
  %.191.i.i.4.i.i = load double, ptr %gep615.i, align 8, !noalias !161
  %.193.i.i.4.i.i = fadd double %.191.i.i.4.i.i, %.253.i.i.3.i.i
  %.253.i.i.4.i.i = fmul double %.575.i.i, %.193.i.i.4.i.i
  %.157.i.i.5.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.5.i.i
  %.159.i.i.5.i.i = mul nsw i64 %.157.i.i.5.i.i, %arg.shape.0
  %gep617.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.5.i.i
  %.191.i.i.5.i.i = load double, ptr %gep617.i, align 8, !noalias !161
  %.193.i.i.5.i.i = fadd double %.191.i.i.5.i.i, %.253.i.i.4.i.i
  %.253.i.i.5.i.i = fmul double %.247.i.i.i.i, %.193.i.i.5.i.i
  %.157.i.i.6.i.i = add nsw i64 %.229.i.01289.i.i, %.155.i.i.6.i.i
  %.159.i.i.6.i.i = mul nsw i64 %.157.i.i.6.i.i, %arg.shape.0
  %gep619.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.159.i.i.6.i.i
  %.191.i.i.6.i.i = load double, ptr %gep619.i, align 8, !noalias !161
  %.193.i.i.6.i.i = fadd double %.191.i.i.6.i.i, %.253.i.i.5.i.i
  %.253.i.i.6.i.i = fmul double %.575.i.i, %.193.i.i.6.i.i
  %.300.i.i.i = add nsw i64 %.229.i.01289.i.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i.01289.i.i, %arg.shape.0
  %gep621.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep621.i, align 8, !noalias !161
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.6.i.i
  %.359.i.i.i = add nsw i64 %.229.i.01289.i.i, %.358.i.i.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep623.i = getelementptr double, ptr %invariant.gep.i8975, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep623.i, align 8, !noalias !157
  %exitcond.not.i.i8976 = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond.not.i.i8976, label %B280.loopexit.i.i, label %B122.if.i.i.i

B1170.endif.endif.i.i:                            ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %.1897.not.i.i, label %B1300.i.i, label %B1208.i.i

_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i: ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1346.loopexit.i.i, %B550.i.i
  %.512.0.i = phi i1 [ %279, %B1346.loopexit.i.i ], [ true, %B550.i.i ], [ true, %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %excinfo.1.0.i = phi ptr [ null, %B1346.loopexit.i.i ], [ null, %B550.i.i ], [ %excinfo.3.3.i.i, %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %common.ret.op.i.i.not = phi i1 [ false, %B1346.loopexit.i.i ], [ false, %B550.i.i ], [ true, %_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %brmerge9160 = select i1 %common.ret.op.i.i.not, i1 true, i1 %.512.0.i, !prof !165
  %brmerge9161 = or i1 %.5201291.not.i.i, %brmerge9160
  %excinfo.1.0.i.mux.mux = select i1 %common.ret.op.i.i.not, ptr %excinfo.1.0.i, ptr %excinfo.13.0, !prof !166
  %.mux.mux = zext i1 %common.ret.op.i.i.not to i32
  br i1 %brmerge9161, label %_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B286.if.i8949, !prof !167

B328.i:                                           ; preds = %B286.if.i8949
  %281 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.634.0625.i
  %.84.i.i8951 = load i64, ptr %281, align 8, !noalias !168
  %.89.i.i8952 = icmp sgt i64 %.84.i.i8951, -1
  br i1 %.89.i.i8952, label %B46.i.i8953, label %B328.endif.i

B46.i.i8953:                                      ; preds = %B328.i
  %.120.i.i8954 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i8951
  %.121.i.i8955 = load i64, ptr %.120.i.i8954, align 8, !noalias !168
  %.122.i.i8956 = icmp eq i64 %.121.i.i8955, 0
  br i1 %.122.i.i8956, label %B80.i.i8957, label %B328.endif.i

B80.i.i8957:                                      ; preds = %B46.i.i8953
  store i64 4, ptr %.120.i.i8954, align 8, !noalias !168
  br label %B328.endif.i

B398.i:                                           ; preds = %B328.endif.i, %B286.if.i8949
  %exitcond629.not.i = icmp eq i64 %.703.i, %arg.shape.0
  br i1 %exitcond629.not.i, label %_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, label %B286.if.i8949

B150.if.i:                                        ; preds = %B3418, %B150.if.i
  %.361.0604.i = phi i64 [ %.430.i8943, %B150.if.i ], [ 0, %B3418 ]
  %.430.i8943 = add nsw i64 %.361.0604.i, 1
  %gep9265 = getelementptr double, ptr %invariant.gep9264, i64 %.361.0604.i
  store double 1.000000e-09, ptr %gep9265, align 8, !noalias !134
  %exitcond.not.i8944 = icmp eq i64 %arg.shape.0, %.430.i8943
  br i1 %exitcond.not.i8944, label %B150.if.1.i, label %B150.if.i

B286.if.i8949:                                    ; preds = %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i, %B398.i
  %.634.0625.i = phi i64 [ %.703.i, %B398.i ], [ 0, %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ]
  %.703.i = add nsw i64 %.634.0625.i, 1
  %282 = getelementptr i64, ptr %74, i64 %.634.0625.i
  %.785.i8950 = load i64, ptr %282, align 8, !noalias !134
  %.786.i = icmp sgt i64 %.785.i8950, -1
  br i1 %.786.i, label %B328.i, label %B398.i

B328.endif.i:                                     ; preds = %B80.i.i8957, %B46.i.i8953, %B328.i
  %283 = getelementptr double, ptr %75, i64 %.634.0625.i
  store double 0.000000e+00, ptr %283, align 8, !noalias !134
  br label %B398.i

_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit: ; preds = %B398.i, %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i
  %excinfo.13.2 = phi ptr [ %excinfo.1.0.i.mux.mux, %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ %excinfo.13.0, %B398.i ]
  %common.ret.op.i = phi i32 [ %.mux.mux, %_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit.i ], [ 0, %B398.i ]
  %.5011.not = icmp eq i32 %common.ret.op.i, 0
  br i1 %.5011.not, label %B3458, label %B3418.if, !prof !53

B3458:                                            ; preds = %B2888, %_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit, %B3414
  %excinfo.13.1 = phi ptr [ %excinfo.13.0, %B3414 ], [ %excinfo.13.2, %_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit ], [ %excinfo.13.0, %B2888 ]
  %brmerge8882.not = and i1 %good.2.1.lcssa, %looked.2.1.lcssa
  br i1 %brmerge8882.not, label %B3466, label %B3518

B3466:                                            ; preds = %B3458
  %brmerge8883.not = select i1 %within.5.1, i1 %.614, i1 false
  %"$phi3502.7.2.2" = select i1 %brmerge8883.not, i64 3, i64 0
  br i1 %.794, label %B3518, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i = getelementptr double, ptr %77, i64 %.180.0654.i
  %.453.i8980 = load double, ptr %.452.i, align 8, !noalias !171
  %.454.i8981 = fcmp olt double %.453.i8980, 5.000000e-01
  br i1 %.454.i8981, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i8982 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i8982, align 8, !noalias !171
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %284 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %284, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !171
  %.556.i = add nsw i64 %.554.i, %"$phi3502.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !171
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i = load double, ptr %.662.i, align 8, !noalias !171
  %.717.i = getelementptr double, ptr %78, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !171
  %.772.i = getelementptr double, ptr %79, i64 %.180.0654.i
  %.773.i = load double, ptr %.772.i, align 8, !noalias !171
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i = icmp slt i64 %.389.i, 0
  %.818.i8983 = select i1 %.817.i, i64 %arg.batch.2.5.0, i64 0
  %285 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i8984 = getelementptr double, ptr %285, i64 %.818.i8983
  %.833.i8985 = load double, ptr %.832.i8984, align 8, !noalias !171
  %.837.i = fcmp ugt double %.833.i8985, %.773.i
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %80, i64 %.180.0654.i
  %286 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9282 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9284 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9286 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9288 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9290 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9292 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9294 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9296 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9298 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i = icmp slt i64 %done.2.3.i, 0
  %.980.i = select i1 %.979.i, i64 %arg.batch.2.5.0, i64 0
  %287 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i = getelementptr double, ptr %287, i64 %.980.i
  %.1220.i = select i1 %.979.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %288 = getelementptr double, ptr %286, i64 %.1250.i
  br label %B474.if.i

B502.i:                                           ; preds = %B474.if.i
  %.1002.i8992 = add nsw i64 %.868.0650.i, %.1000.i8979
  %.1004.i = mul nsw i64 %.1002.i8992, %arg.shape.0
  %gep9299 = getelementptr double, ptr %invariant.gep9298, i64 %.1004.i
  %.1036.i = load double, ptr %gep9299, align 8, !noalias !171
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !171
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %81
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %289 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %289, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !171
  %.1379.i = fcmp ugt double %.1375.i, %.773.i
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !171
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3518, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i ]
  %290 = getelementptr double, ptr %288, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %290, align 8, !noalias !171
  %exitcond.not.i8991 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i8991, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3466, %B789.i
  %.180.0654.i = phi i64 [ %.252.i, %B789.i ], [ 0, %B3466 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !171
  %.388.i = getelementptr i64, ptr %76, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !171
  %.397.i = icmp slt i64 %.334.i, 0
  br i1 %.397.i, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i = load double, ptr %.994.i, align 8, !noalias !171
  %.997.i = fcmp oeq double %.995.i, %.773.i
  br i1 %.997.i, label %B502.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i, %.663.i
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i8986
  %.159.i.i8987 = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9283 = getelementptr double, ptr %invariant.gep9282, i64 %.159.i.i8987
  %.191.i.i8988 = load double, ptr %gep9283, align 8, !noalias !174
  %.193.i.i = fadd double %.191.i.i8988, 0.000000e+00
  %.253.i.i8989 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9285 = getelementptr double, ptr %invariant.gep9284, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9285, align 8, !noalias !174
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i8989
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9287 = getelementptr double, ptr %invariant.gep9286, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9287, align 8, !noalias !174
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9289 = getelementptr double, ptr %invariant.gep9288, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9289, align 8, !noalias !174
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9291 = getelementptr double, ptr %invariant.gep9290, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9291, align 8, !noalias !174
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9293 = getelementptr double, ptr %invariant.gep9292, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9293, align 8, !noalias !174
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9295 = getelementptr double, ptr %invariant.gep9294, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9295, align 8, !noalias !174
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i8990 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep9297 = getelementptr double, ptr %invariant.gep9296, i64 %.271.i.i8990
  %.309.i.i = load double, ptr %gep9297, align 8, !noalias !174
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
  %brmerge9329 = or i1 %.794, %brmerge8878.not.not
  br i1 %brmerge9329, label %B3692, label %B80.if.i4162

B134.i:                                           ; preds = %B80.if.i4162
  %.351.i3436 = getelementptr double, ptr %83, i64 %.141.i3231.09307
  %.352.i3437 = load double, ptr %.351.i3436, align 8, !noalias !178
  %.353.i3438 = fcmp ogt double %.352.i3437, 5.000000e-01
  br i1 %.353.i3438, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i3486 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3231.09307
  %.409.i3487 = load double, ptr %.408.i3486, align 8, !noalias !178
  %.463.i3535 = getelementptr double, ptr %84, i64 %.141.i3231.09307
  %.464.i3536 = load double, ptr %.463.i3535, align 8, !noalias !178
  %.465.i3537 = fsub double %.409.i3487, %.464.i3536
  br i1 %.552.i35759300.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep9388 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3231.09307
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i3587 = fmul double %.465.i3537, %fastest.2.i.2.lcssa
  %.698.i3613 = load double, ptr %.697.i3612, align 8, !noalias !178
  %.699.i3614 = fcmp ogt double %.666.i3587, %.698.i3613
  %.8887 = select i1 %.699.i3614, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i3643 = load double, ptr %.742.i3642, align 8, !noalias !178
  %.773.i3668 = load double, ptr %arg.batch.2.4, align 8, !noalias !178
  %.774.i3669 = fsub double %.743.i3643, %.773.i3668
  %.776.i3671 = fmul double %.8887, %.774.i3669
  %.780.i3674 = fcmp olt double %.465.i3537, %.776.i3671
  br i1 %.780.i3674, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %291 = getelementptr i64, ptr %86, i64 %.141.i3231.09307
  %.838.i4098 = load i64, ptr %291, align 8, !noalias !178
  %.839.i4099 = add nsw i64 %.838.i4098, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i4099, %B490.i ], [ 0, %B380.i ]
  %292 = getelementptr i64, ptr %87, i64 %.141.i3231.09307
  store i64 %"$phi528.1.2.i.2", ptr %292, align 8, !noalias !178
  %.959.i3769 = load double, ptr %.408.i3486, align 8, !noalias !178
  store double %.959.i3769, ptr %.463.i3535, align 8, !noalias !178
  %.1068.i3850 = getelementptr double, ptr %88, i64 %.141.i3231.09307
  store double 1.000000e+00, ptr %.1068.i3850, align 8, !noalias !178
  store i64 1, ptr %.1166, align 8, !noalias !178
  %.1154.i = load i64, ptr %292, align 8, !noalias !178
  %.1155.i = icmp sgt i64 %.1154.i, 1000
  br i1 %.1155.i, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %293 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3231.09307
  %.84.i.i3993 = load i64, ptr %293, align 8, !noalias !182
  %.89.i.i3996 = icmp sgt i64 %.84.i.i3993, -1
  br i1 %.89.i.i3996, label %B46.i.i4001, label %B740.i

B46.i.i4001:                                      ; preds = %B694.i
  %.120.i.i4021 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i3993
  %.121.i.i4022 = load i64, ptr %.120.i.i4021, align 8, !noalias !182
  %.122.i.i4023 = icmp eq i64 %.121.i.i4022, 0
  br i1 %.122.i.i4023, label %B80.i.i4028, label %B740.i

B80.i.i4028:                                      ; preds = %B46.i.i4001
  store i64 6, ptr %.120.i.i4021, align 8, !noalias !182
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i4028, %B694.i, %B46.i.i4001, %B528.i, %B134.i, %B80.if.i4162
  store double 0.000000e+00, ptr %.294.i3376, align 8, !noalias !178
  %.200.i3317 = icmp sgt i64 %.144.i3232.09306, 1
  br i1 %.200.i3317, label %B80.if.i4162, label %B3692

B80.if.i4162:                                     ; preds = %B3636, %B740.i
  %.141.i3231.09307 = phi i64 [ %.213.i4170, %B740.i ], [ 0, %B3636 ]
  %.144.i3232.09306 = phi i64 [ %.209.i4167, %B740.i ], [ %storemerge, %B3636 ]
  %.209.i4167 = add nsw i64 %.144.i3232.09306, -1
  %.213.i4170 = add nsw i64 %.141.i3231.09307, 1
  %.294.i3376 = getelementptr double, ptr %82, i64 %.141.i3231.09307
  %.295.i3377 = load double, ptr %.294.i3376, align 8, !noalias !178
  %.296.i3378 = fcmp oeq double %.295.i3377, 1.000000e+00
  br i1 %.296.i3378, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.29303 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i3248.09302 = phi i64 [ %.565.i4154, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i4154 = add nsw i64 %.496.i3248.09302, 1
  %.592.i4106 = add nsw i64 %.496.i3248.09302, %arg.shape.1
  %.594.i4108 = mul nsw i64 %.592.i4106, %arg.shape.0
  %gep9389 = getelementptr double, ptr %invariant.gep9388, i64 %.594.i4108
  %.626.i4136 = load double, ptr %gep9389, align 8, !noalias !178
  %.627.i4137 = tail call double @llvm.fabs.f64(double %.626.i4136)
  %.10.i.i = fcmp ogt double %.627.i4137, %fastest.2.i.29303
  %.11.i.i = select i1 %.10.i.i, double %.627.i4137, double %fastest.2.i.29303
  %exitcond9343.not = icmp eq i64 %arg.shape.1, %.565.i4154
  br i1 %exitcond9343.not, label %B380.i, label %B270.if.i

B3692:                                            ; preds = %B740.i, %B3636
  %brmerge8889.not = and i1 %.5358.not, %looked.2.1.lcssa
  %brmerge8889.not.not = xor i1 %brmerge8889.not, true
  %brmerge9328 = or i1 %.794, %brmerge8889.not.not
  br i1 %brmerge9328, label %B3742, label %B114.if.i

B46.i.i8994:                                      ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !185
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i9000, label %B228.i

B80.i.i9000:                                      ; preds = %B46.i.i8994
  %.196.i.i = getelementptr double, ptr %89, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !185
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i9000
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !185
  %.321.i.i9001 = getelementptr double, ptr %90, i64 %.302.01639.i
  %.322.i.i9002 = load double, ptr %.321.i.i9001, align 8, !noalias !185
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i9002
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i9003

B76.if.i.lr.ph.i9003:                             ; preds = %B122.i.i
  %294 = getelementptr i64, ptr %91, i64 %.302.01639.i
  %.513.i = load i64, ptr %294, align 8, !noalias !190
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %295 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i9004

B76.if.i.i9004:                                   ; preds = %B76.if.i.i9004, %B76.if.i.lr.ph.i9003
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i9003 ], [ %.188.i390.i, %B76.if.i.i9004 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %296 = getelementptr double, ptr %295, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %296, align 8, !noalias !191
  %297 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %297, align 8, !noalias !191
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %298 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %298, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !191
  %exitcond.not.i9005 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i9005, label %B228.i, label %B76.if.i.i9004

B228.i:                                           ; preds = %B76.if.i.i9004, %B114.if.i, %B122.i.i, %B80.i.i9000, %B46.i.i8994
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i ], [ %some.2.01641.i, %B80.i.i9000 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i8994 ], [ true, %B76.if.i.i9004 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3742

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !190
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !190
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !190
  %.896.i = inttoptr i64 %.780.i to ptr
  tail call void %.896.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i8995), !noalias !190
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i8996, align 8, !noalias !190
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i8995, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !190
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !195
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %89, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !195
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !195
  %.321.i223.i = getelementptr double, ptr %90, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !195
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %92, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !190
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %299 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %299, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !190
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
  %300 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %301 = getelementptr double, ptr %300, i64 %.1743.i
  %invariant.gep9308 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep9310 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %302 = getelementptr double, ptr %301, i64 %.1488.01643.i
  store double %.1622.i, ptr %302, align 8, !noalias !190
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %303 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %303, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %306, align 8, !noalias !198
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !198
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !198
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %304 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %304, align 8, !noalias !190
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %306, align 8, !noalias !201
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !201
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !201
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i8999 = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i8999, label %B598.if.i, label %B3742

B114.if.i:                                        ; preds = %B3692, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3692 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3692 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %305 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %305, align 8, !noalias !185
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i8994

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i8998, %B1076.i ], [ %storemerge.i8993, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i8998 = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %306 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %306, align 8, !noalias !195
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i = mul nsw i64 %.1588.i, %arg.shape.0
  %gep9309 = getelementptr double, ptr %invariant.gep9308, i64 %.1590.i
  %.1622.i = load double, ptr %gep9309, align 8, !noalias !190
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep9311 = getelementptr double, ptr %invariant.gep9310, i64 %.1637.i
  store double %.1622.i, ptr %gep9311, align 8, !noalias !190
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3742:                                            ; preds = %B1076.i, %B3692, %B230.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge9330 = or i1 %.794, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9330, label %B4718, label %B3784.if

B3832:                                            ; preds = %B3784.if
  %.5743 = mul i64 %.5670, %arg.batch.3.3.5.1
  %.5747 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5743
  %.5748 = load i64, ptr %.5747, align 8
  %.5804 = getelementptr i8, ptr %.5747, i64 24
  %.5805 = load i64, ptr %.5804, align 8
  %307 = add i64 %.5748, %.5805
  %.5806 = sub i64 %arg.most, %307
  %.5811 = icmp slt i64 %.5806, 1
  br i1 %.5811, label %B3912, label %B3958

B3912:                                            ; preds = %B3832
  %308 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5508.09316
  %.84.i4251 = load i64, ptr %308, align 8, !noalias !204
  %.89.i4254 = icmp sgt i64 %.84.i4251, -1
  br i1 %.89.i4254, label %B46.i4259, label %B3958

B46.i4259:                                        ; preds = %B3912
  %.120.i4285 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i4251
  %.121.i4286 = load i64, ptr %.120.i4285, align 8, !noalias !204
  %.122.i4287 = icmp eq i64 %.121.i4286, 0
  br i1 %.122.i4287, label %B80.i4292, label %B3958

B80.i4292:                                        ; preds = %B46.i4259
  store i64 5, ptr %.120.i4285, align 8, !noalias !204
  br label %B3958

B3958:                                            ; preds = %B80.i4292, %B3912, %B46.i4259, %B3832
  %.5901 = getelementptr double, ptr %93, i64 %.5508.09316
  %.5902 = load double, ptr %.5901, align 8
  %.5903 = fcmp ogt double %.5902, 5.000000e-01
  br i1 %.5903, label %B3996, label %B4100

B3996:                                            ; preds = %B3958
  %.5958 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5508.09316
  %.5959 = load double, ptr %.5958, align 8
  %.6013 = getelementptr double, ptr %94, i64 %.5508.09316
  %.6014 = load double, ptr %.6013, align 8
  %.6015 = fcmp oeq double %.5959, %.6014
  br i1 %.6015, label %B4060, label %B4100

B4060:                                            ; preds = %B3996
  %.192.i4518 = load i64, ptr %.5669, align 8, !noalias !207
  %.248.i4566 = getelementptr i64, ptr %95, i64 %.5508.09316
  %.249.i4567 = load i64, ptr %.248.i4566, align 8, !noalias !207
  %.250.i4568 = add nsw i64 %.249.i4567, 1
  store i64 %.250.i4568, ptr %.248.i4566, align 8, !noalias !207
  %.373.i4673 = icmp slt i64 %.249.i4567, -1
  %.374.i4674 = select i1 %.373.i4673, i64 %arg.batch.1.2.5.0, i64 0
  %309 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i4568
  %.388.i4688 = getelementptr double, ptr %309, i64 %.374.i4674
  %.389.i4689 = load double, ptr %.388.i4688, align 8, !noalias !207
  %.390.i4690 = fcmp oeq double %.389.i4689, 0x7FF0000000000000
  br i1 %.390.i4690, label %B182.i, label %B240.i

B182.i:                                           ; preds = %B4060
  %.424.i5207 = icmp slt i64 %.192.i4518, 0
  %.425.i5208 = select i1 %.424.i5207, i64 %arg.batch.3.1.5.0, i64 0
  %310 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i4518
  %.439.i5222 = getelementptr i64, ptr %310, i64 %.425.i5208
  %.440.i5223 = load i64, ptr %.439.i5222, align 8, !noalias !207
  %.441.i5224 = icmp eq i64 %.440.i5223, 0
  br i1 %.441.i5224, label %B216.i5228, label %B4100

B216.i5228:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i5222, align 8, !noalias !207
  br label %B4100

B240.i:                                           ; preds = %B4060
  store double %.389.i4689, ptr %.6013, align 8, !noalias !207
  %.592.i4780 = select i1 %.373.i4673, i64 %arg.batch.1.4.5.0, i64 0
  %311 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i4568
  %.606.i4794 = getelementptr i64, ptr %311, i64 %.592.i4780
  %.607.i4795 = load i64, ptr %.606.i4794, align 8, !noalias !207
  %.610.i4797 = icmp eq i64 %.607.i4795, 0
  br i1 %.610.i4797, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i
  %.665.i5161 = getelementptr double, ptr %96, i64 %.5508.09316
  store double 1.000000e+00, ptr %.665.i5161, align 8, !noalias !207
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i
  %.733.i4823 = load i64, ptr %.1166, align 8, !noalias !207
  %.734.i4824 = icmp eq i64 %.733.i4823, 0
  br i1 %.734.i4824, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.1166, align 8, !noalias !207
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i49729312.not, label %B4100, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i5018 = select i1 %.373.i4673, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i5019 = add i64 %.237.i.i5018, %.250.i4568
  %.258.i.i5035 = mul i64 %.238.i.i5019, %arg.batch.1.3.5.1
  %312 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i5035
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4329.09314 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i5082, %B76.if.i.i ]
  %.188.i.i5082 = add nsw i64 %.117.i.i4329.09314, 1
  %313 = getelementptr double, ptr %312, i64 %.117.i.i4329.09314
  %.263.i.i5038 = load double, ptr %313, align 8, !noalias !211
  %314 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4329.09314
  %.293.i.i5054 = load i64, ptr %314, align 8, !noalias !211
  %.295.i.i5056 = mul nsw i64 %.293.i.i5054, %arg.shape.0
  %.297.i.i5058 = add nsw i64 %.295.i.i5056, %.5508.09316
  %.311.i.i5065 = icmp slt i64 %.297.i.i5058, 0
  %.312.i.i5066 = select i1 %.311.i.i5065, i64 %arg.batch.5.1.5.0, i64 0
  %315 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i5058
  %.326.i.i5076 = getelementptr double, ptr %315, i64 %.312.i.i5066
  store double %.263.i.i5038, ptr %.326.i.i5076, align 8, !noalias !211
  %exitcond9344.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i5082
  br i1 %exitcond9344.not, label %B4100, label %B76.if.i.i

B4100:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i5228, %B182.i, %B3996, %B3958
  %.6104 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5670
  %.6105 = load i64, ptr %.6104, align 8
  %.6106.not = icmp eq i64 %.6105, 0
  br i1 %.6106.not, label %B4242, label %B4134

B4134:                                            ; preds = %B4100
  %.6167 = getelementptr i64, ptr %97, i64 %.5508.09316
  %.6168 = load i64, ptr %.6167, align 8
  %.6198 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5670
  store i64 %.6168, ptr %.6198, align 8
  store i64 -1, ptr %.5669, align 8
  %.236.i9006 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !215
  %.293.i9011 = getelementptr double, ptr %98, i64 %.5508.09316
  store double 0.000000e+00, ptr %.293.i9011, align 8, !noalias !215
  %.324.i9013 = load i64, ptr %.323.i9012, align 8, !noalias !215
  %.326.i9014 = icmp eq i64 %.236.i9006, %.324.i9013
  br i1 %.326.i9014, label %B4450, label %B132.i9015

B132.i9015:                                       ; preds = %B4134
  %.359.i9016 = add nsw i64 %.236.i9006, 1
  store i64 %.359.i9016, ptr %arg.batch.4.2.4, align 8, !noalias !215
  store i64 1, ptr %.1166, align 8, !noalias !215
  %.438.i9018 = icmp slt i64 %.236.i9006, 0
  %.439.i9019 = select i1 %.438.i9018, i64 %arg.batch.0.2.5.0, i64 0
  %316 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i9006
  %.453.i9020 = getelementptr i64, ptr %316, i64 %.439.i9019
  %.454.i9021 = load i64, ptr %.453.i9020, align 8, !noalias !215
  %.469.i9022 = icmp slt i64 %.454.i9021, 0
  %.470.i9023 = select i1 %.469.i9022, i64 %arg.batch.1.0.5.0, i64 0
  %317 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i9021
  %.484.i9024 = getelementptr i64, ptr %317, i64 %.470.i9023
  %.485.i9025 = load i64, ptr %.484.i9024, align 8, !noalias !215
  store i64 %.236.i9006, ptr %.5669, align 8, !noalias !215
  %.595.i9029 = getelementptr i64, ptr %99, i64 %.5508.09316
  store i64 %.485.i9025, ptr %.595.i9029, align 8, !noalias !215
  store i64 1, ptr %.6167, align 8, !noalias !215
  %.709.i9033 = getelementptr i64, ptr %100, i64 %.5508.09316
  store i64 0, ptr %.709.i9033, align 8, !noalias !215
  br i1 %.8051131.not.i9034, label %B402.i9049, label %B358.if.lr.ph.i9035

B358.if.lr.ph.i9035:                              ; preds = %B132.i9015
  %.867.i9036 = select i1 %.438.i9018, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i9037 = add i64 %.867.i9036, %.236.i9006
  %.888.i9038 = mul i64 %.868.i9037, %arg.batch.0.1.5.1
  %318 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i9038
  %invariant.gep9390 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5508.09316
  br label %B358.if.i9039

B402.i9049:                                       ; preds = %B358.if.i9039, %B132.i9015
  br i1 %.175.i1134.not.i9050, label %B402.endif.i9068, label %B76.if.i.lr.ph.i9051

B76.if.i.lr.ph.i9051:                             ; preds = %B402.i9049
  %.990.i9052 = load i64, ptr %.595.i9029, align 8, !noalias !215
  %.236.i.i9053 = icmp slt i64 %.990.i9052, 0
  %.237.i.i9054 = select i1 %.236.i.i9053, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i9055 = add i64 %.237.i.i9054, %.990.i9052
  %.258.i.i9056 = mul i64 %.238.i.i9055, %arg.batch.1.3.5.1
  %319 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9056
  br label %B76.if.i.i9057

B76.if.i.i9057:                                   ; preds = %B76.if.i.i9057, %B76.if.i.lr.ph.i9051
  %.117.i.01135.i9058 = phi i64 [ 0, %B76.if.i.lr.ph.i9051 ], [ %.188.i.i9059, %B76.if.i.i9057 ]
  %.188.i.i9059 = add nsw i64 %.117.i.01135.i9058, 1
  %320 = getelementptr double, ptr %319, i64 %.117.i.01135.i9058
  %.263.i.i9060 = load double, ptr %320, align 8, !noalias !218
  %321 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i9058
  %.293.i.i9061 = load i64, ptr %321, align 8, !noalias !218
  %.295.i.i9062 = mul nsw i64 %.293.i.i9061, %arg.shape.0
  %.297.i.i9063 = add nsw i64 %.295.i.i9062, %.5508.09316
  %.311.i.i9064 = icmp slt i64 %.297.i.i9063, 0
  %.312.i.i9065 = select i1 %.311.i.i9064, i64 %arg.batch.5.1.5.0, i64 0
  %322 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i9063
  %.326.i.i9066 = getelementptr double, ptr %322, i64 %.312.i.i9065
  store double %.263.i.i9060, ptr %.326.i.i9066, align 8, !noalias !218
  %exitcond1142.not.i9067 = icmp eq i64 %.188.i.i9059, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i9067, label %B402.endif.i9068, label %B76.if.i.i9057

B888.i9156:                                       ; preds = %B580.if.i9084
  store double 0.000000e+00, ptr %.1877.i9153, align 8, !noalias !215
  br label %B4450

B358.if.i9039:                                    ; preds = %B358.if.i9039, %B358.if.lr.ph.i9035
  %.747.01132.i9040 = phi i64 [ 0, %B358.if.lr.ph.i9035 ], [ %.818.i9041, %B358.if.i9039 ]
  %.818.i9041 = add nsw i64 %.747.01132.i9040, 1
  %323 = getelementptr double, ptr %318, i64 %.747.01132.i9040
  %.893.i9042 = load double, ptr %323, align 8, !noalias !215
  %.895.i9043 = mul nsw i64 %.747.01132.i9040, %arg.shape.0
  %gep9391 = getelementptr double, ptr %invariant.gep9390, i64 %.895.i9043
  store double %.893.i9042, ptr %gep9391, align 8, !noalias !215
  %exitcond.not.i9048 = icmp eq i64 %.818.i9041, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i9048, label %B402.i9049, label %B358.if.i9039

B402.endif.i9068:                                 ; preds = %B76.if.i.i9057, %B402.i9049
  br i1 %.11171137.not.i9069, label %B580.if.i9084, label %B496.if.lr.ph.i9070

B496.if.lr.ph.i9070:                              ; preds = %B402.endif.i9068
  %.1179.i9071 = select i1 %.438.i9018, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i9072 = add i64 %.1179.i9071, %.236.i9006
  %.1200.i9073 = mul i64 %.1180.i9072, %arg.batch.0.0.5.1
  %324 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i9073
  %invariant.gep9392 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5508.09316
  br label %B496.if.i9074

B496.if.i9074:                                    ; preds = %B496.if.i9074, %B496.if.lr.ph.i9070
  %.1061.01138.i9075 = phi i64 [ 0, %B496.if.lr.ph.i9070 ], [ %.1130.i9076, %B496.if.i9074 ]
  %.1130.i9076 = add nsw i64 %.1061.01138.i9075, 1
  %325 = getelementptr double, ptr %324, i64 %.1061.01138.i9075
  %.1205.i9077 = load double, ptr %325, align 8, !noalias !215
  %.1207.i9078 = mul nsw i64 %.1061.01138.i9075, %arg.shape.0
  %gep9393 = getelementptr double, ptr %invariant.gep9392, i64 %.1207.i9078
  store double %.1205.i9077, ptr %gep9393, align 8, !noalias !215
  %exitcond1143.not.i9083 = icmp eq i64 %.1130.i9076, %arg.shape.1
  br i1 %exitcond1143.not.i9083, label %B580.if.i9084, label %B496.if.i9074

B580.if.i9084:                                    ; preds = %B496.if.i9074, %B402.endif.i9068
  %invariant.gep.i9085 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5508.09316
  store double 0.000000e+00, ptr %invariant.gep.i9085, align 8, !noalias !215
  %gep.1.i9086 = getelementptr double, ptr %invariant.gep.i9085, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i9086, align 8, !noalias !215
  %gep.2.i9088 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.2.idx.i9087
  store double 0.000000e+00, ptr %gep.2.i9088, align 8, !noalias !215
  %gep.3.i9090 = getelementptr i8, ptr %invariant.gep.i9085, i64 %.idx.i9010
  store double 0.000000e+00, ptr %gep.3.i9090, align 8, !noalias !215
  %gep.4.i9092 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.4.idx.i9091
  store double 0.000000e+00, ptr %gep.4.i9092, align 8, !noalias !215
  %gep.5.i9094 = getelementptr i8, ptr %invariant.gep.i9085, i64 %.idx8826
  store double 0.000000e+00, ptr %gep.5.i9094, align 8, !noalias !215
  %gep.6.i9096 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.6.idx.i9095
  store double 0.000000e+00, ptr %gep.6.i9096, align 8, !noalias !215
  %gep.7.i9098 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.7.idx.i9097
  store double 0.000000e+00, ptr %gep.7.i9098, align 8, !noalias !215
  %gep.8.i9100 = getelementptr i8, ptr %invariant.gep.i9085, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i9100, align 8, !noalias !215
  %gep.9.i9102 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.9.idx.i9101
  store double 0.000000e+00, ptr %gep.9.i9102, align 8, !noalias !215
  %gep.10.i9104 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.10.idx.i9103
  store double 0.000000e+00, ptr %gep.10.i9104, align 8, !noalias !215
  %gep.11.i9106 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.11.idx.i9105
  store double 0.000000e+00, ptr %gep.11.i9106, align 8, !noalias !215
  %gep.12.i9108 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.12.idx.i9107
  store double 0.000000e+00, ptr %gep.12.i9108, align 8, !noalias !215
  %gep.13.i9110 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.13.idx.i9109
  store double 0.000000e+00, ptr %gep.13.i9110, align 8, !noalias !215
  %gep.14.i9112 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.14.idx.i9111
  store double 0.000000e+00, ptr %gep.14.i9112, align 8, !noalias !215
  %gep.15.i9114 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.15.idx.i9113
  store double 0.000000e+00, ptr %gep.15.i9114, align 8, !noalias !215
  %gep.16.i9116 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.16.idx.i9115
  store double 0.000000e+00, ptr %gep.16.i9116, align 8, !noalias !215
  %gep.17.i9118 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.17.idx.i9117
  store double 0.000000e+00, ptr %gep.17.i9118, align 8, !noalias !215
  %gep.18.i9120 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.18.idx.i9119
  store double 0.000000e+00, ptr %gep.18.i9120, align 8, !noalias !215
  %gep.19.i9122 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.19.idx.i9121
  store double 0.000000e+00, ptr %gep.19.i9122, align 8, !noalias !215
  %gep.20.i9124 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.20.idx.i9123
  store double 0.000000e+00, ptr %gep.20.i9124, align 8, !noalias !215
  %gep.21.i9126 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.21.idx.i9125
  store double 0.000000e+00, ptr %gep.21.i9126, align 8, !noalias !215
  %gep.22.i9128 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.22.idx.i9127
  store double 0.000000e+00, ptr %gep.22.i9128, align 8, !noalias !215
  %gep.23.i9130 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.23.idx.i9129
  store double 0.000000e+00, ptr %gep.23.i9130, align 8, !noalias !215
  %gep.24.i9132 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.24.idx.i9131
  store double 0.000000e+00, ptr %gep.24.i9132, align 8, !noalias !215
  %gep.25.i9134 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.25.idx.i9133
  store double 0.000000e+00, ptr %gep.25.i9134, align 8, !noalias !215
  %gep.26.i9136 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.26.idx.i9135
  store double 0.000000e+00, ptr %gep.26.i9136, align 8, !noalias !215
  %gep.27.i9138 = getelementptr i8, ptr %invariant.gep.i9085, i64 %gep.27.idx.i9137
  store double 0.000000e+00, ptr %gep.27.i9138, align 8, !noalias !215
  %.1455.i9139 = load double, ptr %arg.batch.2.4, align 8, !noalias !215
  %.1516.i9140 = load i64, ptr %.595.i9029, align 8, !noalias !215
  %.1531.i9141 = icmp slt i64 %.1516.i9140, 0
  %.1532.i9142 = select i1 %.1531.i9141, i64 %arg.batch.1.2.5.0, i64 0
  %326 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i9140
  %.1546.i9143 = getelementptr double, ptr %326, i64 %.1532.i9142
  %.1547.i9144 = load double, ptr %.1546.i9143, align 8, !noalias !215
  store double %.1455.i9139, ptr %invariant.gep.i9085, align 8, !noalias !215
  %.1656.i9147 = getelementptr double, ptr %101, i64 %.5508.09316
  store double %.1547.i9144, ptr %.1656.i9147, align 8, !noalias !215
  store double 1.000000e+00, ptr %.293.i9011, align 8, !noalias !215
  %.1767.i9149 = getelementptr double, ptr %102, i64 %.5508.09316
  store double 0xFFF0000000000000, ptr %.1767.i9149, align 8, !noalias !215
  %.1822.i9151 = getelementptr double, ptr %103, i64 %.5508.09316
  store double 0x7FF0000000000000, ptr %.1822.i9151, align 8, !noalias !215
  %.1877.i9153 = getelementptr double, ptr %104, i64 %.5508.09316
  %.1878.i9154 = load double, ptr %.1877.i9153, align 8, !noalias !215
  %.1880.i9155 = fcmp ueq double %.1878.i9154, 0xFFF0000000000000
  br i1 %.1880.i9155, label %B4450, label %B888.i9156

B4242:                                            ; preds = %B4100
  %.6394 = getelementptr double, ptr %105, i64 %.5508.09316
  %.6395 = load double, ptr %.6394, align 8
  %.6397 = fcmp ult double %.6395, 1.500000e+01
  br i1 %.6397, label %B4450, label %B4290

B4290:                                            ; preds = %B4242
  %.6441 = load double, ptr %.6440, align 8
  %.6495 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5508.09316
  %.6496 = load double, ptr %.6495, align 8
  %.6497 = fsub double %.6441, %.6496
  %.6551 = getelementptr double, ptr %108, i64 %.5508.09316
  %.6552 = load double, ptr %.6551, align 8
  %.6554 = fmul double %.6552, 5.000000e+03
  %.6555 = fcmp ogt double %.6497, %.6554
  br i1 %.6555, label %B4450, label %B4426

B4426:                                            ; preds = %B4290
  store double 0.000000e+00, ptr %.6394, align 8
  br label %B4450

B4450:                                            ; preds = %B888.i9156, %B4134, %B580.if.i9084, %B4290, %B4426, %B4242
  %budget.7.4 = phi i64 [ %budget.5.29318, %B4242 ], [ 0, %B4290 ], [ %budget.5.29318, %B4426 ], [ %budget.5.29318, %B580.if.i9084 ], [ %budget.5.29318, %B4134 ], [ %budget.5.29318, %B888.i9156 ]
  %.6683 = load i64, ptr %.5669, align 8
  %.6684 = icmp sgt i64 %.6683, -1
  br i1 %.6684, label %B4488, label %B4745

B4488:                                            ; preds = %B4450
  %.6689 = add nsw i64 %active.5.29319, 1
  %.6798 = mul i64 %.6683, %arg.batch.3.3.5.1
  %.6802 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6798
  %.6803 = load i64, ptr %.6802, align 8
  %.6814.0 = and i64 %.6803, 127
  %.6844 = sub nsw i64 128, %.6814.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6844, i64 %.5806)
  %.6932 = getelementptr double, ptr %109, i64 %.5508.09316
  %.6933 = load double, ptr %.6932, align 8
  %.6935 = fcmp ogt double %.6933, 0.000000e+00
  %.6946 = sitofp i64 %.11.i to double
  %"$phi4658.1.2.5" = select i1 %.6935, double 1.000000e+00, double %.6946
  %.7009 = getelementptr double, ptr %110, i64 %.5508.09316
  store double %"$phi4658.1.2.5", ptr %.7009, align 8
  %.111.i5361 = getelementptr i64, ptr %111, i64 %.5508.09316
  %.112.i5362 = load i64, ptr %.111.i5361, align 8, !noalias !222
  %.169.i5411 = getelementptr double, ptr %112, i64 %.5508.09316
  %.170.i5412 = load double, ptr %.169.i5411, align 8, !noalias !222
  %.224.i5460 = getelementptr double, ptr %113, i64 %.5508.09316
  store double %.170.i5412, ptr %.224.i5460, align 8, !noalias !222
  %.237.i5468 = icmp slt i64 %.112.i5362, %arg.batch.2.5.0
  br i1 %.237.i5468, label %B134.i5473, label %B4745

B134.i5473:                                       ; preds = %B4488
  %.253.i5484 = icmp slt i64 %.112.i5362, 0
  %.254.i5485 = select i1 %.253.i5484, i64 %arg.batch.2.5.0, i64 0
  %327 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i5362
  %.268.i5499 = getelementptr double, ptr %327, i64 %.254.i5485
  %.269.i5500 = load double, ptr %.268.i5499, align 8, !noalias !222
  %.328.i5551 = load double, ptr %.169.i5411, align 8, !noalias !222
  %.10.i.i5558 = fcmp olt double %.328.i5551, %.269.i5500
  %.11.i.i5559 = select i1 %.10.i.i5558, double %.328.i5551, double %.269.i5500
  store double %.11.i.i5559, ptr %.224.i5460, align 8, !noalias !222
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
  br i1 %.794, label %B4744.endif, label %B80.if.i2041.lr.ph

B80.if.i2041.lr.ph:                               ; preds = %B4744
  %.idx = mul i64 %arg.batch.4.0.5.1, 184
  %328 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8824 = mul i64 %arg.batch.4.0.5.1, 192
  %329 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8824
  %.703.i1699 = add nsw i64 %arg.shape.2, -1
  %.idx8825 = mul i64 %arg.batch.4.0.5.1, 168
  %330 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8825
  br label %B80.if.i2041

B126.i1346:                                       ; preds = %B80.if.i2041
  %.318.i1393 = getelementptr double, ptr %328, i64 %.105.i1191.09326
  %.319.i1394 = load double, ptr %.318.i1393, align 8, !noalias !226
  %.5.i.i1395 = fptosi double %.319.i1394 to i64
  %.397.i1444 = getelementptr double, ptr %329, i64 %.105.i1191.09326
  %.398.i1445 = load double, ptr %.397.i1444, align 8, !noalias !226
  %.5.i1.i1446 = fptosi double %.398.i1445 to i64
  %.478.i1497 = mul i64 %.258.i1339, %arg.batch.3.3.5.1
  %.482.i1501 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.478.i1497
  %.483.i1502 = load i64, ptr %.482.i1501, align 8, !noalias !226
  %.485.i1504 = add nsw i64 %.483.i1502, %.5.i.i1395
  store i64 %.485.i1504, ptr %.482.i1501, align 8, !noalias !226
  %.591.i1599 = getelementptr i8, ptr %.482.i1501, i64 24
  %.592.i1600 = load i64, ptr %.591.i1599, align 8, !noalias !226
  %.594.i1602 = add nsw i64 %.592.i1600, %.5.i1.i1446
  store i64 %.594.i1602, ptr %.591.i1599, align 8, !noalias !226
  %.700.i1696 = getelementptr i8, ptr %.482.i1501, i64 8
  %.701.i1697 = load i64, ptr %.700.i1696, align 8, !noalias !226
  %.706.i1702 = add nsw i64 %.5.i1.i1446, %.5.i.i1395
  %.707.i1703 = mul nsw i64 %.706.i1702, %.703.i1699
  %..5.i.i1395 = select i1 %.625, i64 0, i64 %.5.i.i1395
  %.708.i1704 = add i64 %.707.i1703, %..5.i.i1395
  %.841.i1809 = add i64 %.708.i1704, %.701.i1697
  store i64 %.841.i1809, ptr %.700.i1696, align 8, !noalias !226
  store double 0.000000e+00, ptr %.318.i1393, align 8, !noalias !226
  store double 0.000000e+00, ptr %.397.i1444, align 8, !noalias !226
  %.1072.i1987 = getelementptr double, ptr %330, i64 %.105.i1191.09326
  %.1073.i1988 = load double, ptr %.1072.i1987, align 8, !noalias !226
  %.1081.i1994 = sitofp i64 %.706.i1702 to double
  %.1082.i1995 = fsub double %.1073.i1988, %.1081.i1994
  store double %.1082.i1995, ptr %.1072.i1987, align 8, !noalias !226
  br label %B568.i1343

B568.i1343:                                       ; preds = %B126.i1346, %B80.if.i2041
  %.163.i1272 = icmp sgt i64 %.108.i1192.09325, 1
  br i1 %.163.i1272, label %B80.if.i2041, label %B4744.endif

B80.if.i2041:                                     ; preds = %B80.if.i2041.lr.ph, %B568.i1343
  %.105.i1191.09326 = phi i64 [ 0, %B80.if.i2041.lr.ph ], [ %.176.i2048, %B568.i1343 ]
  %.108.i1192.09325 = phi i64 [ %storemerge, %B80.if.i2041.lr.ph ], [ %.172.i2045, %B568.i1343 ]
  %.172.i2045 = add nsw i64 %.108.i1192.09325, -1
  %.176.i2048 = add nsw i64 %.105.i1191.09326, 1
  %331 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1191.09326
  %.258.i1339 = load i64, ptr %331, align 8, !noalias !226
  %.263.i1342 = icmp sgt i64 %.258.i1339, -1
  br i1 %.263.i1342, label %B126.i1346, label %B568.i1343

B4745:                                            ; preds = %B4488, %B134.i5473, %B4450, %B3784.if
  %budget.6.3 = phi i64 [ %budget.5.29318, %B3784.if ], [ %budget.7.4, %B4450 ], [ %budget.7.4, %B134.i5473 ], [ %budget.7.4, %B4488 ]
  %active.6.3 = phi i64 [ %active.5.29319, %B3784.if ], [ %active.5.29319, %B4450 ], [ %.6689, %B134.i5473 ], [ %.6689, %B4488 ]
  %.5571 = icmp sgt i64 %.5511.09317, 1
  br i1 %.5571, label %B3784.if, label %B4718

common.ret:                                       ; preds = %B3418.if, %B3318.endif.if, %B2766.endif.if, %B4744.endif
  %common.ret.op = phi i32 [ %.4830, %B3318.endif.if ], [ %.4227, %B2766.endif.if ], [ 0, %B4744.endif ], [ %common.ret.op.i, %B3418.if ]
  ret i32 %common.ret.op

B416.if:                                          ; preds = %B416.if.lr.ph, %B502
  %active.4.09171 = phi i64 [ 0, %B416.if.lr.ph ], [ %.1089, %B502 ]
  %.783.09170 = phi i64 [ %storemerge, %B416.if.lr.ph ], [ %.847, %B502 ]
  %.780.09169 = phi i64 [ 0, %B416.if.lr.ph ], [ %.851, %B502 ]
  %.847 = add nsw i64 %.783.09170, -1
  %.851 = add nsw i64 %.780.09169, 1
  %332 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.09169
  %.933 = load i64, ptr %332, align 8
  %.934 = icmp slt i64 %.933, 0
  br i1 %.934, label %B458, label %B502

B1534.if:                                         ; preds = %B1502, %B1726
  %.2165.09186 = phi i64 [ %.2234, %B1726 ], [ 1, %B1502 ]
  %.2234 = add i64 %.2165.09186, 1
  %333 = getelementptr i64, ptr %arg.code.4, i64 %.2165.09186
  %334 = getelementptr i8, ptr %333, i64 128
  %.2293 = load i64, ptr %334, align 8
  %.2338 = inttoptr i64 %.2293 to ptr
  tail call void %.2338(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2344 = add nsw i64 %.2165.09186, %.
  %.2346 = mul nsw i64 %.2344, %.463
  %.2391 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2346
  tail call void %.2392(ptr %.571, ptr %.2366, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2391)
  br i1 %or.cond9162.not, label %B68.if.lr.ph.i, label %B1726

B1870.if:                                         ; preds = %B1728, %B1956
  %looked.2.19192 = phi i1 [ %"$phi1956.1.2.2", %B1956 ], [ %spec.select8891, %B1728 ]
  %good.2.19191 = phi i1 [ %"$phi1914.1.2.2", %B1956 ], [ false, %B1728 ]
  %.2611.09190 = phi i64 [ %.2673, %B1956 ], [ %storemerge, %B1728 ]
  %.2608.09189 = phi i64 [ %.2677, %B1956 ], [ 0, %B1728 ]
  %.2673 = add nsw i64 %.2611.09190, -1
  %.2677 = add nsw i64 %.2608.09189, 1
  br i1 %good.2.19191, label %B1914, label %B1878

B2030.if:                                         ; preds = %B2030.preheader, %B2536
  %checked.3.29202 = phi i1 [ %checked.4.3, %B2536 ], [ false, %B2030.preheader ]
  %within.3.29201 = phi i1 [ %within.4.3, %B2536 ], [ false, %B2030.preheader ]
  %.2966.09200 = phi i64 [ %.3034, %B2536 ], [ %storemerge, %B2030.preheader ]
  %.2963.09199 = phi i64 [ %.3038, %B2536 ], [ 0, %B2030.preheader ]
  %.3034 = add nsw i64 %.2966.09200, -1
  %.3038 = add nsw i64 %.2963.09199, 1
  %.3123 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.09199
  %.3124 = load i64, ptr %.3123, align 8
  %.3178 = getelementptr i64, ptr %38, i64 %.2963.09199
  %.3179 = load i64, ptr %.3178, align 8
  %.3239 = getelementptr double, ptr %39, i64 %.2963.09199
  store double 0.000000e+00, ptr %.3239, align 8
  %.3242 = icmp sgt i64 %.3124, -1
  br i1 %.3242, label %B2130, label %B2536

B46.i:                                            ; preds = %B2168
  %.120.i2143 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2117
  %.121.i2144 = load i64, ptr %.120.i2143, align 8, !noalias !50
  %.122.i2145 = icmp eq i64 %.121.i2144, 0
  br i1 %.122.i2145, label %B80.i2149, label %B2268

B80.i2149:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i2143, align 8, !noalias !50
  br label %B2268

B2766.endif.if:                                   ; preds = %B2766
  %.4228 = load ptr, ptr %excinfo.9, align 8
  store ptr %.4228, ptr %excinfo, align 8
  br label %common.ret

B2946.if:                                         ; preds = %B2898
  %.4418 = load i64, ptr %115, align 8
  %.4463 = inttoptr i64 %.4418 to ptr
  tail call void %.4463(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4494 = load i64, ptr %arg.code.4, align 8
  %.4544 = inttoptr i64 %.4494 to ptr
  tail call void %.4544(ptr %.571, ptr %.4518, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4543)
  %.4418.1 = load i64, ptr %116, align 8
  %.4463.1 = inttoptr i64 %.4418.1 to ptr
  tail call void %.4463.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4494.1 = load i64, ptr %arg.code.4, align 8
  %.4544.1 = inttoptr i64 %.4494.1 to ptr
  tail call void %.4544.1(ptr %.571, ptr %.4518, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4543.1)
  %.4418.2 = load i64, ptr %117, align 8
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

B3418.if:                                         ; preds = %_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.exit
  store ptr %excinfo.13.2, ptr %excinfo, align 8
  br label %common.ret

B3784.if:                                         ; preds = %B3742, %B4745
  %active.5.29319 = phi i64 [ %active.6.3, %B4745 ], [ 0, %B3742 ]
  %budget.5.29318 = phi i64 [ %budget.6.3, %B4745 ], [ %.1132, %B3742 ]
  %.5511.09317 = phi i64 [ %.5580, %B4745 ], [ %storemerge, %B3742 ]
  %.5508.09316 = phi i64 [ %.5584, %B4745 ], [ 0, %B3742 ]
  %.5580 = add nsw i64 %.5511.09317, -1
  %.5584 = add nsw i64 %.5508.09316, 1
  %.5669 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5508.09316
  %.5670 = load i64, ptr %.5669, align 8
  %.5675 = icmp slt i64 %.5670, 0
  br i1 %.5675, label %B4745, label %B3832

B4744.endif:                                      ; preds = %B568.i1343, %B4744
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
  %.5201291.not = icmp slt i64 %arg.shape.0, 1
  %factor.op.mul = mul i64 %arg.decided, 3
  %.idx1277 = mul i64 %arg.lane.0.5.1, 48
  %1 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1277
  %.idx1278 = shl i64 %arg.lane.0.5.1, 6
  %2 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1278
  %.287.i1288.not = icmp slt i64 %arg.shape.1, 1
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
  %exitcond1307.not = icmp eq i64 %arg.shape.0, %.533
  br i1 %exitcond1307.not, label %B348, label %B280.if

B348:                                             ; preds = %B280.loopexit, %B246.if
  %.634 = icmp ult i64 %.341.01294, 8
  %.1280 = select i1 %.634, i64 16, i64 17
  %.650 = mul i64 %.644.reass, %.341.01294
  %.707 = load i64, ptr %.706, align 8
  %.782 = mul i64 %.778, %.1280
  %.800 = getelementptr double, ptr %arg.arrays.0.4, i64 %.782
  %.825 = getelementptr double, ptr %arg.arrays.4.4, i64 %.650
  %.826 = inttoptr i64 %.707 to ptr
  tail call void %.826(ptr %.747, ptr %.800, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.825)
  %.399 = icmp sgt i64 %.344.01295, 1
  br i1 %.399, label %B246.if, label %B550

B550:                                             ; preds = %B348
  %.9341296 = icmp sgt i64 %arg.shape.0, 0
  br i1 %.9341296, label %B584.lr.ph, label %B1346

B584.lr.ph:                                       ; preds = %B550
  %.880.11299 = add nsw i64 %arg.shape.0, -1
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
  %.924.sroa.0.01304 = phi i64 [ 0, %B584.lr.ph ], [ %.924.sroa.0.0, %B1342 ]
  %.880.11303 = phi i64 [ %.880.11299, %B584.lr.ph ], [ %.880.1, %B1342 ]
  %.877.11302 = phi i64 [ 1, %B584.lr.ph ], [ %.877.1, %B1342 ]
  %some.2.01301 = phi i1 [ false, %B584.lr.ph ], [ %some.3.1, %B1342 ]
  %excinfo.3.01300 = phi ptr [ null, %B584.lr.ph ], [ %excinfo.3.1, %B1342 ]
  %.1009 = icmp slt i64 %.924.sroa.0.01304, 0
  %.1010 = select i1 %.1009, i64 %arg.lane.0.5.1, i64 0
  %.1011 = add i64 %.1010, %.924.sroa.0.01304
  %.1032 = getelementptr double, ptr %3, i64 %.1011
  %.1033 = load double, ptr %.1032, align 8
  %.1065 = select i1 %.1009, i64 %arg.lane.1.5.1, i64 0
  %.1066 = add i64 %.1065, %.924.sroa.0.01304
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
  %exitcond1308.not = icmp eq i64 %.51.i13.0, %storemerge1269
  br i1 %exitcond1308.not, label %B830.endif, label %B36.i

B36.i:                                            ; preds = %B34.i
  %.122.i103 = add i64 %.51.i13.0, 1
  %.157.i54 = add nsw i64 %.51.i13.0, %.155.i
  %.159.i = mul nsw i64 %.157.i54, %arg.shape.0
  %.161.i = add nsw i64 %.159.i, %.924.sroa.0.01304
  %.175.i63 = icmp slt i64 %.161.i, 0
  %.176.i64 = select i1 %.175.i63, i64 %arg.arrays.4.5.0, i64 0
  %12 = getelementptr double, ptr %arg.arrays.4.4, i64 %.161.i
  %.190.i = getelementptr double, ptr %12, i64 %.176.i64
  %.191.i = load double, ptr %.190.i, align 8, !noalias !230
  %.195.i80 = add nsw i64 %.161.i, %.194.i79
  %.209.i = icmp slt i64 %.195.i80, 0
  %.210.i = select i1 %.209.i, i64 %arg.arrays.4.5.0, i64 0
  %13 = getelementptr double, ptr %arg.arrays.4.4, i64 %.195.i80
  %.224.i91 = getelementptr double, ptr %13, i64 %.210.i
  %.225.i92 = load double, ptr %.224.i91, align 8, !noalias !230
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
  %14 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %last.3.2
  %switch.gep = getelementptr i8, ptr %14, i64 64
  %switch.load = load double, ptr %switch.gep, align 8
  br label %B996

B996:                                             ; preds = %B966, %B958
  %"$phi996.1.2.2" = phi double [ 0.000000e+00, %B958 ], [ %switch.load, %B966 ]
  %.1630 = getelementptr double, ptr %7, i64 %.1011
  store double %"$phi996.1.2.2", ptr %.1630, align 8
  %15 = getelementptr double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %last.3.2
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
  %storemerge348.i = tail call i64 @llvm.smin.i64(i64 %16, i64 7)
  %.309380.not.i = icmp slt i64 %"$phi1114.1.2.2", 1
  %17 = tail call i64 @llvm.smax.i64(i64 range(i64 -1, 9) %"$phi1114.1.2.2", i64 1)
  %storemerge349.i = add nsw i64 %17, -1
  %.504384.i = icmp sgt i64 %"$phi1114.1.2.2", 1
  %.447.1386.i = select i1 %.504384.i, i64 2, i64 1
  %.513387.i = sext i1 %.504384.i to i64
  %.450.1388.i = add nsw i64 %storemerge349.i, %.513387.i
  %.494.sroa.0.0389.i = zext i1 %.504384.i to i64
  br label %B50.i

B50.i:                                            ; preds = %B830.i, %B1170
  %.58.0.i = phi i64 [ 0, %B1170 ], [ %.130.i, %B830.i ]
  %exitcond.not.i = icmp eq i64 %.58.0.i, %storemerge.i
  br i1 %exitcond.not.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit, label %B52.if.i

B274.i:                                           ; preds = %B212.if.i, %B52.if.i
  %nearest.3.1.lcssa.i = phi double [ 0x7FF0000000000000, %B52.if.i ], [ %.11.i353.i, %B212.if.i ]
  br i1 %.504384.i, label %B310.lr.ph.i, label %B830.i

B310.lr.ph.i:                                     ; preds = %B274.i
  %.666.i = fmul double %.11.i.i.3.i, 1.000000e+01
  br label %B310.i

B310.i:                                           ; preds = %B905.i, %B310.lr.ph.i
  %.494.sroa.0.0393.i = phi i64 [ %.494.sroa.0.0389.i, %B310.lr.ph.i ], [ %.494.sroa.0.0.i, %B905.i ]
  %.450.1392.i = phi i64 [ %.450.1388.i, %B310.lr.ph.i ], [ %.450.1.i, %B905.i ]
  %.447.1391.i = phi i64 [ %.447.1386.i, %B310.lr.ph.i ], [ %.447.1.i, %B905.i ]
  %nearest.4.1390.i = phi double [ %nearest.3.1.lcssa.i, %B310.lr.ph.i ], [ %nearest.5.2.i, %B905.i ]
  %.550.i = add nsw i64 %.494.sroa.0.0393.i, -1
  %.552.i = mul nsw i64 %.550.i, %.30.i
  %.554.i = add nsw i64 %.552.i, %.160.i
  %.568.i = icmp slt i64 %.554.i, 0
  %.569.i = select i1 %.568.i, i64 %arg.arrays.4.5.0, i64 0
  %18 = getelementptr double, ptr %arg.arrays.4.4, i64 %.554.i
  %.583.i = getelementptr double, ptr %18, i64 %.569.i
  %.584.i = load double, ptr %.583.i, align 8, !noalias !234
  %.587.i = mul nsw i64 %.494.sroa.0.0393.i, %.30.i
  %.589.i = add nsw i64 %.587.i, %.160.i
  %.603.i = icmp slt i64 %.589.i, 0
  %.604.i = select i1 %.603.i, i64 %arg.arrays.4.5.0, i64 0
  %19 = getelementptr double, ptr %arg.arrays.4.4, i64 %.589.i
  %.618.i = getelementptr double, ptr %19, i64 %.604.i
  %.619.i = load double, ptr %.618.i, align 8, !noalias !234
  %.621.i = add nsw i64 %.494.sroa.0.0393.i, 1
  %.623.i = mul nsw i64 %.621.i, %.30.i
  %.625.i = add nsw i64 %.623.i, %.160.i
  %.639.i = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i, i64 %arg.arrays.4.5.0, i64 0
  %20 = getelementptr double, ptr %arg.arrays.4.4, i64 %.625.i
  %.654.i = getelementptr double, ptr %20, i64 %.640.i
  %.655.i = load double, ptr %.654.i, align 8, !noalias !234
  %.669.i = fsub double %.584.i, %.619.i
  %.670.i = tail call double @llvm.fabs.f64(double %.669.i)
  %.673.i = fsub double %.655.i, %.619.i
  %.674.i = tail call double @llvm.fabs.f64(double %.673.i)
  %.675.i = fadd double %.670.i, %.674.i
  %.676.i = fmul double %.675.i, 3.000000e+00
  %.677.i = fadd double %.666.i, %.676.i
  %.679.i = fcmp olt double %.619.i, %.677.i
  br i1 %.679.i, label %B518.i, label %B905.i

B518.i:                                           ; preds = %B310.i
  %switch.tableidx6 = add i64 %.494.sroa.0.0393.i, 9
  %21 = icmp ult i64 %switch.tableidx6, 18
  br i1 %21, label %switch.lookup7, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

B724.i:                                           ; preds = %switch.lookup19
  %.888.i = fneg double %.829.i
  %.892.i = fmul double %.878.i, 5.000000e-01
  %.897.i = fdiv double %.892.i, %.861.i
  %.898.i = fcmp ogt double %.897.i, %.888.i
  %.908.i = fcmp olt double %.897.i, %.755.i
  %or.cond350.i = and i1 %.898.i, %.908.i
  br i1 %or.cond350.i, label %B764.i, label %B905.i

B764.i:                                           ; preds = %B724.i
  %.935.i = fmul double %.878.i, 2.500000e-01
  %.937.i = fmul double %.878.i, %.935.i
  %.944.i = fdiv double %.937.i, %.861.i
  %.948.i = fsub double %.619.i, %.944.i
  %.10.i.i = fcmp olt double %.948.i, %nearest.4.1390.i
  %.11.i.i = select i1 %.10.i.i, double %.948.i, double %nearest.4.1390.i
  br label %B905.i

B830.i:                                           ; preds = %B905.i, %B274.i
  %nearest.4.1.lcssa.i = phi double [ %nearest.3.1.lcssa.i, %B274.i ], [ %nearest.5.2.i, %B905.i ]
  %.1017.i = add nsw i64 %.160.i, %.28.i
  %.1033.i = icmp slt i64 %.1017.i, 0
  %.1034.i = select i1 %.1033.i, i64 %arg.arrays.4.5.0, i64 0
  %22 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1017.i
  %.1048.i = getelementptr double, ptr %22, i64 %.1034.i
  %.1049.i = load double, ptr %.1048.i, align 8, !noalias !234
  %.1051.i = fcmp ule double %.11.i.i.3.i, %.1049.i
  %.1054.i = fmul double %.11.i.i.3.i, 1.000000e+01
  %.1058.i = fcmp ugt double %nearest.4.1.lcssa.i, %.1054.i
  %or.cond.i = select i1 %.1051.i, i1 true, i1 %.1058.i
  br i1 %or.cond.i, label %B50.i, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

B905.i:                                           ; preds = %switch.lookup19, %B764.i, %B724.i, %B310.i
  %nearest.5.2.i = phi double [ %nearest.4.1390.i, %B724.i ], [ %.11.i.i, %B764.i ], [ %nearest.4.1390.i, %B310.i ], [ %nearest.4.1390.i, %switch.lookup19 ]
  %.504.i = icmp sgt i64 %.450.1392.i, 0
  %.517.i = zext i1 %.504.i to i64
  %.447.1.i = add i64 %.447.1391.i, %.517.i
  %.513.i = sext i1 %.504.i to i64
  %.450.1.i = add nsw i64 %.450.1392.i, %.513.i
  %.494.sroa.0.0.i = select i1 %.504.i, i64 %.447.1391.i, i64 0
  br i1 %.504.i, label %B310.i, label %B830.i

B52.if.i:                                         ; preds = %B50.i
  %.130.i = add i64 %.58.0.i, 1
  %.156.i = add nsw i64 %.58.0.i, %arg.decided
  %.158.i = mul nsw i64 %.156.i, %arg.shape.0
  %.160.i = add nsw i64 %.158.i, %.924.sroa.0.01304
  %.192.i.i = add nsw i64 %.160.i, %.30.i
  %.206.i.i = icmp slt i64 %.192.i.i, 0
  %.207.i.i = select i1 %.206.i.i, i64 %arg.arrays.4.5.0, i64 0
  %23 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.i
  %.221.i.i = getelementptr double, ptr %23, i64 %.207.i.i
  %.222.i.i = load double, ptr %.221.i.i, align 8, !noalias !238
  %.472.i.i = icmp slt i64 %.160.i, 0
  %.473.i.i = select i1 %.472.i.i, i64 %arg.arrays.4.5.0, i64 0
  %24 = getelementptr double, ptr %arg.arrays.4.4, i64 %.160.i
  %.487.i.i = getelementptr double, ptr %24, i64 %.473.i.i
  %.488.i.i = load double, ptr %.487.i.i, align 8, !noalias !238
  %.489.i.i = fmul double %.488.i.i, 0x3FDDF27AAAADCB3A
  %.491.i.i = fsub double %.222.i.i, %.489.i.i
  %.458.i.1.i = add nsw i64 %.160.i, %.454.i.i
  %.472.i.1.i = icmp slt i64 %.458.i.1.i, 0
  %.473.i.1.i = select i1 %.472.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %25 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.1.i
  %.487.i.1.i = getelementptr double, ptr %25, i64 %.473.i.1.i
  %.488.i.1.i = load double, ptr %.487.i.1.i, align 8, !noalias !238
  %.489.i.1.i = fmul double %.488.i.1.i, 0x3FEC575F1EBC4F2F
  %.491.i.1.i = fsub double %.491.i.i, %.489.i.1.i
  %.458.i.2.i = add nsw i64 %.160.i, %.456.i.2.i
  %.472.i.2.i = icmp slt i64 %.458.i.2.i, 0
  %.473.i.2.i = select i1 %.472.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %26 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.2.i
  %.487.i.2.i = getelementptr double, ptr %26, i64 %.473.i.2.i
  %.488.i.2.i = load double, ptr %.487.i.2.i, align 8, !noalias !238
  %.489.i.2.i = fmul double %.488.i.2.i, 0x3FE1306AA3D795F4
  %27 = fadd double %.491.i.1.i, %.489.i.2.i
  %.458.i.3.i = add nsw i64 %.160.i, %.456.i.3.i
  %.472.i.3.i = icmp slt i64 %.458.i.3.i, 0
  %.473.i.3.i = select i1 %.472.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %28 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.3.i
  %.487.i.3.i = getelementptr double, ptr %28, i64 %.473.i.3.i
  %.488.i.3.i = load double, ptr %.487.i.3.i, align 8, !noalias !238
  %.489.i.3.i = fmul double %.488.i.3.i, 0x3FCCB9F574BDCC3A
  %.491.i.3.i = fsub double %27, %.489.i.3.i
  %.458.i.4.i = add nsw i64 %.160.i, %.456.i.4.i
  %.472.i.4.i = icmp slt i64 %.458.i.4.i, 0
  %.473.i.4.i = select i1 %.472.i.4.i, i64 %arg.arrays.4.5.0, i64 0
  %29 = getelementptr double, ptr %arg.arrays.4.4, i64 %.458.i.4.i
  %.487.i.4.i = getelementptr double, ptr %29, i64 %.473.i.4.i
  %.488.i.4.i = load double, ptr %.487.i.4.i, align 8, !noalias !238
  %.489.i.4.i = fmul double %.488.i.4.i, 0x3FA4EAF2D6B11E79
  %30 = fadd double %.491.i.3.i, %.489.i.4.i
  %.502.i.i = tail call double @llvm.fabs.f64(double %30)
  %.10.i.i.i = fcmp ogt double %.502.i.i, 0.000000e+00
  %.11.i.i.i = select i1 %.10.i.i.i, double %.502.i.i, double 0.000000e+00
  %.192.i.1.i = add nsw i64 %.160.i, %.190.i.1.i
  %.206.i.1.i = icmp slt i64 %.192.i.1.i, 0
  %.207.i.1.i = select i1 %.206.i.1.i, i64 %arg.arrays.4.5.0, i64 0
  %31 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.1.i
  %.221.i.1.i = getelementptr double, ptr %31, i64 %.207.i.1.i
  %.222.i.1.i = load double, ptr %.221.i.1.i, align 8, !noalias !238
  %.489.i.1430.i = fmul double %.488.i.i, 0x3FA5118805F8B876
  %32 = fadd double %.222.i.1.i, %.489.i.1430.i
  %.489.i.1.1.i = fmul double %.488.i.1.i, 0x3FE51326698BC5BD
  %.491.i.1.1.i = fsub double %32, %.489.i.1.1.i
  %.489.i.2.1.i = fmul double %.488.i.2.i, 0x3FDF97DED30D4572
  %.491.i.2.1.i = fsub double %.491.i.1.1.i, %.489.i.2.1.i
  %.489.i.3.1.i = fmul double %.488.i.3.i, 0x3FC0DA0C684D1D67
  %33 = fadd double %.491.i.2.1.i, %.489.i.3.1.i
  %.489.i.4.1.i = fmul double %.488.i.4.i, 0x3F9510B8EC0D4D92
  %.491.i.4.1.i = fsub double %33, %.489.i.4.1.i
  %.502.i.1.i = tail call double @llvm.fabs.f64(double %.491.i.4.1.i)
  %.10.i.i.1.i = fcmp ogt double %.502.i.1.i, %.11.i.i.i
  %.11.i.i.1.i = select i1 %.10.i.i.1.i, double %.502.i.1.i, double %.11.i.i.i
  %.192.i.2.i = add nsw i64 %.160.i, %.190.i.2.i
  %.206.i.2.i = icmp slt i64 %.192.i.2.i, 0
  %.207.i.2.i = select i1 %.206.i.2.i, i64 %arg.arrays.4.5.0, i64 0
  %34 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.2.i
  %.221.i.2.i = getelementptr double, ptr %34, i64 %.207.i.2.i
  %.222.i.2.i = load double, ptr %.221.i.2.i, align 8, !noalias !238
  %.489.i.2457.i = fmul double %.488.i.i, 0x3F9635A30F8F142F
  %.491.i.2458.i = fsub double %.222.i.2.i, %.489.i.2457.i
  %.489.i.1.2.i = fmul double %.488.i.1.i, 0x3FC1EAE0FF33D241
  %35 = fadd double %.491.i.2458.i, %.489.i.1.2.i
  %.489.i.2.2.i = fmul double %.488.i.2.i, 0x3FE1625D59218460
  %.491.i.2.2.i = fsub double %35, %.489.i.2.2.i
  %.489.i.3.2.i = fmul double %.488.i.3.i, 0x3FE3BBC3E8A29641
  %.491.i.3.2.i = fsub double %.491.i.2.2.i, %.489.i.3.2.i
  %.489.i.4.2.i = fmul double %.488.i.4.i, 0x3FA55161A739EB34
  %36 = fadd double %.491.i.3.2.i, %.489.i.4.2.i
  %.502.i.2.i = tail call double @llvm.fabs.f64(double %36)
  %.10.i.i.2.i = fcmp ogt double %.502.i.2.i, %.11.i.i.1.i
  %.11.i.i.2.i = select i1 %.10.i.i.2.i, double %.502.i.2.i, double %.11.i.i.1.i
  %.192.i.3.i = add nsw i64 %.160.i, %.190.i.3.i
  %.206.i.3.i = icmp slt i64 %.192.i.3.i, 0
  %.207.i.3.i = select i1 %.206.i.3.i, i64 %arg.arrays.4.5.0, i64 0
  %37 = getelementptr double, ptr %arg.arrays.4.4, i64 %.192.i.3.i
  %.221.i.3.i = getelementptr double, ptr %37, i64 %.207.i.3.i
  %.222.i.3.i = load double, ptr %.221.i.3.i, align 8, !noalias !238
  %.489.i.3484.i = fmul double %.488.i.i, 0x3FA4F0C0BB579409
  %38 = fadd double %.222.i.3.i, %.489.i.3484.i
  %.489.i.1.3.i = fmul double %.488.i.1.i, 0x3FCD2266FBC0D976
  %.491.i.1.3.i = fsub double %38, %.489.i.1.3.i
  %.489.i.2.3.i = fmul double %.488.i.2.i, 0x3FE1F2DB6FEE3151
  %39 = fadd double %.491.i.1.3.i, %.489.i.2.3.i
  %.489.i.3.3.i = fmul double %.488.i.3.i, 0x3FF0C05015964CBE
  %.491.i.3.3.i = fsub double %39, %.489.i.3.3.i
  %.489.i.4.3.i = fmul double %.488.i.4.i, 0x3FD4F15B230DB570
  %.491.i.4.3.i = fsub double %.491.i.3.3.i, %.489.i.4.3.i
  %.502.i.3.i = tail call double @llvm.fabs.f64(double %.491.i.4.3.i)
  %.10.i.i.3.i = fcmp ogt double %.502.i.3.i, %.11.i.i.2.i
  %.11.i.i.3.i = select i1 %.10.i.i.3.i, double %.502.i.3.i, double %.11.i.i.2.i
  br i1 %.309380.not.i, label %B274.i, label %B212.if.i

B212.if.i:                                        ; preds = %B52.if.i, %B212.if.i
  %nearest.3.1383.i = phi double [ %.11.i353.i, %B212.if.i ], [ 0x7FF0000000000000, %B52.if.i ]
  %.256.0382.i = phi i64 [ %.318.i, %B212.if.i ], [ %storemerge348.i, %B52.if.i ]
  %.253.0381.i = phi i64 [ %.322.i, %B212.if.i ], [ 1, %B52.if.i ]
  %.318.i = add nsw i64 %.256.0382.i, -1
  %.322.i = add nsw i64 %.253.0381.i, 1
  %40 = mul nsw i64 %.253.0381.i, %.30.i
  %.350.i = add nsw i64 %40, %.160.i
  %.364.i = icmp slt i64 %.350.i, 0
  %.365.i = select i1 %.364.i, i64 %arg.arrays.4.5.0, i64 0
  %41 = getelementptr double, ptr %arg.arrays.4.4, i64 %.350.i
  %.379.i = getelementptr double, ptr %41, i64 %.365.i
  %.380.i = load double, ptr %.379.i, align 8, !noalias !234
  %.10.i352.i = fcmp olt double %.380.i, %nearest.3.1383.i
  %.11.i353.i = select i1 %.10.i352.i, double %.380.i, double %nearest.3.1383.i
  %.309.i = icmp sgt i64 %.256.0382.i, 1
  br i1 %.309.i, label %B212.if.i, label %B274.i

switch.lookup7:                                   ; preds = %B518.i
  %switch.tableidx10 = add i64 %.494.sroa.0.0393.i, 8
  %42 = icmp ult i64 %switch.tableidx10, 18
  br i1 %42, label %switch.lookup11, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup11:                                  ; preds = %switch.lookup7
  %switch.gep8 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx6
  %switch.load9 = load double, ptr %switch.gep8, align 8
  %switch.gep12 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx10
  %switch.load13 = load double, ptr %switch.gep12, align 8
  %.755.i = fsub double %switch.load9, %switch.load13
  %switch.tableidx14 = add i64 %.494.sroa.0.0393.i, 10
  %43 = icmp ult i64 %switch.tableidx14, 18
  br i1 %43, label %switch.lookup15, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup15:                                  ; preds = %switch.lookup11
  %switch.tableidx18 = add i64 %.494.sroa.0.0393.i, 9
  %44 = icmp ult i64 %switch.tableidx18, 18
  br i1 %44, label %switch.lookup19, label %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit

switch.lookup19:                                  ; preds = %switch.lookup15
  %switch.gep16 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx14
  %switch.load17 = load double, ptr %switch.gep16, align 8
  %switch.gep20 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.12, i64 %switch.tableidx18
  %switch.load21 = load double, ptr %switch.gep20, align 8
  %.829.i = fsub double %switch.load17, %switch.load21
  %.845.i = fdiv double %.673.i, %.829.i
  %.848.i = fsub double %.619.i, %.584.i
  %.853.i = fdiv double %.848.i, %.755.i
  %.854.i = fsub double %.845.i, %.853.i
  %.857.i = fadd double %.755.i, %.829.i
  %.861.i = fdiv double %.854.i, %.857.i
  %.877.i = fmul double %.755.i, %.861.i
  %.878.i = fadd double %.853.i, %.877.i
  %.883.i = fcmp ogt double %.861.i, 0.000000e+00
  br i1 %.883.i, label %B724.i, label %B905.i

_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B50.i, %B830.i, %B518.i, %switch.lookup7, %switch.lookup11, %switch.lookup15
  %.1897.not = phi i1 [ true, %B518.i ], [ true, %switch.lookup15 ], [ true, %switch.lookup11 ], [ true, %switch.lookup7 ], [ %exitcond.not.i, %B830.i ], [ %exitcond.not.i, %B50.i ]
  %excinfo.3.3 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %B518.i ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup15 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup11 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.16, %switch.lookup7 ], [ %excinfo.3.01300, %B830.i ], [ %excinfo.3.01300, %B50.i ]
  %.1886.not = phi i1 [ false, %B518.i ], [ false, %switch.lookup15 ], [ false, %switch.lookup11 ], [ false, %switch.lookup7 ], [ true, %B830.i ], [ true, %B50.i ]
  %common.ret.op.i = phi i32 [ 1, %B518.i ], [ 1, %switch.lookup15 ], [ 1, %switch.lookup11 ], [ 1, %switch.lookup7 ], [ 0, %B830.i ], [ 0, %B50.i ]
  br i1 %.1886.not, label %B1170.endif.endif, label %B1170.endif.if, !prof !53

B1208:                                            ; preds = %B1170.endif.endif
  %.1972 = fmul double %.1861, 5.000000e-01
  store double 0.000000e+00, ptr %.1257, align 8, !noalias !242
  %.161.i230 = getelementptr double, ptr %10, i64 %.1011
  store double 0.000000e+00, ptr %.161.i230, align 8, !noalias !242
  %.214.i273 = getelementptr double, ptr %11, i64 %.1011
  store double %.1972, ptr %.214.i273, align 8, !noalias !242
  %.268.i313 = load i64, ptr %.1197, align 8, !noalias !242
  %.294.i = icmp slt i64 %.268.i313, 0
  %.295.i = select i1 %.294.i, i64 %arg.results.3.5.0, i64 0
  %.296.i324 = add i64 %.295.i, %.268.i313
  %.316.i333 = mul i64 %.296.i324, %arg.results.3.5.1
  %.320.i = getelementptr i64, ptr %arg.results.3.4, i64 %.316.i333
  %.321.i = load i64, ptr %.320.i, align 8, !noalias !242
  %.322.i336 = add nsw i64 %.321.i, -1
  store i64 %.322.i336, ptr %.320.i, align 8, !noalias !242
  %.426.i = load i64, ptr %.1197, align 8, !noalias !242
  %.452.i = icmp slt i64 %.426.i, 0
  %.453.i = select i1 %.452.i, i64 %arg.results.3.5.0, i64 0
  %.454.i = add i64 %.453.i, %.426.i
  %.474.i = mul i64 %.454.i, %arg.results.3.5.1
  %45 = getelementptr i64, ptr %arg.results.3.4, i64 %.474.i
  %.478.i = getelementptr i8, ptr %45, i64 24
  %.479.i = load i64, ptr %.478.i, align 8, !noalias !242
  %.480.i = add nsw i64 %.479.i, 1
  store i64 %.480.i, ptr %.478.i, align 8, !noalias !242
  store i64 -1, ptr %.1087, align 8
  br label %B1300

B1300:                                            ; preds = %B996, %B1208, %B1170.endif.endif, %B1122
  %excinfo.3.2 = phi ptr [ %excinfo.3.3, %B1170.endif.endif ], [ %excinfo.3.3, %B1208 ], [ %excinfo.3.01300, %B1122 ], [ %excinfo.3.01300, %B996 ]
  br i1 %some.2.01301, label %B1342, label %B1304

B1304:                                            ; preds = %B1300
  %.2136 = load i64, ptr %.1087, align 8
  %.2137 = icmp sgt i64 %.2136, -1
  br label %B1342

B1342:                                            ; preds = %B1300, %B1304, %B702, %B584
  %excinfo.3.1 = phi ptr [ %excinfo.3.2, %B1300 ], [ %excinfo.3.2, %B1304 ], [ %excinfo.3.01300, %B702 ], [ %excinfo.3.01300, %B584 ]
  %some.3.1 = phi i1 [ true, %B1300 ], [ %.2137, %B1304 ], [ %some.2.01301, %B702 ], [ %some.2.01301, %B584 ]
  %.934 = icmp sgt i64 %.880.11303, 0
  %.947 = zext i1 %.934 to i64
  %.877.1 = add i64 %.877.11302, %.947
  %.943 = sext i1 %.934 to i64
  %.880.1 = add nsw i64 %.880.11303, %.943
  %.924.sroa.0.0 = select i1 %.934, i64 %.877.11302, i64 0
  br i1 %.934, label %B584, label %B1346.loopexit

common.ret:                                       ; preds = %B1170.endif.if, %B1346
  %common.ret.op = phi i32 [ 0, %B1346 ], [ %common.ret.op.i, %B1170.endif.if ]
  ret i32 %common.ret.op

B1346.loopexit:                                   ; preds = %B1342
  %46 = zext i1 %some.3.1 to i8
  br label %B1346

B1346:                                            ; preds = %B1346.loopexit, %B550
  %some.2.0.lcssa = phi i8 [ 0, %B550 ], [ %46, %B1346.loopexit ]
  store i8 %some.2.0.lcssa, ptr %retptr, align 1
  br label %common.ret

B246.if:                                          ; preds = %entry, %B348
  %.344.01295 = phi i64 [ %.354, %entry ], [ %.408, %B348 ]
  %.341.01294 = phi i64 [ %., %entry ], [ %.412, %B348 ]
  %.408 = add nsw i64 %.344.01295, -1
  %.412 = add nsw i64 %.341.01294, 1
  br i1 %.5201291.not, label %B348, label %B280.if.preheader

B280.if.preheader:                                ; preds = %B246.if
  %47 = icmp ult i64 %.341.01294, 8
  %switch.gep23 = getelementptr inbounds double, ptr @switch.table._ZN12clpt_control6native9for_numba11mark_passedB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_285_298UniTupleIxLi7EEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE.13, i64 %.341.01294
  br label %B280.if

B280.if:                                          ; preds = %B280.if.preheader, %B280.loopexit
  %.464.01292 = phi i64 [ %.533, %B280.loopexit ], [ 0, %B280.if.preheader ]
  %.533 = add nsw i64 %.464.01292, 1
  br i1 %47, label %switch.lookup22, label %switch.end

switch.lookup22:                                  ; preds = %B280.if
  %switch.load24 = load double, ptr %switch.gep23, align 8
  br label %switch.end

switch.end:                                       ; preds = %B280.if, %switch.lookup22
  %.575 = phi double [ %switch.load24, %switch.lookup22 ], [ 1.000000e+00, %B280.if ]
  %.92.i = getelementptr double, ptr %arg.lane.0.4, i64 %.464.01292
  %.93.i = load double, ptr %.92.i, align 8, !noalias !245
  %.146.i = getelementptr double, ptr %1, i64 %.464.01292
  %.147.i = load double, ptr %.146.i, align 8, !noalias !245
  %.149.i = fmul double %.575, %.147.i
  %.150.i = fadd double %.93.i, %.149.i
  %.203.i = getelementptr double, ptr %2, i64 %.464.01292
  store double %.150.i, ptr %.203.i, align 8, !noalias !245
  br i1 %.287.i1288.not, label %B280.loopexit, label %B122.if.i.lr.ph

B122.if.i.lr.ph:                                  ; preds = %switch.end
  %.247.i.i = fsub double 1.000000e+00, %.575
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep27 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep29 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep31 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep33 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep35 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep37 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep39 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  %invariant.gep41 = getelementptr double, ptr %arg.arrays.0.4, i64 %.464.01292
  br label %B122.if.i

B122.if.i:                                        ; preds = %B122.if.i.lr.ph, %B122.if.i
  %.229.i.01289 = phi i64 [ 0, %B122.if.i.lr.ph ], [ %.300.i, %B122.if.i ]
  %.157.i.i = add nsw i64 %.155.i.i, %.229.i.01289
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep, align 8, !noalias !249
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %.575, %.193.i.i
  %.157.i.i.1 = add nsw i64 %.155.i.i.1, %.229.i.01289
  %.159.i.i.1 = mul nsw i64 %.157.i.i.1, %arg.shape.0
  %gep28 = getelementptr double, ptr %invariant.gep27, i64 %.159.i.i.1
  %.191.i.i.1 = load double, ptr %gep28, align 8, !noalias !249
  %.193.i.i.1 = fadd double %.253.i.i, %.191.i.i.1
  %.253.i.i.1 = fmul double %.247.i.i, %.193.i.i.1
  %.157.i.i.2 = add nsw i64 %.155.i.i.2, %.229.i.01289
  %.159.i.i.2 = mul nsw i64 %.157.i.i.2, %arg.shape.0
  %gep30 = getelementptr double, ptr %invariant.gep29, i64 %.159.i.i.2
  %.191.i.i.2 = load double, ptr %gep30, align 8, !noalias !249
  %.193.i.i.2 = fadd double %.253.i.i.1, %.191.i.i.2
  %.253.i.i.2 = fmul double %.575, %.193.i.i.2
  %.157.i.i.3 = add nsw i64 %.155.i.i.3, %.229.i.01289
  %.159.i.i.3 = mul nsw i64 %.157.i.i.3, %arg.shape.0
  %gep32 = getelementptr double, ptr %invariant.gep31, i64 %.159.i.i.3
  %.191.i.i.3 = load double, ptr %gep32, align 8, !noalias !249
  %.193.i.i.3 = fadd double %.253.i.i.2, %.191.i.i.3
  %.253.i.i.3 = fmul double %.247.i.i, %.193.i.i.3
  %.157.i.i.4 = add nsw i64 %.155.i.i.4, %.229.i.01289
  %.159.i.i.4 = mul nsw i64 %.157.i.i.4, %arg.shape.0
  %gep34 = getelementptr double, ptr %invariant.gep33, i64 %.159.i.i.4
  %.191.i.i.4 = load double, ptr %gep34, align 8, !noalias !249
  %.193.i.i.4 = fadd double %.253.i.i.3, %.191.i.i.4
  %.253.i.i.4 = fmul double %.575, %.193.i.i.4
  %.157.i.i.5 = add nsw i64 %.155.i.i.5, %.229.i.01289
  %.159.i.i.5 = mul nsw i64 %.157.i.i.5, %arg.shape.0
  %gep36 = getelementptr double, ptr %invariant.gep35, i64 %.159.i.i.5
  %.191.i.i.5 = load double, ptr %gep36, align 8, !noalias !249
  %.193.i.i.5 = fadd double %.253.i.i.4, %.191.i.i.5
  %.253.i.i.5 = fmul double %.247.i.i, %.193.i.i.5
  %.157.i.i.6 = add nsw i64 %.155.i.i.6, %.229.i.01289
  %.159.i.i.6 = mul nsw i64 %.157.i.i.6, %arg.shape.0
  %gep38 = getelementptr double, ptr %invariant.gep37, i64 %.159.i.i.6
  %.191.i.i.6 = load double, ptr %gep38, align 8, !noalias !249
  %.193.i.i.6 = fadd double %.253.i.i.5, %.191.i.i.6
  %.253.i.i.6 = fmul double %.575, %.193.i.i.6
  %.300.i = add nsw i64 %.229.i.01289, 1
  %.271.i.i = mul nsw i64 %.229.i.01289, %arg.shape.0
  %gep40 = getelementptr double, ptr %invariant.gep39, i64 %.271.i.i
  %.309.i.i = load double, ptr %gep40, align 8, !noalias !249
  %.313.i.i = fadd double %.253.i.i.6, %.309.i.i
  %.359.i = add nsw i64 %.229.i.01289, %.358.i
  %.361.i = mul nsw i64 %.359.i, %arg.shape.0
  %gep42 = getelementptr double, ptr %invariant.gep41, i64 %.361.i
  store double %.313.i.i, ptr %gep42, align 8, !noalias !245
  %exitcond.not = icmp eq i64 %arg.shape.1, %.300.i
  br i1 %exitcond.not, label %B280.loopexit, label %B122.if.i

B830.endif:                                       ; preds = %B36.i, %B34.i
  %.1371.0 = phi i64 [ %.51.i13.0, %B36.i ], [ -1, %B34.i ]
  store i64 %.1371.0, ptr %.1087, align 8
  %exitcond1309.not = icmp eq i64 %last.2.3, 7
  br i1 %exitcond1309.not, label %B958, label %B920

B1170.endif.if:                                   ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.3.3, ptr %excinfo, align 8
  br label %common.ret

B1170.endif.endif:                                ; preds = %_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1897.not, label %B1300, label %B1208
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
!65 = distinct !{!65, !66, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!66 = distinct !{!66, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!67 = distinct !{!67, !66, !"_ZN12clpt_control6native9for_numba14measure_effectB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedEx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!68 = !{!69, !71, !65, !67, !62}
!69 = distinct !{!69, !70, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!70 = distinct !{!70, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!71 = distinct !{!71, !70, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!72 = !{!73, !75, !65, !67, !62}
!73 = distinct !{!73, !74, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!74 = distinct !{!74, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!75 = distinct !{!75, !74, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!76 = !{!77, !79, !80, !82, !62}
!77 = distinct !{!77, !78, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!78 = distinct !{!78, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!79 = distinct !{!79, !78, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!80 = distinct !{!80, !81, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!81 = distinct !{!81, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!82 = distinct !{!82, !81, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!83 = !{!80, !82, !62}
!84 = !{!85, !87, !62}
!85 = distinct !{!85, !86, !"_ZN12clpt_control6native9for_numba14measure_effectB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!86 = distinct !{!86, !"_ZN12clpt_control6native9for_numba14measure_effectB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!87 = distinct !{!87, !86, !"_ZN12clpt_control6native9for_numba14measure_effectB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE23Literal_5bint_5d_289_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!88 = !{!89, !91, !85, !87, !62}
!89 = distinct !{!89, !90, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!90 = distinct !{!90, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!91 = distinct !{!91, !90, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!92 = !{!93, !95, !85, !87, !62}
!93 = distinct !{!93, !94, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!94 = distinct !{!94, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx"}
!95 = distinct !{!95, !94, !"_ZN12clpt_control6native9for_numba8exchangeB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedExx: %excinfo"}
!96 = !{!97, !99, !100, !102, !62}
!97 = distinct !{!97, !98, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!98 = distinct !{!98, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!99 = distinct !{!99, !98, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!100 = distinct !{!100, !101, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!101 = distinct !{!101, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!102 = distinct !{!102, !101, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!103 = !{!100, !102, !62}
!104 = !{!105, !107, !62}
!105 = distinct !{!105, !106, !"_ZN12clpt_control6native9for_numba12first_passedB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!106 = distinct !{!106, !"_ZN12clpt_control6native9for_numba12first_passedB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE"}
!107 = distinct !{!107, !106, !"_ZN12clpt_control6native9for_numba12first_passedB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_289_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!108 = !{!109, !62}
!109 = distinct !{!109, !110, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!110 = distinct !{!110, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!111 = !{!112, !114, !115, !117, !62}
!112 = distinct !{!112, !113, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!113 = distinct !{!113, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!114 = distinct !{!114, !113, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!115 = distinct !{!115, !116, !"_ZN12clpt_control6native9for_numba5bendsB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!116 = distinct !{!116, !"_ZN12clpt_control6native9for_numba5bendsB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE"}
!117 = distinct !{!117, !116, !"_ZN12clpt_control6native9for_numba5bendsB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!118 = !{!115, !117, !62}
!119 = !{!120, !62}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!122 = !{!123, !125, !62}
!123 = distinct !{!123, !124, !"_ZN12clpt_control6native9for_numba12first_passedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!124 = distinct !{!124, !"_ZN12clpt_control6native9for_numba12first_passedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE"}
!125 = distinct !{!125, !124, !"_ZN12clpt_control6native9for_numba12first_passedB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx23Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!126 = !{!127, !129, !62}
!127 = distinct !{!127, !128, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!128 = distinct !{!128, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!129 = distinct !{!129, !128, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!130 = !{!131, !133, !127, !129, !62}
!131 = distinct !{!131, !132, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!132 = distinct !{!132, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!133 = distinct !{!133, !132, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!134 = !{!135, !137}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!137 = distinct !{!137, !136, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!138 = !{!139, !141, !135, !137}
!139 = distinct !{!139, !140, !"_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!140 = distinct !{!140, !"_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!141 = distinct !{!141, !140, !"_ZN12clpt_control6native9for_numba11mark_passedB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_282_298UniTupleIxLi7EE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!142 = !{!143, !145, !139, !141, !135, !137}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba12first_passedB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba12first_passedB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !144, !"_ZN12clpt_control6native9for_numba12first_passedB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!146 = !{!147, !149, !139, !141, !135, !137}
!147 = distinct !{!147, !148, !"_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !148, !"_ZN12clpt_control6native9for_numba8may_hideB3v45B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx23Literal_5bint_5d_281_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!150 = !{!151, !153, !147, !149, !139, !141, !135, !137}
!151 = distinct !{!151, !152, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!153 = distinct !{!153, !152, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!154 = !{!155, !139, !141, !135, !137}
!155 = distinct !{!155, !156, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!156 = distinct !{!156, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!157 = !{!158, !160, !139, !141, !135, !137}
!158 = distinct !{!158, !159, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!159 = distinct !{!159, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!160 = distinct !{!160, !159, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!161 = !{!162, !164, !158, !160, !139, !141, !135, !137}
!162 = distinct !{!162, !163, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!163 = distinct !{!163, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!164 = distinct !{!164, !163, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!165 = !{!"branch_weights", i32 1, i32 99}
!166 = !{!"branch_weights", i32 101, i32 99}
!167 = !{!"branch_weights", i32 301, i32 99}
!168 = !{!169, !135, !137}
!169 = distinct !{!169, !170, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!170 = distinct !{!170, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!171 = !{!172}
!172 = distinct !{!172, !173, !"_ZN12clpt_control6native9for_numba6sampleB3v46B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!173 = distinct !{!173, !"_ZN12clpt_control6native9for_numba6sampleB3v46B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!174 = !{!175, !177, !172}
!175 = distinct !{!175, !176, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!176 = distinct !{!176, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!177 = distinct !{!177, !176, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!178 = !{!179, !181}
!179 = distinct !{!179, !180, !"_ZN12clpt_control6native9for_numba11decide_anewB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!180 = distinct !{!180, !"_ZN12clpt_control6native9for_numba11decide_anewB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!181 = distinct !{!181, !180, !"_ZN12clpt_control6native9for_numba11decide_anewB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!182 = !{!183, !179, !181}
!183 = distinct !{!183, !184, !"_ZN12clpt_control6native9for_numba4failB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!184 = distinct !{!184, !"_ZN12clpt_control6native9for_numba4failB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!185 = !{!186, !188}
!186 = distinct !{!186, !187, !"_ZN12clpt_control6native9for_numba6at_endB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!187 = distinct !{!187, !"_ZN12clpt_control6native9for_numba6at_endB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!188 = distinct !{!188, !189, !"_ZN12clpt_control6native9for_numba4jumpB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!189 = distinct !{!189, !"_ZN12clpt_control6native9for_numba4jumpB3v49B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!190 = !{!188}
!191 = !{!192, !194, !188}
!192 = distinct !{!192, !193, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!193 = distinct !{!193, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!194 = distinct !{!194, !193, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!195 = !{!196, !188}
!196 = distinct !{!196, !197, !"_ZN12clpt_control6native9for_numba6at_endB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!197 = distinct !{!197, !"_ZN12clpt_control6native9for_numba6at_endB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!198 = !{!199, !188}
!199 = distinct !{!199, !200, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!200 = distinct !{!200, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!201 = !{!202, !188}
!202 = distinct !{!202, !203, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!203 = distinct !{!203, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!204 = !{!205}
!205 = distinct !{!205, !206, !"_ZN12clpt_control6native9for_numba4failB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!206 = distinct !{!206, !"_ZN12clpt_control6native9for_numba4failB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!207 = !{!208, !210}
!208 = distinct !{!208, !209, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!209 = distinct !{!209, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!210 = distinct !{!210, !209, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!211 = !{!212, !214, !208, !210}
!212 = distinct !{!212, !213, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!213 = distinct !{!213, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!214 = distinct !{!214, !213, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!215 = !{!216}
!216 = distinct !{!216, !217, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!217 = distinct !{!217, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!218 = !{!219, !221, !216}
!219 = distinct !{!219, !220, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!220 = distinct !{!220, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!221 = distinct !{!221, !220, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!222 = !{!223, !225}
!223 = distinct !{!223, !224, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!224 = distinct !{!224, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!225 = distinct !{!225, !224, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!226 = !{!227, !229}
!227 = distinct !{!227, !228, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!228 = distinct !{!228, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!229 = distinct !{!229, !228, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!230 = !{!231, !233}
!231 = distinct !{!231, !232, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!232 = distinct !{!232, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!233 = distinct !{!233, !232, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!234 = !{!235, !237}
!235 = distinct !{!235, !236, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!236 = distinct !{!236, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE"}
!237 = distinct !{!237, !236, !"_ZN12clpt_control6native9for_numba8may_hideB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!238 = !{!239, !241, !235, !237}
!239 = distinct !{!239, !240, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!240 = distinct !{!240, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!241 = distinct !{!241, !240, !"_ZN12clpt_control6native9for_numba13error_betweenB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!242 = !{!243}
!243 = distinct !{!243, !244, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!244 = distinct !{!244, !"_ZN12clpt_control6native9for_numba9try_againB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!245 = !{!246, !248}
!246 = distinct !{!246, !247, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!247 = distinct !{!247, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!248 = distinct !{!248, !247, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!249 = !{!250, !252, !246, !248}
!250 = distinct !{!250, !251, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!251 = distinct !{!251, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!252 = distinct !{!252, !251, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}

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
