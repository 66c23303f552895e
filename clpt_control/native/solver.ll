; sha256 4b5406737965e839f29f067919a3f4bfb176dfd48c6b829f1f246b6bf7aac3d7

@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant [76 x i8] c"\80\04\95A\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Erange() arg 3 must not be zero\94\85\94N\87\94."
@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1 = internal constant [20 x i8] c"\CA\8E\FB:r\D6\14\FE\87 2\CC\E3\AC2`\07\A3\07'"
@.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727, i32 76, ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1, ptr null, i32 0 }

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readonly %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readonly %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, i64 %arg.budget, i64 %arg.most, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.runs.0.46872 = ptrtoint ptr %arg.runs.0.4 to i64
  %arg.results.0.46871 = ptrtoint ptr %arg.results.0.4 to i64
  %.358 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.466.idx = shl i64 %arg.lane.0.5.1, 6
  %.466 = getelementptr i8, ptr %arg.lane.0.4, i64 %.466.idx
  %.274.i = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.274.i, i64 0, i64 %arg.shape.0
  br i1 %.274.i, label %B0.endif, label %B50.if.i.lr.ph

B50.if.i.lr.ph:                                   ; preds = %entry
  %arg.results.0.46867 = ptrtoint ptr %arg.results.0.4 to i64
  %arg.runs.0.46868 = ptrtoint ptr %arg.runs.0.4 to i64
  %.373.i6465 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %.444.i = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %0 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx.i = shl i64 %arg.lane.1.5.1, 4
  %1 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i
  %.6961380.not.i = icmp slt i64 %arg.shape.1, 1
  %.851.i6471 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661383.not.i = icmp slt i64 %arg.shape.2, 1
  %.11851386.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i.not = icmp eq i64 %arg.shape.0, 1
  %.163.i1389.not.i = icmp slt i64 %arg.shape.1, 1
  %2 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1370.i = shl i64 %arg.lane.0.5.1, 4
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1370.i
  %.idx1371.i = mul i64 %arg.lane.0.5.1, 24
  %4 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1371.i
  %.idx1372.i = shl i64 %arg.lane.0.5.1, 5
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1372.i
  %.15851392.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx1375.i = shl i64 %arg.lane.0.5.1, 4
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1375.i
  %7 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1376.i = mul i64 %arg.lane.0.5.1, 24
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1376.i
  %.idx1377.i = shl i64 %arg.lane.0.5.1, 5
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1377.i
  %.idx1378.i = mul i64 %arg.lane.0.5.1, 120
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1378.i
  %.idx1379.i = mul i64 %arg.lane.1.5.1, 24
  %11 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1379.i
  %12 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %13 = shl i64 %12, 3
  %14 = shl i64 %arg.runs.0.5.1, 3
  %min.iters.check = icmp ult i64 %arg.shape.1, 8
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B50.if.i

B104.i:                                           ; preds = %B50.if.i
  %.420.i = add nsw i64 %active.3.i.06752, 1
  br label %B171.i

B116.i:                                           ; preds = %B50.if.i
  %.314.i = load i64, ptr %arg.lane.2.4, align 8, !noalias !0
  %.374.i = load i64, ptr %.373.i6465, align 8, !noalias !0
  %.375.i6466 = icmp slt i64 %.314.i, %.374.i
  br i1 %.375.i6466, label %B130.i, label %B316.i

B130.i:                                           ; preds = %B116.i
  %.385.i = add nsw i64 %.314.i, 1
  store i64 %.385.i, ptr %arg.lane.2.4, align 8, !noalias !0
  store i64 1, ptr %.444.i, align 8, !noalias !0
  %.502.i6468 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.06750
  store i64 %.314.i, ptr %.502.i6468, align 8, !noalias !0
  %.557.i = getelementptr i64, ptr %0, i64 %.260.i.06750
  store i64 0, ptr %.557.i, align 8, !noalias !0
  %.612.i = getelementptr i64, ptr %1, i64 %.260.i.06750
  store i64 1, ptr %.612.i, align 8, !noalias !0
  br i1 %.6961380.not.i, label %B316.i, label %B272.if.lr.ph.i

B272.if.lr.ph.i:                                  ; preds = %B130.i
  %.757.i = icmp slt i64 %.314.i, 0
  %.758.i = select i1 %.757.i, i64 %arg.runs.0.5.0, i64 0
  %.759.i = add i64 %.758.i, %.314.i
  %.779.i = mul i64 %.759.i, %arg.runs.0.5.1
  %15 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i
  %.822.i6469 = select i1 %.757.i, i64 %arg.results.0.5.0, i64 0
  %.823.i6470 = add i64 %.822.i6469, %.314.i
  %.853.i = mul i64 %.851.i6471, %.823.i6470
  %16 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i
  br i1 %min.iters.check, label %B272.if.i.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %B272.if.lr.ph.i
  %17 = mul i64 %13, %.823.i6470
  %18 = mul i64 %14, %.759.i
  %19 = add i64 %17, %arg.results.0.46867
  %20 = add i64 %18, %arg.runs.0.46868
  %21 = sub i64 %19, %20
  %diff.check = icmp ult i64 %21, 32
  br i1 %diff.check, label %B272.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %22 = getelementptr double, ptr %15, i64 %index
  %23 = getelementptr i8, ptr %22, i64 16
  %wide.load = load <2 x double>, ptr %22, align 8, !noalias !0
  %wide.load6869 = load <2 x double>, ptr %23, align 8, !noalias !0
  %24 = getelementptr double, ptr %16, i64 %index
  %25 = getelementptr i8, ptr %24, i64 16
  store <2 x double> %wide.load, ptr %24, align 8, !noalias !0
  store <2 x double> %wide.load6869, ptr %25, align 8, !noalias !0
  %index.next = add i64 %index, 4
  %26 = icmp eq i64 %index.next, %n.vec
  br i1 %26, label %middle.block, label %vector.body, !llvm.loop !6

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B316.i, label %B272.if.i.preheader

B272.if.i.preheader:                              ; preds = %vector.memcheck, %B272.if.lr.ph.i, %middle.block
  %.638.01381.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B272.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B272.if.i

B316.i:                                           ; preds = %B272.if.i, %middle.block, %B130.i, %B116.i
  %m.2.0.i = phi i64 [ 0, %B116.i ], [ %.314.i, %B130.i ], [ %.314.i, %middle.block ], [ %.314.i, %B272.if.i ]
  br i1 %.9661383.not.i, label %B390.i, label %B346.if.lr.ph.i

B346.if.lr.ph.i:                                  ; preds = %B316.i
  %.1027.i = icmp slt i64 %m.2.0.i, 0
  %.1028.i = select i1 %.1027.i, i64 %arg.runs.1.5.0, i64 0
  %.1029.i = add i64 %.1028.i, %m.2.0.i
  %.1049.i = mul i64 %.1029.i, %arg.runs.1.5.1
  %27 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i
  %invariant.gep6969 = getelementptr double, ptr %arg.arrays.1.4, i64 %.260.i.06750
  br label %B346.if.i

B390.i:                                           ; preds = %B346.if.i, %B316.i
  br i1 %.11851386.not.i, label %B516.i, label %B446.if.lr.ph.i

B446.if.lr.ph.i:                                  ; preds = %B390.i
  %.1237.i = icmp slt i64 %m.2.0.i, 0
  %.1238.i = select i1 %.1237.i, i64 %arg.runs.2.5.0, i64 0
  %28 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1252.i = getelementptr i64, ptr %28, i64 %.1238.i
  br label %B446.if.i

B516.i:                                           ; preds = %B446.if.i, %B390.i
  br i1 %.375.i6466, label %B574.i, label %B520.i

B520.i:                                           ; preds = %B516.i
  br i1 %.1423.i.not, label %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B532.i

B532.i:                                           ; preds = %B520.i
  br i1 %.163.i1389.not.i, label %B102.i.i, label %B46.if.i.i.preheader

B46.if.i.i.preheader:                             ; preds = %B532.i
  %invariant.gep6971 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.06750
  br label %B46.if.i.i

B102.i.i:                                         ; preds = %B46.if.i.i, %B532.i
  %.360.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.06750
  store double 0.000000e+00, ptr %.360.i.i, align 8, !noalias !9
  %.415.i.i = getelementptr double, ptr %2, i64 %.260.i.06750
  store double 5.000000e-01, ptr %.415.i.i, align 8, !noalias !9
  %.470.i.i = getelementptr double, ptr %3, i64 %.260.i.06750
  store double 1.000000e+00, ptr %.470.i.i, align 8, !noalias !9
  %.529.i.i = getelementptr double, ptr %4, i64 %.260.i.06750
  store double 0.000000e+00, ptr %.529.i.i, align 8, !noalias !9
  %.586.i.i = getelementptr double, ptr %5, i64 %.260.i.06750
  store double 0.000000e+00, ptr %.586.i.i, align 8, !noalias !9
  br label %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B46.if.i.i:                                       ; preds = %B46.if.i.i.preheader, %B46.if.i.i
  %.105.i.01390.i = phi i64 [ %.176.i.i, %B46.if.i.i ], [ 0, %B46.if.i.i.preheader ]
  %.176.i.i = add nsw i64 %.105.i.01390.i, 1
  %29 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01390.i
  %.255.i.i = load double, ptr %29, align 8, !noalias !9
  %.257.i.i = mul nsw i64 %.105.i.01390.i, %arg.shape.0
  %gep6972 = getelementptr double, ptr %invariant.gep6971, i64 %.257.i.i
  store double %.255.i.i, ptr %gep6972, align 8, !noalias !9
  %exitcond1397.not.i = icmp eq i64 %arg.shape.1, %.176.i.i
  br i1 %exitcond1397.not.i, label %B102.i.i, label %B46.if.i.i

B574.i:                                           ; preds = %B516.i
  br i1 %.15851392.not.i, label %B648.i, label %B604.if.lr.ph.i

B604.if.lr.ph.i:                                  ; preds = %B574.i
  %.1646.i = icmp slt i64 %m.2.0.i, 0
  %.1647.i = select i1 %.1646.i, i64 %arg.runs.0.5.0, i64 0
  %.1648.i = add i64 %.1647.i, %m.2.0.i
  %.1668.i = mul i64 %.1648.i, %arg.runs.0.5.1
  %30 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i
  %invariant.gep6973 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.06750
  br label %B604.if.i

B648.i:                                           ; preds = %B604.if.i, %B574.i
  %.1748.i = load double, ptr %arg.times.4, align 8, !noalias !0
  %.1765.i = icmp slt i64 %m.2.0.i, 0
  %.1766.i = select i1 %.1765.i, i64 %arg.runs.2.5.0, i64 0
  %31 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1780.i = getelementptr i64, ptr %31, i64 %.1766.i
  %.1781.i = load i64, ptr %.1780.i, align 8, !noalias !0
  %.1812.i = icmp slt i64 %.1781.i, 0
  %.1813.i = select i1 %.1812.i, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i = add i64 %.1813.i, %.1781.i
  %.1834.i = mul i64 %.1814.i, %arg.schedule.0.5.1
  %.1838.i = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i
  %.1839.i = load double, ptr %.1838.i, align 8, !noalias !0
  %.1895.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.06750
  store double %.1748.i, ptr %.1895.i, align 8, !noalias !0
  %.1950.i = getelementptr double, ptr %6, i64 %.260.i.06750
  store double %.1839.i, ptr %.1950.i, align 8, !noalias !0
  %.2005.i = getelementptr double, ptr %7, i64 %.260.i.06750
  store double 0.000000e+00, ptr %.2005.i, align 8, !noalias !0
  %.2064.i = getelementptr double, ptr %8, i64 %.260.i.06750
  store double 1.000000e+00, ptr %.2064.i, align 8, !noalias !0
  %.2119.i = getelementptr double, ptr %9, i64 %.260.i.06750
  store double 0.000000e+00, ptr %.2119.i, align 8, !noalias !0
  %.2175.i = getelementptr double, ptr %10, i64 %.260.i.06750
  store double 0xFFF0000000000000, ptr %.2175.i, align 8, !noalias !0
  %32 = getelementptr i64, ptr %11, i64 %.260.i.06750
  store i64 0, ptr %32, align 8, !noalias !0
  br label %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B272.if.i:                                        ; preds = %B272.if.i.preheader, %B272.if.i
  %.638.01381.i = phi i64 [ %.709.i, %B272.if.i ], [ %.638.01381.i.ph, %B272.if.i.preheader ]
  %.709.i = add nsw i64 %.638.01381.i, 1
  %33 = getelementptr double, ptr %15, i64 %.638.01381.i
  %.784.i = load double, ptr %33, align 8, !noalias !0
  %34 = getelementptr double, ptr %16, i64 %.638.01381.i
  store double %.784.i, ptr %34, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.709.i, %arg.shape.1
  br i1 %exitcond.not.i, label %B316.i, label %B272.if.i, !llvm.loop !13

B346.if.i:                                        ; preds = %B346.if.i, %B346.if.lr.ph.i
  %.910.01384.i = phi i64 [ 0, %B346.if.lr.ph.i ], [ %.979.i, %B346.if.i ]
  %.979.i = add nsw i64 %.910.01384.i, 1
  %35 = getelementptr double, ptr %27, i64 %.910.01384.i
  %.1054.i = load double, ptr %35, align 8, !noalias !0
  %.1056.i = mul nsw i64 %.910.01384.i, %arg.shape.0
  %gep6970 = getelementptr double, ptr %invariant.gep6969, i64 %.1056.i
  store double %.1054.i, ptr %gep6970, align 8, !noalias !0
  %exitcond1395.not.i = icmp eq i64 %.979.i, %arg.shape.2
  br i1 %exitcond1395.not.i, label %B390.i, label %B346.if.i

B446.if.i:                                        ; preds = %B446.if.i, %B446.if.lr.ph.i
  %.1129.01387.i = phi i64 [ 0, %B446.if.lr.ph.i ], [ %.1198.i, %B446.if.i ]
  %.1198.i = add nsw i64 %.1129.01387.i, 1
  %.1253.i = load i64, ptr %.1252.i, align 8, !noalias !0
  %.1289.i = icmp slt i64 %.1253.i, 0
  %.1290.i = select i1 %.1289.i, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i = add i64 %.1290.i, %.1253.i
  %.1321.i = mul i64 %.1319.i, %.1291.i
  %36 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i
  %37 = getelementptr double, ptr %36, i64 %.1129.01387.i
  %.1328.i6467 = load double, ptr %37, align 8, !noalias !0
  %38 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01387.i
  %.1358.i = load i64, ptr %38, align 8, !noalias !0
  %.1360.i = mul nsw i64 %.1358.i, %arg.shape.0
  %.1362.i = add nsw i64 %.1360.i, %.260.i.06750
  %.1376.i = icmp slt i64 %.1362.i, 0
  %.1377.i = select i1 %.1376.i, i64 %arg.arrays.1.5.0, i64 0
  %39 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i
  %.1391.i = getelementptr double, ptr %39, i64 %.1377.i
  store double %.1328.i6467, ptr %.1391.i, align 8, !noalias !0
  %exitcond1396.not.i = icmp eq i64 %.1198.i, %arg.schedule.2.5.0
  br i1 %exitcond1396.not.i, label %B516.i, label %B446.if.i

B604.if.i:                                        ; preds = %B604.if.i, %B604.if.lr.ph.i
  %.1529.01393.i = phi i64 [ 0, %B604.if.lr.ph.i ], [ %.1598.i, %B604.if.i ]
  %.1598.i = add nsw i64 %.1529.01393.i, 1
  %40 = getelementptr double, ptr %30, i64 %.1529.01393.i
  %.1673.i = load double, ptr %40, align 8, !noalias !0
  %.1675.i = mul nsw i64 %.1529.01393.i, %arg.shape.0
  %gep6974 = getelementptr double, ptr %invariant.gep6973, i64 %.1675.i
  store double %.1673.i, ptr %gep6974, align 8, !noalias !0
  %exitcond1398.not.i = icmp eq i64 %.1598.i, %arg.shape.1
  br i1 %exitcond1398.not.i, label %B648.i, label %B604.if.i

_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B520.i, %B102.i.i, %B648.i
  %storemerge1373.i = phi i64 [ 1, %B648.i ], [ 0, %B102.i.i ], [ 0, %B520.i ]
  %.525.i = add nsw i64 %storemerge1373.i, %active.3.i.06752
  br label %B171.i

B171.i:                                           ; preds = %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B104.i
  %active.4.i.1 = phi i64 [ %.420.i, %B104.i ], [ %.525.i, %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.318.i = icmp sgt i64 %.263.i.06751, 1
  br i1 %.318.i, label %B50.if.i, label %B0.endif

B50.if.i:                                         ; preds = %B50.if.i.lr.ph, %B171.i
  %active.3.i.06752 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %active.4.i.1, %B171.i ]
  %.263.i.06751 = phi i64 [ %storemerge, %B50.if.i.lr.ph ], [ %.327.i, %B171.i ]
  %.260.i.06750 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %.331.i, %B171.i ]
  %.327.i = add nsw i64 %.263.i.06751, -1
  %.331.i = add nsw i64 %.260.i.06750, 1
  %41 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.06750
  %.414.i = load i64, ptr %41, align 8, !noalias !14
  %.415.i = icmp sgt i64 %.414.i, -1
  br i1 %.415.i, label %B104.i, label %B116.i

B194:                                             ; preds = %B194.preheader, %B3394
  %budget.2.0 = phi i64 [ %.634, %B3394 ], [ %arg.budget, %B194.preheader ]
  %active.4.0 = phi i64 [ %active.3.2.lcssa, %B3394 ], [ %active.3.i.0.lcssa, %B194.preheader ]
  %.634 = add nsw i64 %budget.2.0, -1
  %.669 = load i64, ptr %.668, align 8
  %.670 = icmp sgt i64 %.669, 0
  br i1 %.670, label %B228, label %B918

B228:                                             ; preds = %B194
  %.702 = icmp eq i64 %.669, 1
  store i64 0, ptr %.668, align 8
  %.765 = load i64, ptr %.764, align 8
  %.810 = inttoptr i64 %.765 to ptr
  tail call void %.810(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.702, label %B352, label %B918

B352:                                             ; preds = %B228
  br i1 %.821, label %B364, label %B408

B364:                                             ; preds = %B352
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !15
  %.195.i99 = inttoptr i64 %.150.i to ptr
  tail call void %.195.i99(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br i1 %.274.i, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i = icmp sgt i64 %.224.i.06758, 1
  br i1 %.279.i, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B364
  %.614.i = load i64, ptr %.764, align 8, !noalias !15
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br label %B408

B118.if.i:                                        ; preds = %B364, %B248.i
  %.224.i.06758 = phi i64 [ %.288.i238, %B248.i ], [ %storemerge, %B364 ]
  %.221.i.06757 = phi i64 [ %.292.i240, %B248.i ], [ 0, %B364 ]
  %.288.i238 = add nsw i64 %.224.i.06758, -1
  %.292.i240 = add nsw i64 %.221.i.06757, 1
  %42 = getelementptr double, ptr %161, i64 %.221.i.06757
  %.374.i149 = load double, ptr %42, align 8, !noalias !15
  %.375.i = fcmp ule double %.374.i149, 5.000000e-01
  %brmerge = select i1 %.375.i, i1 true, i1 %.457.i1786753
  br i1 %brmerge, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep6975 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.06757
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i.06754 = phi i64 [ %.470.i231, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i231 = add nsw i64 %.401.i.06754, 1
  %.496.i189 = mul nsw i64 %.401.i.06754, %arg.shape.0
  %gep6976 = getelementptr double, ptr %invariant.gep6975, i64 %.496.i189
  %.528.i210 = load double, ptr %gep6976, align 8, !noalias !15
  %.530.i = add nsw i64 %.401.i.06754, %arg.held
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i = add nsw i64 %.532.i, %.221.i.06757
  %.548.i = icmp slt i64 %.534.i, 0
  %.549.i218 = select i1 %.548.i, i64 %arg.arrays.1.5.0, i64 0
  %43 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i
  %.563.i = getelementptr double, ptr %43, i64 %.549.i218
  store double %.528.i210, ptr %.563.i, align 8, !noalias !15
  %exitcond.not = icmp eq i64 %.470.i231, %arg.decided
  br i1 %exitcond.not, label %B248.i, label %B190.if.i

B408:                                             ; preds = %B250.i, %B352
  %.908 = load i64, ptr %arg.code.4, align 8
  %.956 = inttoptr i64 %.908 to ptr
  tail call void %.956(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.955)
  br i1 %.959.not, label %B570, label %B502

B502:                                             ; preds = %B408
  %.990 = load i64, ptr %.989, align 8
  %.1035 = inttoptr i64 %.990 to ptr
  tail call void %.1035(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B570

B570:                                             ; preds = %B502, %B408
  %.1067 = load i64, ptr %.1066, align 8
  %.1112 = inttoptr i64 %.1067 to ptr
  tail call void %.1112(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1143 = load i64, ptr %.1142, align 8
  %.1188 = inttoptr i64 %.1143 to ptr
  tail call void %.1188(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1219 = load i64, ptr %arg.code.4, align 8
  %.1269 = inttoptr i64 %.1219 to ptr
  tail call void %.1269(ptr %.466, ptr %.1243, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1268)
  %.1300 = load i64, ptr %.1299, align 8
  %.1345 = inttoptr i64 %.1300 to ptr
  tail call void %.1345(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B918, label %B62.if.i

B104.i430:                                        ; preds = %B62.if.i
  store double 0.000000e+00, ptr %.296.i427, align 8, !noalias !19
  %.412.i513 = getelementptr double, ptr %163, i64 %.144.i332.06760
  store double 0.000000e+00, ptr %.412.i513, align 8, !noalias !19
  %44 = getelementptr i64, ptr %arg.lane.1.4, i64 %.144.i332.06760
  %.468.i560 = load i64, ptr %44, align 8, !noalias !19
  %.495.i583 = icmp slt i64 %.468.i560, 0
  %.496.i584 = select i1 %.495.i583, i64 %arg.results.3.5.0, i64 0
  %.497.i585 = add i64 %.496.i584, %.468.i560
  %.517.i605 = mul i64 %.497.i585, %arg.results.3.5.1
  %45 = getelementptr i64, ptr %arg.results.3.4, i64 %.517.i605
  %.521.i608 = getelementptr i8, ptr %45, i64 8
  %.522.i609 = load i64, ptr %.521.i608, align 8, !noalias !19
  %.523.i610 = add nsw i64 %.522.i609, 2
  store i64 %.523.i610, ptr %.521.i608, align 8, !noalias !19
  %.630.i = load i64, ptr %44, align 8, !noalias !19
  %.657.i = icmp slt i64 %.630.i, 0
  %.658.i687 = select i1 %.657.i, i64 %arg.results.3.5.0, i64 0
  %.659.i688 = add i64 %.658.i687, %.630.i
  %.679.i = mul i64 %.659.i688, %arg.results.3.5.1
  %46 = getelementptr i64, ptr %arg.results.3.4, i64 %.679.i
  %.683.i = getelementptr i8, ptr %46, i64 16
  %.684.i = load i64, ptr %.683.i, align 8, !noalias !19
  %.685.i = add nsw i64 %.684.i, 1
  store i64 %.685.i, ptr %.683.i, align 8, !noalias !19
  %.791.i = getelementptr double, ptr %164, i64 %.144.i332.06760
  %.792.i = load double, ptr %.791.i, align 8, !noalias !19
  %.793.i = fcmp une double %.792.i, 0.000000e+00
  br i1 %.793.i, label %B336.i, label %B382.i

B336.i:                                           ; preds = %B104.i430
  %.84.i.i = load i64, ptr %44, align 8, !noalias !23
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B382.i

B46.i.i:                                          ; preds = %B336.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !23
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B382.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !23
  br label %B382.i

B382.i:                                           ; preds = %B80.i.i, %B336.i, %B46.i.i, %B104.i430
  br i1 %.959.not, label %B518.i, label %B386.i

B386.i:                                           ; preds = %B382.i
  %47 = getelementptr double, ptr %arg.arrays.4.4, i64 %.144.i332.06760
  %.863.i = load double, ptr %47, align 8, !noalias !19
  %.865.i = fcmp olt double %.863.i, -1.000000e-09
  br i1 %.865.i, label %B422.i, label %B518.i

B422.i:                                           ; preds = %B386.i
  %.84.i63.i = load i64, ptr %44, align 8, !noalias !26
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B46.i71.i:                                        ; preds = %B422.i
  %.120.i91.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !26
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !26
  br label %_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i: ; preds = %B46.i71.i, %B422.i, %B80.i98.i
  %.954.i = getelementptr double, ptr %arg.lane.0.4, i64 %.144.i332.06760
  %.955.i = load double, ptr %.954.i, align 8, !noalias !19
  %.1011.i = getelementptr double, ptr %165, i64 %.144.i332.06760
  store double %.955.i, ptr %.1011.i, align 8, !noalias !19
  br label %B518.i

B518.i:                                           ; preds = %_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B386.i, %B382.i, %B62.if.i
  %.202.i383 = icmp sgt i64 %.147.i.06761, 1
  br i1 %.202.i383, label %B62.if.i, label %B918

B62.if.i:                                         ; preds = %B570, %B518.i
  %.147.i.06761 = phi i64 [ %.211.i728, %B518.i ], [ %storemerge, %B570 ]
  %.144.i332.06760 = phi i64 [ %.215.i731, %B518.i ], [ 0, %B570 ]
  %.211.i728 = add nsw i64 %.147.i.06761, -1
  %.215.i731 = add nsw i64 %.144.i332.06760, 1
  %.296.i427 = getelementptr double, ptr %162, i64 %.144.i332.06760
  %.297.i428 = load double, ptr %.296.i427, align 8, !noalias !19
  %.298.i429 = fcmp ogt double %.297.i428, 5.000000e-01
  br i1 %.298.i429, label %B104.i430, label %B518.i

B918:                                             ; preds = %B518.i, %B570, %B194, %B228
  %.1433 = load i64, ptr %.1432, align 8
  %.1478 = inttoptr i64 %.1433 to ptr
  tail call void %.1478(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B1028.if

B1214:                                            ; preds = %B1028.if
  %.1789 = load i64, ptr %.1788, align 8
  %.1834 = inttoptr i64 %.1789 to ptr
  tail call void %.1834(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B1896, label %B1326.if

B1402:                                            ; preds = %B1326.if
  %.2159 = mul i64 %.2039, %arg.results.3.5.1
  %48 = getelementptr i64, ptr %arg.results.3.4, i64 %.2159
  %.2163 = getelementptr i8, ptr %48, i64 8
  %.2164 = load i64, ptr %.2163, align 8
  %.2166 = add nsw i64 %.2164, 11
  store i64 %.2166, ptr %.2163, align 8
  %.2272 = getelementptr double, ptr %167, i64 %.1875.06765
  %.2273 = load double, ptr %.2272, align 8
  %.2274 = fcmp ogt double %.2273, 5.000000e-01
  br i1 %.2274, label %B1502, label %B1548

B1502:                                            ; preds = %B1402
  %49 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1875.06765
  %.84.i776 = load i64, ptr %49, align 8, !noalias !29
  %.89.i779 = icmp sgt i64 %.84.i776, -1
  br i1 %.89.i779, label %B46.i, label %B1548

B46.i:                                            ; preds = %B1502
  %.120.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i776
  %.121.i791 = load i64, ptr %.120.i, align 8, !noalias !29
  %.122.i792 = icmp eq i64 %.121.i791, 0
  br i1 %.122.i792, label %B80.i, label %B1548

B80.i:                                            ; preds = %B46.i
  store i64 2, ptr %.120.i, align 8, !noalias !29
  br label %B1548

B1548:                                            ; preds = %B80.i, %B1502, %B46.i, %B1402
  %.2364 = getelementptr double, ptr %168, i64 %.1875.06765
  %.2365 = load double, ptr %.2364, align 8
  %.2366 = fcmp olt double %.2365, 5.000000e-01
  br i1 %.2366, label %B1586, label %B1634

B1586:                                            ; preds = %B1548
  %.2445 = getelementptr i8, ptr %48, i64 24
  %.2446 = load i64, ptr %.2445, align 8
  %.2447 = add nsw i64 %.2446, 1
  store i64 %.2447, ptr %.2445, align 8
  br label %B3421

B1634:                                            ; preds = %B1548
  %spec.select = select i1 %within.3.16769, i1 true, i1 %.2515
  %.2594 = load i64, ptr %48, align 8
  %.2595 = add nsw i64 %.2594, 1
  store i64 %.2595, ptr %48, align 8
  %.2704 = load i64, ptr %.2163, align 8
  %.2705 = add nsw i64 %.2704, 1
  store i64 %.2705, ptr %.2163, align 8
  %.2769 = icmp slt i64 %.2094, %arg.times.5.0
  br i1 %.2769, label %B1784, label %B3421

B1784:                                            ; preds = %B1634
  %.2796 = icmp slt i64 %.2094, 0
  %.2797 = select i1 %.2796, i64 %arg.times.5.0, i64 0
  %50 = getelementptr double, ptr %arg.times.4, i64 %.2094
  %.2811 = getelementptr double, ptr %50, i64 %.2797
  %.2812 = load double, ptr %.2811, align 8
  %.2866 = getelementptr double, ptr %169, i64 %.1875.06765
  %.2867 = load double, ptr %.2866, align 8
  %.2868 = fcmp ugt double %.2812, %.2867
  br i1 %.2868, label %B3421, label %B1834

B1834:                                            ; preds = %B1784
  %.2977 = fcmp olt double %.2812, %.2867
  %spec.select6461 = or i1 %spec.select, %.2977
  br label %B3421

B1896.loopexit:                                   ; preds = %B3421
  %51 = select i1 %wanted.3.2, i1 true, i1 %within.4.2
  %52 = xor i1 %51, true
  br label %B1896

B1896:                                            ; preds = %B1896.loopexit, %B1214
  %good.2.1.lcssa = phi i1 [ false, %B1214 ], [ %good.3.2, %B1896.loopexit ]
  %wanted.2.1.lcssa = phi i1 [ true, %B1214 ], [ %52, %B1896.loopexit ]
  %within.3.1.lcssa = phi i1 [ false, %B1214 ], [ %within.4.2, %B1896.loopexit ]
  br i1 %good.2.1.lcssa, label %B1900, label %B2016

B1900:                                            ; preds = %B1896
  %.3068 = load i64, ptr %arg.code.4, align 8
  %.3118 = inttoptr i64 %.3068 to ptr
  tail call void %.3118(ptr %.466, ptr %.3092, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3117)
  br label %B2016

B2016:                                            ; preds = %B1900, %B1896
  %brmerge.not = and i1 %.3129, %good.2.1.lcssa
  br i1 %brmerge.not, label %B2036, label %B2158

B2036:                                            ; preds = %B2016
  %.3169 = load i64, ptr %.3168, align 8
  %.3216 = inttoptr i64 %.3169 to ptr
  tail call void %.3216(ptr %.466, ptr %.3190, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2158, label %B38.if.i

B104.i1027:                                       ; preds = %B38.if.i
  %.349.i1071 = getelementptr double, ptr %171, i64 %.78.i859.06774
  %.350.i1072 = load double, ptr %.349.i1071, align 8, !noalias !32
  %.351.i1073 = fcmp ogt double %.350.i1072, 5.000000e-01
  br i1 %.351.i1073, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i1027, %B36.i.i
  %.48.i.i822.0 = phi i64 [ %.119.i.i, %B36.i.i ], [ 0, %B104.i1027 ]
  %exitcond6861.not = icmp eq i64 %.48.i.i822.0, %arg.decided
  br i1 %exitcond6861.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i = add i64 %.48.i.i822.0, 1
  %.149.i.i1326 = add nsw i64 %.48.i.i822.0, %arg.decided
  %.151.i.i1328 = mul nsw i64 %.149.i.i1326, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i1328, %.78.i859.06774
  %.167.i.i = icmp slt i64 %.153.i.i, 0
  %.168.i.i1332 = select i1 %.167.i.i, i64 %arg.arrays.4.5.0, i64 0
  %53 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i.i
  %.182.i.i = getelementptr double, ptr %53, i64 %.168.i.i1332
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !36
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i1134:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i973, align 8, !noalias !32
  %.503.i1229 = getelementptr double, ptr %172, i64 %.78.i859.06774
  store double 0.000000e+00, ptr %.503.i1229, align 8, !noalias !32
  %.558.i1275 = getelementptr double, ptr %173, i64 %.78.i859.06774
  store double 1.000000e+00, ptr %.558.i1275, align 8, !noalias !32
  %.616.i = getelementptr i64, ptr %174, i64 %.78.i859.06774
  store i64 %.363.i870.0, ptr %.616.i, align 8, !noalias !32
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i1134, %B104.i1027, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i1134 ], [ %some.2.i.06776, %B142.endif.i ], [ %some.2.i.06776, %B104.i1027 ], [ %some.2.i.06776, %B38.if.i ]
  %.136.i911 = icmp sgt i64 %.81.i860.06775, 1
  br i1 %.136.i911, label %B38.if.i, label %B2158

B38.if.i:                                         ; preds = %B2036, %B304.i
  %some.2.i.06776 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2036 ]
  %.81.i860.06775 = phi i64 [ %.145.i1347, %B304.i ], [ %storemerge, %B2036 ]
  %.78.i859.06774 = phi i64 [ %.149.i1350, %B304.i ], [ 0, %B2036 ]
  %.145.i1347 = add nsw i64 %.81.i860.06775, -1
  %.149.i1350 = add nsw i64 %.78.i859.06774, 1
  %.234.i973 = getelementptr double, ptr %170, i64 %.78.i859.06774
  store double 0.000000e+00, ptr %.234.i973, align 8, !noalias !32
  %.289.i1019 = getelementptr i64, ptr %arg.lane.1.4, i64 %.78.i859.06774
  %.290.i1020 = load i64, ptr %.289.i1019, align 8, !noalias !32
  %.291.i1021 = icmp sgt i64 %.290.i1020, -1
  br i1 %.291.i1021, label %B104.i1027, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i870.0 = phi i64 [ %.48.i.i822.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i1133 = icmp sgt i64 %.363.i870.0, -1
  br i1 %.393.i1133, label %B190.i1134, label %B304.i

B2158:                                            ; preds = %B304.i, %B2036, %B2016
  %beyond.2.1 = phi i1 [ false, %B2016 ], [ false, %B2036 ], [ %some.3.i.1, %B304.i ]
  %brmerge6462 = select i1 %within.3.1.lcssa, i1 true, i1 %beyond.2.1
  br i1 %brmerge6462, label %B2230.if, label %B2654

B102.loopexit.i.critedge:                         ; preds = %B104.if.i
  %.1014.i.c = load i64, ptr %.1013.i, align 8, !noalias !40
  %.1131.i.c = inttoptr i64 %.1014.i.c to ptr
  tail call void %.1131.i.c(ptr %.466, ptr %.1105.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !40
  br label %B102.loopexit.i

B102.loopexit.i:                                  ; preds = %B1498.i, %B102.loopexit.i.critedge
  %.281.i = icmp ugt i64 %.225.01193.i, 1
  br i1 %.281.i, label %B104.if.i, label %B842.i

B138.loopexit.i:                                  ; preds = %B380.if.i, %middle.block6961, %B138.if.i
  %exitcond1198.not.i = icmp eq i64 %arg.shape.0, %.412.i
  br i1 %exitcond1198.not.i, label %B474.i, label %B138.if.i

B474.i:                                           ; preds = %B138.loopexit.i
  %.1014.i = load i64, ptr %.1013.i, align 8, !noalias !40
  %.1131.i = inttoptr i64 %.1014.i to ptr
  tail call void %.1131.i(ptr %.466, ptr %.1105.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !40
  br label %B622.if.i

B674.i:                                           ; preds = %B622.if.i
  %.1364.i = getelementptr double, ptr %175, i64 %.1157.01191.i
  %.1365.i = load double, ptr %.1364.i, align 8, !noalias !40
  %.1419.i = getelementptr double, ptr %176, i64 %.1157.01191.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !40
  %.1421.i = fadd double %.1365.i, %.1420.i
  %.1422.i = fmul double %.1421.i, 5.000000e-01
  br label %B34.i.i6478

B34.i.i6478:                                      ; preds = %B34.if.i.i6479, %B674.i
  %.48.i.0.i = phi i64 [ 0, %B674.i ], [ %.119.i73.i, %B34.if.i.i6479 ]
  %exitcond1199.not.i = icmp eq i64 %.48.i.0.i, %storemerge1173.i
  br i1 %exitcond1199.not.i, label %B812.i, label %B34.if.i.i6479

B80.i.i6481:                                      ; preds = %B34.if.i.i6479
  %54 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %54, label %B786.i, label %B812.i

B34.if.i.i6479:                                   ; preds = %B34.i.i6478
  %.119.i73.i = add i64 %.48.i.0.i, 1
  %.149.i42.i = add nsw i64 %.48.i.0.i, %arg.decided
  %.151.i.i = mul nsw i64 %.149.i42.i, %arg.shape.0
  %.153.i44.i = add nsw i64 %.151.i.i, %.1157.01191.i
  %.167.i51.i = icmp slt i64 %.153.i44.i, 0
  %.168.i.i = select i1 %.167.i51.i, i64 %arg.arrays.4.5.0, i64 0
  %55 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i44.i
  %.182.i.i6480 = getelementptr double, ptr %55, i64 %.168.i.i
  %.183.i63.i = load double, ptr %.182.i.i6480, align 8, !noalias !43
  %.184.i64.i = fcmp ogt double %.183.i63.i, 5.000000e-01
  br i1 %.184.i64.i, label %B80.i.i6481, label %B34.i.i6478

B786.i:                                           ; preds = %B80.i.i6481
  store double %.1422.i, ptr %.1419.i, align 8, !noalias !40
  br label %B1498.i

B812.i:                                           ; preds = %B34.i.i6478, %B80.i.i6481
  store double %.1422.i, ptr %.1364.i, align 8, !noalias !40
  br label %B1498.i

B842.i:                                           ; preds = %B102.loopexit.i
  br i1 %.274.i, label %B2612, label %B874.if.i

B978.i:                                           ; preds = %B874.if.i
  %.2010.i = load double, ptr %.1786.i, align 8, !noalias !40
  %.2011.i = tail call double @llvm.fabs.f64(double %.2010.i)
  %.2012.i = fmul double %.2011.i, 2.000000e-12
  %.2069.i = getelementptr double, ptr %175, i64 %.1635.01195.i
  %.2070.i = load double, ptr %.2069.i, align 8, !noalias !40
  %.2125.i = getelementptr double, ptr %178, i64 %.1635.01195.i
  %.2126.i = load double, ptr %.2125.i, align 8, !noalias !40
  %.2183.i = fmul double %.2126.i, 0x3D719799812DEA11
  %.10.i.i = fcmp ogt double %.2012.i, %.2183.i
  %.11.i.i = select i1 %.10.i.i, double %.2012.i, double %.2183.i
  %.2071.i = fsub double 1.000000e+00, %.2070.i
  %.2127.i = fmul double %.2071.i, %.2126.i
  %.2212.i6477 = fcmp ugt double %.2127.i, %.11.i.i
  br i1 %.2212.i6477, label %B1268.i, label %B1232.i

B1232.i:                                          ; preds = %B978.i
  store double 2.000000e+00, ptr %.1896.i, align 8, !noalias !40
  br label %B1497.i

B1268.i:                                          ; preds = %B978.i
  %56 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1635.01195.i
  %.1954.i = load i64, ptr %56, align 8, !noalias !40
  %.2331.i = getelementptr double, ptr %180, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2331.i, align 8, !noalias !40
  %.2386.i = getelementptr double, ptr %181, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2386.i, align 8, !noalias !40
  %.2441.i = getelementptr double, ptr %176, i64 %.1635.01195.i
  %.2442.i = load double, ptr %.2441.i, align 8, !noalias !40
  %.2497.i = load double, ptr %.2125.i, align 8, !noalias !40
  %.2498.i = fmul double %.2442.i, %.2497.i
  %.2554.i = getelementptr double, ptr %182, i64 %.1635.01195.i
  store double %.2498.i, ptr %.2554.i, align 8, !noalias !40
  %.2583.i = icmp slt i64 %.1954.i, 0
  %.2584.i = select i1 %.2583.i, i64 %arg.results.3.5.0, i64 0
  %.2585.i = add i64 %.2584.i, %.1954.i
  %.2605.i = mul i64 %.2585.i, %arg.results.3.5.1
  %.2609.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2605.i
  %.2610.i = load i64, ptr %.2609.i, align 8, !noalias !40
  %.2611.i = add nsw i64 %.2610.i, -1
  store i64 %.2611.i, ptr %.2609.i, align 8, !noalias !40
  %.2719.i = getelementptr i8, ptr %.2609.i, i64 24
  %.2720.i = load i64, ptr %.2719.i, align 8, !noalias !40
  %.2721.i = add nsw i64 %.2720.i, 1
  store i64 %.2721.i, ptr %.2719.i, align 8, !noalias !40
  br label %B1497.i

B1497.i:                                          ; preds = %B874.if.i, %B1268.i, %B1232.i
  %exitcond1201.not.i = icmp eq i64 %.1705.i, %arg.shape.0
  br i1 %exitcond1201.not.i, label %B2612, label %B874.if.i

B1498.i:                                          ; preds = %B622.if.i, %B812.i, %B786.i
  %exitcond1200.not.i = icmp eq i64 %arg.shape.0, %.1226.i
  br i1 %exitcond1200.not.i, label %B102.loopexit.i, label %B622.if.i

B104.if.i:                                        ; preds = %B2230.if, %B102.loopexit.i
  %.225.01193.i = phi i64 [ %.290.i, %B102.loopexit.i ], [ 50, %B2230.if ]
  %.290.i = add nsw i64 %.225.01193.i, -1
  br i1 %.274.i, label %B102.loopexit.i.critedge, label %B138.if.i

B138.if.i:                                        ; preds = %B104.if.i, %B138.loopexit.i
  %.343.01188.i = phi i64 [ %.412.i, %B138.loopexit.i ], [ 0, %B104.if.i ]
  %.412.i = add nsw i64 %.343.01188.i, 1
  %.493.i = getelementptr double, ptr %175, i64 %.343.01188.i
  %.494.i = load double, ptr %.493.i, align 8, !noalias !40
  %.548.i6474 = getelementptr double, ptr %176, i64 %.343.01188.i
  %.549.i = load double, ptr %.548.i6474, align 8, !noalias !40
  %.550.i = fadd double %.494.i, %.549.i
  %.551.i = fmul double %.550.i, 5.000000e-01
  %.608.i = getelementptr double, ptr %177, i64 %.343.01188.i
  %.609.i = load double, ptr %.608.i, align 8, !noalias !40
  %.610.i = fcmp une double %.609.i, 1.000000e+00
  %share.3.2.i = select i1 %.610.i, double 1.000000e+00, double %.551.i
  %.668.i = getelementptr double, ptr %arg.lane.0.4, i64 %.343.01188.i
  %.669.i = load double, ptr %.668.i, align 8, !noalias !40
  %.723.i = getelementptr double, ptr %178, i64 %.343.01188.i
  %.724.i = load double, ptr %.723.i, align 8, !noalias !40
  %.726.i = fmul double %share.3.2.i, %.724.i
  %.727.i = fadd double %.669.i, %.726.i
  %.781.i = getelementptr double, ptr %.466, i64 %.343.01188.i
  store double %.727.i, ptr %.781.i, align 8, !noalias !40
  br i1 %.8631184.not.i, label %B138.loopexit.i, label %B380.if.lr.ph.i

B380.if.lr.ph.i:                                  ; preds = %B138.if.i
  %.247.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6780 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6782 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6784 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6786 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6788 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6790 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6792 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep6794 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %or.cond6965.not = xor i1 %or.cond6965, true
  %brmerge7017 = select i1 %or.cond6965.not, i1 true, i1 %conflict.rdx6940
  br i1 %brmerge7017, label %B380.if.i.preheader, label %vector.ph6943

vector.ph6943:                                    ; preds = %B380.if.lr.ph.i
  %broadcast.splatinsert6946 = insertelement <2 x double> poison, double %.247.i.i, i64 0
  %broadcast.splat6947 = shufflevector <2 x double> %broadcast.splatinsert6946, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert6948 = insertelement <2 x double> poison, double %share.3.2.i, i64 0
  %broadcast.splat6949 = shufflevector <2 x double> %broadcast.splatinsert6948, <2 x double> poison, <2 x i32> zeroinitializer
  %invariant.gep6977 = getelementptr double, ptr %invariant.gep, i64 %.155.i.i
  %invariant.gep6979 = getelementptr double, ptr %invariant.gep6780, i64 %.155.i.1.i
  %invariant.gep6981 = getelementptr double, ptr %invariant.gep6782, i64 %.155.i.2.i
  %invariant.gep6983 = getelementptr double, ptr %invariant.gep6784, i64 %.155.i.3.i
  %invariant.gep6985 = getelementptr double, ptr %invariant.gep6786, i64 %.155.i.4.i
  %invariant.gep6987 = getelementptr double, ptr %invariant.gep6788, i64 %.155.i.5.i
  %invariant.gep6989 = getelementptr double, ptr %invariant.gep6790, i64 %.155.i.6.i
  %invariant.gep6991 = getelementptr double, ptr %invariant.gep6794, i64 %.935.i
  br label %vector.body6950

vector.body6950:                                  ; preds = %vector.body6950, %vector.ph6943
  %index6951 = phi i64 [ 0, %vector.ph6943 ], [ %index.next6960, %vector.body6950 ]
  %gep6978 = getelementptr double, ptr %invariant.gep6977, i64 %index6951
  %wide.load6952 = load <2 x double>, ptr %gep6978, align 8, !noalias !47
  %57 = fadd <2 x double> %wide.load6952, zeroinitializer
  %58 = fmul <2 x double> %broadcast.splat6949, %57
  %gep6980 = getelementptr double, ptr %invariant.gep6979, i64 %index6951
  %wide.load6953 = load <2 x double>, ptr %gep6980, align 8, !noalias !47
  %59 = fadd <2 x double> %wide.load6953, %58
  %60 = fmul <2 x double> %broadcast.splat6947, %59
  %gep6982 = getelementptr double, ptr %invariant.gep6981, i64 %index6951
  %wide.load6954 = load <2 x double>, ptr %gep6982, align 8, !noalias !47
  %61 = fadd <2 x double> %wide.load6954, %60
  %62 = fmul <2 x double> %broadcast.splat6949, %61
  %gep6984 = getelementptr double, ptr %invariant.gep6983, i64 %index6951
  %wide.load6955 = load <2 x double>, ptr %gep6984, align 8, !noalias !47
  %63 = fadd <2 x double> %wide.load6955, %62
  %64 = fmul <2 x double> %broadcast.splat6947, %63
  %gep6986 = getelementptr double, ptr %invariant.gep6985, i64 %index6951
  %wide.load6956 = load <2 x double>, ptr %gep6986, align 8, !noalias !47
  %65 = fadd <2 x double> %wide.load6956, %64
  %66 = fmul <2 x double> %broadcast.splat6949, %65
  %gep6988 = getelementptr double, ptr %invariant.gep6987, i64 %index6951
  %wide.load6957 = load <2 x double>, ptr %gep6988, align 8, !noalias !47
  %67 = fadd <2 x double> %wide.load6957, %66
  %68 = fmul <2 x double> %broadcast.splat6947, %67
  %gep6990 = getelementptr double, ptr %invariant.gep6989, i64 %index6951
  %wide.load6958 = load <2 x double>, ptr %gep6990, align 8, !noalias !47
  %69 = fadd <2 x double> %wide.load6958, %68
  %70 = fmul <2 x double> %broadcast.splat6949, %69
  %71 = getelementptr double, ptr %invariant.gep6792, i64 %index6951
  %wide.load6959 = load <2 x double>, ptr %71, align 8, !noalias !47
  %72 = fadd <2 x double> %wide.load6959, %70
  %gep6992 = getelementptr double, ptr %invariant.gep6991, i64 %index6951
  store <2 x double> %72, ptr %gep6992, align 8, !noalias !40
  %index.next6960 = add i64 %index6951, 2
  %73 = icmp eq i64 %index.next6960, %n.vec6945
  br i1 %73, label %middle.block6961, label %vector.body6950, !llvm.loop !51

middle.block6961:                                 ; preds = %vector.body6950
  br i1 %cmp.n6962, label %B138.loopexit.i, label %B380.if.i.preheader

B380.if.i.preheader:                              ; preds = %B380.if.lr.ph.i, %middle.block6961
  %.807.01185.i.ph = phi i64 [ %n.vec6945, %middle.block6961 ], [ 0, %B380.if.lr.ph.i ]
  br label %B380.if.i

B380.if.i:                                        ; preds = %B380.if.i.preheader, %B380.if.i
  %.807.01185.i = phi i64 [ %.876.i, %B380.if.i ], [ %.807.01185.i.ph, %B380.if.i.preheader ]
  %.157.i.i = add nsw i64 %.807.01185.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep, align 8, !noalias !47
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %share.3.2.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.807.01185.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep6781 = getelementptr double, ptr %invariant.gep6780, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep6781, align 8, !noalias !47
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.807.01185.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep6783 = getelementptr double, ptr %invariant.gep6782, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep6783, align 8, !noalias !47
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %share.3.2.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.807.01185.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep6785 = getelementptr double, ptr %invariant.gep6784, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep6785, align 8, !noalias !47
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.807.01185.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep6787 = getelementptr double, ptr %invariant.gep6786, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep6787, align 8, !noalias !47
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %share.3.2.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.807.01185.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep6789 = getelementptr double, ptr %invariant.gep6788, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep6789, align 8, !noalias !47
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.807.01185.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep6791 = getelementptr double, ptr %invariant.gep6790, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep6791, align 8, !noalias !47
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %share.3.2.i, %.193.i.6.i
  %.876.i = add nsw i64 %.807.01185.i, 1
  %.271.i.i = mul nsw i64 %.807.01185.i, %arg.shape.0
  %gep6793 = getelementptr double, ptr %invariant.gep6792, i64 %.271.i.i
  %.309.i.i = load double, ptr %gep6793, align 8, !noalias !47
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  %.936.i = add nsw i64 %.807.01185.i, %.935.i
  %.938.i = mul nsw i64 %.936.i, %arg.shape.0
  %gep6795 = getelementptr double, ptr %invariant.gep6794, i64 %.938.i
  store double %.313.i.i, ptr %gep6795, align 8, !noalias !40
  %exitcond.not.i6475 = icmp eq i64 %arg.shape.1, %.876.i
  br i1 %exitcond.not.i6475, label %B138.loopexit.i, label %B380.if.i, !llvm.loop !52

B622.if.i:                                        ; preds = %B474.i, %B1498.i
  %.1157.01191.i = phi i64 [ %.1226.i, %B1498.i ], [ 0, %B474.i ]
  %.1226.i = add nsw i64 %.1157.01191.i, 1
  %.1307.i = getelementptr double, ptr %177, i64 %.1157.01191.i
  %.1308.i = load double, ptr %.1307.i, align 8, !noalias !40
  %.1309.i = fcmp oeq double %.1308.i, 1.000000e+00
  br i1 %.1309.i, label %B674.i, label %B1498.i

B874.if.i:                                        ; preds = %B842.i, %B1497.i
  %.1635.01195.i = phi i64 [ %.1705.i, %B1497.i ], [ 0, %B842.i ]
  %.1705.i = add nsw i64 %.1635.01195.i, 1
  %.1786.i = getelementptr double, ptr %179, i64 %.1635.01195.i
  %.1787.i = load double, ptr %.1786.i, align 8, !noalias !40
  %.1841.i = getelementptr double, ptr %.466, i64 %.1635.01195.i
  store double %.1787.i, ptr %.1841.i, align 8, !noalias !40
  %.1896.i = getelementptr double, ptr %177, i64 %.1635.01195.i
  %.1897.i = load double, ptr %.1896.i, align 8, !noalias !40
  %.1898.i = fcmp oeq double %.1897.i, 1.000000e+00
  br i1 %.1898.i, label %B978.i, label %B1497.i

B2612:                                            ; preds = %B1497.i, %B842.i, %B2230.if
  br i1 %.3792.not, label %B2654, label %B112.if.i

B110.loopexit.i.critedge:                         ; preds = %B112.if.i
  %.846.i.c = load i64, ptr %.845.i, align 8, !noalias !53
  %.963.i.c = inttoptr i64 %.846.i.c to ptr
  tail call void %.963.i.c(ptr %.466, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !53
  br label %B110.loopexit.i

B110.loopexit.i:                                  ; preds = %B678.i, %B110.loopexit.i.critedge
  %exitcond671.not.i = icmp eq i64 %.292.i, 17
  br i1 %exitcond671.not.i, label %B2654, label %B112.if.i

B166.loopexit.i:                                  ; preds = %B288.if.i, %middle.block6920, %B166.if.i
  %exitcond669.not.i = icmp eq i64 %arg.shape.0, %.419.i
  br i1 %exitcond669.not.i, label %B382.i6531, label %B166.if.i

B382.i6531:                                       ; preds = %B166.loopexit.i
  %.846.i = load i64, ptr %.845.i, align 8, !noalias !53
  %.963.i = inttoptr i64 %.846.i to ptr
  tail call void %.963.i(ptr %.466, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !53
  br label %B530.if.i

B572.i:                                           ; preds = %B530.if.i
  %74 = getelementptr double, ptr %arg.arrays.4.4, i64 %.989.0665.i
  %.1173.i = load double, ptr %74, align 8, !noalias !53
  %.1175.i = fcmp olt double %.1173.i, -1.000000e-09
  br i1 %.1175.i, label %B608.i, label %B678.i

B608.i:                                           ; preds = %B572.i
  %75 = getelementptr i64, ptr %arg.lane.1.4, i64 %.989.0665.i
  %.84.i35.i = load i64, ptr %75, align 8, !noalias !56
  %.89.i37.i = icmp sgt i64 %.84.i35.i, -1
  br i1 %.89.i37.i, label %B46.i.i6533, label %B608.endif.i

B46.i.i6533:                                      ; preds = %B608.i
  %.120.i51.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i35.i
  %.121.i.i6534 = load i64, ptr %.120.i51.i, align 8, !noalias !56
  %.122.i.i6535 = icmp eq i64 %.121.i.i6534, 0
  br i1 %.122.i.i6535, label %B80.i.i6536, label %B608.endif.i

B80.i.i6536:                                      ; preds = %B46.i.i6533
  store i64 4, ptr %.120.i51.i, align 8, !noalias !56
  br label %B608.endif.i

B678.i:                                           ; preds = %B608.endif.i, %B530.if.i, %B572.i
  %exitcond670.not.i = icmp eq i64 %arg.shape.0, %.1058.i6532
  br i1 %exitcond670.not.i, label %B110.loopexit.i, label %B530.if.i

B112.if.i:                                        ; preds = %B2612, %B110.loopexit.i
  %.220.0667.i = phi i64 [ %.292.i, %B110.loopexit.i ], [ 1, %B2612 ]
  %.292.i = add nsw i64 %.220.0667.i, 1
  %76 = uitofp i64 %.220.0667.i to double
  %77 = fmul double %76, 6.250000e-02
  br i1 %.274.i, label %B110.loopexit.i.critedge, label %B166.if.lr.ph.i

B166.if.lr.ph.i:                                  ; preds = %B112.if.i
  %.247.i.i6483 = fsub double 1.000000e+00, %77
  %broadcast.splatinsert = insertelement <2 x double> poison, double %77, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert6907 = insertelement <2 x double> poison, double %.247.i.i6483, i64 0
  %broadcast.splat6908 = shufflevector <2 x double> %broadcast.splatinsert6907, <2 x double> poison, <2 x i32> zeroinitializer
  br label %B166.if.i

B166.if.i:                                        ; preds = %B166.if.lr.ph.i, %B166.loopexit.i
  %.350.0662.i = phi i64 [ 0, %B166.if.lr.ph.i ], [ %.419.i, %B166.loopexit.i ]
  %.419.i = add nsw i64 %.350.0662.i, 1
  %.500.i = getelementptr double, ptr %arg.lane.0.4, i64 %.350.0662.i
  %.501.i = load double, ptr %.500.i, align 8, !noalias !53
  %.555.i = getelementptr double, ptr %183, i64 %.350.0662.i
  %.556.i = load double, ptr %.555.i, align 8, !noalias !53
  %.558.i = fmul double %77, %.556.i
  %.559.i = fadd double %.501.i, %.558.i
  %.613.i6484 = getelementptr double, ptr %.466, i64 %.350.0662.i
  store double %.559.i, ptr %.613.i6484, align 8, !noalias !53
  br i1 %.695658.not.i, label %B166.loopexit.i, label %B288.if.preheader.i

B288.if.preheader.i:                              ; preds = %B166.if.i
  %invariant.gep6796 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6798 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6800 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6802 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6804 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6806 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6808 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6810 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep6812 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %or.cond6966.not = xor i1 %or.cond6966, true
  %brmerge7018 = select i1 %or.cond6966.not, i1 true, i1 %conflict.rdx6901
  br i1 %brmerge7018, label %B288.if.i.preheader, label %vector.ph6904

vector.ph6904:                                    ; preds = %B288.if.preheader.i
  %invariant.gep6993 = getelementptr double, ptr %invariant.gep6796, i64 %.155.i.i6485
  %invariant.gep6995 = getelementptr double, ptr %invariant.gep6798, i64 %.155.i.1.i6491
  %invariant.gep6997 = getelementptr double, ptr %invariant.gep6800, i64 %.155.i.2.i6497
  %invariant.gep6999 = getelementptr double, ptr %invariant.gep6802, i64 %.155.i.3.i6503
  %invariant.gep7001 = getelementptr double, ptr %invariant.gep6804, i64 %.155.i.4.i6509
  %invariant.gep7003 = getelementptr double, ptr %invariant.gep6806, i64 %.155.i.5.i6515
  %invariant.gep7005 = getelementptr double, ptr %invariant.gep6808, i64 %.155.i.6.i6521
  %invariant.gep7007 = getelementptr double, ptr %invariant.gep6812, i64 %.767.i
  br label %vector.body6909

vector.body6909:                                  ; preds = %vector.body6909, %vector.ph6904
  %index6910 = phi i64 [ 0, %vector.ph6904 ], [ %index.next6919, %vector.body6909 ]
  %gep6994 = getelementptr double, ptr %invariant.gep6993, i64 %index6910
  %wide.load6911 = load <2 x double>, ptr %gep6994, align 8, !noalias !59
  %78 = fadd <2 x double> %wide.load6911, zeroinitializer
  %79 = fmul <2 x double> %broadcast.splat, %78
  %gep6996 = getelementptr double, ptr %invariant.gep6995, i64 %index6910
  %wide.load6912 = load <2 x double>, ptr %gep6996, align 8, !noalias !59
  %80 = fadd <2 x double> %wide.load6912, %79
  %81 = fmul <2 x double> %broadcast.splat6908, %80
  %gep6998 = getelementptr double, ptr %invariant.gep6997, i64 %index6910
  %wide.load6913 = load <2 x double>, ptr %gep6998, align 8, !noalias !59
  %82 = fadd <2 x double> %wide.load6913, %81
  %83 = fmul <2 x double> %broadcast.splat, %82
  %gep7000 = getelementptr double, ptr %invariant.gep6999, i64 %index6910
  %wide.load6914 = load <2 x double>, ptr %gep7000, align 8, !noalias !59
  %84 = fadd <2 x double> %wide.load6914, %83
  %85 = fmul <2 x double> %broadcast.splat6908, %84
  %gep7002 = getelementptr double, ptr %invariant.gep7001, i64 %index6910
  %wide.load6915 = load <2 x double>, ptr %gep7002, align 8, !noalias !59
  %86 = fadd <2 x double> %wide.load6915, %85
  %87 = fmul <2 x double> %broadcast.splat, %86
  %gep7004 = getelementptr double, ptr %invariant.gep7003, i64 %index6910
  %wide.load6916 = load <2 x double>, ptr %gep7004, align 8, !noalias !59
  %88 = fadd <2 x double> %wide.load6916, %87
  %89 = fmul <2 x double> %broadcast.splat6908, %88
  %gep7006 = getelementptr double, ptr %invariant.gep7005, i64 %index6910
  %wide.load6917 = load <2 x double>, ptr %gep7006, align 8, !noalias !59
  %90 = fadd <2 x double> %wide.load6917, %89
  %91 = fmul <2 x double> %broadcast.splat, %90
  %92 = getelementptr double, ptr %invariant.gep6810, i64 %index6910
  %wide.load6918 = load <2 x double>, ptr %92, align 8, !noalias !59
  %93 = fadd <2 x double> %wide.load6918, %91
  %gep7008 = getelementptr double, ptr %invariant.gep7007, i64 %index6910
  store <2 x double> %93, ptr %gep7008, align 8, !noalias !53
  %index.next6919 = add i64 %index6910, 2
  %94 = icmp eq i64 %index.next6919, %n.vec6906
  br i1 %94, label %middle.block6920, label %vector.body6909, !llvm.loop !63

middle.block6920:                                 ; preds = %vector.body6909
  br i1 %cmp.n6921, label %B166.loopexit.i, label %B288.if.i.preheader

B288.if.i.preheader:                              ; preds = %B288.if.preheader.i, %middle.block6920
  %.639.0659.i.ph = phi i64 [ %n.vec6906, %middle.block6920 ], [ 0, %B288.if.preheader.i ]
  br label %B288.if.i

B288.if.i:                                        ; preds = %B288.if.i.preheader, %B288.if.i
  %.639.0659.i = phi i64 [ %.708.i, %B288.if.i ], [ %.639.0659.i.ph, %B288.if.i.preheader ]
  %.157.i.i6486 = add nsw i64 %.639.0659.i, %.155.i.i6485
  %.159.i.i6487 = mul nsw i64 %.157.i.i6486, %arg.shape.0
  %gep6797 = getelementptr double, ptr %invariant.gep6796, i64 %.159.i.i6487
  %.191.i.i6488 = load double, ptr %gep6797, align 8, !noalias !59
  %.193.i.i6489 = fadd double %.191.i.i6488, 0.000000e+00
  %.253.i.i6490 = fmul double %77, %.193.i.i6489
  %.157.i.1.i6492 = add nsw i64 %.639.0659.i, %.155.i.1.i6491
  %.159.i.1.i6493 = mul nsw i64 %.157.i.1.i6492, %arg.shape.0
  %gep6799 = getelementptr double, ptr %invariant.gep6798, i64 %.159.i.1.i6493
  %.191.i.1.i6494 = load double, ptr %gep6799, align 8, !noalias !59
  %.193.i.1.i6495 = fadd double %.191.i.1.i6494, %.253.i.i6490
  %.253.i.1.i6496 = fmul double %.247.i.i6483, %.193.i.1.i6495
  %.157.i.2.i6498 = add nsw i64 %.639.0659.i, %.155.i.2.i6497
  %.159.i.2.i6499 = mul nsw i64 %.157.i.2.i6498, %arg.shape.0
  %gep6801 = getelementptr double, ptr %invariant.gep6800, i64 %.159.i.2.i6499
  %.191.i.2.i6500 = load double, ptr %gep6801, align 8, !noalias !59
  %.193.i.2.i6501 = fadd double %.191.i.2.i6500, %.253.i.1.i6496
  %.253.i.2.i6502 = fmul double %77, %.193.i.2.i6501
  %.157.i.3.i6504 = add nsw i64 %.639.0659.i, %.155.i.3.i6503
  %.159.i.3.i6505 = mul nsw i64 %.157.i.3.i6504, %arg.shape.0
  %gep6803 = getelementptr double, ptr %invariant.gep6802, i64 %.159.i.3.i6505
  %.191.i.3.i6506 = load double, ptr %gep6803, align 8, !noalias !59
  %.193.i.3.i6507 = fadd double %.191.i.3.i6506, %.253.i.2.i6502
  %.253.i.3.i6508 = fmul double %.247.i.i6483, %.193.i.3.i6507
  %.157.i.4.i6510 = add nsw i64 %.639.0659.i, %.155.i.4.i6509
  %.159.i.4.i6511 = mul nsw i64 %.157.i.4.i6510, %arg.shape.0
  %gep6805 = getelementptr double, ptr %invariant.gep6804, i64 %.159.i.4.i6511
  %.191.i.4.i6512 = load double, ptr %gep6805, align 8, !noalias !59
  %.193.i.4.i6513 = fadd double %.191.i.4.i6512, %.253.i.3.i6508
  %.253.i.4.i6514 = fmul double %77, %.193.i.4.i6513
  %.157.i.5.i6516 = add nsw i64 %.639.0659.i, %.155.i.5.i6515
  %.159.i.5.i6517 = mul nsw i64 %.157.i.5.i6516, %arg.shape.0
  %gep6807 = getelementptr double, ptr %invariant.gep6806, i64 %.159.i.5.i6517
  %.191.i.5.i6518 = load double, ptr %gep6807, align 8, !noalias !59
  %.193.i.5.i6519 = fadd double %.191.i.5.i6518, %.253.i.4.i6514
  %.253.i.5.i6520 = fmul double %.247.i.i6483, %.193.i.5.i6519
  %.157.i.6.i6522 = add nsw i64 %.639.0659.i, %.155.i.6.i6521
  %.159.i.6.i6523 = mul nsw i64 %.157.i.6.i6522, %arg.shape.0
  %gep6809 = getelementptr double, ptr %invariant.gep6808, i64 %.159.i.6.i6523
  %.191.i.6.i6524 = load double, ptr %gep6809, align 8, !noalias !59
  %.193.i.6.i6525 = fadd double %.191.i.6.i6524, %.253.i.5.i6520
  %.253.i.6.i6526 = fmul double %77, %.193.i.6.i6525
  %.708.i = add nsw i64 %.639.0659.i, 1
  %.271.i.i6527 = mul nsw i64 %.639.0659.i, %arg.shape.0
  %gep6811 = getelementptr double, ptr %invariant.gep6810, i64 %.271.i.i6527
  %.309.i.i6528 = load double, ptr %gep6811, align 8, !noalias !59
  %.313.i.i6529 = fadd double %.309.i.i6528, %.253.i.6.i6526
  %.768.i = add nsw i64 %.639.0659.i, %.767.i
  %.770.i = mul nsw i64 %.768.i, %arg.shape.0
  %gep6813 = getelementptr double, ptr %invariant.gep6812, i64 %.770.i
  store double %.313.i.i6529, ptr %gep6813, align 8, !noalias !53
  %exitcond.not.i6530 = icmp eq i64 %arg.shape.1, %.708.i
  br i1 %exitcond.not.i6530, label %B166.loopexit.i, label %B288.if.i, !llvm.loop !64

B530.if.i:                                        ; preds = %B382.i6531, %B678.i
  %.989.0665.i = phi i64 [ %.1058.i6532, %B678.i ], [ 0, %B382.i6531 ]
  %.1058.i6532 = add nsw i64 %.989.0665.i, 1
  %95 = getelementptr double, ptr %184, i64 %.989.0665.i
  %.1140.i = load double, ptr %95, align 8, !noalias !53
  %.1141.i = fcmp ogt double %.1140.i, 5.000000e-01
  br i1 %.1141.i, label %B572.i, label %B678.i

B608.endif.i:                                     ; preds = %B80.i.i6536, %B46.i.i6533, %B608.i
  store double 0.000000e+00, ptr %95, align 8, !noalias !53
  br label %B678.i

B2654:                                            ; preds = %B110.loopexit.i, %B2158, %B2612
  %brmerge6851 = or i1 %.274.i, %wanted.2.1.lcssa
  br i1 %brmerge6851, label %B2702, label %B76.if.i

B152.i:                                           ; preds = %B76.if.i
  %.454.i = getelementptr double, ptr %186, i64 %.182.0632.i
  %.455.i = load double, ptr %.454.i, align 8, !noalias !65
  %.456.i = fcmp olt double %.455.i, 5.000000e-01
  br i1 %.456.i, label %B730.i, label %B190.i6540

B190.i6540:                                       ; preds = %B152.i
  %.487.i = getelementptr i64, ptr %arg.results.1.4, i64 %.336.i
  %.488.i = load i64, ptr %.487.i, align 8, !noalias !65
  %.489.not.i = icmp eq i64 %.488.i, 0
  br i1 %.489.not.i, label %B226.i, label %B730.i

B226.i:                                           ; preds = %B190.i6540
  br i1 %within.3.1.lcssa, label %B230.i, label %B276.i

B230.i:                                           ; preds = %B226.i
  %.549.i6541 = mul i64 %.336.i, %arg.results.3.5.1
  %96 = getelementptr i64, ptr %arg.results.3.4, i64 %.549.i6541
  %.553.i = getelementptr i8, ptr %96, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !65
  %.555.i6542 = add nsw i64 %.554.i, 3
  store i64 %.555.i6542, ptr %.553.i, align 8, !noalias !65
  br label %B276.i

B276.i:                                           ; preds = %B230.i, %B226.i
  %.666.i = getelementptr double, ptr %arg.lane.0.4, i64 %.182.0632.i
  %.667.i = load double, ptr %.666.i, align 8, !noalias !65
  %.721.i = getelementptr double, ptr %187, i64 %.182.0632.i
  %.722.i = load double, ptr %.721.i, align 8, !noalias !65
  %.776.i = getelementptr double, ptr %188, i64 %.182.0632.i
  %.777.i = load double, ptr %.776.i, align 8, !noalias !65
  %.798.i = icmp slt i64 %.391.i6539, %arg.times.5.0
  br i1 %.798.i, label %B404.i, label %B700.i

B404.i:                                           ; preds = %B276.i
  %.821.i = icmp slt i64 %.391.i6539, 0
  %.822.i6543 = select i1 %.821.i, i64 %arg.times.5.0, i64 0
  %97 = getelementptr double, ptr %arg.times.4, i64 %.391.i6539
  %.836.i = getelementptr double, ptr %97, i64 %.822.i6543
  %.837.i = load double, ptr %.836.i, align 8, !noalias !65
  %.841.i = fcmp ugt double %.837.i, %.777.i
  br i1 %.841.i, label %B700.i, label %B428.preheader.i

B428.preheader.i:                                 ; preds = %B404.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul630.i, %.336.i
  %98 = getelementptr double, ptr %arg.results.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep6814 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6816 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6818 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6820 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6822 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6824 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6826 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6828 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  %invariant.gep6830 = getelementptr double, ptr %arg.arrays.0.4, i64 %.182.0632.i
  br label %B428.i

B428.i:                                           ; preds = %B676.i, %B428.preheader.i
  %done.2.3.i = phi i64 [ %.1266.i, %B676.i ], [ %.391.i6539, %B428.preheader.i ]
  br i1 %.928627.not.i, label %B628.i, label %B458.if.lr.ph.i

B458.if.lr.ph.i:                                  ; preds = %B428.i
  %.983.i = icmp slt i64 %done.2.3.i, 0
  %.984.i = select i1 %.983.i, i64 %arg.times.5.0, i64 0
  %99 = getelementptr double, ptr %arg.times.4, i64 %done.2.3.i
  %.998.i = getelementptr double, ptr %99, i64 %.984.i
  %.1224.i = select i1 %.983.i, i64 %arg.results.0.5.1, i64 0
  %.1225.i = add i64 %.1224.i, %done.2.3.i
  %.1254.i = mul i64 %.1225.i, %arg.results.0.5.2
  %100 = getelementptr double, ptr %98, i64 %.1254.i
  br label %B458.if.i

B486.i:                                           ; preds = %B458.if.i
  %.1006.i = add nsw i64 %.872.0628.i, %.1004.i
  %.1008.i = mul nsw i64 %.1006.i, %arg.shape.0
  %gep6831 = getelementptr double, ptr %invariant.gep6830, i64 %.1008.i
  %.1040.i = load double, ptr %gep6831, align 8, !noalias !65
  br label %B729.i

B628.i:                                           ; preds = %B729.i, %B428.i
  %exitcond634.not.i = icmp eq i64 %done.2.3.i, %189
  br i1 %exitcond634.not.i, label %B700.i, label %B676.i

B676.i:                                           ; preds = %B628.i
  %.1266.i = add i64 %done.2.3.i, 1
  %.1308.i6592 = icmp slt i64 %done.2.3.i, -1
  %.1309.i6593 = select i1 %.1308.i6592, i64 %arg.times.5.0, i64 0
  %101 = getelementptr double, ptr %arg.times.4, i64 %.1266.i
  %.1323.i = getelementptr double, ptr %101, i64 %.1309.i6593
  %.1324.i = load double, ptr %.1323.i, align 8, !noalias !65
  %.1328.i6594 = fcmp ugt double %.1324.i, %.777.i
  br i1 %.1328.i6594, label %B700.i, label %B428.i

B700.i:                                           ; preds = %B676.i, %B628.i, %B404.i, %B276.i
  %done.3.2.i = phi i64 [ %.391.i6539, %B404.i ], [ %.391.i6539, %B276.i ], [ %arg.times.5.0, %B628.i ], [ %.1266.i, %B676.i ]
  store i64 %done.3.2.i, ptr %.390.i6538, align 8, !noalias !65
  br label %B730.i

B729.i:                                           ; preds = %B38.if.i.i, %B486.i
  %.313.i.i6590.sink = phi double [ %.313.i.i6590, %B38.if.i.i ], [ %.1040.i, %B486.i ]
  %102 = getelementptr double, ptr %100, i64 %.872.0628.i
  store double %.313.i.i6590.sink, ptr %102, align 8, !noalias !65
  %exitcond.not.i6591 = icmp eq i64 %arg.shape.1, %.941.i
  br i1 %exitcond.not.i6591, label %B628.i, label %B458.if.i

B730.i:                                           ; preds = %B76.if.i, %B700.i, %B190.i6540, %B152.i
  %exitcond635.not.i = icmp eq i64 %.254.i, %arg.shape.0
  br i1 %exitcond635.not.i, label %B2702, label %B76.if.i

B76.if.i:                                         ; preds = %B2654, %B730.i
  %.182.0632.i = phi i64 [ %.254.i, %B730.i ], [ 0, %B2654 ]
  %.254.i = add nsw i64 %.182.0632.i, 1
  %.335.i = getelementptr i64, ptr %arg.lane.1.4, i64 %.182.0632.i
  %.336.i = load i64, ptr %.335.i, align 8, !noalias !65
  %.390.i6538 = getelementptr i64, ptr %185, i64 %.182.0632.i
  %.391.i6539 = load i64, ptr %.390.i6538, align 8, !noalias !65
  %.399.i = icmp slt i64 %.336.i, 0
  br i1 %.399.i, label %B730.i, label %B152.i

B458.if.i:                                        ; preds = %B729.i, %B458.if.lr.ph.i
  %.872.0628.i = phi i64 [ 0, %B458.if.lr.ph.i ], [ %.941.i, %B729.i ]
  %.941.i = add nsw i64 %.872.0628.i, 1
  %.999.i = load double, ptr %.998.i, align 8, !noalias !65
  %.1001.i = fcmp oeq double %.999.i, %.777.i
  br i1 %.1001.i, label %B486.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B458.if.i
  %.1149.i = fsub double %.999.i, %.667.i
  %.1154.i = fdiv double %.1149.i, %.722.i
  %.247.i.i6545 = fsub double 1.000000e+00, %.1154.i
  %.157.i.i6547 = add nsw i64 %.872.0628.i, %.155.i.i6546
  %.159.i.i6548 = mul nsw i64 %.157.i.i6547, %arg.shape.0
  %gep6815 = getelementptr double, ptr %invariant.gep6814, i64 %.159.i.i6548
  %.191.i.i6549 = load double, ptr %gep6815, align 8, !noalias !68
  %.193.i.i6550 = fadd double %.191.i.i6549, 0.000000e+00
  %.253.i.i6551 = fmul double %.1154.i, %.193.i.i6550
  %.157.i.1.i6553 = add nsw i64 %.872.0628.i, %.155.i.1.i6552
  %.159.i.1.i6554 = mul nsw i64 %.157.i.1.i6553, %arg.shape.0
  %gep6817 = getelementptr double, ptr %invariant.gep6816, i64 %.159.i.1.i6554
  %.191.i.1.i6555 = load double, ptr %gep6817, align 8, !noalias !68
  %.193.i.1.i6556 = fadd double %.191.i.1.i6555, %.253.i.i6551
  %.253.i.1.i6557 = fmul double %.247.i.i6545, %.193.i.1.i6556
  %.157.i.2.i6559 = add nsw i64 %.872.0628.i, %.155.i.2.i6558
  %.159.i.2.i6560 = mul nsw i64 %.157.i.2.i6559, %arg.shape.0
  %gep6819 = getelementptr double, ptr %invariant.gep6818, i64 %.159.i.2.i6560
  %.191.i.2.i6561 = load double, ptr %gep6819, align 8, !noalias !68
  %.193.i.2.i6562 = fadd double %.191.i.2.i6561, %.253.i.1.i6557
  %.253.i.2.i6563 = fmul double %.1154.i, %.193.i.2.i6562
  %.157.i.3.i6565 = add nsw i64 %.872.0628.i, %.155.i.3.i6564
  %.159.i.3.i6566 = mul nsw i64 %.157.i.3.i6565, %arg.shape.0
  %gep6821 = getelementptr double, ptr %invariant.gep6820, i64 %.159.i.3.i6566
  %.191.i.3.i6567 = load double, ptr %gep6821, align 8, !noalias !68
  %.193.i.3.i6568 = fadd double %.191.i.3.i6567, %.253.i.2.i6563
  %.253.i.3.i6569 = fmul double %.247.i.i6545, %.193.i.3.i6568
  %.157.i.4.i6571 = add nsw i64 %.872.0628.i, %.155.i.4.i6570
  %.159.i.4.i6572 = mul nsw i64 %.157.i.4.i6571, %arg.shape.0
  %gep6823 = getelementptr double, ptr %invariant.gep6822, i64 %.159.i.4.i6572
  %.191.i.4.i6573 = load double, ptr %gep6823, align 8, !noalias !68
  %.193.i.4.i6574 = fadd double %.191.i.4.i6573, %.253.i.3.i6569
  %.253.i.4.i6575 = fmul double %.1154.i, %.193.i.4.i6574
  %.157.i.5.i6577 = add nsw i64 %.872.0628.i, %.155.i.5.i6576
  %.159.i.5.i6578 = mul nsw i64 %.157.i.5.i6577, %arg.shape.0
  %gep6825 = getelementptr double, ptr %invariant.gep6824, i64 %.159.i.5.i6578
  %.191.i.5.i6579 = load double, ptr %gep6825, align 8, !noalias !68
  %.193.i.5.i6580 = fadd double %.191.i.5.i6579, %.253.i.4.i6575
  %.253.i.5.i6581 = fmul double %.247.i.i6545, %.193.i.5.i6580
  %.157.i.6.i6583 = add nsw i64 %.872.0628.i, %.155.i.6.i6582
  %.159.i.6.i6584 = mul nsw i64 %.157.i.6.i6583, %arg.shape.0
  %gep6827 = getelementptr double, ptr %invariant.gep6826, i64 %.159.i.6.i6584
  %.191.i.6.i6585 = load double, ptr %gep6827, align 8, !noalias !68
  %.193.i.6.i6586 = fadd double %.191.i.6.i6585, %.253.i.5.i6581
  %.253.i.6.i6587 = fmul double %.1154.i, %.193.i.6.i6586
  %.271.i.i6588 = mul nsw i64 %.872.0628.i, %arg.shape.0
  %gep6829 = getelementptr double, ptr %invariant.gep6828, i64 %.271.i.i6588
  %.309.i.i6589 = load double, ptr %gep6829, align 8, !noalias !68
  %.313.i.i6590 = fadd double %.309.i.i6589, %.253.i.6.i6587
  br label %B729.i

B2702:                                            ; preds = %B730.i, %B2654
  %.3972 = load i64, ptr %.3971, align 8
  %.4017 = inttoptr i64 %.3972 to ptr
  tail call void %.4017(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge6853 = or i1 %.274.i, %beyond.2.1.not
  br i1 %brmerge6853, label %B2810, label %B46.if.i

B98.i1549:                                        ; preds = %B46.if.i
  %.306.i1595 = getelementptr double, ptr %191, i64 %.97.i1423.06834
  %.307.i1596 = load double, ptr %.306.i1595, align 8, !noalias !72
  %.308.i1597 = fcmp ogt double %.307.i1596, 5.000000e-01
  br i1 %.308.i1597, label %B136.i, label %B506.i

B136.i:                                           ; preds = %B98.i1549
  %.363.i1645 = getelementptr double, ptr %arg.lane.0.4, i64 %.97.i1423.06834
  %.364.i1646 = load double, ptr %.363.i1645, align 8, !noalias !72
  %.418.i1694 = getelementptr double, ptr %192, i64 %.97.i1423.06834
  %.419.i1695 = load double, ptr %.418.i1694, align 8, !noalias !72
  %.420.i1696 = fsub double %.364.i1646, %.419.i1695
  %.450.i1721 = load double, ptr %.449.i1720, align 8, !noalias !72
  %.480.i1746 = load double, ptr %arg.times.4, align 8, !noalias !72
  %.481.i1747 = fsub double %.450.i1721, %.480.i1746
  %.482.i1748 = fmul double %.481.i1747, 0x3E7AD7F29ABCAF48
  %.483.i1749 = fcmp olt double %.420.i1696, %.482.i1748
  br i1 %.483.i1749, label %B256.i, label %B294.i

B256.i:                                           ; preds = %B136.i
  %103 = getelementptr i64, ptr %194, i64 %.97.i1423.06834
  %.539.i2136 = load i64, ptr %103, align 8, !noalias !72
  %.540.i2137 = add nsw i64 %.539.i2136, 1
  br label %B294.i

B294.i:                                           ; preds = %B136.i, %B256.i
  %"$phi294.1.2.i.2" = phi i64 [ %.540.i2137, %B256.i ], [ 0, %B136.i ]
  %104 = getelementptr i64, ptr %195, i64 %.97.i1423.06834
  store i64 %"$phi294.1.2.i.2", ptr %104, align 8, !noalias !72
  %.660.i = load double, ptr %.363.i1645, align 8, !noalias !72
  store double %.660.i, ptr %.418.i1694, align 8, !noalias !72
  %.769.i1907 = getelementptr double, ptr %196, i64 %.97.i1423.06834
  store double 1.000000e+00, ptr %.769.i1907, align 8, !noalias !72
  store i64 1, ptr %.668, align 8, !noalias !72
  %.855.i1949 = load i64, ptr %104, align 8, !noalias !72
  %.856.i1950 = icmp sgt i64 %.855.i1949, 1000
  br i1 %.856.i1950, label %B460.i, label %B506.i

B460.i:                                           ; preds = %B294.i
  %105 = getelementptr i64, ptr %arg.lane.1.4, i64 %.97.i1423.06834
  %.84.i.i2027 = load i64, ptr %105, align 8, !noalias !76
  %.89.i.i2030 = icmp sgt i64 %.84.i.i2027, -1
  br i1 %.89.i.i2030, label %B46.i.i2036, label %B506.i

B46.i.i2036:                                      ; preds = %B460.i
  %.120.i.i2056 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i2027
  %.121.i.i2057 = load i64, ptr %.120.i.i2056, align 8, !noalias !76
  %.122.i.i2058 = icmp eq i64 %.121.i.i2057, 0
  br i1 %.122.i.i2058, label %B80.i.i2063, label %B506.i

B80.i.i2063:                                      ; preds = %B46.i.i2036
  store i64 6, ptr %.120.i.i2056, align 8, !noalias !76
  br label %B506.i

B506.i:                                           ; preds = %B80.i.i2063, %B460.i, %B46.i.i2036, %B294.i, %B98.i1549, %B46.if.i
  %.155.i1488 = icmp sgt i64 %.100.i1424.06833, 1
  br i1 %.155.i1488, label %B46.if.i, label %B2810

B46.if.i:                                         ; preds = %B2702, %B506.i
  %.97.i1423.06834 = phi i64 [ %.168.i2146, %B506.i ], [ 0, %B2702 ]
  %.100.i1424.06833 = phi i64 [ %.164.i2143, %B506.i ], [ %storemerge, %B2702 ]
  %.164.i2143 = add nsw i64 %.100.i1424.06833, -1
  %.168.i2146 = add nsw i64 %.97.i1423.06834, 1
  %.249.i1546 = getelementptr double, ptr %190, i64 %.97.i1423.06834
  %.250.i1547 = load double, ptr %.249.i1546, align 8, !noalias !72
  %.251.i1548 = fcmp oeq double %.250.i1547, 2.000000e+00
  br i1 %.251.i1548, label %B98.i1549, label %B506.i

B2810:                                            ; preds = %B506.i, %B2702
  br i1 %brmerge6852, label %B2860, label %B110.if.i

B46.i.i6595:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !79
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i6601, label %B358.i

B80.i.i6601:                                      ; preds = %B46.i.i6595
  %.196.i.i = getelementptr double, ptr %197, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !79
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i6601
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !79
  %.321.i.i = getelementptr double, ptr %198, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !79
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.7511852.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %199, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !84
  %.652.i = add nsw i64 %.651.i, 1
  %106 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %106, align 8, !noalias !84
  %.822.i6602 = icmp slt i64 %.596.i, 0
  %.823.i6603 = select i1 %.822.i6602, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i6603, %.596.i
  %.825.i = icmp slt i64 %.651.i, -1
  %.826.i = select i1 %.825.i, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i
  %.854.i = mul i64 %.852.i, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %107 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i
  %108 = getelementptr double, ptr %107, i64 %.856.i
  br label %B300.if.i

B358.i:                                           ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i6601, %B46.i.i6595
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i6601 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i6595 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i
  br i1 %some.3.2.i, label %B368.i, label %B2860

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.1017.i, align 8, !noalias !84
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !84
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !84
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !84
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !85
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %197, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !85
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !85
  %.321.i223.i = getelementptr double, ptr %198, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !85
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %200, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !84
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %109 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %109, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !84
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i6600 = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %110 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i6600
  %111 = getelementptr double, ptr %110, i64 %.1956.i
  %invariant.gep6835 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep6837 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %112 = getelementptr double, ptr %111, i64 %.1701.01860.i
  store double %.1835.i, ptr %112, align 8, !noalias !84
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %113 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %113, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %119, align 8, !noalias !88
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !88
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !88
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B2860, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !84
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !84
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !91
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %197, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !91
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !91
  %.321.i456.i = getelementptr double, ptr %198, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !91
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %114 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %114, align 8, !noalias !84
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !94
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond6863.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond6863.not, label %B2860, label %B1106.if.i

B110.if.i:                                        ; preds = %B2810, %B358.i
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i ], [ false, %B2810 ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i ], [ 0, %B2810 ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %115 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %115, align 8, !noalias !79
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i, label %B46.i.i6595

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %116 = getelementptr double, ptr %108, i64 %.692.01853.i
  %.861.i = load double, ptr %116, align 8, !noalias !84
  %117 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %117, align 8, !noalias !84
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %118 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %118, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !84
  %exitcond.not.i6604 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i6604, label %B358.i, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %119 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %119, align 8, !noalias !85
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i6597
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep6836 = getelementptr double, ptr %invariant.gep6835, i64 %.1803.i
  %.1835.i = load double, ptr %gep6836, align 8, !noalias !84
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep6838 = getelementptr double, ptr %invariant.gep6837, i64 %.1850.i
  store double %.1835.i, ptr %gep6838, align 8, !noalias !84
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %120 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %120, align 8, !noalias !91
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B2860:                                            ; preds = %B1228.i, %B2810, %B360.i, %B982.i
  br i1 %.274.i, label %B3394, label %B2890.if

B2936:                                            ; preds = %B2890.if
  br i1 %.163.i22796842.not, label %B102.i, label %B46.if.i2614.preheader

B46.if.i2614.preheader:                           ; preds = %B2936
  %invariant.gep7015 = getelementptr double, ptr %arg.arrays.0.4, i64 %.4209.06846
  br label %B46.if.i2614

B102.i:                                           ; preds = %B46.if.i2614, %B2936
  %.360.i2340 = getelementptr double, ptr %arg.lane.0.4, i64 %.4209.06846
  store double 0.000000e+00, ptr %.360.i2340, align 8, !noalias !97
  %.415.i2388 = getelementptr double, ptr %217, i64 %.4209.06846
  store double 5.000000e-01, ptr %.415.i2388, align 8, !noalias !97
  %.470.i2436 = getelementptr double, ptr %218, i64 %.4209.06846
  store double 1.000000e+00, ptr %.470.i2436, align 8, !noalias !97
  %.529.i2484 = getelementptr double, ptr %219, i64 %.4209.06846
  store double 0.000000e+00, ptr %.529.i2484, align 8, !noalias !97
  %.586.i2531 = getelementptr double, ptr %220, i64 %.4209.06846
  store double 0.000000e+00, ptr %.586.i2531, align 8, !noalias !97
  br label %B3422

B46.if.i2614:                                     ; preds = %B46.if.i2614.preheader, %B46.if.i2614
  %.105.i2222.06844 = phi i64 [ %.176.i2622, %B46.if.i2614 ], [ 0, %B46.if.i2614.preheader ]
  %.176.i2622 = add nsw i64 %.105.i2222.06844, 1
  %121 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i2222.06844
  %.255.i2584 = load double, ptr %121, align 8, !noalias !97
  %.257.i2586 = mul nsw i64 %.105.i2222.06844, %arg.shape.0
  %gep7016 = getelementptr double, ptr %invariant.gep7015, i64 %.257.i2586
  store double %.255.i2584, ptr %gep7016, align 8, !noalias !97
  %exitcond6865.not = icmp eq i64 %arg.shape.1, %.176.i2622
  br i1 %exitcond6865.not, label %B102.i, label %B46.if.i2614

B2976:                                            ; preds = %B2890.if
  %.4476 = mul i64 %.4360, %arg.results.3.5.1
  %.4480 = getelementptr i64, ptr %arg.results.3.4, i64 %.4476
  %.4481 = load i64, ptr %.4480, align 8
  %.4535 = getelementptr i8, ptr %.4480, i64 24
  %.4536 = load i64, ptr %.4535, align 8
  %.4537 = add nsw i64 %.4536, %.4481
  %.4539.not = icmp slt i64 %.4537, %arg.most
  br i1 %.4539.not, label %B3092, label %B3046

B3046:                                            ; preds = %B2976
  %122 = getelementptr i64, ptr %arg.lane.1.4, i64 %.4209.06846
  %.84.i2704 = load i64, ptr %122, align 8, !noalias !101
  %.89.i2707 = icmp sgt i64 %.84.i2704, -1
  br i1 %.89.i2707, label %B46.i2712, label %B3092

B46.i2712:                                        ; preds = %B3046
  %.120.i2737 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i2704
  %.121.i2738 = load i64, ptr %.120.i2737, align 8, !noalias !101
  %.122.i2739 = icmp eq i64 %.121.i2738, 0
  br i1 %.122.i2739, label %B80.i2744, label %B3092

B80.i2744:                                        ; preds = %B46.i2712
  store i64 5, ptr %.120.i2737, align 8, !noalias !101
  br label %B3092

B3092:                                            ; preds = %B80.i2744, %B3046, %B46.i2712, %B2976
  %.4629 = getelementptr double, ptr %201, i64 %.4209.06846
  %.4630 = load double, ptr %.4629, align 8
  %.4631 = fcmp ogt double %.4630, 5.000000e-01
  br i1 %.4631, label %B3130, label %B3236

B3130:                                            ; preds = %B3092
  %.4686 = getelementptr double, ptr %arg.lane.0.4, i64 %.4209.06846
  %.4687 = load double, ptr %.4686, align 8
  %.4741 = getelementptr double, ptr %202, i64 %.4209.06846
  %.4742 = load double, ptr %.4741, align 8
  %.4743 = fcmp oeq double %.4687, %.4742
  br i1 %.4743, label %B3194, label %B3236

B3194:                                            ; preds = %B3130
  %.246.i3006 = load i64, ptr %.4359, align 8, !noalias !104
  %.264.i3018 = icmp slt i64 %.246.i3006, 0
  %.265.i3019 = select i1 %.264.i3018, i64 %arg.runs.2.5.0, i64 0
  %123 = getelementptr i64, ptr %arg.runs.2.4, i64 %.246.i3006
  %.279.i3033 = getelementptr i64, ptr %123, i64 %.265.i3019
  %.280.i3034 = load i64, ptr %.279.i3033, align 8, !noalias !104
  %.337.i3082 = getelementptr i64, ptr %203, i64 %.4209.06846
  %.338.i3083 = load i64, ptr %.337.i3082, align 8, !noalias !104
  %.339.i3084 = add nsw i64 %.338.i3083, 1
  store i64 %.339.i3084, ptr %.337.i3082, align 8, !noalias !104
  %.460.i3189 = icmp slt i64 %.280.i3034, 0
  %.461.i3190 = select i1 %.460.i3189, i64 %arg.schedule.1.5.0, i64 0
  %124 = getelementptr i64, ptr %arg.schedule.1.4, i64 %.280.i3034
  %.475.i3204 = getelementptr i64, ptr %124, i64 %.461.i3190
  %.476.i3205 = load i64, ptr %.475.i3204, align 8, !noalias !104
  %.477.i3206 = icmp eq i64 %.339.i3084, %.476.i3205
  br i1 %.477.i3206, label %B186.i, label %B244.i

B186.i:                                           ; preds = %B3194
  %.516.i3558 = select i1 %.264.i3018, i64 %arg.results.1.5.0, i64 0
  %125 = getelementptr i64, ptr %arg.results.1.4, i64 %.246.i3006
  %.530.i3572 = getelementptr i64, ptr %125, i64 %.516.i3558
  %.531.i3573 = load i64, ptr %.530.i3572, align 8, !noalias !104
  %.532.i3574 = icmp eq i64 %.531.i3573, 0
  br i1 %.532.i3574, label %B220.i, label %B3236

B220.i:                                           ; preds = %B186.i
  store i64 1, ptr %.530.i3572, align 8, !noalias !104
  br label %B3236

B244.i:                                           ; preds = %B3194
  %.659.i3278 = select i1 %.460.i3189, i64 %arg.schedule.0.5.0, i64 0
  %.660.i3279 = add i64 %.659.i3278, %.280.i3034
  %.661.i3280 = icmp slt i64 %.338.i3083, -1
  %.662.i = select i1 %.661.i3280, i64 %arg.schedule.0.5.1, i64 0
  %.680.i3297 = mul i64 %.660.i3279, %arg.schedule.0.5.1
  %126 = getelementptr double, ptr %arg.schedule.0.4, i64 %.680.i3297
  %127 = getelementptr double, ptr %126, i64 %.339.i3084
  %.684.i3301 = getelementptr double, ptr %127, i64 %.662.i
  %.685.i3302 = load double, ptr %.684.i3301, align 8, !noalias !104
  store double %.685.i3302, ptr %.4741, align 8, !noalias !104
  %.797.i3393 = load i64, ptr %.337.i3082, align 8, !noalias !104
  %.822.i = select i1 %.460.i3189, i64 %arg.schedule.4.5.0, i64 0
  %.823.i = add i64 %.822.i, %.280.i3034
  %.824.i3409 = icmp slt i64 %.797.i3393, 0
  %.825.i3410 = select i1 %.824.i3409, i64 %arg.schedule.4.5.1, i64 0
  %.843.i3428 = mul i64 %.823.i, %arg.schedule.4.5.1
  %128 = getelementptr i64, ptr %arg.schedule.4.4, i64 %.843.i3428
  %129 = getelementptr i64, ptr %128, i64 %.797.i3393
  %.847.i3432 = getelementptr i64, ptr %129, i64 %.825.i3410
  %.848.i3433 = load i64, ptr %.847.i3432, align 8, !noalias !104
  %.851.i = icmp eq i64 %.848.i3433, 0
  br i1 %.851.i, label %B364.i, label %B412.i

B364.i:                                           ; preds = %B244.i
  %.906.i3512 = getelementptr double, ptr %204, i64 %.4209.06846
  store double 1.000000e+00, ptr %.906.i3512, align 8, !noalias !104
  br label %B456.i.sink.split

B412.i:                                           ; preds = %B244.i
  %.974.i3449 = load i64, ptr %.668, align 8, !noalias !104
  %.975.i3450 = icmp eq i64 %.974.i3449, 0
  br i1 %.975.i3450, label %B456.i.sink.split, label %B456.i

B456.i.sink.split:                                ; preds = %B412.i, %B364.i
  %.sink = phi i64 [ 1, %B364.i ], [ 2, %B412.i ]
  store i64 %.sink, ptr %.668, align 8, !noalias !104
  br label %B456.i

B456.i:                                           ; preds = %B456.i.sink.split, %B412.i
  br i1 %.1103.i6839.not, label %B3236, label %B512.if.i.lr.ph

B512.if.i.lr.ph:                                  ; preds = %B456.i
  %.1227.i = select i1 %.460.i3189, i64 %arg.schedule.3.5.0, i64 0
  %.1228.i = add i64 %.1227.i, %.280.i3034
  %.1258.i = mul i64 %.1256.i, %.1228.i
  %130 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1258.i
  br label %B512.if.i

B512.if.i:                                        ; preds = %B512.if.i.lr.ph, %B512.if.i
  %.1045.i.06841 = phi i64 [ 0, %B512.if.i.lr.ph ], [ %.1116.i, %B512.if.i ]
  %.1116.i = add nsw i64 %.1045.i.06841, 1
  %.1195.i = load i64, ptr %.337.i3082, align 8, !noalias !104
  %.1229.i = icmp slt i64 %.1195.i, 0
  %.1230.i = select i1 %.1229.i, i64 %arg.schedule.3.5.1, i64 0
  %.1231.i = add i64 %.1230.i, %.1195.i
  %.1260.i = mul i64 %.1231.i, %arg.schedule.3.5.2
  %131 = getelementptr double, ptr %130, i64 %.1260.i
  %132 = getelementptr double, ptr %131, i64 %.1045.i.06841
  %.1265.i = load double, ptr %132, align 8, !noalias !104
  %133 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1045.i.06841
  %.1295.i = load i64, ptr %133, align 8, !noalias !104
  %.1297.i = mul nsw i64 %.1295.i, %arg.shape.0
  %.1299.i = add nsw i64 %.1297.i, %.4209.06846
  %.1313.i = icmp slt i64 %.1299.i, 0
  %.1314.i = select i1 %.1313.i, i64 %arg.arrays.1.5.0, i64 0
  %134 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1299.i
  %.1328.i = getelementptr double, ptr %134, i64 %.1314.i
  store double %.1265.i, ptr %.1328.i, align 8, !noalias !104
  %exitcond6864.not = icmp eq i64 %arg.schedule.2.5.0, %.1116.i
  br i1 %exitcond6864.not, label %B3236, label %B512.if.i

B3236:                                            ; preds = %B512.if.i, %B456.i, %B220.i, %B186.i, %B3130, %B3092
  %.4853 = getelementptr i64, ptr %arg.results.1.4, i64 %.4360
  %.4854 = load i64, ptr %.4853, align 8
  %.4855.not = icmp eq i64 %.4854, 0
  br i1 %.4855.not, label %B3422, label %B3270

B3270:                                            ; preds = %B3236
  %.4910 = getelementptr i64, ptr %205, i64 %.4209.06846
  %.4911 = load i64, ptr %.4910, align 8
  %.4941 = getelementptr i64, ptr %arg.results.2.4, i64 %.4360
  store i64 %.4911, ptr %.4941, align 8
  store i64 -1, ptr %.4359, align 8
  %.314.i6605 = load i64, ptr %arg.lane.2.4, align 8, !noalias !108
  %.374.i6607 = load i64, ptr %.373.i6606, align 8, !noalias !108
  %.375.i6608 = icmp slt i64 %.314.i6605, %.374.i6607
  br i1 %.375.i6608, label %B130.i6723, label %B316.i6609

B130.i6723:                                       ; preds = %B3270
  %.385.i6724 = add nsw i64 %.314.i6605, 1
  store i64 %.385.i6724, ptr %arg.lane.2.4, align 8, !noalias !108
  store i64 1, ptr %.668, align 8, !noalias !108
  store i64 %.314.i6605, ptr %.4359, align 8, !noalias !108
  %.557.i6729 = getelementptr i64, ptr %206, i64 %.4209.06846
  store i64 0, ptr %.557.i6729, align 8, !noalias !108
  store i64 1, ptr %.4910, align 8, !noalias !108
  br i1 %.6961380.not.i6732, label %B316.i6609, label %B272.if.lr.ph.i6733

B272.if.lr.ph.i6733:                              ; preds = %B130.i6723
  %.757.i6734 = icmp slt i64 %.314.i6605, 0
  %.758.i6735 = select i1 %.757.i6734, i64 %arg.runs.0.5.0, i64 0
  %.759.i6736 = add i64 %.758.i6735, %.314.i6605
  %.779.i6737 = mul i64 %.759.i6736, %arg.runs.0.5.1
  %135 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i6737
  %.822.i6738 = select i1 %.757.i6734, i64 %arg.results.0.5.0, i64 0
  %.823.i6739 = add i64 %.822.i6738, %.314.i6605
  %.853.i6741 = mul i64 %.851.i6740, %.823.i6739
  %136 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i6741
  br i1 %min.iters.check6875, label %B272.if.i6742.preheader, label %vector.memcheck6870

vector.memcheck6870:                              ; preds = %B272.if.lr.ph.i6733
  %137 = mul i64 %222, %.823.i6739
  %138 = mul i64 %223, %.759.i6736
  %139 = add i64 %137, %arg.results.0.46871
  %140 = add i64 %138, %arg.runs.0.46872
  %141 = sub i64 %139, %140
  %diff.check6873 = icmp ult i64 %141, 32
  br i1 %diff.check6873, label %B272.if.i6742.preheader, label %vector.body6879

vector.body6879:                                  ; preds = %vector.memcheck6870, %vector.body6879
  %index6880 = phi i64 [ %index.next6883, %vector.body6879 ], [ 0, %vector.memcheck6870 ]
  %142 = getelementptr double, ptr %135, i64 %index6880
  %143 = getelementptr i8, ptr %142, i64 16
  %wide.load6881 = load <2 x double>, ptr %142, align 8, !noalias !108
  %wide.load6882 = load <2 x double>, ptr %143, align 8, !noalias !108
  %144 = getelementptr double, ptr %136, i64 %index6880
  %145 = getelementptr i8, ptr %144, i64 16
  store <2 x double> %wide.load6881, ptr %144, align 8, !noalias !108
  store <2 x double> %wide.load6882, ptr %145, align 8, !noalias !108
  %index.next6883 = add i64 %index6880, 4
  %146 = icmp eq i64 %index.next6883, %n.vec6878
  br i1 %146, label %middle.block6884, label %vector.body6879, !llvm.loop !111

middle.block6884:                                 ; preds = %vector.body6879
  br i1 %cmp.n6885, label %B316.i6609, label %B272.if.i6742.preheader

B272.if.i6742.preheader:                          ; preds = %vector.memcheck6870, %B272.if.lr.ph.i6733, %middle.block6884
  %.638.01381.i6743.ph = phi i64 [ 0, %vector.memcheck6870 ], [ 0, %B272.if.lr.ph.i6733 ], [ %n.vec6878, %middle.block6884 ]
  br label %B272.if.i6742

B316.i6609:                                       ; preds = %B272.if.i6742, %middle.block6884, %B130.i6723, %B3270
  %m.2.0.i6610 = phi i64 [ 0, %B3270 ], [ %.314.i6605, %B130.i6723 ], [ %.314.i6605, %middle.block6884 ], [ %.314.i6605, %B272.if.i6742 ]
  br i1 %.9661383.not.i6611, label %B390.i6627, label %B346.if.lr.ph.i6612

B346.if.lr.ph.i6612:                              ; preds = %B316.i6609
  %.1027.i6613 = icmp slt i64 %m.2.0.i6610, 0
  %.1028.i6614 = select i1 %.1027.i6613, i64 %arg.runs.1.5.0, i64 0
  %.1029.i6615 = add i64 %.1028.i6614, %m.2.0.i6610
  %.1049.i6616 = mul i64 %.1029.i6615, %arg.runs.1.5.1
  %147 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i6616
  %invariant.gep7009 = getelementptr double, ptr %arg.arrays.1.4, i64 %.4209.06846
  br label %B346.if.i6617

B390.i6627:                                       ; preds = %B346.if.i6617, %B316.i6609
  br i1 %.11851386.not.i6628, label %B516.i6650, label %B446.if.lr.ph.i6629

B446.if.lr.ph.i6629:                              ; preds = %B390.i6627
  %.1237.i6630 = icmp slt i64 %m.2.0.i6610, 0
  %.1238.i6631 = select i1 %.1237.i6630, i64 %arg.runs.2.5.0, i64 0
  %148 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i6610
  %.1252.i6632 = getelementptr i64, ptr %148, i64 %.1238.i6631
  br label %B446.if.i6634

B516.i6650:                                       ; preds = %B446.if.i6634, %B390.i6627
  br i1 %.375.i6608, label %B574.i6678, label %B520.i6651

B520.i6651:                                       ; preds = %B516.i6650
  br i1 %.1423.i6652, label %B532.i6654, label %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit6747

B532.i6654:                                       ; preds = %B520.i6651
  br i1 %.163.i1389.not.i6655, label %B102.i.i6666, label %B46.if.i.i6656.preheader

B46.if.i.i6656.preheader:                         ; preds = %B532.i6654
  %invariant.gep7011 = getelementptr double, ptr %arg.arrays.0.4, i64 %.4209.06846
  br label %B46.if.i.i6656

B102.i.i6666:                                     ; preds = %B46.if.i.i6656, %B532.i6654
  %.360.i.i6670 = getelementptr double, ptr %arg.lane.0.4, i64 %.4209.06846
  store double 0.000000e+00, ptr %.360.i.i6670, align 8, !noalias !112
  %.415.i.i6671 = getelementptr double, ptr %207, i64 %.4209.06846
  store double 5.000000e-01, ptr %.415.i.i6671, align 8, !noalias !112
  %.470.i.i6673 = getelementptr double, ptr %208, i64 %.4209.06846
  store double 1.000000e+00, ptr %.470.i.i6673, align 8, !noalias !112
  %.529.i.i6675 = getelementptr double, ptr %209, i64 %.4209.06846
  store double 0.000000e+00, ptr %.529.i.i6675, align 8, !noalias !112
  %.586.i.i6677 = getelementptr double, ptr %210, i64 %.4209.06846
  store double 0.000000e+00, ptr %.586.i.i6677, align 8, !noalias !112
  br label %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit6747

B46.if.i.i6656:                                   ; preds = %B46.if.i.i6656.preheader, %B46.if.i.i6656
  %.105.i.01390.i6657 = phi i64 [ %.176.i.i6658, %B46.if.i.i6656 ], [ 0, %B46.if.i.i6656.preheader ]
  %.176.i.i6658 = add nsw i64 %.105.i.01390.i6657, 1
  %149 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01390.i6657
  %.255.i.i6659 = load double, ptr %149, align 8, !noalias !112
  %.257.i.i6660 = mul nsw i64 %.105.i.01390.i6657, %arg.shape.0
  %gep7012 = getelementptr double, ptr %invariant.gep7011, i64 %.257.i.i6660
  store double %.255.i.i6659, ptr %gep7012, align 8, !noalias !112
  %exitcond1397.not.i6665 = icmp eq i64 %arg.shape.1, %.176.i.i6658
  br i1 %exitcond1397.not.i6665, label %B102.i.i6666, label %B46.if.i.i6656

B574.i6678:                                       ; preds = %B516.i6650
  br i1 %.15851392.not.i6679, label %B648.i6695, label %B604.if.lr.ph.i6680

B604.if.lr.ph.i6680:                              ; preds = %B574.i6678
  %.1646.i6681 = icmp slt i64 %m.2.0.i6610, 0
  %.1647.i6682 = select i1 %.1646.i6681, i64 %arg.runs.0.5.0, i64 0
  %.1648.i6683 = add i64 %.1647.i6682, %m.2.0.i6610
  %.1668.i6684 = mul i64 %.1648.i6683, %arg.runs.0.5.1
  %150 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i6684
  %invariant.gep7013 = getelementptr double, ptr %arg.arrays.0.4, i64 %.4209.06846
  br label %B604.if.i6685

B648.i6695:                                       ; preds = %B604.if.i6685, %B574.i6678
  %.1748.i6696 = load double, ptr %arg.times.4, align 8, !noalias !108
  %.1765.i6697 = icmp slt i64 %m.2.0.i6610, 0
  %.1766.i6698 = select i1 %.1765.i6697, i64 %arg.runs.2.5.0, i64 0
  %151 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i6610
  %.1780.i6699 = getelementptr i64, ptr %151, i64 %.1766.i6698
  %.1781.i6700 = load i64, ptr %.1780.i6699, align 8, !noalias !108
  %.1812.i6701 = icmp slt i64 %.1781.i6700, 0
  %.1813.i6702 = select i1 %.1812.i6701, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i6703 = add i64 %.1813.i6702, %.1781.i6700
  %.1834.i6704 = mul i64 %.1814.i6703, %arg.schedule.0.5.1
  %.1838.i6705 = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i6704
  %.1839.i6706 = load double, ptr %.1838.i6705, align 8, !noalias !108
  %.1895.i6710 = getelementptr double, ptr %arg.lane.0.4, i64 %.4209.06846
  store double %.1748.i6696, ptr %.1895.i6710, align 8, !noalias !108
  %.1950.i6712 = getelementptr double, ptr %211, i64 %.4209.06846
  store double %.1839.i6706, ptr %.1950.i6712, align 8, !noalias !108
  %.2005.i6713 = getelementptr double, ptr %212, i64 %.4209.06846
  store double 0.000000e+00, ptr %.2005.i6713, align 8, !noalias !108
  %.2064.i6715 = getelementptr double, ptr %213, i64 %.4209.06846
  store double 1.000000e+00, ptr %.2064.i6715, align 8, !noalias !108
  %.2119.i6717 = getelementptr double, ptr %214, i64 %.4209.06846
  store double 0.000000e+00, ptr %.2119.i6717, align 8, !noalias !108
  %.2175.i6719 = getelementptr double, ptr %215, i64 %.4209.06846
  store double 0xFFF0000000000000, ptr %.2175.i6719, align 8, !noalias !108
  %152 = getelementptr i64, ptr %216, i64 %.4209.06846
  store i64 0, ptr %152, align 8, !noalias !108
  br label %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit6747

B272.if.i6742:                                    ; preds = %B272.if.i6742.preheader, %B272.if.i6742
  %.638.01381.i6743 = phi i64 [ %.709.i6744, %B272.if.i6742 ], [ %.638.01381.i6743.ph, %B272.if.i6742.preheader ]
  %.709.i6744 = add nsw i64 %.638.01381.i6743, 1
  %153 = getelementptr double, ptr %135, i64 %.638.01381.i6743
  %.784.i6745 = load double, ptr %153, align 8, !noalias !108
  %154 = getelementptr double, ptr %136, i64 %.638.01381.i6743
  store double %.784.i6745, ptr %154, align 8, !noalias !108
  %exitcond.not.i6746 = icmp eq i64 %.709.i6744, %arg.shape.1
  br i1 %exitcond.not.i6746, label %B316.i6609, label %B272.if.i6742, !llvm.loop !116

B346.if.i6617:                                    ; preds = %B346.if.i6617, %B346.if.lr.ph.i6612
  %.910.01384.i6618 = phi i64 [ 0, %B346.if.lr.ph.i6612 ], [ %.979.i6619, %B346.if.i6617 ]
  %.979.i6619 = add nsw i64 %.910.01384.i6618, 1
  %155 = getelementptr double, ptr %147, i64 %.910.01384.i6618
  %.1054.i6620 = load double, ptr %155, align 8, !noalias !108
  %.1056.i6621 = mul nsw i64 %.910.01384.i6618, %arg.shape.0
  %gep7010 = getelementptr double, ptr %invariant.gep7009, i64 %.1056.i6621
  store double %.1054.i6620, ptr %gep7010, align 8, !noalias !108
  %exitcond1395.not.i6626 = icmp eq i64 %.979.i6619, %arg.shape.2
  br i1 %exitcond1395.not.i6626, label %B390.i6627, label %B346.if.i6617

B446.if.i6634:                                    ; preds = %B446.if.i6634, %B446.if.lr.ph.i6629
  %.1129.01387.i6635 = phi i64 [ 0, %B446.if.lr.ph.i6629 ], [ %.1198.i6636, %B446.if.i6634 ]
  %.1198.i6636 = add nsw i64 %.1129.01387.i6635, 1
  %.1253.i6637 = load i64, ptr %.1252.i6632, align 8, !noalias !108
  %.1289.i6638 = icmp slt i64 %.1253.i6637, 0
  %.1290.i6639 = select i1 %.1289.i6638, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i6640 = add i64 %.1290.i6639, %.1253.i6637
  %.1321.i6641 = mul i64 %.1319.i6633, %.1291.i6640
  %156 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i6641
  %157 = getelementptr double, ptr %156, i64 %.1129.01387.i6635
  %.1328.i6642 = load double, ptr %157, align 8, !noalias !108
  %158 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01387.i6635
  %.1358.i6643 = load i64, ptr %158, align 8, !noalias !108
  %.1360.i6644 = mul nsw i64 %.1358.i6643, %arg.shape.0
  %.1362.i6645 = add nsw i64 %.1360.i6644, %.4209.06846
  %.1376.i6646 = icmp slt i64 %.1362.i6645, 0
  %.1377.i6647 = select i1 %.1376.i6646, i64 %arg.arrays.1.5.0, i64 0
  %159 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i6645
  %.1391.i6648 = getelementptr double, ptr %159, i64 %.1377.i6647
  store double %.1328.i6642, ptr %.1391.i6648, align 8, !noalias !108
  %exitcond1396.not.i6649 = icmp eq i64 %.1198.i6636, %arg.schedule.2.5.0
  br i1 %exitcond1396.not.i6649, label %B516.i6650, label %B446.if.i6634

B604.if.i6685:                                    ; preds = %B604.if.i6685, %B604.if.lr.ph.i6680
  %.1529.01393.i6686 = phi i64 [ 0, %B604.if.lr.ph.i6680 ], [ %.1598.i6687, %B604.if.i6685 ]
  %.1598.i6687 = add nsw i64 %.1529.01393.i6686, 1
  %160 = getelementptr double, ptr %150, i64 %.1529.01393.i6686
  %.1673.i6688 = load double, ptr %160, align 8, !noalias !108
  %.1675.i6689 = mul nsw i64 %.1529.01393.i6686, %arg.shape.0
  %gep7014 = getelementptr double, ptr %invariant.gep7013, i64 %.1675.i6689
  store double %.1673.i6688, ptr %gep7014, align 8, !noalias !108
  %exitcond1398.not.i6694 = icmp eq i64 %.1598.i6687, %arg.shape.1
  br i1 %exitcond1398.not.i6694, label %B648.i6695, label %B604.if.i6685

_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit6747: ; preds = %B520.i6651, %B102.i.i6666, %B648.i6695
  %storemerge1373.i6653 = phi i64 [ 1, %B648.i6695 ], [ 0, %B102.i.i6666 ], [ 0, %B520.i6651 ]
  %.5001 = add nsw i64 %active.3.26848, -1
  %.5101 = add nsw i64 %.5001, %storemerge1373.i6653
  br label %B3422

B3394:                                            ; preds = %B3422, %B2860
  %active.3.2.lcssa = phi i64 [ %active.4.0, %B2860 ], [ %active.5.2, %B3422 ]
  %.5125 = icmp sgt i64 %active.3.2.lcssa, 0
  %.5139 = icmp sgt i64 %budget.2.0, 1
  %or.cond6464 = select i1 %.5125, i1 %.5139, i1 false
  br i1 %or.cond6464, label %B194, label %B3420

B3420:                                            ; preds = %B3394, %B0.endif
  %active.7.1 = phi i64 [ %active.3.i.0.lcssa, %B0.endif ], [ %active.3.2.lcssa, %B3394 ]
  store i64 %active.7.1, ptr %retptr, align 8
  ret i32 0

B3421:                                            ; preds = %B1326.if, %B1634, %B1784, %B1834, %B1586
  %good.3.2 = phi i1 [ %good.2.16767, %B1586 ], [ true, %B1834 ], [ true, %B1784 ], [ true, %B1634 ], [ %good.2.16767, %B1326.if ]
  %wanted.3.2 = phi i1 [ %wanted.2.16768, %B1586 ], [ true, %B1834 ], [ %wanted.2.16768, %B1784 ], [ %wanted.2.16768, %B1634 ], [ %wanted.2.16768, %B1326.if ]
  %within.4.2 = phi i1 [ %within.3.16769, %B1586 ], [ %spec.select6461, %B1834 ], [ %spec.select, %B1784 ], [ %spec.select, %B1634 ], [ %within.3.16769, %B1326.if ]
  %.1932 = icmp sgt i64 %.1878.06766, 1
  br i1 %.1932, label %B1326.if, label %B1896.loopexit

B3422:                                            ; preds = %B3236, %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit6747, %B102.i
  %active.5.2 = phi i64 [ %active.3.26848, %B102.i ], [ %.5101, %_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit6747 ], [ %active.3.26848, %B3236 ]
  %.4265 = icmp sgt i64 %.4212.06847, 1
  br i1 %.4265, label %B2890.if, label %B3394

B0.endif:                                         ; preds = %B171.i, %entry
  %active.3.i.0.lcssa = phi i64 [ 0, %entry ], [ %active.4.i.1, %B171.i ]
  %.608 = icmp sgt i64 %active.3.i.0.lcssa, 0
  %.624 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.608, i1 %.624, i1 false
  br i1 %or.cond, label %B194.preheader, label %B3420

B194.preheader:                                   ; preds = %B0.endif
  %.668 = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul6850 = mul i64 %arg.shape.0, %arg.shape.1
  %.764 = getelementptr i8, ptr %arg.code.4, i64 8
  %.821 = icmp sgt i64 %arg.decided, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx6460 = mul i64 %arg.lane.0.5.1, 24
  %161 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6460
  %.457.i1786753 = icmp slt i64 %arg.decided, 1
  %.955.idx = shl i64 %.358, 4
  %.955 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.955.idx
  %.959.not = icmp eq i64 %arg.guarded, 0
  %.989 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1066 = getelementptr i8, ptr %arg.code.4, i64 64
  %.1142 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1243.idx = mul i64 %.358, 136
  %.1243 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1243.idx
  %.1268.idx = mul i64 %.358, 24
  %.1268 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1268.idx
  %.1299 = getelementptr i8, ptr %arg.code.4, i64 80
  %.idx6456 = mul i64 %arg.lane.0.5.1, 24
  %162 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6456
  %.idx6457 = shl i64 %arg.lane.0.5.1, 5
  %163 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6457
  %.idx6458 = mul i64 %arg.lane.0.5.1, 88
  %164 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6458
  %.idx6459 = shl i64 %arg.lane.0.5.1, 4
  %165 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6459
  %.1432 = getelementptr i8, ptr %arg.code.4, i64 48
  %.1727.idx = mul i64 %.358, 136
  %.1727 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1727.idx
  %.1788 = getelementptr i8, ptr %arg.code.4, i64 56
  %.idx6452 = shl i64 %arg.lane.1.5.1, 4
  %166 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx6452
  %.idx6453 = mul i64 %arg.lane.0.5.1, 72
  %167 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6453
  %.idx6454 = mul i64 %arg.lane.0.5.1, 40
  %168 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6454
  %.2515 = icmp sgt i64 %arg.guarded, 0
  %.idx6455 = mul i64 %arg.lane.0.5.1, 56
  %169 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6455
  %.3092.idx = mul i64 %.358, 136
  %.3092 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3092.idx
  %.3117.idx = mul i64 %.358, 104
  %.3117 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3117.idx
  %.3129 = icmp sgt i64 %arg.decided, 0
  %.3168 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3190.idx = mul i64 %.358, 136
  %.3190 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3190.idx
  %.idx6447 = mul i64 %arg.lane.0.5.1, 96
  %170 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6447
  %.idx6448 = mul i64 %arg.lane.0.5.1, 40
  %171 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6448
  %.idx6449 = mul i64 %arg.lane.0.5.1, 104
  %172 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6449
  %.idx6450 = mul i64 %arg.lane.0.5.1, 112
  %173 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6450
  %.idx6451 = shl i64 %arg.lane.1.5.1, 5
  %174 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx6451
  %.3527.idx = mul i64 %.358, 136
  %.3527 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3527.idx
  %.3589 = getelementptr i8, ptr %arg.code.4, i64 192
  %.3665 = getelementptr i8, ptr %arg.code.4, i64 96
  %.1013.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.1105.i.idx = shl i64 %factor.op.mul, 4
  %.1105.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1105.i.idx
  %.idx1174.i = mul i64 %arg.lane.0.5.1, 104
  %175 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1174.i
  %.idx1175.i = mul i64 %arg.lane.0.5.1, 112
  %176 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1175.i
  %.idx1176.i = mul i64 %arg.lane.0.5.1, 96
  %177 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1176.i
  %.idx1177.i = mul i64 %arg.lane.0.5.1, 48
  %178 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1177.i
  %.8631184.not.i = icmp slt i64 %arg.shape.1, 1
  %.935.i = shl nsw i64 %arg.shape.1, 1
  %storemerge1173.i = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i6476 = mul i64 %arg.lane.0.5.1, 56
  %179 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i6476
  %.idx1165.i = mul i64 %arg.lane.0.5.1, 40
  %180 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1165.i
  %.idx1166.i = shl i64 %arg.lane.0.5.1, 5
  %181 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1166.i
  %182 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.3792.not = icmp eq i64 %arg.guarded, 0
  %.845.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.937.i.idx = shl i64 %factor.op.mul6850, 4
  %.937.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.937.i.idx
  %.idx652.i = mul i64 %arg.lane.0.5.1, 48
  %183 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx652.i
  %.695658.not.i = icmp slt i64 %arg.shape.1, 1
  %.767.i = shl nsw i64 %arg.shape.1, 1
  %.idx.i6482 = mul i64 %arg.lane.0.5.1, 40
  %184 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i6482
  %.155.i.i6485 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i6491 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i6497 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i6503 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i6509 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i6515 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i6521 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul630.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.idx.i6537 = shl i64 %arg.lane.1.5.1, 4
  %185 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i6537
  %.idx619.i = mul i64 %arg.lane.0.5.1, 40
  %186 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx619.i
  %.idx620.i = mul i64 %arg.lane.0.5.1, 48
  %187 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx620.i
  %.idx621.i = mul i64 %arg.lane.0.5.1, 56
  %188 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx621.i
  %.928627.not.i = icmp slt i64 %arg.shape.1, 1
  %.1004.i = mul nsw i64 %arg.shape.1, 17
  %189 = add i64 %arg.times.5.0, -1
  %.155.i.i6546 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i6552 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i6558 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i6564 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i6570 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i6576 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i6582 = mul nsw i64 %arg.shape.1, 18
  %.3971 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx6441 = mul i64 %arg.lane.0.5.1, 96
  %190 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6441
  %.idx6442 = mul i64 %arg.lane.0.5.1, 40
  %191 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6442
  %.idx6443 = mul i64 %arg.lane.0.5.1, 120
  %192 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6443
  %193 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.449.i1720 = getelementptr i8, ptr %193, i64 -8
  %.idx6444 = mul i64 %arg.lane.1.5.1, 24
  %194 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx6444
  %.idx6445 = mul i64 %arg.lane.1.5.1, 24
  %195 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx6445
  %.idx6446 = mul i64 %arg.lane.0.5.1, 24
  %196 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6446
  %.4068.not = icmp eq i64 %arg.jumping, 0
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %197 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %198 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %199 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.7511852.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.852.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1017.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i6597 = mul nsw i64 %arg.shape.1, 17
  %.1233.i6598 = mul nsw i64 %.1231.i6597, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i6598
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %200 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx = mul i64 %arg.lane.0.5.1, 40
  %201 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx6433 = shl i64 %arg.lane.0.5.1, 4
  %202 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6433
  %203 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx6434 = mul i64 %arg.lane.0.5.1, 24
  %204 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6434
  %.1103.i6839.not = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1256.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.idx6436 = shl i64 %arg.lane.1.5.1, 4
  %205 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx6436
  %.373.i6606 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %206 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.6961380.not.i6732 = icmp slt i64 %arg.shape.1, 1
  %.851.i6740 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661383.not.i6611 = icmp slt i64 %arg.shape.2, 1
  %.11851386.not.i6628 = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i6633 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i6652 = icmp sgt i64 %arg.shape.0, 1
  %.163.i1389.not.i6655 = icmp slt i64 %arg.shape.1, 1
  %207 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1370.i6672 = shl i64 %arg.lane.0.5.1, 4
  %208 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1370.i6672
  %.idx1371.i6674 = mul i64 %arg.lane.0.5.1, 24
  %209 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1371.i6674
  %.idx1372.i6676 = shl i64 %arg.lane.0.5.1, 5
  %210 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1372.i6676
  %.15851392.not.i6679 = icmp slt i64 %arg.shape.1, 1
  %.idx1375.i6711 = shl i64 %arg.lane.0.5.1, 4
  %211 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1375.i6711
  %212 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1376.i6714 = mul i64 %arg.lane.0.5.1, 24
  %213 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1376.i6714
  %.idx1377.i6716 = shl i64 %arg.lane.0.5.1, 5
  %214 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1377.i6716
  %.idx1378.i6718 = mul i64 %arg.lane.0.5.1, 120
  %215 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1378.i6718
  %.idx1379.i6721 = mul i64 %arg.lane.1.5.1, 24
  %216 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1379.i6721
  %.163.i22796842.not = icmp slt i64 %arg.shape.1, 1
  %217 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx6438 = shl i64 %arg.lane.0.5.1, 4
  %218 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6438
  %.idx6439 = mul i64 %arg.lane.0.5.1, 24
  %219 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6439
  %.idx6440 = shl i64 %arg.lane.0.5.1, 5
  %220 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx6440
  %221 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %222 = shl i64 %221, 3
  %223 = shl i64 %arg.runs.0.5.1, 3
  %224 = mul i64 %arg.shape.1, -176
  %225 = mul i64 %arg.shape.1, -168
  %226 = mul i64 %arg.shape.1, -160
  %227 = mul i64 %arg.shape.1, -152
  %228 = mul i64 %arg.shape.1, -144
  %229 = mul i64 %arg.shape.1, -136
  %230 = mul i64 %arg.shape.1, -128
  %231 = mul i64 %arg.shape.1, -176
  %232 = mul i64 %arg.shape.1, -168
  %233 = mul i64 %arg.shape.1, -160
  %234 = mul i64 %arg.shape.1, -152
  %235 = mul i64 %arg.shape.1, -144
  %236 = mul i64 %arg.shape.1, -136
  %237 = mul i64 %arg.shape.1, -128
  %238 = getelementptr i8, ptr %arg.code.4, i64 200
  %.3552.idx = mul i64 %.358, 112
  %.3552 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3552.idx
  %239 = getelementptr i8, ptr %arg.code.4, i64 208
  %.3552.1.idx = mul i64 %.358, 120
  %.3552.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3552.1.idx
  %240 = getelementptr i8, ptr %arg.code.4, i64 216
  %.3552.2.idx = shl i64 %.358, 7
  %.3552.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3552.2.idx
  %min.iters.check6942 = icmp ne i64 %arg.shape.1, 1
  %ident.check6924.not = icmp eq i64 %arg.shape.0, 1
  %or.cond6965 = and i1 %min.iters.check6942, %ident.check6924.not
  %diff.check6926 = icmp eq i64 %231, 0
  %diff.check6927 = icmp ult i64 %232, 16
  %conflict.rdx6928 = or i1 %diff.check6926, %diff.check6927
  %diff.check6929 = icmp eq i64 %233, 0
  %conflict.rdx6930 = or i1 %conflict.rdx6928, %diff.check6929
  %diff.check6931 = icmp ult i64 %234, 16
  %conflict.rdx6932 = or i1 %conflict.rdx6930, %diff.check6931
  %diff.check6933 = icmp eq i64 %235, 0
  %conflict.rdx6934 = or i1 %conflict.rdx6932, %diff.check6933
  %diff.check6935 = icmp ult i64 %236, 16
  %conflict.rdx6936 = or i1 %conflict.rdx6934, %diff.check6935
  %diff.check6937 = icmp eq i64 %237, 0
  %conflict.rdx6938 = or i1 %conflict.rdx6936, %diff.check6937
  %.mask = and i64 %arg.shape.1, 1152921504606846975
  %diff.check6939 = icmp eq i64 %.mask, 0
  %conflict.rdx6940 = or i1 %conflict.rdx6938, %diff.check6939
  %n.vec6945 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n6962 = icmp eq i64 %arg.shape.1, %n.vec6945
  %min.iters.check6903 = icmp ne i64 %arg.shape.1, 1
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond6966 = and i1 %min.iters.check6903, %ident.check.not
  %diff.check6888 = icmp eq i64 %224, 0
  %diff.check6889 = icmp ult i64 %225, 16
  %conflict.rdx = or i1 %diff.check6888, %diff.check6889
  %diff.check6890 = icmp eq i64 %226, 0
  %conflict.rdx6891 = or i1 %conflict.rdx, %diff.check6890
  %diff.check6892 = icmp ult i64 %227, 16
  %conflict.rdx6893 = or i1 %conflict.rdx6891, %diff.check6892
  %diff.check6894 = icmp eq i64 %228, 0
  %conflict.rdx6895 = or i1 %conflict.rdx6893, %diff.check6894
  %diff.check6896 = icmp ult i64 %229, 16
  %conflict.rdx6897 = or i1 %conflict.rdx6895, %diff.check6896
  %diff.check6898 = icmp eq i64 %230, 0
  %conflict.rdx6899 = or i1 %conflict.rdx6897, %diff.check6898
  %.mask6964 = and i64 %arg.shape.1, 1152921504606846975
  %diff.check6900 = icmp eq i64 %.mask6964, 0
  %conflict.rdx6901 = or i1 %conflict.rdx6899, %diff.check6900
  %n.vec6906 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n6921 = icmp eq i64 %arg.shape.1, %n.vec6906
  %brmerge6852 = or i1 %.4068.not, %.274.i
  %min.iters.check6875 = icmp ult i64 %arg.shape.1, 8
  %n.vec6878 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n6885 = icmp eq i64 %arg.shape.1, %n.vec6878
  br label %B194

B1028.if:                                         ; preds = %B918, %B1028.if
  %.1503.06762 = phi i64 [ 1, %B918 ], [ %.1572, %B1028.if ]
  %.1572 = add nsw i64 %.1503.06762, 1
  %241 = getelementptr i64, ptr %arg.code.4, i64 %.1503.06762
  %242 = getelementptr i8, ptr %241, i64 96
  %.1627 = load i64, ptr %242, align 8
  %.1672 = inttoptr i64 %.1627 to ptr
  tail call void %.1672(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1703 = load i64, ptr %arg.code.4, align 8
  %.1708 = mul nsw i64 %.1572, %.358
  %.1752 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1708
  %.1753 = inttoptr i64 %.1703 to ptr
  tail call void %.1753(ptr %.466, ptr %.1727, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1752)
  %exitcond6860.not = icmp eq i64 %.1572, 12
  br i1 %exitcond6860.not, label %B1214, label %B1028.if

B1326.if:                                         ; preds = %B1214, %B3421
  %within.3.16769 = phi i1 [ %within.4.2, %B3421 ], [ false, %B1214 ]
  %wanted.2.16768 = phi i1 [ %wanted.3.2, %B3421 ], [ false, %B1214 ]
  %good.2.16767 = phi i1 [ %good.3.2, %B3421 ], [ false, %B1214 ]
  %.1878.06766 = phi i64 [ %.1941, %B3421 ], [ %storemerge, %B1214 ]
  %.1875.06765 = phi i64 [ %.1945, %B3421 ], [ 0, %B1214 ]
  %.1941 = add nsw i64 %.1878.06766, -1
  %.1945 = add nsw i64 %.1875.06765, 1
  %.2038 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1875.06765
  %.2039 = load i64, ptr %.2038, align 8
  %.2093 = getelementptr i64, ptr %166, i64 %.1875.06765
  %.2094 = load i64, ptr %.2093, align 8
  %.2102 = icmp sgt i64 %.2039, -1
  br i1 %.2102, label %B1402, label %B3421

B2230.if:                                         ; preds = %B2158
  %.3427 = load i64, ptr %238, align 8
  %.3472 = inttoptr i64 %.3427 to ptr
  tail call void %.3472(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.3503 = load i64, ptr %arg.code.4, align 8
  %.3553 = inttoptr i64 %.3503 to ptr
  tail call void %.3553(ptr %.466, ptr %.3527, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3552)
  %.3427.1 = load i64, ptr %239, align 8
  %.3472.1 = inttoptr i64 %.3427.1 to ptr
  tail call void %.3472.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.3503.1 = load i64, ptr %arg.code.4, align 8
  %.3553.1 = inttoptr i64 %.3503.1 to ptr
  tail call void %.3553.1(ptr %.466, ptr %.3527, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3552.1)
  %.3427.2 = load i64, ptr %240, align 8
  %.3472.2 = inttoptr i64 %.3427.2 to ptr
  tail call void %.3472.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.3503.2 = load i64, ptr %arg.code.4, align 8
  %.3553.2 = inttoptr i64 %.3503.2 to ptr
  tail call void %.3553.2(ptr %.466, ptr %.3527, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3552.2)
  %.3590 = load i64, ptr %.3589, align 8
  %.3635 = inttoptr i64 %.3590 to ptr
  tail call void %.3635(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.3666 = load i64, ptr %.3665, align 8
  %.3711 = inttoptr i64 %.3666 to ptr
  tail call void %.3711(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %beyond.2.1, label %B104.if.i, label %B2612

B2890.if:                                         ; preds = %B2860, %B3422
  %active.3.26848 = phi i64 [ %active.5.2, %B3422 ], [ %active.4.0, %B2860 ]
  %.4212.06847 = phi i64 [ %.4274, %B3422 ], [ %storemerge, %B2860 ]
  %.4209.06846 = phi i64 [ %.4278, %B3422 ], [ 0, %B2860 ]
  %.4274 = add nsw i64 %.4212.06847, -1
  %.4278 = add nsw i64 %.4209.06846, 1
  %.4359 = getelementptr i64, ptr %arg.lane.1.4, i64 %.4209.06846
  %.4360 = load i64, ptr %.4359, align 8
  %.4365 = icmp slt i64 %.4360, 0
  br i1 %.4365, label %B2936, label %B2976
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

define dso_local range(i32 0, 2) i32 @advance_fixed(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, double %arg.step, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readnone %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readnone %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr readnone %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.arrays.0.44803 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.results.0.44802 = ptrtoint ptr %arg.results.0.4 to i64
  %.428 = icmp sgt i64 %arg.runs.0.5.0, 0
  %.431 = icmp eq i64 %arg.shape.0, 0
  br i1 %.431, label %B0.if, label %B0.endif, !prof !117

B148.loopexit:                                    ; preds = %B1706, %B1576
  %.473 = icmp sgt i64 %.417.14768, 0
  %.486 = select i1 %.473, i64 %arg.shape.0, i64 0
  %.414.1 = add i64 %.486, %.414.14767
  %.482 = sext i1 %.473 to i64
  %.417.1 = add nsw i64 %.417.14768, %.482
  %.463.sroa.0.0 = select i1 %.473, i64 %.414.14767, i64 0
  br i1 %.473, label %B152, label %B1712

B152:                                             ; preds = %B152.lr.ph, %B148.loopexit
  %.463.sroa.0.04769 = phi i64 [ 0, %B152.lr.ph ], [ %.463.sroa.0.0, %B148.loopexit ]
  %.417.14768 = phi i64 [ %.417.14766, %B152.lr.ph ], [ %.417.1, %B148.loopexit ]
  %.414.14767 = phi i64 [ %arg.shape.0, %B152.lr.ph ], [ %.414.1, %B148.loopexit ]
  %.528 = sub i64 %arg.runs.0.5.0, %.463.sroa.0.04769
  %.11.i = tail call i64 @llvm.smin.i64(i64 %.528, i64 %arg.shape.0)
  br i1 %.6414696.not, label %B512, label %B248.if.lr.ph

B248.if.lr.ph:                                    ; preds = %B152
  %.683 = add nsw i64 %.11.i, -1
  br label %B248.if

B410:                                             ; preds = %B366.if, %B248.if
  br i1 %.10764693.not, label %B500, label %B440.if.lr.ph

B440.if.lr.ph:                                    ; preds = %B410
  %.1137 = icmp slt i64 %.714, 0
  %.1138 = select i1 %.1137, i64 %arg.runs.0.5.0, i64 0
  %.1139 = add i64 %.1138, %.714
  %.1159 = mul i64 %.1139, %arg.runs.0.5.1
  %0 = getelementptr double, ptr %arg.runs.0.4, i64 %.1159
  %.1236 = select i1 %.1137, i64 %arg.results.0.5.0, i64 0
  %.1237 = add i64 %.1236, %.714
  %.1267 = mul i64 %.1265, %.1237
  %1 = getelementptr double, ptr %arg.results.0.4, i64 %.1267
  %invariant.gep4975 = getelementptr double, ptr %arg.arrays.0.4, i64 %.585.04697
  br label %B440.if

B500:                                             ; preds = %B440.if, %B410
  %.1296 = icmp slt i64 %.714, 0
  %.1297 = select i1 %.1296, i64 %arg.results.2.5.0, i64 0
  %2 = getelementptr i64, ptr %arg.results.2.4, i64 %.714
  %.1311 = getelementptr i64, ptr %2, i64 %.1297
  store i64 1, ptr %.1311, align 8
  %exitcond4776.not = icmp eq i64 %arg.shape.0, %.654
  br i1 %exitcond4776.not, label %B512, label %B248.if

B512:                                             ; preds = %B500, %B152
  br i1 %.1414, label %B598.preheader, label %B1576

B598.preheader:                                   ; preds = %B512
  %3 = getelementptr i64, ptr %arg.runs.2.4, i64 %.463.sroa.0.04769
  %.1364 = icmp slt i64 %.463.sroa.0.04769, 0
  %.1365 = select i1 %.1364, i64 %arg.runs.2.5.0, i64 0
  %.1379 = getelementptr i64, ptr %3, i64 %.1365
  %.1380 = load i64, ptr %.1379, align 8
  %.1349 = load double, ptr %arg.times.4, align 8
  %.1701 = icmp slt i64 %.1380, 0
  %.1702 = select i1 %.1701, i64 %arg.schedule.3.5.0, i64 0
  %.1703 = add i64 %.1702, %.1380
  %.1733 = mul i64 %.1731, %.1703
  %4 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1733
  %.2405 = icmp slt i64 %.1380, 0
  %.2406 = select i1 %.2405, i64 %arg.schedule.0.5.0, i64 0
  %.2407 = add i64 %.2406, %.1380
  %.2427 = mul i64 %.2407, %arg.schedule.0.5.1
  %5 = getelementptr double, ptr %arg.schedule.0.4, i64 %.2427
  br label %B598

B598:                                             ; preds = %B598.preheader, %B1536
  %t.2.1 = phi double [ %t.3.4, %B1536 ], [ %.1349, %B598.preheader ]
  %done.3.1 = phi i64 [ %done.4.4, %B1536 ], [ 1, %B598.preheader ]
  %edge.2.1 = phi i64 [ %edge.3.4, %B1536 ], [ 0, %B598.preheader ]
  br i1 %.1468, label %B748.else.endif, label %B654.if.lr.ph

B654.if.lr.ph:                                    ; preds = %B598
  %.1704 = icmp slt i64 %edge.2.1, 0
  %.1705 = select i1 %.1704, i64 %arg.schedule.3.5.1, i64 0
  %.1706 = add i64 %.1705, %edge.2.1
  %.1735 = mul i64 %.1706, %arg.schedule.3.5.2
  %6 = getelementptr double, ptr %4, i64 %.1735
  br label %B654.if

B654.loopexit:                                    ; preds = %B688.if, %B654.if
  %.1510 = icmp sgt i64 %.1457.04704, 1
  br i1 %.1510, label %B654.if, label %B748.else.endif

B906:                                             ; preds = %B906.preheader, %B1496
  %t.4.3 = phi double [ %.11.i4679, %B1496 ], [ %t.2.1, %B906.preheader ]
  %done.6.3 = phi i64 [ %done.5.5, %B1496 ], [ %done.3.1, %B906.preheader ]
  %.2364 = icmp slt i64 %done.6.3, 0
  %.2365 = select i1 %.2364, i64 %arg.times.5.0, i64 0
  %7 = getelementptr double, ptr %arg.times.4, i64 %done.6.3
  %.2379 = getelementptr double, ptr %7, i64 %.2365
  %.2380 = load double, ptr %.2379, align 8
  %.2432 = load double, ptr %.2431, align 8
  %.10.i = fcmp olt double %.2432, %.2380
  %.11.i4679 = select i1 %.10.i, double %.2432, double %.2380
  %.2466 = fsub double %.11.i4679, %t.4.3
  %.2471 = fdiv double %.2466, %arg.step
  %.2472 = fmul double %.2471, 0x3FEFFFFFFFFFDCD1
  %.2473 = tail call double @llvm.ceil.f64(double %.2472)
  %.2474 = fptosi double %.2473 to i64
  %.11.i4680 = tail call i64 @llvm.smax.i64(i64 %.2474, i64 1)
  %.2506 = uitofp i64 %.11.i4680 to double
  %.2510 = fdiv double %.2466, %.2506
  br i1 %.2065, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !117

B1158:                                            ; preds = %B906.endif.endif.endif.endif.endif
  br i1 %.2625.not, label %B1384, label %B1166

B1166:                                            ; preds = %B1158
  %.2678 = load double, ptr %.2431, align 8
  %.2680 = fcmp oeq double %.11.i4679, %.2678
  br i1 %.2680, label %B1194.else.endif, label %B1384

B1384:                                            ; preds = %B1228.i, %B360.i, %.4350.if, %B982.i, %B1166, %B1158
  %.4543 = load double, ptr %.2379, align 8
  %.4545 = fcmp oeq double %.11.i4679, %.4543
  br i1 %.4545, label %B1408, label %B1456

B1408:                                            ; preds = %B1384
  br i1 %.191230.not.i, label %_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.lr.ph.i

B60.if.lr.ph.i:                                   ; preds = %B1408
  %.513.i = select i1 %.2364, i64 %arg.results.0.5.1, i64 0
  %.514.i = add i64 %.513.i, %done.6.3
  %.543.i = mul i64 %.514.i, %arg.results.0.5.2
  %invariant.gep.i = getelementptr double, ptr %arg.results.0.4, i64 %.543.i
  %.557.i = add nsw i64 %done.6.3, 1
  %8 = shl i64 %.514.i, 3
  br label %B60.if.i

B106.i:                                           ; preds = %B60.if.i
  %.322.i = getelementptr i64, ptr %arg.results.1.4, i64 %.286.i
  %.323.i = load i64, ptr %.322.i, align 8, !noalias !118
  %.324.i = icmp eq i64 %.323.i, 0
  br i1 %.324.i, label %B140.i, label %B232.i

B140.i:                                           ; preds = %B106.i
  br i1 %.406226.not.i, label %B216.i, label %B170.if.lr.ph.i

B170.if.lr.ph.i:                                  ; preds = %B140.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul229.i, %.286.i
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %factor.op.mul.reass.i
  %invariant.gep4758 = getelementptr double, ptr %arg.arrays.0.4, i64 %.133.0231.i
  br i1 %or.cond4958, label %vector.memcheck, label %B170.if.i.preheader

vector.memcheck:                                  ; preds = %B170.if.lr.ph.i
  %9 = mul i64 %35, %.286.i
  %10 = add i64 %8, %9
  %11 = mul i64 %arg.results.0.5.2, %10
  %12 = add i64 %20, %11
  %diff.check = icmp ult i64 %12, 32
  br i1 %diff.check, label %B170.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %13 = getelementptr double, ptr %invariant.gep4758, i64 %index
  %14 = getelementptr i8, ptr %13, i64 16
  %wide.load = load <2 x double>, ptr %13, align 8, !noalias !118
  %wide.load4804 = load <2 x double>, ptr %14, align 8, !noalias !118
  %15 = getelementptr double, ptr %gep.i, i64 %index
  %16 = getelementptr i8, ptr %15, i64 16
  store <2 x double> %wide.load, ptr %15, align 8, !noalias !118
  store <2 x double> %wide.load4804, ptr %16, align 8, !noalias !118
  %index.next = add i64 %index, 4
  %17 = icmp eq i64 %index.next, %n.vec
  br i1 %17, label %middle.block, label %vector.body, !llvm.loop !121

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B216.i, label %B170.if.i.preheader

B170.if.i.preheader:                              ; preds = %vector.memcheck, %B170.if.lr.ph.i, %middle.block
  %.350.0227.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B170.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B170.if.i

B216.i:                                           ; preds = %B170.if.i, %middle.block, %B140.i
  %.587.i = getelementptr i64, ptr %arg.results.2.4, i64 %.286.i
  store i64 %.557.i, ptr %.587.i, align 8, !noalias !118
  br label %B232.i

B232.i:                                           ; preds = %B60.if.i, %B216.i, %B106.i
  %exitcond233.not.i = icmp eq i64 %arg.shape.0, %.204.i
  br i1 %exitcond233.not.i, label %_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.i

B60.if.i:                                         ; preds = %B232.i, %B60.if.lr.ph.i
  %.133.0231.i = phi i64 [ 0, %B60.if.lr.ph.i ], [ %.204.i, %B232.i ]
  %18 = shl i64 %.133.0231.i, 3
  %19 = add i64 %18, %arg.arrays.0.44803
  %20 = sub i64 %arg.results.0.44802, %19
  %.204.i = add nsw i64 %.133.0231.i, 1
  %21 = getelementptr i64, ptr %arg.lane.1.4, i64 %.133.0231.i
  %.286.i = load i64, ptr %21, align 8, !noalias !118
  %.291.i = icmp sgt i64 %.286.i, -1
  br i1 %.291.i, label %B106.i, label %B232.i

B170.if.i:                                        ; preds = %B170.if.i.preheader, %B170.if.i
  %.350.0227.i = phi i64 [ %.419.i, %B170.if.i ], [ %.350.0227.i.ph, %B170.if.i.preheader ]
  %.419.i = add nsw i64 %.350.0227.i, 1
  %.445.i = mul nsw i64 %.350.0227.i, %arg.shape.0
  %gep4759 = getelementptr double, ptr %invariant.gep4758, i64 %.445.i
  %.477.i = load double, ptr %gep4759, align 8, !noalias !118
  %22 = getelementptr double, ptr %gep.i, i64 %.350.0227.i
  store double %.477.i, ptr %22, align 8, !noalias !118
  %exitcond.not.i = icmp eq i64 %arg.shape.1, %.419.i
  br i1 %exitcond.not.i, label %B216.i, label %B170.if.i, !llvm.loop !122

_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B232.i, %B1408
  %.4603 = add nsw i64 %done.6.3, 1
  br label %B1456

B1456:                                            ; preds = %_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B1384
  %done.5.5 = phi i64 [ %.4603, %_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %done.6.3, %B1384 ]
  %.4662 = load double, ptr %.2431, align 8
  %.4664 = fcmp oeq double %.11.i4679, %.4662
  br i1 %.4664, label %B1484, label %B1496

B1484:                                            ; preds = %B1456
  %.4677 = add nsw i64 %edge.2.1, 1
  br label %B1536

B1496:                                            ; preds = %B1456
  %.4711 = icmp slt i64 %done.5.5, %arg.times.5.0
  br i1 %.4711, label %B906, label %B1536

B1536:                                            ; preds = %B906.endif.endif.endif.endif.endif, %B1496, %.2131.if, %B1484
  %t.3.4 = phi double [ %t.2.1, %.2131.if ], [ %.11.i4679, %B1484 ], [ %.11.i4679, %B1496 ], [ %t.4.3, %B906.endif.endif.endif.endif.endif ]
  %done.4.4 = phi i64 [ %done.3.1, %.2131.if ], [ %done.5.5, %B1484 ], [ %done.5.5, %B1496 ], [ %arg.times.5.0, %B906.endif.endif.endif.endif.endif ]
  %edge.3.4 = phi i64 [ %edge.2.1, %.2131.if ], [ %.4677, %B1484 ], [ %edge.2.1, %B1496 ], [ %edge.2.1, %B906.endif.endif.endif.endif.endif ]
  %.4751 = icmp slt i64 %done.4.4, %arg.times.5.0
  br i1 %.4751, label %B598, label %B1576

B1576:                                            ; preds = %B1536, %B512
  %edge.4.2 = phi i64 [ 0, %B512 ], [ %edge.3.4, %B1536 ]
  %.48504760.not = icmp slt i64 %.11.i, 1
  br i1 %.48504760.not, label %B148.loopexit, label %B1606.if

B1680:                                            ; preds = %B1606.if
  store i64 1, ptr %.4980, align 8
  br label %B1706

B1706:                                            ; preds = %B1680, %B1606.if
  %exitcond4798.not = icmp eq i64 %.11.i, %.4863
  br i1 %exitcond4798.not, label %B148.loopexit, label %B1606.if

common.ret:                                       ; preds = %B0.if, %B1712
  %common.ret.op = phi i32 [ 0, %B1712 ], [ 1, %B0.if ]
  ret i32 %common.ret.op

B1712:                                            ; preds = %B148.loopexit, %B0.endif.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:                                            ; preds = %entry
  store ptr @.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727, ptr %excinfo, align 8, !numba_exception_output !123
  br label %common.ret

B0.endif:                                         ; preds = %entry
  %.429 = icmp sgt i64 %arg.shape.0, 0
  %.430 = xor i1 %.429, %.428
  br i1 %.430, label %B0.endif.endif, label %B0.endif.else

B0.endif.else:                                    ; preds = %B0.endif
  %.445 = srem i64 %arg.runs.0.5.0, %arg.shape.0
  %.446 = sub nsw i64 0, %.445
  %.447 = select i1 %.428, i64 %.445, i64 %.446
  %.448 = icmp sgt i64 %.447, 0
  %.449 = sdiv i64 %arg.runs.0.5.0, %arg.shape.0
  %.450 = zext i1 %.448 to i64
  %.451 = add i64 %.449, %.450
  br label %B0.endif.endif

B0.endif.endif:                                   ; preds = %B0.endif, %B0.endif.else
  %storemerge = phi i64 [ %.451, %B0.endif.else ], [ 0, %B0.endif ]
  %.4734763 = icmp sgt i64 %storemerge, 0
  br i1 %.4734763, label %B152.lr.ph, label %B1712

B152.lr.ph:                                       ; preds = %B0.endif.endif
  %.417.14766 = add nsw i64 %storemerge, -1
  %.6414696.not = icmp slt i64 %arg.shape.0, 1
  %.8684690.not = icmp slt i64 %arg.shape.2, 1
  %.10764693.not = icmp slt i64 %arg.shape.1, 1
  %.1265 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.1414 = icmp sgt i64 %arg.times.5.0, 1
  %.1468 = icmp slt i64 %arg.schedule.2.5.0, 1
  %storemerge4657 = select i1 %.1468, i64 0, i64 %arg.schedule.2.5.0
  %.2065 = icmp slt i64 %arg.lane.0.5.1, 1
  %.2211 = getelementptr i8, ptr %arg.code.4, i64 8
  %.16314699.not = icmp slt i64 %arg.shape.0, 1
  %.1731 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.223.i = mul i64 %arg.shape.1, %arg.shape.0
  %.331.i.idx = shl i64 %arg.lane.0.5.1, 6
  %.331.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.331.i.idx
  %.idx4659 = shl i64 %arg.lane.0.5.1, 4
  %23 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4659
  %.1621.i4713.not = icmp slt i64 %.223.i, 1
  %.1728.i = icmp sgt i64 %arg.decided, 0
  %.idx4661 = mul i64 %arg.lane.0.5.1, 24
  %24 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4661
  %.149.i.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.279.i.i4721.not = icmp slt i64 %arg.shape.0, 1
  %.idx4672 = mul i64 %arg.lane.0.5.1, 24
  %25 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4672
  %.457.i.i4718 = icmp slt i64 %arg.decided, 1
  %.2204.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.223.i
  %.149.i154.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.169.i.i.idx = mul i64 %.223.i, 136
  %.169.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.169.i.i.idx
  %.279.i211.i4727.not = icmp slt i64 %arg.shape.0, 1
  %.idx4671 = mul i64 %arg.lane.0.5.1, 24
  %26 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4671
  %.457.i354.i4724 = icmp slt i64 %arg.decided, 1
  %.2522.i.idx = mul i64 %.223.i, 136
  %.2522.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2522.i.idx
  %.2584.i = getelementptr i8, ptr %arg.code.4, i64 248
  %.2633.i.not = icmp eq i64 %arg.guarded, 0
  %.2663.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.2795.i4736.not = icmp slt i64 %arg.shape.0, 1
  %.3250.i4732.not = icmp slt i64 %arg.shape.1, 1
  %.idx = mul i64 %arg.lane.0.5.1, 48
  %27 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.3568.i = icmp ne i64 %arg.shape.0, 1
  %.3652.i4743.not4772 = icmp slt i64 %arg.shape.1, 1
  %.2625.not = icmp eq i64 %arg.jumping, 0
  %.idx4665 = shl i64 %arg.lane.0.5.1, 4
  %28 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4665
  %.idx4666 = mul i64 %arg.lane.0.5.1, 40
  %29 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4666
  %.3941 = icmp slt i64 %arg.lane.1.5.1, 1
  %30 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx4667 = shl i64 %arg.lane.1.5.1, 4
  %.4101855.not.i = icmp slt i64 %arg.shape.0, 1
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %31 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %32 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %33 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.852.i4683 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i = mul nsw i64 %arg.shape.1, 17
  %.1233.i = mul nsw i64 %.1231.i, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %34 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %factor.op.mul229.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.191230.not.i = icmp slt i64 %arg.shape.0, 1
  %.406226.not.i = icmp slt i64 %arg.shape.1, 1
  %scevgep = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx4667
  %35 = shl i64 %arg.results.0.5.1, 3
  %36 = shl i64 %arg.shape.1, 3
  %scevgep4857 = getelementptr i8, ptr %arg.arrays.0.4, i64 %36
  %37 = mul i64 %arg.shape.1, 144
  %scevgep4858 = getelementptr i8, ptr %arg.arrays.0.4, i64 %37
  %38 = mul i64 %arg.shape.1, 152
  %scevgep4859 = getelementptr i8, ptr %arg.arrays.0.4, i64 %38
  %39 = mul i64 %arg.shape.1, %arg.shape.0
  %40 = mul i64 %39, 144
  %min.iters.check4890 = icmp ult i64 %.223.i, 4
  %diff.check4888 = icmp ult i64 %40, 32
  %or.cond4959 = select i1 %min.iters.check4890, i1 true, i1 %diff.check4888
  %n.vec4893 = and i64 %.223.i, 9223372036854775804
  %41 = mul i64 %.223.i, 144
  %cmp.n4900 = icmp eq i64 %.223.i, %n.vec4893
  %.idx4799 = mul i64 %.223.i, 144
  %invariant.gep4977 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx4799
  %min.iters.check4861 = icmp ult i64 %arg.shape.1, 4
  %bound0 = icmp ult ptr %arg.arrays.0.4, %scevgep4859
  %bound1 = icmp ult ptr %scevgep4858, %scevgep4857
  %found.conflict = and i1 %bound0, %bound1
  %n.vec4864 = and i64 %arg.shape.1, 9223372036854775804
  %42 = mul i64 %arg.shape.1, 144
  %cmp.n4873 = icmp eq i64 %arg.shape.1, %n.vec4864
  %.idx4800 = mul i64 %arg.shape.1, 144
  %invariant.gep4985 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx4800
  %min.iters.check = icmp ugt i64 %arg.shape.1, 9
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond4958 = and i1 %min.iters.check, %ident.check.not
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B152

B248.if:                                          ; preds = %B248.if.lr.ph, %B500
  %.585.04697 = phi i64 [ 0, %B248.if.lr.ph ], [ %.654, %B500 ]
  %.654 = add nsw i64 %.585.04697, 1
  %.11.i4681 = tail call i64 @llvm.smin.i64(i64 %.683, i64 %.585.04697)
  %.714 = add nsw i64 %.11.i4681, %.463.sroa.0.04769
  %.720 = icmp slt i64 %.585.04697, %.11.i
  %"$phi314.2.2.2" = select i1 %.720, i64 %.714, i64 -1
  %43 = getelementptr i64, ptr %arg.lane.1.4, i64 %.585.04697
  store i64 %"$phi314.2.2.2", ptr %43, align 8
  br i1 %.8684690.not, label %B410, label %B366.if.lr.ph

B366.if.lr.ph:                                    ; preds = %B248.if
  %.929 = icmp slt i64 %.714, 0
  %.930 = select i1 %.929, i64 %arg.runs.1.5.0, i64 0
  %.931 = add i64 %.930, %.714
  %.951 = mul i64 %.931, %arg.runs.1.5.1
  %44 = getelementptr double, ptr %arg.runs.1.4, i64 %.951
  %invariant.gep4973 = getelementptr double, ptr %arg.arrays.1.4, i64 %.585.04697
  br label %B366.if

B366.if:                                          ; preds = %B366.if.lr.ph, %B366.if
  %.812.04691 = phi i64 [ 0, %B366.if.lr.ph ], [ %.881, %B366.if ]
  %.881 = add nsw i64 %.812.04691, 1
  %45 = getelementptr double, ptr %44, i64 %.812.04691
  %.956 = load double, ptr %45, align 8
  %.958 = mul nsw i64 %.812.04691, %arg.shape.0
  %gep4974 = getelementptr double, ptr %invariant.gep4973, i64 %.958
  store double %.956, ptr %gep4974, align 8
  %exitcond.not = icmp eq i64 %arg.shape.2, %.881
  br i1 %exitcond.not, label %B410, label %B366.if

B440.if:                                          ; preds = %B440.if.lr.ph, %B440.if
  %.1020.04694 = phi i64 [ 0, %B440.if.lr.ph ], [ %.1089, %B440.if ]
  %.1089 = add nsw i64 %.1020.04694, 1
  %46 = getelementptr double, ptr %0, i64 %.1020.04694
  %.1164 = load double, ptr %46, align 8
  %.1166 = mul nsw i64 %.1020.04694, %arg.shape.0
  %gep4976 = getelementptr double, ptr %invariant.gep4975, i64 %.1166
  store double %.1164, ptr %gep4976, align 8
  %47 = getelementptr double, ptr %1, i64 %.1020.04694
  store double %.1164, ptr %47, align 8
  %exitcond4775.not = icmp eq i64 %arg.shape.1, %.1089
  br i1 %exitcond4775.not, label %B500, label %B440.if

B654.if:                                          ; preds = %B654.if.lr.ph, %B654.loopexit
  %.1457.04704 = phi i64 [ %storemerge4657, %B654.if.lr.ph ], [ %.1519, %B654.loopexit ]
  %.1454.04703 = phi i64 [ 0, %B654.if.lr.ph ], [ %.1523, %B654.loopexit ]
  %.1519 = add nsw i64 %.1457.04704, -1
  %.1523 = add nsw i64 %.1454.04703, 1
  br i1 %.16314699.not, label %B654.loopexit, label %B688.if.lr.ph

B688.if.lr.ph:                                    ; preds = %B654.if
  %48 = getelementptr double, ptr %6, i64 %.1454.04703
  %49 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1454.04703
  br label %B688.if

B688.if:                                          ; preds = %B688.if.lr.ph, %B688.if
  %.1575.04700 = phi i64 [ 0, %B688.if.lr.ph ], [ %.1644, %B688.if ]
  %.1644 = add nsw i64 %.1575.04700, 1
  %.1740 = load double, ptr %48, align 8
  %.1771 = load i64, ptr %49, align 8
  %.1773 = mul nsw i64 %.1771, %arg.shape.0
  %.1774 = add nsw i64 %.1773, %.1575.04700
  %.1788 = icmp slt i64 %.1774, 0
  %.1789 = select i1 %.1788, i64 %arg.arrays.1.5.0, i64 0
  %50 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1774
  %.1803 = getelementptr double, ptr %50, i64 %.1789
  store double %.1740, ptr %.1803, align 8
  %exitcond4777.not = icmp eq i64 %arg.shape.0, %.1644
  br i1 %exitcond4777.not, label %B654.loopexit, label %B688.if

B748.else.endif:                                  ; preds = %B654.loopexit, %B598
  br i1 %.2065, label %B748.endif.else.endif.if, label %B748.endif.else.endif.endif.endif.if, !prof !117

B748.endif.else.endif.if:                         ; preds = %B748.else.endif
  br label %B748.endif.else.endif.endif.endif.if

B748.endif.else.endif.endif.endif.if:             ; preds = %B748.endif.else.endif.if, %B748.else.endif
  %.2037.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B748.endif.else.endif.if ], [ 0, %B748.else.endif ]
  %.2161.not4705 = icmp slt i64 %.2037.sroa.0.3, %arg.lane.0.5.1
  br i1 %.2161.not4705, label %.2131.endif.preheader, label %.2131.if, !prof !124

.2131.endif.preheader:                            ; preds = %B748.endif.else.endif.endif.endif.if
  %51 = sub i64 %arg.lane.0.5.1, %.2037.sroa.0.3
  %min.iters.check4945 = icmp ult i64 %51, 4
  br i1 %min.iters.check4945, label %.2131.endif.preheader4970, label %vector.ph4946, !prof !125

vector.ph4946:                                    ; preds = %.2131.endif.preheader
  %n.vec4948 = and i64 %51, -4
  %52 = add i64 %.2037.sroa.0.3, %n.vec4948
  %broadcast.splatinsert4949 = insertelement <2 x double> poison, double %t.2.1, i64 0
  %broadcast.splat4950 = shufflevector <2 x double> %broadcast.splatinsert4949, <2 x double> poison, <2 x i32> zeroinitializer
  %53 = getelementptr double, ptr %arg.lane.0.4, i64 %.2037.sroa.0.3
  br label %vector.body4951

vector.body4951:                                  ; preds = %vector.body4951, %vector.ph4946
  %index4952 = phi i64 [ 0, %vector.ph4946 ], [ %index.next4954, %vector.body4951 ]
  %54 = getelementptr double, ptr %53, i64 %index4952
  %55 = getelementptr i8, ptr %54, i64 16
  store <2 x double> %broadcast.splat4950, ptr %54, align 8
  store <2 x double> %broadcast.splat4950, ptr %55, align 8
  %index.next4954 = add i64 %index4952, 4
  %56 = icmp eq i64 %index.next4954, %n.vec4948
  br i1 %56, label %middle.block4955, label %vector.body4951, !prof !126, !llvm.loop !127

middle.block4955:                                 ; preds = %vector.body4951
  %cmp.n4956 = icmp eq i64 %51, %n.vec4948
  br i1 %cmp.n4956, label %.2131.if, label %.2131.endif.preheader4970, !prof !129

.2131.endif.preheader4970:                        ; preds = %.2131.endif.preheader, %middle.block4955
  %.2127.04706.ph = phi i64 [ %.2037.sroa.0.3, %.2131.endif.preheader ], [ %52, %middle.block4955 ]
  br label %.2131.endif

.2131.if:                                         ; preds = %.2131.endif, %middle.block4955, %B748.endif.else.endif.endif.endif.if
  %.2212 = load i64, ptr %.2211, align 8
  %.2324 = inttoptr i64 %.2212 to ptr
  tail call void %.2324(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.2337 = icmp slt i64 %done.3.1, %arg.times.5.0
  br i1 %.2337, label %B906.preheader, label %B1536

B906.preheader:                                   ; preds = %.2131.if
  %.2408 = icmp slt i64 %edge.2.1, 0
  %.2409 = select i1 %.2408, i64 %arg.schedule.0.5.1, i64 0
  %57 = getelementptr double, ptr %5, i64 %edge.2.1
  %.2431 = getelementptr double, ptr %57, i64 %.2409
  %broadcast.splatinsert = insertelement <2 x i64> poison, i64 %edge.2.1, i64 0
  %broadcast.splat = shufflevector <2 x i64> %broadcast.splatinsert, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %B906

.2131.endif:                                      ; preds = %.2131.endif.preheader4970, %.2131.endif
  %.2127.04706 = phi i64 [ %.2175, %.2131.endif ], [ %.2127.04706.ph, %.2131.endif.preheader4970 ]
  %.2170 = getelementptr double, ptr %arg.lane.0.4, i64 %.2127.04706
  store double %t.2.1, ptr %.2170, align 8
  %.2175 = add nsw i64 %.2127.04706, 1
  %exitcond4778.not = icmp eq i64 %.2175, %arg.lane.0.5.1
  br i1 %exitcond4778.not, label %.2131.if, label %.2131.endif, !prof !130, !llvm.loop !131

B358.i:                                           ; preds = %B308.if.i, %middle.block4899, %.1491.if.i
  br i1 %.1728.i, label %B370.else.i, label %B442.i

B442.i:                                           ; preds = %B250.i.i, %B358.i
  %.2158.i = load i64, ptr %arg.code.4, align 8, !noalias !133
  %.2205.i = inttoptr i64 %.2158.i to ptr
  tail call void %.2205.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2204.i), !noalias !133
  br label %B558.if.i

B648.i:                                           ; preds = %B558.if.i
  %.150.i155.i = load i64, ptr %.149.i154.i, align 8, !noalias !137
  %.195.i174.i = inttoptr i64 %.150.i155.i to ptr
  tail call void %.195.i174.i(ptr %.331.i, ptr %.169.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !137
  br i1 %.279.i211.i4727.not, label %B250.i219.i, label %B118.if.i429.i

B248.i313.i:                                      ; preds = %B190.if.i414.i, %B118.if.i429.i
  %exitcond4787.not = icmp eq i64 %arg.shape.0, %.292.i435.i
  br i1 %exitcond4787.not, label %B250.i219.i, label %B118.if.i429.i

B250.i219.i:                                      ; preds = %B248.i313.i, %B648.i
  %.614.i243.i = load i64, ptr %.2211, align 8, !noalias !137
  %.661.i263.i = inttoptr i64 %.614.i243.i to ptr
  tail call void %.661.i263.i(ptr %.331.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !137
  br label %B708.i

B118.if.i429.i:                                   ; preds = %B648.i, %B248.i313.i
  %.221.i102.i.04729 = phi i64 [ %.292.i435.i, %B248.i313.i ], [ 0, %B648.i ]
  %.292.i435.i = add nsw i64 %.221.i102.i.04729, 1
  %58 = getelementptr double, ptr %26, i64 %.221.i102.i.04729
  %.374.i311.i = load double, ptr %58, align 8, !noalias !137
  %.375.i312.i = fcmp ule double %.374.i311.i, 5.000000e-01
  %brmerge = select i1 %.375.i312.i, i1 true, i1 %.457.i354.i4724
  br i1 %brmerge, label %B248.i313.i, label %B190.if.i414.i.preheader

B190.if.i414.i.preheader:                         ; preds = %B118.if.i429.i
  %invariant.gep4981 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i102.i.04729
  br label %B190.if.i414.i

B190.if.i414.i:                                   ; preds = %B190.if.i414.i.preheader, %B190.if.i414.i
  %.401.i116.i.04726 = phi i64 [ %.470.i420.i, %B190.if.i414.i ], [ 0, %B190.if.i414.i.preheader ]
  %.470.i420.i = add nsw i64 %.401.i116.i.04726, 1
  %.496.i366.i = mul nsw i64 %.401.i116.i.04726, %arg.shape.0
  %gep4982 = getelementptr double, ptr %invariant.gep4981, i64 %.496.i366.i
  %.528.i388.i = load double, ptr %gep4982, align 8, !noalias !137
  %.530.i390.i = add nsw i64 %.401.i116.i.04726, %arg.held
  %.532.i392.i = mul nsw i64 %.530.i390.i, %arg.shape.0
  %.534.i394.i = add nsw i64 %.532.i392.i, %.221.i102.i.04729
  %.548.i402.i = icmp slt i64 %.534.i394.i, 0
  %.549.i403.i = select i1 %.548.i402.i, i64 %arg.arrays.1.5.0, i64 0
  %59 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i394.i
  %.563.i413.i = getelementptr double, ptr %59, i64 %.549.i403.i
  store double %.528.i388.i, ptr %.563.i413.i, align 8, !noalias !137
  %exitcond4786.not = icmp eq i64 %.470.i420.i, %arg.decided
  br i1 %exitcond4786.not, label %B248.i313.i, label %B190.if.i414.i

B708.i:                                           ; preds = %B250.i219.i, %B558.if.i
  %.2495.i = load i64, ptr %arg.code.4, align 8, !noalias !133
  %.2503.i = mul nsw i64 %.2299.i, %.223.i
  %.2547.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.2503.i
  %.2548.i = inttoptr i64 %.2495.i to ptr
  tail call void %.2548.i(ptr %.331.i, ptr %.2522.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2547.i), !noalias !133
  %exitcond4788.not = icmp eq i64 %.2299.i, 4
  br i1 %exitcond4788.not, label %B816.i, label %B558.if.i

B816.i:                                           ; preds = %B708.i
  %.2585.i = load i64, ptr %.2584.i, align 8, !noalias !133
  %.2630.i = inttoptr i64 %.2585.i to ptr
  tail call void %.2630.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !133
  br i1 %.2633.i.not, label %B962.i, label %B894.i

B894.i:                                           ; preds = %B816.i
  %.2664.i = load i64, ptr %.2663.i, align 8, !noalias !133
  %.2709.i = inttoptr i64 %.2664.i to ptr
  tail call void %.2709.i(ptr %.331.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !133
  br label %B962.i

B962.i:                                           ; preds = %B894.i, %B816.i
  br i1 %.2795.i4736.not, label %B1410.i, label %B996.if.i

B1046.i:                                          ; preds = %B996.if.i
  %.2929.i = getelementptr i64, ptr %arg.results.1.4, i64 %.2890.i
  %.2930.i = load i64, ptr %.2929.i, align 8, !noalias !133
  %.2931.i.not = icmp eq i64 %.2930.i, 0
  br i1 %.2931.i.not, label %B1082.i, label %B1621.i

B1082.i:                                          ; preds = %B1046.i
  %.3001.i = mul i64 %.2890.i, %arg.results.3.5.1
  %.3005.i = getelementptr i64, ptr %arg.results.3.4, i64 %.3001.i
  %.3006.i = load i64, ptr %.3005.i, align 8, !noalias !133
  %.3007.i = add nsw i64 %.3006.i, 1
  store i64 %.3007.i, ptr %.3005.i, align 8, !noalias !133
  %.3115.i = getelementptr i8, ptr %.3005.i, i64 8
  %.3116.i = load i64, ptr %.3115.i, align 8, !noalias !133
  %.3117.i = add nsw i64 %.3116.i, 4
  store i64 %.3117.i, ptr %.3115.i, align 8, !noalias !133
  br i1 %.3250.i4732.not, label %B1310.i, label %B1204.if.i.preheader

B1204.if.i.preheader:                             ; preds = %B1082.i
  %invariant.gep4983 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2739.i.04737
  br label %B1204.if.i

B1250.i.loopexit:                                 ; preds = %B1204.if.i
  %60 = fcmp une double %.3324.i, 0.000000e+00
  br i1 %60, label %B1262.i, label %B1310.i

B1262.i:                                          ; preds = %B1250.i.loopexit
  %.84.i477.i = load i64, ptr %104, align 8, !noalias !141
  %.89.i.i = icmp sgt i64 %.84.i477.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B1621.i

B46.i.i:                                          ; preds = %B1262.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i477.i
  %.121.i486.i = load i64, ptr %.120.i.i, align 8, !noalias !141
  %.122.i487.i = icmp eq i64 %.121.i486.i, 0
  br i1 %.122.i487.i, label %B80.i.i, label %B1621.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !141
  br label %B1621.i

B1310.i:                                          ; preds = %B1082.i, %B1250.i.loopexit
  br i1 %.2633.i.not, label %B1398.i, label %B1314.i

B1314.i:                                          ; preds = %B1310.i
  %61 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2739.i.04737
  %.3412.i = load double, ptr %61, align 8, !noalias !133
  %.3414.i = fcmp olt double %.3412.i, -1.000000e-09
  br i1 %.3414.i, label %B1350.i, label %B1398.i

B1350.i:                                          ; preds = %B1314.i
  %.84.i577.i = load i64, ptr %104, align 8, !noalias !144
  %.89.i580.i = icmp sgt i64 %.84.i577.i, -1
  br i1 %.89.i580.i, label %B46.i585.i, label %B1621.i

B46.i585.i:                                       ; preds = %B1350.i
  %.120.i606.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i577.i
  %.121.i607.i = load i64, ptr %.120.i606.i, align 8, !noalias !144
  %.122.i608.i = icmp eq i64 %.121.i607.i, 0
  br i1 %.122.i608.i, label %B80.i613.i, label %B1621.i

B80.i613.i:                                       ; preds = %B46.i585.i
  store i64 4, ptr %.120.i606.i, align 8, !noalias !144
  br label %B1621.i

B1398.i:                                          ; preds = %B1314.i, %B1310.i
  %.3461.i = add nsw i64 %active.3.i.14739, 1
  br label %B1621.i

B1410.i.loopexit:                                 ; preds = %B1621.i
  %62 = icmp ne i64 %active.4.i.2, 0
  br label %B1410.i

B1410.i:                                          ; preds = %B1410.i.loopexit, %B962.i
  %active.3.i.1.lcssa = phi i1 [ false, %B962.i ], [ %62, %B1410.i.loopexit ]
  %.804.i = icmp sgt i64 %.742.i.04742, 1
  %or.cond = select i1 %active.3.i.1.lcssa, i1 %.804.i, i1 false
  br i1 %or.cond, label %B186.if.i, label %B1430.i

B1430.i:                                          ; preds = %B1410.i
  %or.cond.not4773 = or i1 %.3568.i, %active.3.i.1.lcssa
  %brmerge4771 = select i1 %or.cond.not4773, i1 true, i1 %.3652.i4743.not4772
  br i1 %brmerge4771, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i.preheader

B1484.if.i.preheader:                             ; preds = %B1430.i
  %brmerge4987 = select i1 %min.iters.check4861, i1 true, i1 %found.conflict
  br i1 %brmerge4987, label %B1484.if.i.preheader4968, label %vector.body4865

vector.body4865:                                  ; preds = %B1484.if.i.preheader, %vector.body4865
  %index4866 = phi i64 [ %index.next4871, %vector.body4865 ], [ 0, %B1484.if.i.preheader ]
  %63 = getelementptr double, ptr %arg.arrays.0.4, i64 %index4866
  %64 = getelementptr i8, ptr %63, i64 %42
  %65 = getelementptr i8, ptr %64, i64 16
  %wide.load4867 = load <2 x double>, ptr %64, align 8, !alias.scope !147, !noalias !133
  %wide.load4868 = load <2 x double>, ptr %65, align 8, !alias.scope !147, !noalias !133
  %66 = getelementptr i8, ptr %63, i64 16
  %wide.load4869 = load <2 x double>, ptr %63, align 8, !alias.scope !150, !noalias !152
  %wide.load4870 = load <2 x double>, ptr %66, align 8, !alias.scope !150, !noalias !152
  %67 = fsub <2 x double> %wide.load4869, %wide.load4867
  %68 = fsub <2 x double> %wide.load4870, %wide.load4868
  store <2 x double> %wide.load4867, ptr %63, align 8, !alias.scope !150, !noalias !152
  store <2 x double> %wide.load4868, ptr %66, align 8, !alias.scope !150, !noalias !152
  store <2 x double> %67, ptr %64, align 8, !alias.scope !147, !noalias !133
  store <2 x double> %68, ptr %65, align 8, !alias.scope !147, !noalias !133
  %index.next4871 = add i64 %index4866, 4
  %69 = icmp eq i64 %index.next4871, %n.vec4864
  br i1 %69, label %middle.block4872, label %vector.body4865, !llvm.loop !153

middle.block4872:                                 ; preds = %vector.body4865
  br i1 %cmp.n4873, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i.preheader4968

B1484.if.i.preheader4968:                         ; preds = %B1484.if.i.preheader, %middle.block4872
  %.3596.i.04744.ph = phi i64 [ %n.vec4864, %middle.block4872 ], [ 0, %B1484.if.i.preheader ]
  br label %B1484.if.i

B1621.i:                                          ; preds = %B80.i613.i, %B1350.i, %B46.i585.i, %B80.i.i, %B1262.i, %B46.i.i, %B996.if.i, %B1046.i, %B1398.i
  %active.4.i.2 = phi i64 [ %.3461.i, %B1398.i ], [ %active.3.i.14739, %B996.if.i ], [ %active.3.i.14739, %B80.i.i ], [ %active.3.i.14739, %B1046.i ], [ %active.3.i.14739, %B46.i.i ], [ %active.3.i.14739, %B1262.i ], [ %active.3.i.14739, %B46.i585.i ], [ %active.3.i.14739, %B1350.i ], [ %active.3.i.14739, %B80.i613.i ]
  %exitcond4790.not = icmp eq i64 %arg.shape.0, %.2808.i
  br i1 %exitcond4790.not, label %B1410.i.loopexit, label %B996.if.i

B0.endif.else.endif.if.i:                         ; preds = %B906
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B906
  %spec.select = phi i64 [ %arg.lane.0.5.1, %B0.endif.else.endif.if.i ], [ 0, %B906 ]
  %.693.i.not4707 = icmp slt i64 %spec.select, %arg.lane.0.5.1
  br i1 %.693.i.not4707, label %.663.endif.i.preheader, label %B186.if.i.preheader, !prof !124

.663.endif.i.preheader:                           ; preds = %B0.endif.else.endif.endif.i
  %70 = sub i64 %arg.lane.0.5.1, %spec.select
  %min.iters.check4931 = icmp ult i64 %70, 4
  br i1 %min.iters.check4931, label %.663.endif.i.preheader4969, label %vector.ph4932, !prof !125

vector.ph4932:                                    ; preds = %.663.endif.i.preheader
  %n.vec4934 = and i64 %70, -4
  %71 = add i64 %spec.select, %n.vec4934
  %broadcast.splatinsert4935 = insertelement <2 x double> poison, double %.2510, i64 0
  %broadcast.splat4936 = shufflevector <2 x double> %broadcast.splatinsert4935, <2 x double> poison, <2 x i32> zeroinitializer
  %72 = getelementptr double, ptr %27, i64 %spec.select
  br label %vector.body4937

vector.body4937:                                  ; preds = %vector.body4937, %vector.ph4932
  %index4938 = phi i64 [ 0, %vector.ph4932 ], [ %index.next4940, %vector.body4937 ]
  %73 = getelementptr double, ptr %72, i64 %index4938
  %74 = getelementptr i8, ptr %73, i64 16
  store <2 x double> %broadcast.splat4936, ptr %73, align 8, !noalias !133
  store <2 x double> %broadcast.splat4936, ptr %74, align 8, !noalias !133
  %index.next4940 = add i64 %index4938, 4
  %75 = icmp eq i64 %index.next4940, %n.vec4934
  br i1 %75, label %middle.block4941, label %vector.body4937, !prof !126, !llvm.loop !154

middle.block4941:                                 ; preds = %vector.body4937
  %cmp.n4942 = icmp eq i64 %70, %n.vec4934
  br i1 %cmp.n4942, label %B186.if.i.preheader, label %.663.endif.i.preheader4969, !prof !129

.663.endif.i.preheader4969:                       ; preds = %.663.endif.i.preheader, %middle.block4941
  %.659.i.04708.ph = phi i64 [ %spec.select, %.663.endif.i.preheader ], [ %71, %middle.block4941 ]
  br label %.663.endif.i

.663.endif.i:                                     ; preds = %.663.endif.i.preheader4969, %.663.endif.i
  %.659.i.04708 = phi i64 [ %.707.i, %.663.endif.i ], [ %.659.i.04708.ph, %.663.endif.i.preheader4969 ]
  %.702.i = getelementptr double, ptr %27, i64 %.659.i.04708
  store double %.2510, ptr %.702.i, align 8, !noalias !133
  %.707.i = add nsw i64 %.659.i.04708, 1
  %exitcond4779.not = icmp eq i64 %.707.i, %arg.lane.0.5.1
  br i1 %exitcond4779.not, label %B186.if.i.preheader, label %.663.endif.i, !prof !130, !llvm.loop !155

B186.if.i.preheader:                              ; preds = %.663.endif.i, %middle.block4941, %B0.endif.else.endif.endif.i
  br label %B186.if.i

B186.if.i:                                        ; preds = %B186.if.i.preheader, %B1410.i
  %.742.i.04742 = phi i64 [ %.813.i, %B1410.i ], [ %.11.i4680, %B186.if.i.preheader ]
  %.739.i.04741 = phi i64 [ %.817.i, %B1410.i ], [ 0, %B186.if.i.preheader ]
  %.813.i = add nsw i64 %.742.i.04742, -1
  %.817.i = add nsw i64 %.739.i.04741, 1
  %.845.i = uitofp i64 %.739.i.04741 to double
  %.846.i = fmul double %.2510, %.845.i
  %.848.i = fadd double %t.4.3, %.846.i
  %.851.i = uitofp i64 %.817.i to double
  %.852.i = fmul double %.2510, %.851.i
  %.854.i = fadd double %t.4.3, %.852.i
  br i1 %.2065, label %B188.endif.else.endif.if.i, label %B188.endif.else.endif.endif.i, !prof !117

B188.endif.else.endif.if.i:                       ; preds = %B186.if.i
  br label %B188.endif.else.endif.endif.i

B188.endif.else.endif.endif.i:                    ; preds = %B188.endif.else.endif.if.i, %B186.if.i
  %spec.select4676 = phi i64 [ %arg.lane.0.5.1, %B188.endif.else.endif.if.i ], [ 0, %B186.if.i ]
  %.1178.i.not4709 = icmp slt i64 %spec.select4676, %arg.lane.0.5.1
  br i1 %.1178.i.not4709, label %.1148.endif.i.preheader, label %.1149.else.i, !prof !124

.1148.endif.i.preheader:                          ; preds = %B188.endif.else.endif.endif.i
  %76 = sub i64 %arg.lane.0.5.1, %spec.select4676
  %min.iters.check4917 = icmp ult i64 %76, 4
  br i1 %min.iters.check4917, label %.1148.endif.i.preheader4963, label %vector.ph4918, !prof !125

vector.ph4918:                                    ; preds = %.1148.endif.i.preheader
  %n.vec4920 = and i64 %76, -4
  %77 = add i64 %spec.select4676, %n.vec4920
  %broadcast.splatinsert4921 = insertelement <2 x double> poison, double %.848.i, i64 0
  %broadcast.splat4922 = shufflevector <2 x double> %broadcast.splatinsert4921, <2 x double> poison, <2 x i32> zeroinitializer
  %78 = getelementptr double, ptr %arg.lane.0.4, i64 %spec.select4676
  br label %vector.body4923

vector.body4923:                                  ; preds = %vector.body4923, %vector.ph4918
  %index4924 = phi i64 [ 0, %vector.ph4918 ], [ %index.next4926, %vector.body4923 ]
  %79 = getelementptr double, ptr %78, i64 %index4924
  %80 = getelementptr i8, ptr %79, i64 16
  store <2 x double> %broadcast.splat4922, ptr %79, align 8, !noalias !133
  store <2 x double> %broadcast.splat4922, ptr %80, align 8, !noalias !133
  %index.next4926 = add i64 %index4924, 4
  %81 = icmp eq i64 %index.next4926, %n.vec4920
  br i1 %81, label %middle.block4927, label %vector.body4923, !prof !126, !llvm.loop !156

middle.block4927:                                 ; preds = %vector.body4923
  %cmp.n4928 = icmp eq i64 %76, %n.vec4920
  br i1 %cmp.n4928, label %.1149.else.i, label %.1148.endif.i.preheader4963, !prof !129

.1148.endif.i.preheader4963:                      ; preds = %.1148.endif.i.preheader, %middle.block4927
  %.1144.i.04710.ph = phi i64 [ %spec.select4676, %.1148.endif.i.preheader ], [ %77, %middle.block4927 ]
  br label %.1148.endif.i

.1148.endif.i:                                    ; preds = %.1148.endif.i.preheader4963, %.1148.endif.i
  %.1144.i.04710 = phi i64 [ %.1192.i, %.1148.endif.i ], [ %.1144.i.04710.ph, %.1148.endif.i.preheader4963 ]
  %.1187.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1144.i.04710
  store double %.848.i, ptr %.1187.i, align 8, !noalias !133
  %.1192.i = add nsw i64 %.1144.i.04710, 1
  %exitcond4780.not = icmp eq i64 %.1192.i, %arg.lane.0.5.1
  br i1 %exitcond4780.not, label %.1149.else.i, label %.1148.endif.i, !prof !130, !llvm.loop !157

.1149.else.i:                                     ; preds = %.1148.endif.i, %middle.block4927, %B188.endif.else.endif.endif.i
  br i1 %.2065, label %.1149.endif.else.endif.if.i, label %.1149.endif.else.endif.endif.i, !prof !117

.1149.endif.else.endif.if.i:                      ; preds = %.1149.else.i
  br label %.1149.endif.else.endif.endif.i

.1149.endif.else.endif.endif.i:                   ; preds = %.1149.endif.else.endif.if.i, %.1149.else.i
  %spec.select4677 = phi i64 [ %arg.lane.0.5.1, %.1149.endif.else.endif.if.i ], [ 0, %.1149.else.i ]
  %.1521.i.not4711 = icmp slt i64 %spec.select4677, %arg.lane.0.5.1
  br i1 %.1521.i.not4711, label %.1491.endif.i.preheader, label %.1491.if.i, !prof !124

.1491.endif.i.preheader:                          ; preds = %.1149.endif.else.endif.endif.i
  %82 = sub i64 %arg.lane.0.5.1, %spec.select4677
  %min.iters.check4903 = icmp ult i64 %82, 4
  br i1 %min.iters.check4903, label %.1491.endif.i.preheader4962, label %vector.ph4904, !prof !125

vector.ph4904:                                    ; preds = %.1491.endif.i.preheader
  %n.vec4906 = and i64 %82, -4
  %83 = add i64 %spec.select4677, %n.vec4906
  %broadcast.splatinsert4907 = insertelement <2 x double> poison, double %.854.i, i64 0
  %broadcast.splat4908 = shufflevector <2 x double> %broadcast.splatinsert4907, <2 x double> poison, <2 x i32> zeroinitializer
  %84 = getelementptr double, ptr %23, i64 %spec.select4677
  br label %vector.body4909

vector.body4909:                                  ; preds = %vector.body4909, %vector.ph4904
  %index4910 = phi i64 [ 0, %vector.ph4904 ], [ %index.next4912, %vector.body4909 ]
  %85 = getelementptr double, ptr %84, i64 %index4910
  %86 = getelementptr i8, ptr %85, i64 16
  store <2 x double> %broadcast.splat4908, ptr %85, align 8, !noalias !133
  store <2 x double> %broadcast.splat4908, ptr %86, align 8, !noalias !133
  %index.next4912 = add i64 %index4910, 4
  %87 = icmp eq i64 %index.next4912, %n.vec4906
  br i1 %87, label %middle.block4913, label %vector.body4909, !prof !126, !llvm.loop !158

middle.block4913:                                 ; preds = %vector.body4909
  %cmp.n4914 = icmp eq i64 %82, %n.vec4906
  br i1 %cmp.n4914, label %.1491.if.i, label %.1491.endif.i.preheader4962, !prof !129

.1491.endif.i.preheader4962:                      ; preds = %.1491.endif.i.preheader, %middle.block4913
  %.1487.i.04712.ph = phi i64 [ %spec.select4677, %.1491.endif.i.preheader ], [ %83, %middle.block4913 ]
  br label %.1491.endif.i

.1491.if.i:                                       ; preds = %.1491.endif.i, %middle.block4913, %.1149.endif.else.endif.endif.i
  br i1 %.1621.i4713.not, label %B358.i, label %B308.if.i.preheader

B308.if.i.preheader:                              ; preds = %.1491.if.i
  br i1 %or.cond4959, label %B308.if.i.preheader4961, label %vector.body4894

vector.body4894:                                  ; preds = %B308.if.i.preheader, %vector.body4894
  %index4895 = phi i64 [ %index.next4898, %vector.body4894 ], [ 0, %B308.if.i.preheader ]
  %88 = getelementptr double, ptr %arg.arrays.0.4, i64 %index4895
  %89 = getelementptr i8, ptr %88, i64 16
  %wide.load4896 = load <2 x double>, ptr %88, align 8, !noalias !133
  %wide.load4897 = load <2 x double>, ptr %89, align 8, !noalias !133
  %90 = getelementptr i8, ptr %88, i64 %41
  %91 = getelementptr i8, ptr %90, i64 16
  store <2 x double> %wide.load4896, ptr %90, align 8, !noalias !133
  store <2 x double> %wide.load4897, ptr %91, align 8, !noalias !133
  %index.next4898 = add i64 %index4895, 4
  %92 = icmp eq i64 %index.next4898, %n.vec4893
  br i1 %92, label %middle.block4899, label %vector.body4894, !llvm.loop !159

middle.block4899:                                 ; preds = %vector.body4894
  br i1 %cmp.n4900, label %B358.i, label %B308.if.i.preheader4961

B308.if.i.preheader4961:                          ; preds = %B308.if.i.preheader, %middle.block4899
  %.1565.i.04714.ph = phi i64 [ 0, %B308.if.i.preheader ], [ %n.vec4893, %middle.block4899 ]
  br label %B308.if.i

.1491.endif.i:                                    ; preds = %.1491.endif.i.preheader4962, %.1491.endif.i
  %.1487.i.04712 = phi i64 [ %.1535.i, %.1491.endif.i ], [ %.1487.i.04712.ph, %.1491.endif.i.preheader4962 ]
  %.1530.i = getelementptr double, ptr %23, i64 %.1487.i.04712
  store double %.854.i, ptr %.1530.i, align 8, !noalias !133
  %.1535.i = add nsw i64 %.1487.i.04712, 1
  %exitcond4781.not = icmp eq i64 %.1535.i, %arg.lane.0.5.1
  br i1 %exitcond4781.not, label %.1491.if.i, label %.1491.endif.i, !prof !130, !llvm.loop !160

B308.if.i:                                        ; preds = %B308.if.i.preheader4961, %B308.if.i
  %.1565.i.04714 = phi i64 [ %.1634.i, %B308.if.i ], [ %.1565.i.04714.ph, %B308.if.i.preheader4961 ]
  %.1634.i = add nsw i64 %.1565.i.04714, 1
  %93 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1565.i.04714
  %.1688.i = load double, ptr %93, align 8, !noalias !133
  %gep4978 = getelementptr double, ptr %invariant.gep4977, i64 %.1565.i.04714
  store double %.1688.i, ptr %gep4978, align 8, !noalias !133
  %exitcond4782.not = icmp eq i64 %.223.i, %.1634.i
  br i1 %exitcond4782.not, label %B358.i, label %B308.if.i, !llvm.loop !161

B370.else.i:                                      ; preds = %B358.i
  br i1 %.2065, label %B370.endif.else.endif.if.i, label %B370.endif.else.endif.endif.i, !prof !117

B370.endif.else.endif.if.i:                       ; preds = %B370.else.i
  br label %B370.endif.else.endif.endif.i

B370.endif.else.endif.endif.i:                    ; preds = %B370.endif.else.endif.if.i, %B370.else.i
  %spec.select4678 = phi i64 [ %arg.lane.0.5.1, %B370.endif.else.endif.if.i ], [ 0, %B370.else.i ]
  %.2053.i.not4716 = icmp slt i64 %spec.select4678, %arg.lane.0.5.1
  br i1 %.2053.i.not4716, label %.2023.endif.i.preheader, label %.2023.if.i, !prof !124

.2023.endif.i.preheader:                          ; preds = %B370.endif.else.endif.endif.i
  %94 = sub i64 %arg.lane.0.5.1, %spec.select4678
  %min.iters.check4876 = icmp ult i64 %94, 4
  br i1 %min.iters.check4876, label %.2023.endif.i.preheader4960, label %vector.ph4877, !prof !125

vector.ph4877:                                    ; preds = %.2023.endif.i.preheader
  %n.vec4879 = and i64 %94, -4
  %95 = add i64 %spec.select4678, %n.vec4879
  %96 = getelementptr double, ptr %24, i64 %spec.select4678
  br label %vector.body4880

vector.body4880:                                  ; preds = %vector.body4880, %vector.ph4877
  %index4881 = phi i64 [ 0, %vector.ph4877 ], [ %index.next4883, %vector.body4880 ]
  %97 = getelementptr double, ptr %96, i64 %index4881
  %98 = getelementptr i8, ptr %97, i64 16
  store <2 x double> splat (double 1.000000e+00), ptr %97, align 8, !noalias !133
  store <2 x double> splat (double 1.000000e+00), ptr %98, align 8, !noalias !133
  %index.next4883 = add i64 %index4881, 4
  %99 = icmp eq i64 %index.next4883, %n.vec4879
  br i1 %99, label %middle.block4884, label %vector.body4880, !prof !126, !llvm.loop !162

middle.block4884:                                 ; preds = %vector.body4880
  %cmp.n4885 = icmp eq i64 %94, %n.vec4879
  br i1 %cmp.n4885, label %.2023.if.i, label %.2023.endif.i.preheader4960, !prof !129

.2023.endif.i.preheader4960:                      ; preds = %.2023.endif.i.preheader, %middle.block4884
  %.2019.i.04717.ph = phi i64 [ %spec.select4678, %.2023.endif.i.preheader ], [ %95, %middle.block4884 ]
  br label %.2023.endif.i

B248.i.i:                                         ; preds = %B190.if.i.i, %B118.if.i.i
  %exitcond4785.not = icmp eq i64 %arg.shape.0, %.292.i.i
  br i1 %exitcond4785.not, label %B250.i.i, label %B118.if.i.i

B250.i.i:                                         ; preds = %B248.i.i, %.2023.if.i
  %.614.i.i = load i64, ptr %.2211, align 8, !noalias !163
  %.661.i.i = inttoptr i64 %.614.i.i to ptr
  tail call void %.661.i.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !163
  br label %B442.i

B118.if.i.i:                                      ; preds = %.2023.if.i, %B248.i.i
  %.221.i.i.04723 = phi i64 [ %.292.i.i, %B248.i.i ], [ 0, %.2023.if.i ]
  %.292.i.i = add nsw i64 %.221.i.i.04723, 1
  %100 = getelementptr double, ptr %25, i64 %.221.i.i.04723
  %.374.i.i = load double, ptr %100, align 8, !noalias !163
  %.375.i.i = fcmp ule double %.374.i.i, 5.000000e-01
  %brmerge4770 = select i1 %.375.i.i, i1 true, i1 %.457.i.i4718
  br i1 %brmerge4770, label %B248.i.i, label %B190.if.i.i.preheader

B190.if.i.i.preheader:                            ; preds = %B118.if.i.i
  %invariant.gep4979 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.i.04723
  br label %B190.if.i.i

B190.if.i.i:                                      ; preds = %B190.if.i.i.preheader, %B190.if.i.i
  %.401.i.i.04719 = phi i64 [ %.470.i.i, %B190.if.i.i ], [ 0, %B190.if.i.i.preheader ]
  %.470.i.i = add nsw i64 %.401.i.i.04719, 1
  %.496.i.i = mul nsw i64 %.401.i.i.04719, %arg.shape.0
  %gep4980 = getelementptr double, ptr %invariant.gep4979, i64 %.496.i.i
  %.528.i.i = load double, ptr %gep4980, align 8, !noalias !163
  %.530.i.i = add nsw i64 %.401.i.i.04719, %arg.held
  %.532.i.i = mul nsw i64 %.530.i.i, %arg.shape.0
  %.534.i.i = add nsw i64 %.532.i.i, %.221.i.i.04723
  %.548.i.i = icmp slt i64 %.534.i.i, 0
  %.549.i.i = select i1 %.548.i.i, i64 %arg.arrays.1.5.0, i64 0
  %101 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i.i
  %.563.i.i = getelementptr double, ptr %101, i64 %.549.i.i
  store double %.528.i.i, ptr %.563.i.i, align 8, !noalias !163
  %exitcond4784.not = icmp eq i64 %.470.i.i, %arg.decided
  br i1 %exitcond4784.not, label %B248.i.i, label %B190.if.i.i

.2023.if.i:                                       ; preds = %.2023.endif.i, %middle.block4884, %B370.endif.else.endif.endif.i
  %.150.i.i = load i64, ptr %.149.i.i, align 8, !noalias !163
  %.195.i.i = inttoptr i64 %.150.i.i to ptr
  tail call void %.195.i.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !163
  br i1 %.279.i.i4721.not, label %B250.i.i, label %B118.if.i.i

.2023.endif.i:                                    ; preds = %.2023.endif.i.preheader4960, %.2023.endif.i
  %.2019.i.04717 = phi i64 [ %.2067.i, %.2023.endif.i ], [ %.2019.i.04717.ph, %.2023.endif.i.preheader4960 ]
  %.2062.i = getelementptr double, ptr %24, i64 %.2019.i.04717
  store double 1.000000e+00, ptr %.2062.i, align 8, !noalias !133
  %.2067.i = add nsw i64 %.2019.i.04717, 1
  %exitcond4783.not = icmp eq i64 %.2067.i, %arg.lane.0.5.1
  br i1 %exitcond4783.not, label %.2023.if.i, label %.2023.endif.i, !prof !130, !llvm.loop !167

B558.if.i:                                        ; preds = %B442.i, %B708.i
  %.2230.i.04730 = phi i64 [ 1, %B442.i ], [ %.2299.i, %B708.i ]
  %.2299.i = add nsw i64 %.2230.i.04730, 1
  %102 = getelementptr i64, ptr %arg.code.4, i64 %.2230.i.04730
  %103 = getelementptr i8, ptr %102, i64 216
  %.2358.i = load i64, ptr %103, align 8, !noalias !133
  %.2403.i = inttoptr i64 %.2358.i to ptr
  tail call void %.2403.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !133
  br i1 %.1728.i, label %B648.i, label %B708.i

B996.if.i:                                        ; preds = %B962.i, %B1621.i
  %active.3.i.14739 = phi i64 [ %active.4.i.2, %B1621.i ], [ 0, %B962.i ]
  %.2739.i.04737 = phi i64 [ %.2808.i, %B1621.i ], [ 0, %B962.i ]
  %.2808.i = add nsw i64 %.2739.i.04737, 1
  %104 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2739.i.04737
  %.2890.i = load i64, ptr %104, align 8, !noalias !133
  %.2898.i = icmp slt i64 %.2890.i, 0
  br i1 %.2898.i, label %B1621.i, label %B1046.i

B1204.if.i:                                       ; preds = %B1204.if.i.preheader, %B1204.if.i
  %trouble.2.i.34735 = phi double [ %.3324.i, %B1204.if.i ], [ 0.000000e+00, %B1204.if.i.preheader ]
  %.3194.i.04733 = phi i64 [ %.3263.i, %B1204.if.i ], [ 0, %B1204.if.i.preheader ]
  %.3263.i = add nsw i64 %.3194.i.04733, 1
  %105 = mul nsw i64 %.3194.i.04733, %arg.shape.0
  %gep4984 = getelementptr double, ptr %invariant.gep4983, i64 %105
  %.3321.i = load double, ptr %gep4984, align 8, !noalias !133
  %.3322.i = fmul double %.3321.i, 0.000000e+00
  %.3324.i = fadd double %trouble.2.i.34735, %.3322.i
  %exitcond4789.not = icmp eq i64 %arg.shape.1, %.3263.i
  br i1 %exitcond4789.not, label %B1250.i.loopexit, label %B1204.if.i

B1484.if.i:                                       ; preds = %B1484.if.i.preheader4968, %B1484.if.i
  %.3596.i.04744 = phi i64 [ %.3665.i, %B1484.if.i ], [ %.3596.i.04744.ph, %B1484.if.i.preheader4968 ]
  %.3665.i = add nsw i64 %.3596.i.04744, 1
  %gep4986 = getelementptr double, ptr %invariant.gep4985, i64 %.3596.i.04744
  %.3722.i = load double, ptr %gep4986, align 8, !noalias !133
  %106 = getelementptr double, ptr %arg.arrays.0.4, i64 %.3596.i.04744
  %.3752.i = load double, ptr %106, align 8, !noalias !133
  %.3786.i = fsub double %.3752.i, %.3722.i
  store double %.3722.i, ptr %106, align 8, !noalias !133
  store double %.3786.i, ptr %gep4986, align 8, !noalias !133
  %exitcond4791.not = icmp eq i64 %arg.shape.1, %.3665.i
  br i1 %exitcond4791.not, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i, !llvm.loop !168

B906.endif.endif.endif.endif.endif:               ; preds = %B1484.if.i, %middle.block4872, %B1430.i
  br i1 %active.3.i.1.lcssa, label %B1158, label %B1536

B1194.else.endif:                                 ; preds = %B1166
  br i1 %.2065, label %B1194.endif.else.endif.if, label %B1194.endif.else.endif.endif.endif.if, !prof !117

B1194.endif.else.endif.if:                        ; preds = %B1194.else.endif
  br label %B1194.endif.else.endif.endif.endif.if

B1194.endif.else.endif.endif.endif.if:            ; preds = %B1194.endif.else.endif.if, %B1194.else.endif
  %.2882.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B1194.endif.else.endif.if ], [ 0, %B1194.else.endif ]
  %.3006.not4746 = icmp slt i64 %.2882.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3006.not4746, label %.2976.endif.preheader, label %.2977.else.endif, !prof !124

.2976.endif.preheader:                            ; preds = %B1194.endif.else.endif.endif.endif.if
  %107 = sub i64 %arg.lane.0.5.1, %.2882.sroa.0.3
  %min.iters.check4843 = icmp ult i64 %107, 4
  br i1 %min.iters.check4843, label %.2976.endif.preheader4967, label %vector.ph4844, !prof !125

vector.ph4844:                                    ; preds = %.2976.endif.preheader
  %n.vec4846 = and i64 %107, -4
  %108 = add i64 %.2882.sroa.0.3, %n.vec4846
  %broadcast.splatinsert4847 = insertelement <2 x double> poison, double %.11.i4679, i64 0
  %broadcast.splat4848 = shufflevector <2 x double> %broadcast.splatinsert4847, <2 x double> poison, <2 x i32> zeroinitializer
  %109 = getelementptr double, ptr %arg.lane.0.4, i64 %.2882.sroa.0.3
  br label %vector.body4849

vector.body4849:                                  ; preds = %vector.body4849, %vector.ph4844
  %index4850 = phi i64 [ 0, %vector.ph4844 ], [ %index.next4852, %vector.body4849 ]
  %110 = getelementptr double, ptr %109, i64 %index4850
  %111 = getelementptr i8, ptr %110, i64 16
  store <2 x double> %broadcast.splat4848, ptr %110, align 8
  store <2 x double> %broadcast.splat4848, ptr %111, align 8
  %index.next4852 = add i64 %index4850, 4
  %112 = icmp eq i64 %index.next4852, %n.vec4846
  br i1 %112, label %middle.block4853, label %vector.body4849, !prof !126, !llvm.loop !169

middle.block4853:                                 ; preds = %vector.body4849
  %cmp.n4854 = icmp eq i64 %107, %n.vec4846
  br i1 %cmp.n4854, label %.2977.else.endif, label %.2976.endif.preheader4967, !prof !129

.2976.endif.preheader4967:                        ; preds = %.2976.endif.preheader, %middle.block4853
  %.2972.04747.ph = phi i64 [ %.2882.sroa.0.3, %.2976.endif.preheader ], [ %108, %middle.block4853 ]
  br label %.2976.endif

.2976.endif:                                      ; preds = %.2976.endif.preheader4967, %.2976.endif
  %.2972.04747 = phi i64 [ %.3020, %.2976.endif ], [ %.2972.04747.ph, %.2976.endif.preheader4967 ]
  %.3015 = getelementptr double, ptr %arg.lane.0.4, i64 %.2972.04747
  store double %.11.i4679, ptr %.3015, align 8
  %.3020 = add nsw i64 %.2972.04747, 1
  %exitcond4792.not = icmp eq i64 %.3020, %arg.lane.0.5.1
  br i1 %exitcond4792.not, label %.2977.else.endif, label %.2976.endif, !prof !130, !llvm.loop !170

.2977.else.endif:                                 ; preds = %.2976.endif, %middle.block4853, %B1194.endif.else.endif.endif.endif.if
  br i1 %.2065, label %.2977.endif.else.endif.if, label %.2977.endif.else.endif.endif.endif.if, !prof !117

.2977.endif.else.endif.if:                        ; preds = %.2977.else.endif
  br label %.2977.endif.else.endif.endif.endif.if

.2977.endif.else.endif.endif.endif.if:            ; preds = %.2977.endif.else.endif.if, %.2977.else.endif
  %.3226.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.2977.endif.else.endif.if ], [ 0, %.2977.else.endif ]
  %.3350.not4748 = icmp slt i64 %.3226.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3350.not4748, label %.3320.endif.preheader, label %.3321.else.endif, !prof !124

.3320.endif.preheader:                            ; preds = %.2977.endif.else.endif.endif.endif.if
  %113 = sub i64 %arg.lane.0.5.1, %.3226.sroa.0.3
  %min.iters.check4829 = icmp ult i64 %113, 4
  br i1 %min.iters.check4829, label %.3320.endif.preheader4966, label %vector.ph4830, !prof !125

vector.ph4830:                                    ; preds = %.3320.endif.preheader
  %n.vec4832 = and i64 %113, -4
  %114 = add i64 %.3226.sroa.0.3, %n.vec4832
  %broadcast.splatinsert4833 = insertelement <2 x double> poison, double %.11.i4679, i64 0
  %broadcast.splat4834 = shufflevector <2 x double> %broadcast.splatinsert4833, <2 x double> poison, <2 x i32> zeroinitializer
  %115 = getelementptr double, ptr %28, i64 %.3226.sroa.0.3
  br label %vector.body4835

vector.body4835:                                  ; preds = %vector.body4835, %vector.ph4830
  %index4836 = phi i64 [ 0, %vector.ph4830 ], [ %index.next4838, %vector.body4835 ]
  %116 = getelementptr double, ptr %115, i64 %index4836
  %117 = getelementptr i8, ptr %116, i64 16
  store <2 x double> %broadcast.splat4834, ptr %116, align 8
  store <2 x double> %broadcast.splat4834, ptr %117, align 8
  %index.next4838 = add i64 %index4836, 4
  %118 = icmp eq i64 %index.next4838, %n.vec4832
  br i1 %118, label %middle.block4839, label %vector.body4835, !prof !126, !llvm.loop !171

middle.block4839:                                 ; preds = %vector.body4835
  %cmp.n4840 = icmp eq i64 %113, %n.vec4832
  br i1 %cmp.n4840, label %.3321.else.endif, label %.3320.endif.preheader4966, !prof !129

.3320.endif.preheader4966:                        ; preds = %.3320.endif.preheader, %middle.block4839
  %.3316.04749.ph = phi i64 [ %.3226.sroa.0.3, %.3320.endif.preheader ], [ %114, %middle.block4839 ]
  br label %.3320.endif

.3320.endif:                                      ; preds = %.3320.endif.preheader4966, %.3320.endif
  %.3316.04749 = phi i64 [ %.3364, %.3320.endif ], [ %.3316.04749.ph, %.3320.endif.preheader4966 ]
  %.3359 = getelementptr double, ptr %28, i64 %.3316.04749
  store double %.11.i4679, ptr %.3359, align 8
  %.3364 = add nsw i64 %.3316.04749, 1
  %exitcond4793.not = icmp eq i64 %.3364, %arg.lane.0.5.1
  br i1 %exitcond4793.not, label %.3321.else.endif, label %.3320.endif, !prof !130, !llvm.loop !172

.3321.else.endif:                                 ; preds = %.3320.endif, %middle.block4839, %.2977.endif.else.endif.endif.endif.if
  br i1 %.2065, label %.3321.endif.else.endif.if, label %.3321.endif.else.endif.endif.endif.if, !prof !117

.3321.endif.else.endif.if:                        ; preds = %.3321.else.endif
  br label %.3321.endif.else.endif.endif.endif.if

.3321.endif.else.endif.endif.endif.if:            ; preds = %.3321.endif.else.endif.if, %.3321.else.endif
  %.3569.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.3321.endif.else.endif.if ], [ 0, %.3321.else.endif ]
  %.3693.not4750 = icmp slt i64 %.3569.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3693.not4750, label %.3663.endif.preheader, label %.3664.else.endif, !prof !124

.3663.endif.preheader:                            ; preds = %.3321.endif.else.endif.endif.endif.if
  %119 = sub i64 %arg.lane.0.5.1, %.3569.sroa.0.3
  %min.iters.check4817 = icmp ult i64 %119, 4
  br i1 %min.iters.check4817, label %.3663.endif.preheader4965, label %vector.ph4818, !prof !125

vector.ph4818:                                    ; preds = %.3663.endif.preheader
  %n.vec4820 = and i64 %119, -4
  %120 = add i64 %.3569.sroa.0.3, %n.vec4820
  %121 = getelementptr double, ptr %29, i64 %.3569.sroa.0.3
  br label %vector.body4821

vector.body4821:                                  ; preds = %vector.body4821, %vector.ph4818
  %index4822 = phi i64 [ 0, %vector.ph4818 ], [ %index.next4824, %vector.body4821 ]
  %122 = getelementptr double, ptr %121, i64 %index4822
  %123 = getelementptr i8, ptr %122, i64 16
  store <2 x double> splat (double 1.000000e+00), ptr %122, align 8
  store <2 x double> splat (double 1.000000e+00), ptr %123, align 8
  %index.next4824 = add i64 %index4822, 4
  %124 = icmp eq i64 %index.next4824, %n.vec4820
  br i1 %124, label %middle.block4825, label %vector.body4821, !prof !126, !llvm.loop !173

middle.block4825:                                 ; preds = %vector.body4821
  %cmp.n4826 = icmp eq i64 %119, %n.vec4820
  br i1 %cmp.n4826, label %.3664.else.endif, label %.3663.endif.preheader4965, !prof !129

.3663.endif.preheader4965:                        ; preds = %.3663.endif.preheader, %middle.block4825
  %.3659.04751.ph = phi i64 [ %.3569.sroa.0.3, %.3663.endif.preheader ], [ %120, %middle.block4825 ]
  br label %.3663.endif

.3663.endif:                                      ; preds = %.3663.endif.preheader4965, %.3663.endif
  %.3659.04751 = phi i64 [ %.3707, %.3663.endif ], [ %.3659.04751.ph, %.3663.endif.preheader4965 ]
  %.3702 = getelementptr double, ptr %29, i64 %.3659.04751
  store double 1.000000e+00, ptr %.3702, align 8
  %.3707 = add nsw i64 %.3659.04751, 1
  %exitcond4794.not = icmp eq i64 %.3707, %arg.lane.0.5.1
  br i1 %exitcond4794.not, label %.3664.else.endif, label %.3663.endif, !prof !130, !llvm.loop !174

.3664.else.endif:                                 ; preds = %.3663.endif, %middle.block4825, %.3321.endif.else.endif.endif.endif.if
  br i1 %.3941, label %.3664.endif.else.endif.if, label %.3664.endif.else.endif.endif.endif.if, !prof !117

.3664.endif.else.endif.if:                        ; preds = %.3664.else.endif
  br label %.3664.endif.else.endif.endif.endif.if

.3664.endif.else.endif.endif.endif.if:            ; preds = %.3664.endif.else.endif.if, %.3664.else.endif
  %.3913.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.3664.endif.else.endif.if ], [ 0, %.3664.else.endif ]
  %.4037.not4752 = icmp slt i64 %.3913.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4037.not4752, label %.4007.endif.preheader, label %.4008.else.endif, !prof !124

.4007.endif.preheader:                            ; preds = %.3664.endif.else.endif.endif.endif.if
  %125 = sub i64 %arg.lane.1.5.1, %.3913.sroa.0.3
  %min.iters.check4806 = icmp ult i64 %125, 4
  br i1 %min.iters.check4806, label %.4007.endif.preheader4964, label %vector.ph4807, !prof !125

vector.ph4807:                                    ; preds = %.4007.endif.preheader
  %n.vec4809 = and i64 %125, -4
  %126 = add i64 %.3913.sroa.0.3, %n.vec4809
  %127 = getelementptr i64, ptr %30, i64 %.3913.sroa.0.3
  br label %vector.body4810

vector.body4810:                                  ; preds = %vector.body4810, %vector.ph4807
  %index4811 = phi i64 [ 0, %vector.ph4807 ], [ %index.next4812, %vector.body4810 ]
  %128 = getelementptr i64, ptr %127, i64 %index4811
  %129 = getelementptr i8, ptr %128, i64 16
  store <2 x i64> %broadcast.splat, ptr %128, align 8
  store <2 x i64> %broadcast.splat, ptr %129, align 8
  %index.next4812 = add i64 %index4811, 4
  %130 = icmp eq i64 %index.next4812, %n.vec4809
  br i1 %130, label %middle.block4813, label %vector.body4810, !prof !126, !llvm.loop !175

middle.block4813:                                 ; preds = %vector.body4810
  %cmp.n4814 = icmp eq i64 %125, %n.vec4809
  br i1 %cmp.n4814, label %.4008.else.endif, label %.4007.endif.preheader4964, !prof !129

.4007.endif.preheader4964:                        ; preds = %.4007.endif.preheader, %middle.block4813
  %.4003.04753.ph = phi i64 [ %.3913.sroa.0.3, %.4007.endif.preheader ], [ %126, %middle.block4813 ]
  br label %.4007.endif

.4007.endif:                                      ; preds = %.4007.endif.preheader4964, %.4007.endif
  %.4003.04753 = phi i64 [ %.4051, %.4007.endif ], [ %.4003.04753.ph, %.4007.endif.preheader4964 ]
  %.4046 = getelementptr i64, ptr %30, i64 %.4003.04753
  store i64 %edge.2.1, ptr %.4046, align 8
  %.4051 = add nsw i64 %.4003.04753, 1
  %exitcond4795.not = icmp eq i64 %.4051, %arg.lane.1.5.1
  br i1 %exitcond4795.not, label %.4008.else.endif, label %.4007.endif, !prof !130, !llvm.loop !176

.4008.else.endif:                                 ; preds = %.4007.endif, %middle.block4813, %.3664.endif.else.endif.endif.endif.if
  br i1 %.3941, label %.4008.endif.else.endif.if, label %.4008.endif.else.endif.endif.endif.if, !prof !117

.4008.endif.else.endif.if:                        ; preds = %.4008.else.endif
  br label %.4008.endif.else.endif.endif.endif.if

.4008.endif.else.endif.endif.endif.if:            ; preds = %.4008.endif.else.endif.if, %.4008.else.endif
  %.4256.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.4008.endif.else.endif.if ], [ 0, %.4008.else.endif ]
  %.4380.not4754 = icmp slt i64 %.4256.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4380.not4754, label %.4350.endif.preheader, label %.4350.if, !prof !124

.4350.endif.preheader:                            ; preds = %.4008.endif.else.endif.endif.endif.if
  %131 = shl i64 %.4256.sroa.0.3, 3
  %scevgep4796 = getelementptr i8, ptr %scevgep, i64 %131
  %132 = sub i64 %arg.lane.1.5.1, %.4256.sroa.0.3
  %133 = shl i64 %132, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %scevgep4796, i8 0, i64 %133, i1 false)
  br label %.4350.if

.4350.if:                                         ; preds = %.4350.endif.preheader, %.4008.endif.else.endif.endif.endif.if
  br i1 %.4101855.not.i, label %B1384, label %B110.if.i

B46.i.i4684:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !177
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i4686, label %B358.i4685

B80.i.i4686:                                      ; preds = %B46.i.i4684
  %.196.i.i = getelementptr double, ptr %31, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !177
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i4685, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i4686
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !177
  %.321.i.i = getelementptr double, ptr %32, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !177
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.1468
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i4685, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %33, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !182
  %.652.i = add nsw i64 %.651.i, 1
  %134 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %134, align 8, !noalias !182
  %.822.i = icmp slt i64 %.596.i, 0
  %.823.i = select i1 %.822.i, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i, %.596.i
  %.825.i = icmp slt i64 %.651.i, -1
  %.826.i = select i1 %.825.i, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i
  %.854.i4687 = mul i64 %.852.i4683, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %135 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i4687
  %136 = getelementptr double, ptr %135, i64 %.856.i
  br label %B300.if.i

B358.i4685:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i4686, %B46.i.i4684
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i4686 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i4684 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i4685
  br i1 %some.3.2.i, label %B368.i, label %B1384

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.2211, align 8, !noalias !182
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !182
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !182
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !182
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !183
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %31, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !183
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !183
  %.321.i223.i = getelementptr double, ptr %32, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !183
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %34, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !182
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %137 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %137, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !182
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %138 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i
  %139 = getelementptr double, ptr %138, i64 %.1956.i
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep4756 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %140 = getelementptr double, ptr %139, i64 %.1701.01860.i
  store double %.1835.i, ptr %140, align 8, !noalias !182
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %141 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %141, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %147, align 8, !noalias !186
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !186
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !186
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B1384, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !182
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !182
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !189
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %31, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !189
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !189
  %.321.i456.i = getelementptr double, ptr %32, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !189
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %142 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %142, align 8, !noalias !182
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !192
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond4797.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond4797.not, label %B1384, label %B1106.if.i

B110.if.i:                                        ; preds = %.4350.if, %B358.i4685
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i4685 ], [ false, %.4350.if ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i4685 ], [ 0, %.4350.if ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %143 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %143, align 8, !noalias !177
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i4685, label %B46.i.i4684

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %144 = getelementptr double, ptr %136, i64 %.692.01853.i
  %.861.i = load double, ptr %144, align 8, !noalias !182
  %145 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %145, align 8, !noalias !182
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %146 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %146, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !182
  %exitcond.not.i4688 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i4688, label %B358.i4685, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %147 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %147, align 8, !noalias !183
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1803.i
  %.1835.i = load double, ptr %gep, align 8, !noalias !182
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep4757 = getelementptr double, ptr %invariant.gep4756, i64 %.1850.i
  store double %.1835.i, ptr %gep4757, align 8, !noalias !182
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %148 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %148, align 8, !noalias !189
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B1606.if:                                         ; preds = %B1576, %B1706
  %.4794.04761 = phi i64 [ %.4863, %B1706 ], [ 0, %B1576 ]
  %.4863 = add nsw i64 %.4794.04761, 1
  %.4893 = add nsw i64 %.4794.04761, %.463.sroa.0.04769
  %.4921 = icmp slt i64 %.4893, 0
  %.4922 = select i1 %.4921, i64 %arg.results.3.5.0, i64 0
  %.4923 = add i64 %.4922, %.4893
  %.4943 = mul i64 %.4923, %arg.results.3.5.1
  %149 = getelementptr i64, ptr %arg.results.3.4, i64 %.4943
  %.4947 = getelementptr i8, ptr %149, i64 16
  store i64 %edge.4.2, ptr %.4947, align 8
  %.4966 = select i1 %.4921, i64 %arg.results.1.5.0, i64 0
  %150 = getelementptr i64, ptr %arg.results.1.4, i64 %.4893
  %.4980 = getelementptr i64, ptr %150, i64 %.4966
  %.4981 = load i64, ptr %.4980, align 8
  %.4982 = icmp eq i64 %.4981, 0
  br i1 %.4982, label %B1680, label %B1706
}

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.ceil.f64(double)

; Function Attrs: nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)

define dso_local noundef i32 @signals_at(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.states.0, ptr readnone %arg.states.1, i64 %arg.states.2, i64 %arg.states.3, ptr %arg.states.4, i64 %arg.states.5.0, i64 %arg.states.6.0, i64 %arg.n, ptr readnone %arg.pieces.0, ptr readnone %arg.pieces.1, i64 %arg.pieces.2, i64 %arg.pieces.3, ptr readonly %arg.pieces.4, i64 %arg.pieces.5.0, i64 %arg.pieces.6.0, ptr readnone %arg.places.0, ptr readnone %arg.places.1, i64 %arg.places.2, i64 %arg.places.3, ptr readonly %arg.places.4, i64 %arg.places.5.0, i64 %arg.places.6.0, ptr readnone %arg.values.0, ptr readnone %arg.values.1, i64 %arg.values.2, i64 %arg.values.3, ptr readonly %arg.values.4, i64 %arg.values.5.0, i64 %arg.values.5.1, i64 %arg.values.6.0, i64 %arg.values.6.1, ptr readnone %arg.t.0, ptr readnone %arg.t.1, i64 %arg.t.2, i64 %arg.t.3, ptr %arg.t.4, i64 %arg.t.5.0, i64 %arg.t.6.0, ptr readnone %arg.P.0, ptr readnone %arg.P.1, i64 %arg.P.2, i64 %arg.P.3, ptr %arg.P.4, i64 %arg.P.5.0, i64 %arg.P.6.0, ptr readnone %arg.T.0, ptr readnone %arg.T.1, i64 %arg.T.2, i64 %arg.T.3, ptr %arg.T.4, i64 %arg.T.5.0, i64 %arg.T.6.0, ptr readnone %arg.W.0, ptr readnone %arg.W.1, i64 %arg.W.2, i64 %arg.W.3, ptr %arg.W.4, i64 %arg.W.5.0, i64 %arg.W.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.230536.not = icmp slt i64 %arg.times.5.0, 1
  br i1 %.230536.not, label %B464, label %B64.if.lr.ph

B64.if.lr.ph:                                     ; preds = %entry
  %arg.out.4542 = ptrtoint ptr %arg.out.4 to i64
  %arg.W.4543 = ptrtoint ptr %arg.W.4 to i64
  %.497530.not = icmp slt i64 %arg.places.5.0, 1
  %.684 = getelementptr i8, ptr %arg.code.4, i64 8
  %.764 = getelementptr i8, ptr %arg.code.4, i64 24
  %.907533.not = icmp slt i64 %arg.out.5.1, 1
  %0 = sub i64 %arg.out.4542, %arg.W.4543
  %1 = shl i64 %arg.out.5.1, 3
  %min.iters.check = icmp ult i64 %arg.out.5.1, 4
  %n.vec = and i64 %arg.out.5.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.out.5.1, %n.vec
  br label %B64.if

B64.loopexit:                                     ; preds = %B430.if, %middle.block, %B304
  %exitcond541.not = icmp eq i64 %.243, %arg.times.5.0
  br i1 %exitcond541.not, label %B464, label %B64.if

B114:                                             ; preds = %B64.if
  br i1 %.497530.not, label %B230, label %B186.if.lr.ph

B186.if.lr.ph:                                    ; preds = %B114
  %.558 = icmp slt i64 %.366, 0
  %.559 = select i1 %.558, i64 %arg.values.5.0, i64 0
  %.560 = add i64 %.559, %.366
  %.580 = mul i64 %.560, %arg.values.5.1
  %2 = getelementptr double, ptr %arg.values.4, i64 %.580
  br label %B186.if

B230:                                             ; preds = %B186.if, %B114
  %.685 = load i64, ptr %.684, align 8
  %.688 = mul nsw i64 %.172.0537, %arg.n
  %.707 = getelementptr double, ptr %arg.states.4, i64 %.688
  %.733 = inttoptr i64 %.685 to ptr
  tail call void %.733(ptr nonnull %arg.t.4, ptr %.707, ptr %arg.P.4, ptr %arg.T.4, ptr %arg.W.4, ptr %arg.W.4)
  br label %B304

B304:                                             ; preds = %B230, %B64.if
  %piece.3.1 = phi i64 [ %.366, %B230 ], [ %piece.2.0539, %B64.if ]
  %.765 = load i64, ptr %.764, align 8
  %.768 = mul nsw i64 %.172.0537, %arg.n
  %.787 = getelementptr double, ptr %arg.states.4, i64 %.768
  %.813 = inttoptr i64 %.765 to ptr
  tail call void %.813(ptr nonnull %arg.t.4, ptr %.787, ptr %arg.P.4, ptr %arg.T.4, ptr %arg.W.4, ptr %arg.W.4)
  br i1 %.907533.not, label %B64.loopexit, label %B430.if.lr.ph

B430.if.lr.ph:                                    ; preds = %B304
  %.1020 = mul i64 %.172.0537, %arg.out.5.1
  %3 = getelementptr double, ptr %arg.out.4, i64 %.1020
  %diff.check = icmp ult i64 %10, 32
  %or.cond = select i1 %min.iters.check, i1 true, i1 %diff.check
  br i1 %or.cond, label %B430.if.preheader, label %vector.body

vector.body:                                      ; preds = %B430.if.lr.ph, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %B430.if.lr.ph ]
  %4 = getelementptr double, ptr %arg.W.4, i64 %index
  %5 = getelementptr i8, ptr %4, i64 16
  %wide.load = load <2 x double>, ptr %4, align 8
  %wide.load544 = load <2 x double>, ptr %5, align 8
  %6 = getelementptr double, ptr %3, i64 %index
  %7 = getelementptr i8, ptr %6, i64 16
  store <2 x double> %wide.load, ptr %6, align 8
  store <2 x double> %wide.load544, ptr %7, align 8
  %index.next = add i64 %index, 4
  %8 = icmp eq i64 %index.next, %n.vec
  br i1 %8, label %middle.block, label %vector.body, !llvm.loop !195

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B64.loopexit, label %B430.if.preheader

B430.if.preheader:                                ; preds = %B430.if.lr.ph, %middle.block
  %.851.0534.ph = phi i64 [ 0, %B430.if.lr.ph ], [ %n.vec, %middle.block ]
  br label %B430.if

B464:                                             ; preds = %B64.loopexit, %entry
  store ptr null, ptr %retptr, align 8
  ret i32 0

B64.if:                                           ; preds = %B64.if.lr.ph, %B64.loopexit
  %piece.2.0539 = phi i64 [ -1, %B64.if.lr.ph ], [ %piece.3.1, %B64.loopexit ]
  %.172.0537 = phi i64 [ 0, %B64.if.lr.ph ], [ %.243, %B64.loopexit ]
  %9 = mul i64 %1, %.172.0537
  %10 = add i64 %0, %9
  %.243 = add nsw i64 %.172.0537, 1
  %11 = getelementptr double, ptr %arg.times.4, i64 %.172.0537
  %.305 = load double, ptr %11, align 8
  store double %.305, ptr %arg.t.4, align 8
  %12 = getelementptr i64, ptr %arg.pieces.4, i64 %.172.0537
  %.366 = load i64, ptr %12, align 8
  %.368.not = icmp eq i64 %.366, %piece.2.0539
  br i1 %.368.not, label %B304, label %B114

B186.if:                                          ; preds = %B186.if.lr.ph, %B186.if
  %.441.0531 = phi i64 [ 0, %B186.if.lr.ph ], [ %.510, %B186.if ]
  %.510 = add nsw i64 %.441.0531, 1
  %13 = getelementptr double, ptr %2, i64 %.441.0531
  %.585 = load double, ptr %13, align 8
  %14 = getelementptr i64, ptr %arg.places.4, i64 %.441.0531
  %.615 = load i64, ptr %14, align 8
  %.629 = icmp slt i64 %.615, 0
  %.630 = select i1 %.629, i64 %arg.P.5.0, i64 0
  %15 = getelementptr double, ptr %arg.P.4, i64 %.615
  %.644 = getelementptr double, ptr %15, i64 %.630
  store double %.585, ptr %.644, align 8
  %exitcond.not = icmp eq i64 %arg.places.5.0, %.510
  br i1 %exitcond.not, label %B230, label %B186.if

B430.if:                                          ; preds = %B430.if.preheader, %B430.if
  %.851.0534 = phi i64 [ %.920, %B430.if ], [ %.851.0534.ph, %B430.if.preheader ]
  %.920 = add nsw i64 %.851.0534, 1
  %16 = getelementptr double, ptr %arg.W.4, i64 %.851.0534
  %.974 = load double, ptr %16, align 8
  %17 = getelementptr double, ptr %3, i64 %.851.0534
  store double %.974, ptr %17, align 8
  %exitcond540.not = icmp eq i64 %arg.out.5.1, %.920
  br i1 %exitcond540.not, label %B64.loopexit, label %B430.if, !llvm.loop !196
}


!0 = !{!1, !3, !5}
!1 = distinct !{!1, !2, !"_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = distinct !{!3, !4, !"_ZN19clpt_control_solver5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!4 = distinct !{!4, !"_ZN19clpt_control_solver5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!5 = distinct !{!5, !4, !"_ZN19clpt_control_solver5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!6 = distinct !{!6, !7, !8}
!7 = !{!"llvm.loop.isvectorized", i32 1}
!8 = !{!"llvm.loop.unroll.runtime.disable"}
!9 = !{!10, !12, !1, !3, !5}
!10 = distinct !{!10, !11, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = distinct !{!12, !11, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!13 = distinct !{!13, !7}
!14 = !{!3, !5}
!15 = !{!16, !18}
!16 = distinct !{!16, !17, !"_ZN19clpt_control_solver6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!17 = distinct !{!17, !"_ZN19clpt_control_solver6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!18 = distinct !{!18, !17, !"_ZN19clpt_control_solver6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!19 = !{!20, !22}
!20 = distinct !{!20, !21, !"_ZN19clpt_control_solver5beginB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!21 = distinct !{!21, !"_ZN19clpt_control_solver5beginB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!22 = distinct !{!22, !21, !"_ZN19clpt_control_solver5beginB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!23 = !{!24, !20, !22}
!24 = distinct !{!24, !25, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!25 = distinct !{!25, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!26 = !{!27, !20, !22}
!27 = distinct !{!27, !28, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!28 = distinct !{!28, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!29 = !{!30}
!30 = distinct !{!30, !31, !"_ZN19clpt_control_solver4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29: %retptr"}
!31 = distinct !{!31, !"_ZN19clpt_control_solver4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29"}
!32 = !{!33, !35}
!33 = distinct !{!33, !34, !"_ZN19clpt_control_solver6passesB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN19clpt_control_solver6passesB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!35 = distinct !{!35, !34, !"_ZN19clpt_control_solver6passesB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!36 = !{!37, !39, !33, !35}
!37 = distinct !{!37, !38, !"_ZN19clpt_control_solver6passedB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN19clpt_control_solver6passedB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!39 = distinct !{!39, !38, !"_ZN19clpt_control_solver6passedB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!40 = !{!41}
!41 = distinct !{!41, !42, !"_ZN19clpt_control_solver5crossB3v12B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!42 = distinct !{!42, !"_ZN19clpt_control_solver5crossB3v12B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!43 = !{!44, !46, !41}
!44 = distinct !{!44, !45, !"_ZN19clpt_control_solver6passedB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!45 = distinct !{!45, !"_ZN19clpt_control_solver6passedB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!46 = distinct !{!46, !45, !"_ZN19clpt_control_solver6passedB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!47 = !{!48, !50, !41}
!48 = distinct !{!48, !49, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!49 = distinct !{!49, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!50 = distinct !{!50, !49, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!51 = distinct !{!51, !7, !8}
!52 = distinct !{!52, !7}
!53 = !{!54}
!54 = distinct !{!54, !55, !"_ZN19clpt_control_solver5watchB3v15B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!55 = distinct !{!55, !"_ZN19clpt_control_solver5watchB3v15B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!56 = !{!57, !54}
!57 = distinct !{!57, !58, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!58 = distinct !{!58, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!59 = !{!60, !62, !54}
!60 = distinct !{!60, !61, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!61 = distinct !{!61, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!62 = distinct !{!62, !61, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!63 = distinct !{!63, !7, !8}
!64 = distinct !{!64, !7}
!65 = !{!66}
!66 = distinct !{!66, !67, !"_ZN19clpt_control_solver6sampleB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEb: %retptr"}
!67 = distinct !{!67, !"_ZN19clpt_control_solver6sampleB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEb"}
!68 = !{!69, !71, !66}
!69 = distinct !{!69, !70, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!70 = distinct !{!70, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!71 = distinct !{!71, !70, !"_ZN19clpt_control_solver7betweenB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!72 = !{!73, !75}
!73 = distinct !{!73, !74, !"_ZN19clpt_control_solver11decide_anewB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!74 = distinct !{!74, !"_ZN19clpt_control_solver11decide_anewB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!75 = distinct !{!75, !74, !"_ZN19clpt_control_solver11decide_anewB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!76 = !{!77, !73, !75}
!77 = distinct !{!77, !78, !"_ZN19clpt_control_solver4failB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!78 = distinct !{!78, !"_ZN19clpt_control_solver4failB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!79 = !{!80, !82}
!80 = distinct !{!80, !81, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!81 = distinct !{!81, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!82 = distinct !{!82, !83, !"_ZN19clpt_control_solver4leapB3v19B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!83 = distinct !{!83, !"_ZN19clpt_control_solver4leapB3v19B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!84 = !{!82}
!85 = !{!86, !82}
!86 = distinct !{!86, !87, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!87 = distinct !{!87, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!88 = !{!89, !82}
!89 = distinct !{!89, !90, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!90 = distinct !{!90, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!91 = !{!92, !82}
!92 = distinct !{!92, !93, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!93 = distinct !{!93, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!94 = !{!95, !82}
!95 = distinct !{!95, !96, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!96 = distinct !{!96, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!97 = !{!98, !100}
!98 = distinct !{!98, !99, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!99 = distinct !{!99, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!100 = distinct !{!100, !99, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!101 = !{!102}
!102 = distinct !{!102, !103, !"_ZN19clpt_control_solver4failB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!103 = distinct !{!103, !"_ZN19clpt_control_solver4failB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!104 = !{!105, !107}
!105 = distinct !{!105, !106, !"_ZN19clpt_control_solver5enterB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!106 = distinct !{!106, !"_ZN19clpt_control_solver5enterB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!107 = distinct !{!107, !106, !"_ZN19clpt_control_solver5enterB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!108 = !{!109}
!109 = distinct !{!109, !110, !"_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!110 = distinct !{!110, !"_ZN19clpt_control_solver4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!111 = distinct !{!111, !7, !8}
!112 = !{!113, !115, !109}
!113 = distinct !{!113, !114, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!114 = distinct !{!114, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!115 = distinct !{!115, !114, !"_ZN19clpt_control_solver4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!116 = distinct !{!116, !7}
!117 = !{!"branch_weights", i32 1, i32 99}
!118 = !{!119}
!119 = distinct !{!119, !120, !"_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!120 = distinct !{!120, !"_ZN19clpt_control_solver4keepB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!121 = distinct !{!121, !7, !8}
!122 = distinct !{!122, !7}
!123 = !{i1 true}
!124 = !{!"branch_weights", i32 127, i32 1}
!125 = !{!"branch_weights", i32 1, i32 127}
!126 = !{!"branch_weights", i32 127, i32 3048}
!127 = distinct !{!127, !7, !8, !128}
!128 = !{!"llvm.loop.estimated_trip_count", i32 25}
!129 = !{!"branch_weights", i32 1, i32 3}
!130 = !{!"branch_weights", i32 1, i32 0}
!131 = distinct !{!131, !8, !7, !132}
!132 = !{!"llvm.loop.estimated_trip_count", i32 0}
!133 = !{!134, !136}
!134 = distinct !{!134, !135, !"_ZN19clpt_control_solver5marchB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx: %retptr"}
!135 = distinct !{!135, !"_ZN19clpt_control_solver5marchB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx"}
!136 = distinct !{!136, !135, !"_ZN19clpt_control_solver5marchB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx: %excinfo"}
!137 = !{!138, !140, !134, !136}
!138 = distinct !{!138, !139, !"_ZN19clpt_control_solver6decideB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!139 = distinct !{!139, !"_ZN19clpt_control_solver6decideB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!140 = distinct !{!140, !139, !"_ZN19clpt_control_solver6decideB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!141 = !{!142, !134, !136}
!142 = distinct !{!142, !143, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!143 = distinct !{!143, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!144 = !{!145, !134, !136}
!145 = distinct !{!145, !146, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!146 = distinct !{!146, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!147 = !{!148}
!148 = distinct !{!148, !149}
!149 = distinct !{!149, !"LVerDomain"}
!150 = !{!151}
!151 = distinct !{!151, !149}
!152 = !{!134, !136, !148}
!153 = distinct !{!153, !7, !8}
!154 = distinct !{!154, !7, !8, !128}
!155 = distinct !{!155, !8, !7, !132}
!156 = distinct !{!156, !7, !8, !128}
!157 = distinct !{!157, !8, !7, !132}
!158 = distinct !{!158, !7, !8, !128}
!159 = distinct !{!159, !7, !8}
!160 = distinct !{!160, !8, !7, !132}
!161 = distinct !{!161, !7}
!162 = distinct !{!162, !7, !8, !128}
!163 = !{!164, !166, !134, !136}
!164 = distinct !{!164, !165, !"_ZN19clpt_control_solver6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!165 = distinct !{!165, !"_ZN19clpt_control_solver6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!166 = distinct !{!166, !165, !"_ZN19clpt_control_solver6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!167 = distinct !{!167, !8, !7, !132}
!168 = distinct !{!168, !7}
!169 = distinct !{!169, !7, !8, !128}
!170 = distinct !{!170, !8, !7, !132}
!171 = distinct !{!171, !7, !8, !128}
!172 = distinct !{!172, !8, !7, !132}
!173 = distinct !{!173, !7, !8, !128}
!174 = distinct !{!174, !8, !7, !132}
!175 = distinct !{!175, !7, !8, !128}
!176 = distinct !{!176, !8, !7, !132}
!177 = !{!178, !180}
!178 = distinct !{!178, !179, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!179 = distinct !{!179, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!180 = distinct !{!180, !181, !"_ZN19clpt_control_solver4leapB3v19B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!181 = distinct !{!181, !"_ZN19clpt_control_solver4leapB3v19B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!182 = !{!180}
!183 = !{!184, !180}
!184 = distinct !{!184, !185, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!185 = distinct !{!185, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!186 = !{!187, !180}
!187 = distinct !{!187, !188, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!188 = distinct !{!188, !"_ZN19clpt_control_solver4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!189 = !{!190, !180}
!190 = distinct !{!190, !191, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!191 = distinct !{!191, !"_ZN19clpt_control_solver6at_endB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!192 = !{!193, !180}
!193 = distinct !{!193, !194, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!194 = distinct !{!194, !"_ZN19clpt_control_solver4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!195 = distinct !{!195, !7, !8}
!196 = distinct !{!196, !7}
