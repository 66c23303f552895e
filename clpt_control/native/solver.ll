; sha256 ec9a6e89eadf52c07865d9218bbe4f8f8560d2110713ce72d486820b768ab50b

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readonly %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readonly %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, i64 %arg.budget, i64 %arg.most, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %.388 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.496.idx = shl i64 %arg.lane.0.5.1, 6
  %.496 = getelementptr i8, ptr %arg.lane.0.4, i64 %.496.idx
  %.535 = icmp eq i64 %arg.shape.3, 9
  %.537.not = icmp ne i64 %arg.shape.3, 4
  %.539 = icmp ne i64 %arg.shape.3, 12
  %.276.i = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.276.i, i64 0, i64 %arg.shape.0
  br i1 %.276.i, label %B0.endif, label %B50.if.i.lr.ph

B50.if.i.lr.ph:                                   ; preds = %entry
  %.364.i = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %.435.i = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %0 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx.i = shl i64 %arg.lane.1.5.1, 4
  %1 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i
  %.6871761.not.i = icmp slt i64 %arg.shape.1, 1
  %.842.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9571764.not.i = icmp slt i64 %arg.shape.2, 1
  %.190.i1767.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.295.i.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1188.i.not = icmp eq i64 %arg.shape.0, 1
  %.166.i801770.not.i = icmp slt i64 %arg.shape.1, 1
  %2 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1742.i = shl i64 %arg.lane.0.5.1, 4
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1742.i
  %.idx1743.i = mul i64 %arg.lane.0.5.1, 24
  %4 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1743.i
  %.idx1744.i = shl i64 %arg.lane.0.5.1, 5
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1744.i
  %.idx1745.i = mul i64 %arg.lane.0.5.1, 168
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1745.i
  %.idx1746.i = mul i64 %arg.lane.0.5.1, 248
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1746.i
  %.13511773.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx1749.i = shl i64 %arg.lane.0.5.1, 4
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1749.i
  %9 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1750.i = mul i64 %arg.lane.0.5.1, 24
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1750.i
  %.idx1751.i = shl i64 %arg.lane.0.5.1, 5
  %11 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1751.i
  %.idx1752.i = mul i64 %arg.lane.0.5.1, 120
  %12 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1752.i
  %.idx1753.i = mul i64 %arg.lane.1.5.1, 24
  %13 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1753.i
  %.idx1754.i = mul i64 %arg.lane.0.5.1, 248
  %14 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1754.i
  %.idx1755.i = mul i64 %arg.lane.0.5.1, 224
  %15 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1755.i
  %.idx1756.i = mul i64 %arg.lane.0.5.1, 232
  %16 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1756.i
  %.idx1757.i = mul i64 %arg.lane.0.5.1, 192
  %17 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1757.i
  %.idx1758.i = mul i64 %arg.lane.0.5.1, 200
  %18 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1758.i
  %.idx1759.i = mul i64 %arg.lane.0.5.1, 152
  %19 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1759.i
  %.idx1760.i = mul i64 %arg.lane.0.5.1, 144
  %20 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1760.i
  br label %B50.if.i

B104.i:                                           ; preds = %B50.if.i
  %.422.i = add nsw i64 %active.3.i.010025, 1
  br label %B171.i

B116.i:                                           ; preds = %B50.if.i
  %.305.i = load i64, ptr %arg.lane.2.4, align 8, !noalias !0
  %.365.i = load i64, ptr %.364.i, align 8, !noalias !0
  %.366.i = icmp slt i64 %.305.i, %.365.i
  br i1 %.366.i, label %B116.i9703, label %B302.i

B116.i9703:                                       ; preds = %B116.i
  %.376.i = add nsw i64 %.305.i, 1
  store i64 %.376.i, ptr %arg.lane.2.4, align 8, !noalias !0
  store i64 1, ptr %.435.i, align 8, !noalias !0
  %.493.i = getelementptr i64, ptr %arg.lane.1.4, i64 %.262.i.010023
  store i64 %.305.i, ptr %.493.i, align 8, !noalias !0
  %.548.i = getelementptr i64, ptr %0, i64 %.262.i.010023
  store i64 0, ptr %.548.i, align 8, !noalias !0
  %.603.i = getelementptr i64, ptr %1, i64 %.262.i.010023
  store i64 1, ptr %.603.i, align 8, !noalias !0
  br i1 %.6871761.not.i, label %B302.i, label %B258.if.lr.ph.i

B258.if.lr.ph.i:                                  ; preds = %B116.i9703
  %.748.i = icmp slt i64 %.305.i, 0
  %.749.i = select i1 %.748.i, i64 %arg.runs.0.5.0, i64 0
  %.750.i = add i64 %.749.i, %.305.i
  %.770.i = mul i64 %.750.i, %arg.runs.0.5.1
  %21 = getelementptr double, ptr %arg.runs.0.4, i64 %.770.i
  %.813.i = select i1 %.748.i, i64 %arg.results.0.5.0, i64 0
  %.814.i = add i64 %.813.i, %.305.i
  %.844.i = mul i64 %.842.i, %.814.i
  %22 = getelementptr double, ptr %arg.results.0.4, i64 %.844.i
  br label %B258.if.i

B302.i:                                           ; preds = %B258.if.i, %B116.i9703, %B116.i
  %m.2.0.i = phi i64 [ 0, %B116.i ], [ %.305.i, %B116.i9703 ], [ %.305.i, %B258.if.i ]
  br i1 %.9571764.not.i, label %B376.i, label %B332.if.lr.ph.i

B332.if.lr.ph.i:                                  ; preds = %B302.i
  %.1018.i = icmp slt i64 %m.2.0.i, 0
  %.1019.i = select i1 %.1018.i, i64 %arg.runs.1.5.0, i64 0
  %.1020.i = add i64 %.1019.i, %m.2.0.i
  %.1040.i = mul i64 %.1020.i, %arg.runs.1.5.1
  %23 = getelementptr double, ptr %arg.runs.1.4, i64 %.1040.i
  %invariant.gep10197 = getelementptr double, ptr %arg.arrays.1.4, i64 %.262.i.010023
  br label %B332.if.i

B376.i:                                           ; preds = %B332.if.i, %B302.i
  %.1102.i = icmp slt i64 %m.2.0.i, 0
  %.1103.i = select i1 %.1102.i, i64 %arg.runs.2.5.0, i64 0
  %24 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1117.i = getelementptr i64, ptr %24, i64 %.1103.i
  br i1 %.190.i1767.not.i, label %B376.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B376.i
  %.1118.i = load i64, ptr %.1117.i, align 8, !noalias !0
  %.265.i.i = icmp slt i64 %.1118.i, 0
  %.266.i.i9701 = select i1 %.265.i.i, i64 %arg.schedule.3.5.0, i64 0
  %.267.i.i = add i64 %.266.i.i9701, %.1118.i
  %.297.i.i = mul i64 %.295.i.i, %.267.i.i
  %25 = getelementptr double, ptr %arg.schedule.3.4, i64 %.297.i.i
  br label %B76.if.i.i9702

B76.if.i.i9702:                                   ; preds = %B76.if.i.i9702, %B76.if.i.lr.ph.i
  %.132.i.01768.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.203.i.i, %B76.if.i.i9702 ]
  %.203.i.i = add nsw i64 %.132.i.01768.i, 1
  %26 = getelementptr double, ptr %25, i64 %.132.i.01768.i
  %.304.i.i = load double, ptr %26, align 8, !noalias !6
  %27 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.132.i.01768.i
  %.334.i.i = load i64, ptr %27, align 8, !noalias !6
  %.336.i.i = mul nsw i64 %.334.i.i, %arg.shape.0
  %.338.i.i = add nsw i64 %.336.i.i, %.262.i.010023
  %.352.i.i = icmp slt i64 %.338.i.i, 0
  %.353.i.i = select i1 %.352.i.i, i64 %arg.arrays.1.5.0, i64 0
  %28 = getelementptr double, ptr %arg.arrays.1.4, i64 %.338.i.i
  %.367.i.i = getelementptr double, ptr %28, i64 %.353.i.i
  store double %.304.i.i, ptr %.367.i.i, align 8, !noalias !6
  %exitcond1777.not.i = icmp eq i64 %.203.i.i, %arg.schedule.2.5.0
  br i1 %exitcond1777.not.i, label %B376.endif.i, label %B76.if.i.i9702

B432.i:                                           ; preds = %B376.endif.i
  br i1 %.1188.i.not, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B444.i

B444.i:                                           ; preds = %B432.i
  br i1 %.166.i801770.not.i, label %B104.i.i, label %B48.if.i.i.preheader

B48.if.i.i.preheader:                             ; preds = %B444.i
  %invariant.gep10199 = getelementptr double, ptr %arg.arrays.0.4, i64 %.262.i.010023
  br label %B48.if.i.i

B104.i.i:                                         ; preds = %B48.if.i.i, %B444.i
  %.363.i123.i = getelementptr double, ptr %arg.lane.0.4, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.363.i123.i, align 8, !noalias !10
  %.418.i.i = getelementptr double, ptr %2, i64 %.262.i.010023
  store double 5.000000e-01, ptr %.418.i.i, align 8, !noalias !10
  %.473.i.i = getelementptr double, ptr %3, i64 %.262.i.010023
  store double 1.000000e+00, ptr %.473.i.i, align 8, !noalias !10
  %.534.i.i = getelementptr double, ptr %4, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.534.i.i, align 8, !noalias !10
  %.589.i.i = getelementptr double, ptr %5, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.589.i.i, align 8, !noalias !10
  %.644.i.i = getelementptr double, ptr %6, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.644.i.i, align 8, !noalias !10
  %.701.i.i = getelementptr double, ptr %7, i64 %.262.i.010023
  store double 0x7FF0000000000000, ptr %.701.i.i, align 8, !noalias !10
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B48.if.i.i:                                       ; preds = %B48.if.i.i.preheader, %B48.if.i.i
  %.108.i.01771.i = phi i64 [ %.179.i184.i, %B48.if.i.i ], [ 0, %B48.if.i.i.preheader ]
  %.179.i184.i = add nsw i64 %.108.i.01771.i, 1
  %29 = getelementptr double, ptr %arg.runs.0.4, i64 %.108.i.01771.i
  %.258.i.i = load double, ptr %29, align 8, !noalias !10
  %.260.i161.i = mul nsw i64 %.108.i.01771.i, %arg.shape.0
  %gep10200 = getelementptr double, ptr %invariant.gep10199, i64 %.260.i161.i
  store double %.258.i.i, ptr %gep10200, align 8, !noalias !10
  %exitcond1778.not.i = icmp eq i64 %arg.shape.1, %.179.i184.i
  br i1 %exitcond1778.not.i, label %B104.i.i, label %B48.if.i.i

B486.i:                                           ; preds = %B376.endif.i
  br i1 %.13511773.not.i, label %B560.i, label %B516.if.lr.ph.i

B516.if.lr.ph.i:                                  ; preds = %B486.i
  %.1413.i = select i1 %.1102.i, i64 %arg.runs.0.5.0, i64 0
  %.1414.i = add i64 %.1413.i, %m.2.0.i
  %.1434.i = mul i64 %.1414.i, %arg.runs.0.5.1
  %30 = getelementptr double, ptr %arg.runs.0.4, i64 %.1434.i
  %invariant.gep10201 = getelementptr double, ptr %arg.arrays.0.4, i64 %.262.i.010023
  br label %B516.if.i

B560.i:                                           ; preds = %B516.if.i, %B486.i
  %.1514.i = load double, ptr %arg.times.4, align 8, !noalias !0
  %.1551.i = load i64, ptr %.1117.i, align 8, !noalias !0
  %.1581.i = icmp slt i64 %.1551.i, 0
  %.1582.i = select i1 %.1581.i, i64 %arg.schedule.0.5.0, i64 0
  %.1583.i = add i64 %.1582.i, %.1551.i
  %.1603.i = mul i64 %.1583.i, %arg.schedule.0.5.1
  %.1607.i = getelementptr double, ptr %arg.schedule.0.4, i64 %.1603.i
  %.1608.i = load double, ptr %.1607.i, align 8, !noalias !0
  %.1662.i = getelementptr double, ptr %arg.lane.0.4, i64 %.262.i.010023
  store double %.1514.i, ptr %.1662.i, align 8, !noalias !0
  %.1717.i = getelementptr double, ptr %8, i64 %.262.i.010023
  store double %.1608.i, ptr %.1717.i, align 8, !noalias !0
  %.1772.i = getelementptr double, ptr %9, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.1772.i, align 8, !noalias !0
  %.1831.i = getelementptr double, ptr %10, i64 %.262.i.010023
  store double 1.000000e+00, ptr %.1831.i, align 8, !noalias !0
  %.1886.i = getelementptr double, ptr %11, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.1886.i, align 8, !noalias !0
  %.1942.i = getelementptr double, ptr %12, i64 %.262.i.010023
  store double 0xFFF0000000000000, ptr %.1942.i, align 8, !noalias !0
  %31 = getelementptr i64, ptr %13, i64 %.262.i.010023
  store i64 0, ptr %31, align 8, !noalias !0
  %.2054.i = getelementptr double, ptr %14, i64 %.262.i.010023
  store double 0x7FF0000000000000, ptr %.2054.i, align 8, !noalias !0
  %.2113.i = getelementptr double, ptr %15, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.2113.i, align 8, !noalias !0
  %.2168.i = getelementptr double, ptr %16, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.2168.i, align 8, !noalias !0
  %.2229.i = getelementptr double, ptr %17, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.2229.i, align 8, !noalias !0
  %.2284.i = getelementptr double, ptr %18, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.2284.i, align 8, !noalias !0
  %.2339.i = getelementptr double, ptr %19, i64 %.262.i.010023
  store double 0.000000e+00, ptr %.2339.i, align 8, !noalias !0
  %.2394.i = getelementptr double, ptr %20, i64 %.262.i.010023
  %.2395.i = load double, ptr %.2394.i, align 8, !noalias !0
  %.2397.i = fcmp ueq double %.2395.i, 0xFFF0000000000000
  br i1 %.2397.i, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1034.i

B1034.i:                                          ; preds = %B560.i
  store double 0.000000e+00, ptr %.2394.i, align 8, !noalias !0
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B258.if.i:                                        ; preds = %B258.if.i, %B258.if.lr.ph.i
  %.629.01762.i = phi i64 [ 0, %B258.if.lr.ph.i ], [ %.700.i, %B258.if.i ]
  %.700.i = add nsw i64 %.629.01762.i, 1
  %32 = getelementptr double, ptr %21, i64 %.629.01762.i
  %.775.i = load double, ptr %32, align 8, !noalias !0
  %33 = getelementptr double, ptr %22, i64 %.629.01762.i
  store double %.775.i, ptr %33, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.700.i, %arg.shape.1
  br i1 %exitcond.not.i, label %B302.i, label %B258.if.i

B332.if.i:                                        ; preds = %B332.if.i, %B332.if.lr.ph.i
  %.901.01765.i = phi i64 [ 0, %B332.if.lr.ph.i ], [ %.970.i, %B332.if.i ]
  %.970.i = add nsw i64 %.901.01765.i, 1
  %34 = getelementptr double, ptr %23, i64 %.901.01765.i
  %.1045.i = load double, ptr %34, align 8, !noalias !0
  %.1047.i = mul nsw i64 %.901.01765.i, %arg.shape.0
  %gep10198 = getelementptr double, ptr %invariant.gep10197, i64 %.1047.i
  store double %.1045.i, ptr %gep10198, align 8, !noalias !0
  %exitcond1776.not.i = icmp eq i64 %.970.i, %arg.shape.2
  br i1 %exitcond1776.not.i, label %B376.i, label %B332.if.i

B376.endif.i:                                     ; preds = %B76.if.i.i9702, %B376.i
  br i1 %.366.i, label %B486.i, label %B432.i

B516.if.i:                                        ; preds = %B516.if.i, %B516.if.lr.ph.i
  %.1295.01774.i = phi i64 [ 0, %B516.if.lr.ph.i ], [ %.1364.i, %B516.if.i ]
  %.1364.i = add nsw i64 %.1295.01774.i, 1
  %35 = getelementptr double, ptr %30, i64 %.1295.01774.i
  %.1439.i = load double, ptr %35, align 8, !noalias !0
  %.1441.i = mul nsw i64 %.1295.01774.i, %arg.shape.0
  %gep10202 = getelementptr double, ptr %invariant.gep10201, i64 %.1441.i
  store double %.1439.i, ptr %gep10202, align 8, !noalias !0
  %exitcond1779.not.i = icmp eq i64 %.1364.i, %arg.shape.1
  br i1 %exitcond1779.not.i, label %B560.i, label %B516.if.i

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B432.i, %B104.i.i, %B560.i, %B1034.i
  %storemerge1747.i = phi i64 [ 0, %B432.i ], [ 0, %B104.i.i ], [ 1, %B1034.i ], [ 1, %B560.i ]
  %.528.i = add nsw i64 %storemerge1747.i, %active.3.i.010025
  br label %B171.i

B171.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B104.i
  %active.4.i.1 = phi i64 [ %.422.i, %B104.i ], [ %.528.i, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.320.i = icmp sgt i64 %.265.i.010024, 1
  br i1 %.320.i, label %B50.if.i, label %B0.endif

B50.if.i:                                         ; preds = %B50.if.i.lr.ph, %B171.i
  %active.3.i.010025 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %active.4.i.1, %B171.i ]
  %.265.i.010024 = phi i64 [ %storemerge, %B50.if.i.lr.ph ], [ %.329.i, %B171.i ]
  %.262.i.010023 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %.333.i, %B171.i ]
  %.329.i = add nsw i64 %.265.i.010024, -1
  %.333.i = add nsw i64 %.262.i.010023, 1
  %36 = getelementptr i64, ptr %arg.lane.1.4, i64 %.262.i.010023
  %.416.i = load i64, ptr %36, align 8, !noalias !14
  %.417.i = icmp sgt i64 %.416.i, -1
  br i1 %.417.i, label %B104.i, label %B116.i

B266:                                             ; preds = %B266.preheader, %B4376
  %budget.3.0 = phi i64 [ %budget.4.2, %B4376 ], [ %arg.budget, %B266.preheader ]
  %looked.3.0 = phi i1 [ %looked.4.2.lcssa, %B4376 ], [ true, %B266.preheader ]
  %active.6.0 = phi i64 [ %active.7.2, %B4376 ], [ %active.3.i.0.lcssa, %B266.preheader ]
  %.689 = add nsw i64 %budget.3.0, -1
  %.724 = load i64, ptr %.723, align 8
  %.725 = icmp eq i64 %.724, 1
  %.759 = icmp sgt i64 %.724, 0
  br i1 %.759, label %B334, label %B412

B334:                                             ; preds = %B266
  store i64 0, ptr %.723, align 8
  %.820 = load i64, ptr %.819, align 8
  %.865 = inttoptr i64 %.820 to ptr
  tail call void %.865(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B412

B412:                                             ; preds = %B334, %B266
  br i1 %.725, label %B418, label %B992

B418:                                             ; preds = %B412
  br i1 %.871, label %B430, label %B474

B430:                                             ; preds = %B418
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !15
  %.195.i100 = inttoptr i64 %.150.i to ptr
  tail call void %.195.i100(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br i1 %.276.i, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i124 = icmp sgt i64 %.224.i.010031, 1
  br i1 %.279.i124, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B430
  %.614.i = load i64, ptr %.613.i, align 8, !noalias !15
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br label %B474

B118.if.i:                                        ; preds = %B430, %B248.i
  %.224.i.010031 = phi i64 [ %.288.i, %B248.i ], [ %storemerge, %B430 ]
  %.221.i.010030 = phi i64 [ %.292.i, %B248.i ], [ 0, %B430 ]
  %.288.i = add nsw i64 %.224.i.010031, -1
  %.292.i = add nsw i64 %.221.i.010030, 1
  %37 = getelementptr double, ptr %189, i64 %.221.i.010030
  %.374.i150 = load double, ptr %37, align 8, !noalias !15
  %.375.i = fcmp ule double %.374.i150, 5.000000e-01
  %brmerge10169 = select i1 %.375.i, i1 true, i1 %.457.i17910026
  br i1 %brmerge10169, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep10203 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.010030
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i77.010027 = phi i64 [ %.470.i235, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i235 = add nsw i64 %.401.i77.010027, 1
  %.496.i190 = mul nsw i64 %.401.i77.010027, %arg.shape.0
  %gep10204 = getelementptr double, ptr %invariant.gep10203, i64 %.496.i190
  %.528.i212 = load double, ptr %gep10204, align 8, !noalias !15
  %.530.i = add nsw i64 %.401.i77.010027, %arg.held
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i215 = add nsw i64 %.532.i, %.221.i.010030
  %.548.i220 = icmp slt i64 %.534.i215, 0
  %.549.i = select i1 %.548.i220, i64 %arg.arrays.1.5.0, i64 0
  %38 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i215
  %.563.i = getelementptr double, ptr %38, i64 %.549.i
  store double %.528.i212, ptr %.563.i, align 8, !noalias !15
  %exitcond.not = icmp eq i64 %.470.i235, %arg.decided
  br i1 %exitcond.not, label %B248.i, label %B190.if.i

B474:                                             ; preds = %B250.i, %B418
  br i1 %.930.not, label %B546, label %B478

B478:                                             ; preds = %B474
  %.961 = load i64, ptr %.960, align 8
  %.1006 = inttoptr i64 %.961 to ptr
  tail call void %.1006(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B546

B546:                                             ; preds = %B478, %B474
  br i1 %.537.not, label %B550, label %B950

B550:                                             ; preds = %B546
  %.1040 = load i64, ptr %arg.code.4, align 8
  %.1088 = inttoptr i64 %.1040 to ptr
  tail call void %.1088(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1087)
  %.1119 = load i64, ptr %.1118, align 8
  %.1164 = inttoptr i64 %.1119 to ptr
  tail call void %.1164(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1195 = load i64, ptr %.1194, align 8
  %.1240 = inttoptr i64 %.1195 to ptr
  tail call void %.1240(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1271 = load i64, ptr %arg.code.4, align 8
  %.1321 = inttoptr i64 %.1271 to ptr
  tail call void %.1321(ptr %.496, ptr %.1295, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1320)
  %.1352 = load i64, ptr %.1351, align 8
  %.1397 = inttoptr i64 %.1352 to ptr
  tail call void %.1397(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B950

B950:                                             ; preds = %B550, %B546
  br i1 %.276.i, label %B992, label %B64.if.i

B106.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.323.i440, align 8, !noalias !19
  %.441.i523 = getelementptr double, ptr %191, i64 %.170.i262.010033
  store double 0.000000e+00, ptr %.441.i523, align 8, !noalias !19
  %.496.i571 = getelementptr double, ptr %192, i64 %.170.i262.010033
  store double 0.000000e+00, ptr %.496.i571, align 8, !noalias !19
  %.551.i614 = getelementptr i64, ptr %arg.lane.1.4, i64 %.170.i262.010033
  %.552.i615 = load i64, ptr %.551.i614, align 8, !noalias !19
  %.579.i629 = icmp slt i64 %.552.i615, 0
  %.580.i = select i1 %.579.i629, i64 %arg.results.3.5.0, i64 0
  %.581.i630 = add i64 %.580.i, %.552.i615
  %.601.i641 = mul i64 %.581.i630, %arg.results.3.5.1
  %39 = getelementptr i64, ptr %arg.results.3.4, i64 %.601.i641
  %.605.i = getelementptr i8, ptr %39, i64 8
  %.606.i644 = load i64, ptr %.605.i, align 8, !noalias !19
  %.628.i650 = add nsw i64 %.606.i644, %.
  store i64 %.628.i650, ptr %.605.i, align 8, !noalias !19
  %.744.i = load i64, ptr %.551.i614, align 8, !noalias !19
  %.771.i = icmp slt i64 %.744.i, 0
  %.772.i = select i1 %.771.i, i64 %arg.results.3.5.0, i64 0
  %.773.i = add i64 %.772.i, %.744.i
  %.793.i = mul i64 %.773.i, %arg.results.3.5.1
  %40 = getelementptr i64, ptr %arg.results.3.4, i64 %.793.i
  %.797.i = getelementptr i8, ptr %40, i64 16
  %.798.i = load i64, ptr %.797.i, align 8, !noalias !19
  %.799.i = add nsw i64 %.798.i, 1
  store i64 %.799.i, ptr %.797.i, align 8, !noalias !19
  %.905.i = getelementptr double, ptr %193, i64 %.170.i262.010033
  %.906.i = load double, ptr %.905.i, align 8, !noalias !19
  %.907.i = fcmp une double %.906.i, 0.000000e+00
  br i1 %.907.i, label %B368.i, label %B414.i

B368.i:                                           ; preds = %B106.i
  %41 = getelementptr i64, ptr %arg.lane.1.4, i64 %.170.i262.010033
  %.84.i.i = load i64, ptr %41, align 8, !noalias !23
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B414.i

B46.i.i:                                          ; preds = %B368.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !23
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B414.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !23
  br label %B414.i

B414.i:                                           ; preds = %B80.i.i, %B368.i, %B46.i.i, %B106.i
  br i1 %.930.not, label %B550.i, label %B418.i

B418.i:                                           ; preds = %B414.i
  %42 = getelementptr double, ptr %arg.arrays.4.4, i64 %.170.i262.010033
  %.977.i = load double, ptr %42, align 8, !noalias !19
  %.979.i = fcmp olt double %.977.i, -1.000000e-09
  br i1 %.979.i, label %B454.i, label %B550.i

B454.i:                                           ; preds = %B418.i
  %43 = getelementptr i64, ptr %arg.lane.1.4, i64 %.170.i262.010033
  %.84.i63.i = load i64, ptr %43, align 8, !noalias !26
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B46.i71.i:                                        ; preds = %B454.i
  %.120.i91.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !26
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !26
  br label %_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i: ; preds = %B46.i71.i, %B454.i, %B80.i98.i
  %.1068.i = getelementptr double, ptr %arg.lane.0.4, i64 %.170.i262.010033
  %.1069.i = load double, ptr %.1068.i, align 8, !noalias !19
  %.1123.i = getelementptr double, ptr %194, i64 %.170.i262.010033
  store double %.1069.i, ptr %.1123.i, align 8, !noalias !19
  br label %B550.i

B550.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B418.i, %B414.i
  %.111.i183.i = getelementptr i64, ptr %195, i64 %.170.i262.010033
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !29
  %.169.i.i = getelementptr double, ptr %196, i64 %.170.i262.010033
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !29
  %.224.i.i = getelementptr double, ptr %197, i64 %.170.i262.010033
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !29
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.times.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B584.i

B134.i.i:                                         ; preds = %B550.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.times.5.0, i64 0
  %44 = getelementptr double, ptr %arg.times.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %44, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !29
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !29
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !29
  br label %B584.i

B584.i:                                           ; preds = %B134.i.i, %B550.i, %B64.if.i
  %.229.i = icmp sgt i64 %.173.i263.010034, 1
  br i1 %.229.i, label %B64.if.i, label %B992

B64.if.i:                                         ; preds = %B950, %B584.i
  %.173.i263.010034 = phi i64 [ %.238.i734, %B584.i ], [ %storemerge, %B950 ]
  %.170.i262.010033 = phi i64 [ %.242.i, %B584.i ], [ 0, %B950 ]
  %.238.i734 = add nsw i64 %.173.i263.010034, -1
  %.242.i = add nsw i64 %.170.i262.010033, 1
  %.323.i440 = getelementptr double, ptr %190, i64 %.170.i262.010033
  %.324.i441 = load double, ptr %.323.i440, align 8, !noalias !19
  %.325.i442 = fcmp ogt double %.324.i441, 5.000000e-01
  br i1 %.325.i442, label %B106.i, label %B584.i

B992:                                             ; preds = %B584.i, %B950, %B412
  %brmerge = select i1 %looked.3.0, i1 true, i1 %.537.not
  br i1 %brmerge, label %B1000, label %B1068

B1000:                                            ; preds = %B992
  %.1497 = load i64, ptr %.1496, align 8
  %.1542 = inttoptr i64 %.1497 to ptr
  tail call void %.1542(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B1068

B1068:                                            ; preds = %B992, %B1000
  br i1 %.537.not, label %B1156, label %B1072

B1072:                                            ; preds = %B1068
  %.1576 = load i64, ptr %arg.code.4, align 8
  %.1623 = inttoptr i64 %.1576 to ptr
  tail call void %.1623(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1622)
  br label %B1156

B1156:                                            ; preds = %B1072, %B1068
  br i1 %.535, label %B1160, label %B1200

B1160:                                            ; preds = %B1156
  br i1 %.174.not.i, label %B0.else.endif.endif.endif.if.i, label %B0.else.endif.if.i, !prof !33

B124.i:                                           ; preds = %B0.endif.else.endif.endif.i
  %.154.i.i9710 = load i64, ptr %.153.i.i, align 8, !noalias !34
  %.184.i.i9712 = load i64, ptr %.183.i.i9711, align 8, !noalias !34
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !40

B412.i.i:                                         ; preds = %B330.if.i.i, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2355.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2403.i = icmp sgt i64 %storemerge2355.i, 0
  br i1 %.1392.i2403.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12406.i = add nsw i64 %storemerge2355.i, -1
  %.952.i.i.i = select i1 %.1556.i2382.not.i, i64 %.311.i.i, i64 0
  %45 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.966.i.i.i = getelementptr i64, ptr %45, i64 %.952.i.i.i
  br label %B478.i.i

B474.i.loopexit.i:                                ; preds = %B1261.i.i, %B960.i.i
  %.1392.i.i = icmp sgt i64 %.1338.i.12408.i, 0
  %.1405.i.i = zext i1 %.1392.i.i to i64
  %.1335.i.1.i = add i64 %.1335.i.12407.i, %.1405.i.i
  %.1401.i.i = sext i1 %.1392.i.i to i64
  %.1338.i.1.i = add nsw i64 %.1338.i.12408.i, %.1401.i.i
  %.1382.i.sroa.0.0.i = select i1 %.1392.i.i, i64 %.1335.i.12407.i, i64 0
  br i1 %.1392.i.i, label %B478.i.i, label %B164.i

B478.i.i:                                         ; preds = %B474.i.loopexit.i, %B478.i.lr.ph.i
  %.1382.i.sroa.0.02409.i = phi i64 [ 0, %B478.i.lr.ph.i ], [ %.1382.i.sroa.0.0.i, %B474.i.loopexit.i ]
  %.1338.i.12408.i = phi i64 [ %.1338.i.12406.i, %B478.i.lr.ph.i ], [ %.1338.i.1.i, %B474.i.loopexit.i ]
  %.1335.i.12407.i = phi i64 [ 1, %B478.i.lr.ph.i ], [ %.1335.i.1.i, %B474.i.loopexit.i ]
  %.1462.i.i = load i64, ptr %.1461.i.i, align 8, !noalias !34
  %.1463.i.i = icmp sgt i64 %.1462.i.i, 0
  br i1 %.1463.i.i, label %B508.i.i, label %B914.i.i

B508.i.i:                                         ; preds = %B478.i.i
  br i1 %.1556.i2382.not.i, label %B610.i.i, label %B544.if.i.i

B610.i.i:                                         ; preds = %B544.if.i.i, %B508.i.i
  %.1717.i.i = load i64, ptr %.1716.i.i, align 8, !noalias !34
  %.1833.i.i = inttoptr i64 %.1717.i.i to ptr
  tail call void %.1833.i.i(ptr %arg.lane.0.4, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1832.i.i), !noalias !34
  %.1849.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.1850.i.i = select i1 %.1849.i.i, i64 %.486.i.i, i64 0
  %46 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.1864.i.i = getelementptr i64, ptr %46, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !34
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %47 = getelementptr i8, ptr %46, i64 8
  %.1896.i.i = getelementptr i64, ptr %47, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !34
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2385.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2385.not.i, label %B914.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02386.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %48 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02386.i
  %.2062.i.i = getelementptr i64, ptr %48, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !34
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.arrays.0.5.0, i64 0
  %49 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %49, i64 %.2079.i.i
  %.2094.i.i = load double, ptr %.2093.i.i, align 8, !noalias !34
  %.2161.i.i = fsub double %.2094.i.i, %.2094.i.i
  %.2162.i.i = fcmp oeq double %.2161.i.i, 0.000000e+00
  br label %B910.i.i

B910.i.i:                                         ; preds = %B794.if.i.i, %B802.i.i
  %"$phi910.2.2.i.3.i" = phi i1 [ %.2162.i.i, %B802.i.i ], [ false, %B794.if.i.i ]
  %.1980.i.i = icmp sgt i64 %.1924.i.02387.i, 1
  br i1 %.1980.i.i, label %B794.if.i.i, label %B914.i.i

B914.i.i:                                         ; preds = %B910.i.i, %B610.i.i, %B478.i.i
  %found.3.i.1.i = phi i1 [ false, %B478.i.i ], [ true, %B610.i.i ], [ %"$phi910.2.2.i.3.i", %B910.i.i ]
  br i1 %found.3.i.1.i, label %B960.i.i, label %B918.i.i

B918.i.i:                                         ; preds = %B914.i.i
  %.154.i.i.i = load double, ptr %.153.i.i.i, align 8, !noalias !41
  %.183.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !41
  %.187.i.i.i = fdiv double %.154.i.i.i, %.183.i.i.i
  br i1 %.1162.i2379.not.i, label %B498.i.i.i.critedge, label %B84.if.i.i.i

B230.i.i.i:                                       ; preds = %B84.if.i.i.i
  %.500.i.i.i = load double, ptr %.499.i.i.i, align 8, !noalias !41
  %.501.i.i.i = fmul double %.500.i.i.i, 1.000000e-03
  store double %.501.i.i.i, ptr %.534.i.i.i, align 8, !noalias !41
  br label %B370.if.i.i.i

B398.i.i.i:                                       ; preds = %B370.if.i.i.i
  %gep10036 = getelementptr double, ptr %invariant.gep10035, i64 %.687.i.i.02393.i
  %.851.i.i.i = load double, ptr %gep10036, align 8, !noalias !41
  %.853.i.i.i = fmul double %.851.i.i.i, 5.000000e-01
  br label %B444.i.i.i

B444.i.i.i:                                       ; preds = %B370.if.i.i.i, %B398.i.i.i
  %"$phi444.2.2.i.i.2.i" = phi double [ %.853.i.i.i, %B398.i.i.i ], [ 0.000000e+00, %B370.if.i.i.i ]
  %50 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.i
  %.894.i.i.i = load double, ptr %50, align 8, !noalias !41
  %.895.i.i.i = fadd double %"$phi444.2.2.i.i.2.i", %.894.i.i.i
  %51 = getelementptr double, ptr %50, i64 %.897.i.i.i
  store double %.895.i.i.i, ptr %51, align 8, !noalias !41
  %exitcond2417.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.i
  br i1 %exitcond2417.not.i, label %B498.i.i.i, label %B370.if.i.i.i

B498.i.i.i.critedge:                              ; preds = %B918.i.i
  %.500.i.i.i.c = load double, ptr %.499.i.i.i, align 8, !noalias !41
  %.501.i.i.i.c = fmul double %.500.i.i.i.c, 1.000000e-03
  store double %.501.i.i.i.c, ptr %.534.i.i.i, align 8, !noalias !41
  br label %B498.i.i.i

B498.i.i.i:                                       ; preds = %B444.i.i.i, %B498.i.i.i.critedge
  %.967.i.i.i = load i64, ptr %.966.i.i.i, align 8, !noalias !41
  %.969.i.i.i = icmp eq i64 %.967.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.969.i.i.i, label %B522.i.i.i, label %B568.i.i.i

B522.i.i.i:                                       ; preds = %B498.i.i.i
  %.1004.i.i.i = load double, ptr %.534.i.i.i, align 8, !noalias !41
  %.1006.i.i.i = fmul double %.1004.i.i.i, 5.000000e-01
  br label %B568.i.i.i

B568.i.i.i:                                       ; preds = %B522.i.i.i, %B498.i.i.i
  %"$phi568.1.2.i.i.1.i" = phi double [ %.1006.i.i.i, %B522.i.i.i ], [ 0.000000e+00, %B498.i.i.i ]
  %.1074.i.i.i = load double, ptr %arg.lane.0.4, align 8, !noalias !41
  %.1075.i.i.i = fadd double %"$phi568.1.2.i.i.1.i", %.1074.i.i.i
  store double %.1075.i.i.i, ptr %.496, align 8, !noalias !41
  %.1164.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !41
  %.1280.i.i.i = inttoptr i64 %.1164.i.i.i to ptr
  tail call void %.1280.i.i.i(ptr nonnull %.496, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1279.i.i.i), !noalias !41
  br i1 %.1162.i2379.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B1060.i.i.i:                                      ; preds = %B902.if.i.i.i
  %.1750.i.i.i = fsub double %.1666.i.i.i, %.1697.i.i.i
  br label %B1148.i.i.i

B1100.i.i.i:                                      ; preds = %B902.if.i.i.i
  %52 = getelementptr double, ptr %60, i64 %arg.shape.1
  %.1731.i.i.i = load double, ptr %52, align 8, !noalias !41
  %.1796.i.i.i = fsub double %.1666.i.i.i, %.1731.i.i.i
  %.1801.i.i.i = fmul double %.1796.i.i.i, 2.000000e+00
  br label %B1148.i.i.i

B370.if.i.i.1.i:                                  ; preds = %B568.i.i.i, %B444.i.i.1.i
  %.687.i.i.02393.1.i = phi i64 [ %.756.i.i.1.i, %B444.i.i.1.i ], [ 0, %B568.i.i.i ]
  %.756.i.i.1.i = add nsw i64 %.687.i.i.02393.1.i, 1
  %53 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.1.i
  %.814.i.i.1.i = load i64, ptr %53, align 8, !noalias !41
  %.816.i.i.1.i = icmp eq i64 %.814.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.1.i, label %B398.i.i.1.i, label %B444.i.i.1.i

B398.i.i.1.i:                                     ; preds = %B370.if.i.i.1.i
  %gep10038 = getelementptr double, ptr %invariant.gep10037, i64 %.687.i.i.02393.1.i
  %.851.i.i.1.i = load double, ptr %gep10038, align 8, !noalias !41
  %.853.i.i.1.i = fmul double %.851.i.i.1.i, -5.000000e-01
  br label %B444.i.i.1.i

B444.i.i.1.i:                                     ; preds = %B398.i.i.1.i, %B370.if.i.i.1.i
  %"$phi444.2.2.i.i.2.1.i" = phi double [ %.853.i.i.1.i, %B398.i.i.1.i ], [ 0.000000e+00, %B370.if.i.i.1.i ]
  %54 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.1.i
  %.894.i.i.1.i = load double, ptr %54, align 8, !noalias !41
  %.895.i.i.1.i = fadd double %"$phi444.2.2.i.i.2.1.i", %.894.i.i.1.i
  %55 = getelementptr double, ptr %54, i64 %.897.i.i.i
  store double %.895.i.i.1.i, ptr %55, align 8, !noalias !41
  %exitcond2417.1.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.1.i
  br i1 %exitcond2417.1.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B498.i.i.1.i:                                     ; preds = %B444.i.i.1.i, %B568.i.i.i
  %.967.i.i.1.i = load i64, ptr %.966.i.i.i, align 8, !noalias !41
  %.969.i.i.1.i = icmp eq i64 %.967.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.969.i.i.1.i, label %B522.i.i.1.i, label %B568.i.i.1.i

B522.i.i.1.i:                                     ; preds = %B498.i.i.1.i
  %.1004.i.i.1.i = load double, ptr %.534.i.i.i, align 8, !noalias !41
  %.1006.i.i.1.i = fmul double %.1004.i.i.1.i, -5.000000e-01
  br label %B568.i.i.1.i

B568.i.i.1.i:                                     ; preds = %B522.i.i.1.i, %B498.i.i.1.i
  %"$phi568.1.2.i.i.1.1.i" = phi double [ %.1006.i.i.1.i, %B522.i.i.1.i ], [ 0.000000e+00, %B498.i.i.1.i ]
  %.1074.i.i.1.i = load double, ptr %arg.lane.0.4, align 8, !noalias !41
  %.1075.i.i.1.i = fadd double %"$phi568.1.2.i.i.1.1.i", %.1074.i.i.1.i
  store double %.1075.i.i.1.i, ptr %.496, align 8, !noalias !41
  %.1312.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !41
  %.1426.i.i.1.i = inttoptr i64 %.1312.i.i.1.i to ptr
  tail call void %.1426.i.i.1.i(ptr nonnull %.496, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !41
  br i1 %.1162.i2379.not.i, label %B960.i.i, label %B902.if.i.i.i

B1148.i.i.i:                                      ; preds = %B1100.i.i.i, %B1060.i.i.i
  %storemerge2363.i = phi double [ %.1801.i.i.i, %B1100.i.i.i ], [ %.1750.i.i.i, %B1060.i.i.i ]
  store double %storemerge2363.i, ptr %62, align 8, !noalias !41
  %exitcond2419.not.i = icmp eq i64 %arg.shape.1, %.1540.i.i.i
  br i1 %exitcond2419.not.i, label %B960.i.i, label %B902.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B918.i.i, %B84.if.i.i.i
  %.215.i.i.02391.i = phi i64 [ %.286.i.i.i, %B84.if.i.i.i ], [ 0, %B918.i.i ]
  %.286.i.i.i = add nsw i64 %.215.i.i.02391.i, 1
  %56 = getelementptr double, ptr %arg.arrays.0.4, i64 %.215.i.i.02391.i
  %.344.i.i.i = load double, ptr %56, align 8, !noalias !41
  %.345.i.i.i = tail call double @llvm.fabs.f64(double %.344.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.187.i.i.i, %.345.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.187.i.i.i, double %.345.i.i.i
  %.380.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %57 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.380.i.i.i, double %57, double 1.200000e-05
  %58 = getelementptr i8, ptr %56, i64 %.idx2424.i
  store double %"$phi194.2.2.i.i.1.i", ptr %58, align 8, !noalias !41
  %exitcond2416.not.i = icmp eq i64 %arg.shape.1, %.286.i.i.i
  br i1 %exitcond2416.not.i, label %B230.i.i.i, label %B84.if.i.i.i

B370.if.i.i.i:                                    ; preds = %B230.i.i.i, %B444.i.i.i
  %.687.i.i.02393.i = phi i64 [ %.756.i.i.i, %B444.i.i.i ], [ 0, %B230.i.i.i ]
  %.756.i.i.i = add nsw i64 %.687.i.i.02393.i, 1
  %59 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.i
  %.814.i.i.i = load i64, ptr %59, align 8, !noalias !41
  %.816.i.i.i = icmp eq i64 %.814.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.i, label %B398.i.i.i, label %B444.i.i.i

B902.if.i.i.i:                                    ; preds = %B568.i.i.1.i, %B1148.i.i.i
  %.1471.i.i.02398.i = phi i64 [ %.1540.i.i.i, %B1148.i.i.i ], [ 0, %B568.i.i.1.i ]
  %.1540.i.i.i = add nsw i64 %.1471.i.i.02398.i, 1
  %60 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1471.i.i.02398.i
  %.1598.i.i.i = load double, ptr %60, align 8, !noalias !41
  %61 = getelementptr i8, ptr %60, i64 %.1807.i.idx.i
  store double %.1598.i.i.i, ptr %61, align 8, !noalias !41
  %62 = getelementptr i8, ptr %60, i64 %.1279.i.i.idx.i
  %.1666.i.i.i = load double, ptr %62, align 8, !noalias !41
  %63 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1471.i.i.02398.i
  %.1697.i.i.i = load double, ptr %63, align 8, !noalias !41
  %.1743.i.i.i = fsub double %.1697.i.i.i, %.1697.i.i.i
  %.1744.i.i.i = fcmp oeq double %.1743.i.i.i, 0.000000e+00
  br i1 %.1744.i.i.i, label %B1060.i.i.i, label %B1100.i.i.i

B960.i.i:                                         ; preds = %B1148.i.i.i, %B568.i.i.1.i, %B914.i.i
  %.2256.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.2257.i.i = select i1 %.2256.i.i, i64 %.486.i.i, i64 0
  %64 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.2271.i.i = getelementptr i64, ptr %64, i64 %.2257.i.i
  %.2272.i.i = load i64, ptr %.2271.i.i, align 8, !noalias !34
  %.2290.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.2291.i.i = select i1 %.2290.i.i, i64 %.486.i.i, i64 0
  %65 = getelementptr i8, ptr %64, i64 8
  %.2305.i.i = getelementptr i64, ptr %65, i64 %.2291.i.i
  %.2306.i.i = load i64, ptr %.2305.i.i, align 8, !noalias !34
  %.2343.i.i = sub i64 %.2306.i.i, %.2272.i.i
  %.2386.i2400.not.i = icmp slt i64 %.2343.i.i, 1
  br i1 %.2386.i2400.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1080.i.i:                                        ; preds = %B1022.if.i.i
  %.2519.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %66 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2533.i.i = getelementptr i64, ptr %66, i64 %.2519.i.i
  %.2534.i.i = load i64, ptr %.2533.i.i, align 8, !noalias !34
  %.2535.i.i = add nsw i64 %.2534.i.i, %.503.i.i.i
  %.2549.i.i = icmp slt i64 %.2535.i.i, 0
  %.2550.i.i = select i1 %.2549.i.i, i64 %arg.arrays.0.5.0, i64 0
  %67 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2535.i.i
  %.2564.i.i = getelementptr double, ptr %67, i64 %.2550.i.i
  %.2565.i.i = load double, ptr %.2564.i.i, align 8, !noalias !34
  %.2570.i.i = fdiv double %.2490.i.i, %.2565.i.i
  %.2578.i.i = fsub double %.2570.i.i, %.2570.i.i
  %.2579.i.i = fcmp oeq double %.2578.i.i, 0.000000e+00
  %.2570.i..i = select i1 %.2579.i.i, double %.2570.i.i, double 0.000000e+00
  br label %B1162.i.i

B1162.i.i:                                        ; preds = %B1022.if.i.i, %B1080.i.i
  %slope.3.i.2.i = phi double [ %.2490.i.i, %B1022.if.i.i ], [ %.2570.i..i, %B1080.i.i ]
  %.2616.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %68 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2630.i.i = getelementptr i64, ptr %68, i64 %.2616.i.i
  %.2631.i.i = load i64, ptr %.2630.i.i, align 8, !noalias !34
  %.2633.i.i = icmp eq i64 %.2631.i.i, %arg.shape.1
  br i1 %.2633.i.i, label %B1186.i.i, label %B1232.i.i

B1186.i.i:                                        ; preds = %B1162.i.i
  %.2670.i.i = add nsw i64 %.2459.i.i, %.2636.i.i
  %.2685.i.i = icmp slt i64 %.2670.i.i, 0
  %.2686.i.i = select i1 %.2685.i.i, i64 %arg.arrays.0.5.0, i64 0
  %69 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2670.i.i
  %.2700.i.i = getelementptr double, ptr %69, i64 %.2686.i.i
  store double %slope.3.i.2.i, ptr %.2700.i.i, align 8, !noalias !34
  br label %B1261.i.i

B1232.i.i:                                        ; preds = %B1162.i.i
  %.2720.i.i = select i1 %.2443.i.i, i64 %.1014.i.i, i64 0
  %70 = getelementptr i64, ptr %.1030.i.i, i64 %.2330.i.02401.i
  %.2734.i.i = getelementptr i64, ptr %70, i64 %.2720.i.i
  %.2735.i.i = load i64, ptr %.2734.i.i, align 8, !noalias !34
  %.2752.i.i = icmp slt i64 %.2735.i.i, 0
  %.2753.i.i = select i1 %.2752.i.i, i64 %arg.linear.0.5.0, i64 0
  %71 = getelementptr double, ptr %arg.linear.0.4, i64 %.2735.i.i
  %.2767.i.i = getelementptr double, ptr %71, i64 %.2753.i.i
  store double %slope.3.i.2.i, ptr %.2767.i.i, align 8, !noalias !34
  br label %B1261.i.i

B1261.i.i:                                        ; preds = %B1232.i.i, %B1186.i.i
  %.2386.i.i = icmp sgt i64 %.2333.i.02402.i, 1
  br i1 %.2386.i.i, label %B1022.if.i.i, label %B474.i.loopexit.i

B0.endif.i.i:                                     ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.214.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.endif.endif.if.i.i ], [ %.214.i.sroa.11.1.i, %B0.else.endif.endif.endif.i.i ]
  %.302.i.i = sub i64 %.214.i.sroa.11.0.i, %spec.select.i
  %.311.i.i = tail call i64 @llvm.smax.i64(i64 %.302.i.i, i64 0)
  %.327.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select.i
  %.362.i.i = add nsw i64 %.154.i.i9710, %.187.i.i
  br i1 %.409.i.i, label %B0.endif.else.endif.if.i.i, label %B0.endif.else.endif.endif.i.i, !prof !40

B0.else.endif.if.i.i:                             ; preds = %B124.i
  br label %B0.else.endif.endif.i.i

B0.else.endif.endif.i.i:                          ; preds = %B0.else.endif.if.i.i, %B124.i
  %simplifycfg.merge.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.if.i.i ], [ 0, %B124.i ]
  %spec.select.i = select i1 %198, i64 %simplifycfg.merge.i, i64 %.226.i.i, !prof !45
  br i1 %.246.i.i, label %B0.else.endif.endif.if.i.i, label %B0.else.endif.endif.endif.i.i, !prof !40

B0.else.endif.endif.if.i.i:                       ; preds = %B0.else.endif.endif.i.i
  br label %B0.else.endif.endif.endif.i.i

B0.else.endif.endif.endif.i.i:                    ; preds = %B0.else.endif.endif.if.i.i, %B0.else.endif.endif.i.i
  %.214.i.sroa.11.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i.i ], [ %.243.i.i, %B0.else.endif.endif.i.i ]
  br i1 %.251.i.not.i, label %B0.endif.i.i, label %B0.else.endif.endif.endif.if.i.i, !prof !33

B0.else.endif.endif.endif.if.i.i:                 ; preds = %B0.else.endif.endif.endif.i.i
  br label %B0.endif.i.i

B0.endif.endif.i.i:                               ; preds = %B0.endif.else.endif.endif.endif.if.i.i, %B0.endif.else.endif.endif.endif.i.i
  %.389.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.endif.endif.if.i.i ], [ %.389.i.sroa.11.1.i, %B0.endif.else.endif.endif.endif.i.i ]
  %.477.i.i = sub i64 %.389.i.sroa.11.0.i, %spec.select2366.i
  %.486.i.i = tail call i64 @llvm.smax.i64(i64 %.477.i.i, i64 0)
  %.502.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2366.i
  %.540.i.i = add i64 %.539.i.i, %.154.i.i9710
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i9712
  %.578.i.i = icmp slt i64 %.540.i.i, 0
  %.579.i.i = select i1 %.578.i.i, i64 %arg.linear.1.5.0, i64 0
  %.580.i.i = add i64 %.579.i.i, %.540.i.i
  %.583.i.i = icmp slt i64 %.580.i.i, 0
  %.588.i.i = icmp sge i64 %.580.i.i, %arg.linear.1.5.0
  br i1 %.588.i.i, label %B0.endif.endif.else.endif.if.i.i, label %B0.endif.endif.else.endif.endif.i.i, !prof !40

B0.endif.else.endif.if.i.i:                       ; preds = %B0.endif.i.i
  br label %B0.endif.else.endif.endif.i.i

B0.endif.else.endif.endif.i.i:                    ; preds = %B0.endif.else.endif.if.i.i, %B0.endif.i.i
  %simplifycfg.merge2.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i.i ], [ 0, %B0.endif.i.i ]
  %spec.select2366.i = select i1 %199, i64 %simplifycfg.merge2.i, i64 %.243.i.i, !prof !45
  %.416.i.i = icmp slt i64 %.362.i.i, 0
  %.417.i.i = select i1 %.416.i.i, i64 %arg.linear.1.5.0, i64 0
  %.418.i.i9714 = add i64 %.417.i.i, %.362.i.i
  %.421.i.i = icmp slt i64 %.418.i.i9714, 0
  br i1 %.421.i.i, label %B0.endif.else.endif.endif.if.i.i, label %B0.endif.else.endif.endif.endif.i.i, !prof !40

B0.endif.else.endif.endif.if.i.i:                 ; preds = %B0.endif.else.endif.endif.i.i
  br label %B0.endif.else.endif.endif.endif.i.i

B0.endif.else.endif.endif.endif.i.i:              ; preds = %B0.endif.else.endif.endif.if.i.i, %B0.endif.else.endif.endif.i.i
  %.389.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.else.endif.endif.if.i.i ], [ %.418.i.i9714, %B0.endif.else.endif.endif.i.i ]
  %.426.i.not.i = icmp slt i64 %.418.i.i9714, %arg.linear.1.5.0
  br i1 %.426.i.not.i, label %B0.endif.endif.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !33

B0.endif.else.endif.endif.endif.if.i.i:           ; preds = %B0.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.i.i

B0.endif.endif.endif.i.i:                         ; preds = %B0.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.else.endif.endif.endif.i.i
  %.568.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.endif.endif.if.i.i ], [ %.568.i.sroa.11.1.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  %.656.i.i = sub i64 %.568.i.sroa.11.0.i, %spec.select2367.i
  %.665.i.i = tail call i64 @llvm.smax.i64(i64 %.656.i.i, i64 0)
  %.681.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2367.i
  %.711.i.i = shl nsw i64 %.184.i.i9712, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !40

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %72 = or i1 %.583.i.i, %.588.i.i
  %spec.select2367.i = select i1 %72, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !45
  %.595.i.i = icmp slt i64 %.541.i.i, 0
  %.596.i.i = select i1 %.595.i.i, i64 %arg.linear.1.5.0, i64 0
  %.597.i.i = add i64 %.596.i.i, %.541.i.i
  %.600.i.i = icmp slt i64 %.597.i.i, 0
  br i1 %.600.i.i, label %B0.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, !prof !40

B0.endif.endif.else.endif.endif.if.i.i:           ; preds = %B0.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.else.endif.endif.endif.i.i:        ; preds = %B0.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.else.endif.endif.i.i
  %.568.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if.i.i ], [ %.597.i.i, %B0.endif.endif.else.endif.endif.i.i ]
  %.605.i.not.i = icmp slt i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.605.i.not.i, label %B0.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.endif.endif.if.i.i, !prof !33

B0.endif.endif.else.endif.endif.endif.if.i.i:     ; preds = %B0.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.i.i

B0.endif.endif.endif.endif.i.i:                   ; preds = %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i
  %.739.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.739.i.sroa.11.1.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.827.i.i = sub i64 %.739.i.sroa.11.0.i, %spec.select2368.i
  %.836.i.i = tail call i64 @llvm.smax.i64(i64 %.827.i.i, i64 0)
  %.852.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2368.i
  %.889.i.i = mul nsw i64 %.184.i.i9712, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !40

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %73 = or i1 %.600.i.i, %.759.i.i
  %spec.select2368.i = select i1 %73, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !45
  %.766.i.i = icmp slt i64 %.712.i.i, 0
  %.767.i.i = select i1 %.766.i.i, i64 %arg.linear.1.5.0, i64 0
  %.768.i.i = add i64 %.767.i.i, %.712.i.i
  %.771.i.i = icmp slt i64 %.768.i.i, 0
  br i1 %.771.i.i, label %B0.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, !prof !40

B0.endif.endif.endif.else.endif.endif.if.i.i:     ; preds = %B0.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.endif.else.endif.endif.i.i
  %.739.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.endif.else.endif.endif.if.i.i ], [ %.768.i.i, %B0.endif.endif.endif.else.endif.endif.i.i ]
  %.776.i.not.i = icmp slt i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.776.i.not.i, label %B0.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !33

B0.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endif.endif.i.i:             ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
  %.917.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.917.i.sroa.11.1.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1005.i.i = sub i64 %.917.i.sroa.11.0.i, %spec.select2369.i
  %.1014.i.i = tail call i64 @llvm.smax.i64(i64 %.1005.i.i, i64 0)
  %.1030.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2369.i
  br i1 %.1162.i2379.not.i, label %B412.i.i, label %B330.if.i.i

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.i.i
  %simplifycfg.merge8.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i ]
  %74 = or i1 %.771.i.i, %.937.i.i
  %spec.select2369.i = select i1 %74, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !45
  %.944.i.i = icmp slt i64 %.890.i.i, 0
  %.945.i.i = select i1 %.944.i.i, i64 %arg.linear.1.5.0, i64 0
  %.946.i.i = add i64 %.945.i.i, %.890.i.i
  %.949.i.i = icmp slt i64 %.946.i.i, 0
  br i1 %.949.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, !prof !40

B0.endif.endif.endif.endif.else.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i
  %.917.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i.i ], [ %.946.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.954.i.not.i = icmp slt i64 %.946.i.i, %arg.linear.1.5.0
  br i1 %.954.i.not.i, label %B0.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !33

B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.i.i

B330.if.i.i:                                      ; preds = %B0.endif.endif.endif.endif.endif.i.i, %B330.if.i.i
  %.1104.i.02380.i = phi i64 [ %.1175.i.i, %B330.if.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.i.i ]
  %.1175.i.i = add nsw i64 %.1104.i.02380.i, 1
  %75 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1104.i.02380.i
  %.1229.i.i = load double, ptr %75, align 8, !noalias !34
  %76 = getelementptr i8, ptr %75, i64 %.idx2421.i
  store double %.1229.i.i, ptr %76, align 8, !noalias !34
  %77 = getelementptr i8, ptr %75, i64 %.idx2422.i
  store double 0.000000e+00, ptr %77, align 8, !noalias !34
  %exitcond.not.i9715 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i9715, label %B412.i.i, label %B330.if.i.i

B544.if.i.i:                                      ; preds = %B508.i.i, %B544.if.i.i
  %.1503.i.02384.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %storemerge2359.i, %B508.i.i ]
  %.1500.i.02383.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ 0, %B508.i.i ]
  %.1565.i.i = add nsw i64 %.1503.i.02384.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02383.i, 1
  %78 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02383.i
  %.1627.i.i = load i64, ptr %78, align 8, !noalias !34
  %.1629.i.i = icmp eq i64 %.1627.i.i, %.1382.i.sroa.0.02409.i
  %..i = select i1 %.1629.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1500.i.02383.i
  store double %..i, ptr %gep, align 8, !noalias !34
  %.1556.i.i = icmp sgt i64 %.1503.i.02384.i, 1
  br i1 %.1556.i.i, label %B544.if.i.i, label %B610.i.i

B794.if.i.i:                                      ; preds = %B610.i.i, %B910.i.i
  %found.2.i.22388.i = phi i1 [ %"$phi910.2.2.i.3.i", %B910.i.i ], [ true, %B610.i.i ]
  %.1924.i.02387.i = phi i64 [ %.1989.i.i, %B910.i.i ], [ %.1934.i.i, %B610.i.i ]
  %.1921.i.02386.i = phi i64 [ %.1993.i.i, %B910.i.i ], [ %.1865.i.i, %B610.i.i ]
  %.1989.i.i = add nsw i64 %.1924.i.02387.i, -1
  %.1993.i.i = add i64 %.1921.i.02386.i, 1
  br i1 %found.2.i.22388.i, label %B802.i.i, label %B910.i.i

B1022.if.i.i:                                     ; preds = %B960.i.i, %B1261.i.i
  %.2333.i.02402.i = phi i64 [ %.2395.i.i, %B1261.i.i ], [ %.2343.i.i, %B960.i.i ]
  %.2330.i.02401.i = phi i64 [ %.2399.i.i, %B1261.i.i ], [ %.2272.i.i, %B960.i.i ]
  %.2395.i.i = add nsw i64 %.2333.i.02402.i, -1
  %.2399.i.i = add i64 %.2330.i.02401.i, 1
  %.2443.i.i = icmp slt i64 %.2330.i.02401.i, 0
  %.2444.i.i = select i1 %.2443.i.i, i64 %.665.i.i, i64 0
  %79 = getelementptr i64, ptr %.681.i.i, i64 %.2330.i.02401.i
  %.2458.i.i = getelementptr i64, ptr %79, i64 %.2444.i.i
  %.2459.i.i = load i64, ptr %.2458.i.i, align 8, !noalias !34
  %.2460.i.i = add nsw i64 %.2459.i.i, %.1789.i.i
  %.2474.i.i = icmp slt i64 %.2460.i.i, 0
  %.2475.i.i = select i1 %.2474.i.i, i64 %arg.arrays.0.5.0, i64 0
  %80 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2460.i.i
  %.2489.i.i = getelementptr double, ptr %80, i64 %.2475.i.i
  %.2490.i.i = load double, ptr %.2489.i.i, align 8, !noalias !34
  br i1 %found.3.i.1.i, label %B1162.i.i, label %B1080.i.i

B164.i:                                           ; preds = %B474.i.loopexit.i, %B0.endif.else.endif.endif.i, %B412.i.i
  %.634.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !46
  %.664.i = load i64, ptr %.663.i, align 8, !noalias !46
  br i1 %.711.i, label %B226.if.lr.ph.i, label %B1200

B226.if.lr.ph.i:                                  ; preds = %B164.i
  %.829.i = add i64 %.634.i, 1
  %81 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02414.i, %.743.sroa.0.02358.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i = select i1 %.1071.i, i64 %.251.i, i64 0
  %82 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %82, i64 %.1072.i
  %.1087.i = load double, ptr %.1086.i, align 8, !noalias !46
  %.1141.i = load double, ptr %.1140.i, align 8, !noalias !46
  %.1142.i = fadd double %.1087.i, %.1141.i
  store double %.1142.i, ptr %.1086.i, align 8, !noalias !46
  %exitcond2420.not.i = icmp eq i64 %.766.i, %arg.shape.1
  br i1 %exitcond2420.not.i, label %B468.i9708, label %B226.if.i

B468.i9708:                                       ; preds = %B396.i
  %.199.i.i = add i64 %.664.i, 1
  br label %B36.if.i.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1200, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %83 = getelementptr i64, ptr %.437.i, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %83, align 8, !noalias !47
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %84 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %84, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !47
  %.610.i.i = load double, ptr %86, align 8, !noalias !47
  store double %.577.i.i, ptr %86, align 8, !noalias !47
  store double %.610.i.i, ptr %.576.i.i, align 8, !noalias !47
  br i1 %.362493.not.i.i, label %B528.i.i, label %B466.if.i.i

B528.i.i:                                         ; preds = %B466.if.i.i, %B348.i.i
  %.942.i.i = sub i64 %.11.i492.i.i, %.131.i.i
  %.985504.not.i.i = icmp slt i64 %.942.i.i, 1
  br i1 %.985504.not.i.i, label %B34.loopexit.i.i, label %B566.if.i.i

B790.i.i:                                         ; preds = %B716.if.i.i, %B566.if.i.i
  %.985.i.i = icmp sgt i64 %.932.0506.i.i, 1
  br i1 %.985.i.i, label %B566.if.i.i, label %B34.loopexit.i.i

B36.if.i.i:                                       ; preds = %B34.loopexit.i.i, %B468.i9708
  %.59.0509.i.i = phi i64 [ 0, %B468.i9708 ], [ %.131.i.i, %B34.loopexit.i.i ]
  %.131.i.i = add nsw i64 %.59.0509.i.i, 1
  %.161.i.i = mul nsw i64 %.59.0509.i.i, %arg.shape.1
  %.164.i.i = add nsw i64 %.59.0509.i.i, %.634.i
  %.165.i.i = add nsw i64 %.164.i.i, 1
  %.11.i.i.i9709 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %85 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %86 = getelementptr double, ptr %85, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i9709, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %86, align 8, !noalias !47
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
  %.430.i.i = select i1 %.429.i.i, i64 %.251.i, i64 0
  %87 = getelementptr double, ptr %.267.i, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %87, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !47
  %.446.i.i = tail call double @llvm.fabs.f64(double %.445.i.i)
  %.448.i.i = fcmp ogt double %.446.i.i, %largest.2.1496.i.i
  %largest.3.2.i.i = select i1 %.448.i.i, double %.446.i.i, double %largest.2.1496.i.i
  %p.3.2.i.i = select i1 %.448.i.i, i64 %.306.0494.i.i, i64 %p.2.1497.i.i
  %.362.i2370.i = icmp sgt i64 %.309.0495.i.i, 1
  br i1 %.362.i2370.i, label %B234.if.i.i, label %B348.i.i

B466.if.i.i:                                      ; preds = %B348.i.i, %B466.if.i.i
  %.706.0500.i.i = phi i64 [ %.768.i2371.i, %B466.if.i.i ], [ %storemerge488.i.i, %B348.i.i ]
  %.703.0499.i.i = phi i64 [ %.772.i.i, %B466.if.i.i ], [ %.131.i.i, %B348.i.i ]
  %.768.i2371.i = add nsw i64 %.706.0500.i.i, -1
  %.772.i.i = add i64 %.703.0499.i.i, 1
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i
  %.812.i.i = icmp slt i64 %.798.i.i, 0
  %.813.i.i = select i1 %.812.i.i, i64 %.251.i, i64 0
  %88 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2372.i = getelementptr double, ptr %88, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2372.i, align 8, !noalias !47
  %.861.i.i = load double, ptr %86, align 8, !noalias !47
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2372.i, align 8, !noalias !47
  %.759.i2373.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2373.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %89 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2374.i = add nsw i64 %89, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2374.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %90 = getelementptr double, ptr %.267.i, i64 %.1030.i2374.i
  %.1059.i.i = getelementptr double, ptr %90, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !47
  %.1068.i.i = add nsw i64 %89, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %91 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %91, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !47
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !47
  store double %.1060.i.i, ptr %.1097.i.i, align 8, !noalias !47
  %.1171.i2375.i = fcmp oeq double %.1060.i.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i2375.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i2376.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i2376.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %89
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2377.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %92 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %92, i64 %.1311.i2377.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !47
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %93 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %93, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !47
  %.1360.i.i = fmul double %.1060.i.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !47
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B0.else.endif.if.i:                               ; preds = %B1160
  br label %B0.else.endif.endif.endif.if.i

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.if.i, %B1160
  %.154.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i ], [ %.127.i, %B1160 ]
  %.242.i9704 = sub i64 %arg.linear.0.5.0, %.154.sroa.0.3.i
  %.251.i = tail call i64 @llvm.smax.i64(i64 %.242.i9704, i64 0)
  %.267.i = getelementptr double, ptr %arg.linear.0.4, i64 %.154.sroa.0.3.i
  br i1 %.344.i, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !40

B0.endif.else.endif.if.i:                         ; preds = %B0.else.endif.endif.endif.if.i
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B0.else.endif.endif.endif.if.i
  %.324.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i ], [ 5, %B0.else.endif.endif.endif.if.i ]
  %.437.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.324.sroa.0.3.i
  %.525.i = load double, ptr %.524.i, align 8, !noalias !46
  %.526.i = fcmp olt double %.525.i, 5.000000e-01
  br i1 %.526.i, label %B124.i, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02414.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02414.i, 1
  %.798.i9705 = sub i64 %.697.02414.i, %81
  %.11.i.i9706 = tail call i64 @llvm.smax.i64(i64 %.798.i9705, i64 0)
  %.830.i = add i64 %.829.i, %.697.02414.i
  %.11.i2378.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2378.i, %.11.i.i9706
  %.9392410.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392410.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i9707 = mul nsw i64 %.697.02414.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02412.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02411.i = phi i64 [ %.11.i.i9706, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02412.i, -1
  %.952.i = add i64 %.883.02411.i, 1
  %.980.i = add nsw i64 %.883.02411.i, %.979.i9707
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %94 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %94, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !46
  %.1011.i = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %95 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %95, i64 %.1030.i
  store double %.1011.i, ptr %.1044.i, align 8, !noalias !46
  %.939.i = icmp sgt i64 %.886.02412.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1200:                                            ; preds = %B34.loopexit.i.i, %B164.i, %B1156
  br i1 %.176710043.not, label %B1458, label %B1232.if

B1420:                                            ; preds = %B1232.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i9718, label %B0.else.endif.if.i9717, !prof !33

B322.i:                                           ; preds = %B192.if.i
  %.853.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !50
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !50
  %.339.i.i = add i64 %.853.i, 1
  br label %B34.if.i.i9724

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i9724
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i9724

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %96 = add i64 %.883.i, %.853.i
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i9731 = mul nsw i64 %.1780, %arg.shape.1
  br label %B434.if.i

B34.if.i.i9724:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %97 = getelementptr i64, ptr %.358.i, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %97, align 8, !noalias !53
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.arrays.0.5.0, i64 0
  %98 = getelementptr double, ptr %arg.arrays.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %98, i64 %.219.i.i
  %.234.i.i9725 = load double, ptr %.233.i.i, align 8, !noalias !53
  %gep10042 = getelementptr double, ptr %invariant.gep10041, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep10042, align 8, !noalias !53
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !53
  store double %.234.i.i9725, ptr %gep10042, align 8, !noalias !53
  %.340.i.i = add i64 %.339.i.i, %.73.i.0754.i
  %.11.i.i.i9726 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i9726, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i9724
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i9727 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i9727, i64 %arg.arrays.0.5.0, i64 0
  %99 = getelementptr double, ptr %arg.arrays.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %99, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !53
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %100 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %100, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !53
  %.554.i.i = fmul double %.234.i.i9725, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !53
  %.449.i.i = icmp sgt i64 %.396.i.0752.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i

B314.if.i.i:                                      ; preds = %B314.i.loopexit.i, %B314.if.i.lr.ph.i
  %.627.i.0762.in.i = phi i64 [ %arg.shape.1, %B314.if.i.lr.ph.i ], [ %.627.i.0762.i, %B314.i.loopexit.i ]
  %.627.i.0762.i = add nsw i64 %.627.i.0762.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0762.i, %.887.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.arrays.0.5.0, i64 0
  %101 = getelementptr double, ptr %arg.arrays.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %101, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !53
  %.759.i.i9728 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i9728, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %102 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %102, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !53
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !53
  %.866.i.i = sub i64 %.627.i.0762.i, %96
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i9729 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i9729, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.arrays.0.5.0, i64 0
  %103 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1014.i.i9729
  %.1043.i.i = getelementptr double, ptr %103, i64 %.1029.i.i
  %.1044.i.i9730 = load double, ptr %.1043.i.i, align 8, !noalias !53
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i9728
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %104 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %104, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !53
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i9730, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !53
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i9717:                           ; preds = %B1420
  br label %B0.else.endif.endif.endif.if.i9718

B0.else.endif.endif.endif.if.i9718:               ; preds = %B0.else.endif.if.i9717, %B1420
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i9717 ], [ %.42.i, %B1420 ]
  %.156.i = sub i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i9719, label %B0.endif.else.endif.if.i9734, label %B0.endif.else.endif.endif.i9720, !prof !40

B0.endif.else.endif.if.i9734:                     ; preds = %B0.else.endif.endif.endif.if.i9718
  br label %B0.endif.else.endif.endif.i9720

B0.endif.else.endif.endif.i9720:                  ; preds = %B0.endif.else.endif.if.i9734, %B0.else.endif.endif.endif.if.i9718
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i9734 ], [ 5, %B0.else.endif.endif.endif.if.i9718 ]
  %.358.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !40

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.1780, %arg.shape.1
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i9720
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i9720
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i, %B0.endif.else.endif.endif.i9720 ]
  br i1 %.282.not.i, label %B0.endif.endif.else.endif.endif.endif.i, label %B0.endif.endif.else.endif.if.i, !prof !33

B0.endif.endif.else.endif.if.i:                   ; preds = %B0.endif.endif.else.endif.i
  br label %B0.endif.endif.else.endif.endif.endif.i

B0.endif.endif.else.endif.endif.endif.i:          ; preds = %B0.endif.endif.else.endif.if.i, %B0.endif.endif.else.endif.i
  %.418.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i ], [ %.418.sroa.0.1.i, %B0.endif.endif.else.endif.i ]
  %.531.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.418.sroa.0.3.i
  br i1 %.648747.not.i, label %B1456, label %B192.if.lr.ph.i

B192.if.i:                                        ; preds = %B192.if.i, %B192.if.lr.ph.i
  %.590.0748.i = phi i64 [ 0, %B192.if.lr.ph.i ], [ %.661.i9721, %B192.if.i ]
  %.661.i9721 = add nsw i64 %.590.0748.i, 1
  %.690.i = add nsw i64 %.590.0748.i, %.689.i
  %.704.i = icmp slt i64 %.690.i, 0
  %.705.i = select i1 %.704.i, i64 %arg.arrays.0.5.0, i64 0
  %105 = getelementptr double, ptr %arg.arrays.0.4, i64 %.690.i
  %.719.i = getelementptr double, ptr %105, i64 %.705.i
  %.720.i = load double, ptr %.719.i, align 8, !noalias !50
  %gep10040 = getelementptr double, ptr %invariant.gep10039, i64 %.590.0748.i
  %.753.i = load double, ptr %gep10040, align 8, !noalias !50
  %.754.i = fadd double %.720.i, %.753.i
  %106 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %106, align 8, !noalias !50
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.arrays.0.5.0, i64 0
  %107 = getelementptr double, ptr %arg.arrays.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %107, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !50
  %exitcond.not.i9723 = icmp eq i64 %arg.shape.1, %.661.i9721
  br i1 %exitcond.not.i9723, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i9732, %B434.if.i ]
  %.1019.i9732 = add nsw i64 %.950.0764.i, 1
  %108 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %108, align 8, !noalias !50
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.arrays.0.5.0, i64 0
  %109 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %109, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !50
  %.1111.i = add nsw i64 %.950.0764.i, %.1110.i9731
  %.1125.i = icmp slt i64 %.1111.i, 0
  %.1126.i = select i1 %.1125.i, i64 %arg.arrays.0.5.0, i64 0
  %110 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1111.i
  %.1140.i9733 = getelementptr double, ptr %110, i64 %.1126.i
  store double %.1106.i, ptr %.1140.i9733, align 8, !noalias !50
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i9732
  br i1 %exitcond767.not.i, label %B1456, label %B434.if.i

B1456:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1232.if
  %exitcond10184.not = icmp eq i64 %.1711.010044, %storemerge9607
  br i1 %exitcond10184.not, label %B1458, label %B1232.if

B1458:                                            ; preds = %B1456, %B1200
  %.2044 = load i64, ptr %.2043, align 8
  %.2089 = inttoptr i64 %.2044 to ptr
  tail call void %.2089(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %brmerge9681 = select i1 %.725, i1 true, i1 %.535
  %or.cond9682 = select i1 %brmerge9681, i1 true, i1 %.2125
  %spec.select9700 = select i1 %or.cond9682, i1 true, i1 %.2130
  br i1 %.276.i, label %B1692, label %B1602.if

B1610:                                            ; preds = %B1602.if
  %111 = getelementptr double, ptr %201, i64 %.2170.010047
  %.2329 = load double, ptr %111, align 8
  %.2330 = fcmp ogt double %.2329, 5.000000e-01
  br label %B1646

B1646:                                            ; preds = %B1610, %B1602.if
  %"$phi1646.1.2.2" = phi i1 [ true, %B1602.if ], [ %.2330, %B1610 ]
  br i1 %looked.4.210050, label %B1688, label %B1652

B1652:                                            ; preds = %B1646
  %112 = getelementptr double, ptr %202, i64 %.2170.010047
  %.2404 = load double, ptr %112, align 8
  %.2405 = fcmp ogt double %.2404, 5.000000e-01
  br label %B1688

B1688:                                            ; preds = %B1652, %B1646
  %"$phi1688.1.2.2" = phi i1 [ true, %B1646 ], [ %.2405, %B1652 ]
  %.2226 = icmp sgt i64 %.2173.010048, 1
  br i1 %.2226, label %B1602.if, label %B1692

B1692:                                            ; preds = %B1688, %B1458
  %good.2.1.lcssa = phi i1 [ false, %B1458 ], [ %"$phi1646.1.2.2", %B1688 ]
  %looked.4.2.lcssa = phi i1 [ %spec.select9700, %B1458 ], [ %"$phi1688.1.2.2", %B1688 ]
  %looked.4.2.lcssa.not10192 = xor i1 %looked.4.2.lcssa, true
  %brmerge10193 = or i1 %.276.i, %looked.4.2.lcssa.not10192
  br i1 %brmerge10193, label %B2330, label %B46.if.i

B1764.preheader:                                  ; preds = %B468.i
  br i1 %.276.i, label %B2330, label %B1766.if

B92.i:                                            ; preds = %B46.if.i
  %.303.i941 = getelementptr double, ptr %203, i64 %.90.i782.010054
  %.304.i942 = load double, ptr %.303.i941, align 8, !noalias !57
  %.5.i.i = fptosi double %.304.i942 to i64
  %.382.i991 = getelementptr double, ptr %204, i64 %.90.i782.010054
  %.383.i992 = load double, ptr %.382.i991, align 8, !noalias !57
  %.5.i1.i = fptosi double %.383.i992 to i64
  %.457.i1039 = mul i64 %.243.i893, %arg.results.3.5.1
  %.461.i1043 = getelementptr i64, ptr %arg.results.3.4, i64 %.457.i1039
  %.462.i1044 = load i64, ptr %.461.i1043, align 8, !noalias !57
  %.463.i1045 = add nsw i64 %.462.i1044, %.5.i.i
  store i64 %.463.i1045, ptr %.461.i1043, align 8, !noalias !57
  %.569.i1137 = getelementptr i8, ptr %.461.i1043, i64 24
  %.570.i1138 = load i64, ptr %.569.i1137, align 8, !noalias !57
  %.571.i1139 = add nsw i64 %.570.i1138, %.5.i1.i
  store i64 %.571.i1139, ptr %.569.i1137, align 8, !noalias !57
  %.679.i = getelementptr i8, ptr %.461.i1043, i64 8
  %.680.i1224 = load i64, ptr %.679.i, align 8, !noalias !57
  %.683.i1225 = add nsw i64 %.5.i1.i, %.5.i.i
  %.684.i1226 = mul nsw i64 %.683.i1225, %.1724
  %.685.i = add nsw i64 %.684.i1226, %.5.i.i
  %.686.i1227 = add nsw i64 %.685.i, %.680.i1224
  store i64 %.686.i1227, ptr %.679.i, align 8, !noalias !57
  store double 0.000000e+00, ptr %.303.i941, align 8, !noalias !57
  store double 0.000000e+00, ptr %.382.i991, align 8, !noalias !57
  %.908.i = getelementptr double, ptr %205, i64 %.90.i782.010054
  %.909.i1365 = load double, ptr %.908.i, align 8, !noalias !57
  %.911.i1367 = sitofp i64 %.683.i1225 to double
  %.912.i1368 = fsub double %.909.i1365, %.911.i1367
  store double %.912.i1368, ptr %.908.i, align 8, !noalias !57
  br label %B468.i

B468.i:                                           ; preds = %B92.i, %B46.if.i
  %.148.i = icmp sgt i64 %.93.i783.010055, 1
  br i1 %.148.i, label %B46.if.i, label %B1764.preheader

B46.if.i:                                         ; preds = %B1692, %B468.i
  %.93.i783.010055 = phi i64 [ %.157.i1393, %B468.i ], [ %storemerge, %B1692 ]
  %.90.i782.010054 = phi i64 [ %.161.i1396, %B468.i ], [ 0, %B1692 ]
  %.157.i1393 = add nsw i64 %.93.i783.010055, -1
  %.161.i1396 = add nsw i64 %.90.i782.010054, 1
  %113 = getelementptr i64, ptr %arg.lane.1.4, i64 %.90.i782.010054
  %.243.i893 = load i64, ptr %113, align 8, !noalias !57
  %.248.i896 = icmp sgt i64 %.243.i893, -1
  br i1 %.248.i896, label %B92.i, label %B468.i

B1866:                                            ; preds = %B1766.if
  %.2871 = getelementptr double, ptr %208, i64 %.2531.010057
  %.2872 = load double, ptr %.2871, align 8
  %.2873 = fcmp ogt double %.2872, 5.000000e-01
  br i1 %.2873, label %B1904, label %B2004

B1904:                                            ; preds = %B1866
  %.5.i = fptosi double %.2872 to i64
  %114 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2531.010057
  %.84.i2248 = load i64, ptr %114, align 8, !noalias !61
  %.89.i2251 = icmp sgt i64 %.84.i2248, -1
  br i1 %.89.i2251, label %B46.i2255, label %B2004

B2004:                                            ; preds = %B1866, %B46.i2255, %B1904, %B80.i
  %.3066 = getelementptr double, ptr %209, i64 %.2531.010057
  %.3067 = load double, ptr %.3066, align 8
  %.3068 = fcmp ogt double %.3067, 5.000000e-01
  br i1 %.3068, label %B2042, label %B2326

B2042:                                            ; preds = %B2004
  %spec.select = select i1 %within.3.210060, i1 true, i1 %.2125
  %.3146 = mul i64 %.2698, %arg.results.3.5.1
  %.3150 = getelementptr i64, ptr %arg.results.3.4, i64 %.3146
  %.3151 = load i64, ptr %.3150, align 8
  %.3162.0 = and i64 %.3151, 127
  %.3192 = icmp eq i64 %.3162.0, 0
  br i1 %.3192, label %B2150, label %B2112

B2112:                                            ; preds = %B2042
  %.3253 = getelementptr double, ptr %210, i64 %.2531.010057
  %.3254 = load double, ptr %.3253, align 8
  %.3256 = fcmp ogt double %.3254, 0.000000e+00
  br i1 %.3256, label %B2150, label %B2180

B2150:                                            ; preds = %B2042, %B2112
  store double 1.000000e+00, ptr %.2813, align 8
  br label %B2180

B2180:                                            ; preds = %B2150, %B2112
  %doubted.5.5 = phi i1 [ true, %B2150 ], [ %doubted.3.210061, %B2112 ]
  %.3342 = icmp slt i64 %.2753, %arg.times.5.0
  br i1 %.3342, label %B2218, label %B2326

B2218:                                            ; preds = %B2180
  %.3369 = icmp slt i64 %.2753, 0
  %.3370 = select i1 %.3369, i64 %arg.times.5.0, i64 0
  %115 = getelementptr double, ptr %arg.times.4, i64 %.2753
  %.3384 = getelementptr double, ptr %115, i64 %.3370
  %.3385 = load double, ptr %.3384, align 8
  %.3439 = getelementptr double, ptr %211, i64 %.2531.010057
  %.3440 = load double, ptr %.3439, align 8
  %.3441 = fcmp ugt double %.3385, %.3440
  br i1 %.3441, label %B2326, label %B2268

B2268:                                            ; preds = %B2218
  %.3550 = fcmp olt double %.3385, %.3440
  %spec.select9683 = or i1 %spec.select, %.3550
  br label %B2326

B2326:                                            ; preds = %B1766.if, %B2268, %B2218, %B2180, %B2004
  %wanted.4.3 = phi i1 [ true, %B2268 ], [ %wanted.3.210059, %B2218 ], [ %wanted.3.210059, %B2180 ], [ %wanted.3.210059, %B2004 ], [ %wanted.3.210059, %B1766.if ]
  %within.4.3 = phi i1 [ %spec.select9683, %B2268 ], [ %spec.select, %B2218 ], [ %spec.select, %B2180 ], [ %within.3.210060, %B2004 ], [ %within.3.210060, %B1766.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2268 ], [ %doubted.5.5, %B2218 ], [ %doubted.5.5, %B2180 ], [ %doubted.3.210061, %B2004 ], [ %doubted.3.210061, %B1766.if ]
  %.2597 = icmp sgt i64 %.2534.010058, 1
  br i1 %.2597, label %B1766.if, label %B2330.loopexit

B2330.loopexit:                                   ; preds = %B2326
  %116 = xor i1 %doubted.4.3, true
  %117 = select i1 %116, i1 true, i1 %.539
  %118 = select i1 %wanted.4.3, i1 true, i1 %within.4.3
  br label %B2330

B2330:                                            ; preds = %B1692, %B2330.loopexit, %B1764.preheader
  %wanted.2.1 = phi i1 [ false, %B1692 ], [ false, %B1764.preheader ], [ %118, %B2330.loopexit ]
  %within.5.1 = phi i1 [ false, %B1692 ], [ false, %B1764.preheader ], [ %within.4.3, %B2330.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1692 ], [ true, %B1764.preheader ], [ %117, %B2330.loopexit ]
  %brmerge9684.not = select i1 %good.2.1.lcssa, i1 %.537.not, i1 false
  br i1 %brmerge9684.not, label %B2338, label %B2454

B2338:                                            ; preds = %B2330
  %.3649 = load i64, ptr %arg.code.4, align 8
  %.3699 = inttoptr i64 %.3649 to ptr
  tail call void %.3699(ptr %.496, ptr %.3673, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3698)
  br label %B2454

B2454:                                            ; preds = %B2330, %B2338
  br i1 %doubted.2.1, label %B2530, label %B2462

B2462:                                            ; preds = %B2454
  %.3737 = load i64, ptr %.3736, align 8
  %.3782 = inttoptr i64 %.3737 to ptr
  tail call void %.3782(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2530

B2530:                                            ; preds = %B2454, %B2462
  %119 = select i1 %.2130, i1 %good.2.1.lcssa, i1 false
  br i1 %119, label %B2550, label %B2672

B2550:                                            ; preds = %B2530
  %.3833 = load i64, ptr %.3832, align 8
  %.3880 = inttoptr i64 %.3833 to ptr
  tail call void %.3880(ptr %.496, ptr %.3854, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.276.i, label %B2672, label %B38.if.i

B104.i2537:                                       ; preds = %B38.if.i
  %.349.i2585 = getelementptr double, ptr %213, i64 %.78.i2360.010066
  %.350.i2586 = load double, ptr %.349.i2585, align 8, !noalias !64
  %.351.i2587 = fcmp ogt double %.350.i2586, 5.000000e-01
  br i1 %.351.i2587, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i2537, %B36.i.i
  %.48.i.i2319.0 = phi i64 [ %.119.i.i2899, %B36.i.i ], [ 0, %B104.i2537 ]
  %exitcond10185.not = icmp eq i64 %.48.i.i2319.0, %arg.decided
  br i1 %exitcond10185.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i2899 = add i64 %.48.i.i2319.0, 1
  %.149.i.i2866 = add nsw i64 %.48.i.i2319.0, %arg.decided
  %.151.i.i2868 = mul nsw i64 %.149.i.i2866, %arg.shape.0
  %.153.i.i2870 = add nsw i64 %.151.i.i2868, %.78.i2360.010066
  %.167.i.i = icmp slt i64 %.153.i.i2870, 0
  %.168.i.i2878 = select i1 %.167.i.i, i64 %arg.arrays.4.5.0, i64 0
  %120 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i.i2870
  %.182.i.i = getelementptr double, ptr %120, i64 %.168.i.i2878
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !68
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i2665:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i2483, align 8, !noalias !64
  %.503.i2759 = getelementptr double, ptr %214, i64 %.78.i2360.010066
  store double 0.000000e+00, ptr %.503.i2759, align 8, !noalias !64
  %.558.i2807 = getelementptr double, ptr %215, i64 %.78.i2360.010066
  store double 1.000000e+00, ptr %.558.i2807, align 8, !noalias !64
  %.616.i2854 = getelementptr i64, ptr %216, i64 %.78.i2360.010066
  store i64 %.363.i2371.0, ptr %.616.i2854, align 8, !noalias !64
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i2665, %B104.i2537, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i2665 ], [ %some.2.i.010068, %B142.endif.i ], [ %some.2.i.010068, %B104.i2537 ], [ %some.2.i.010068, %B38.if.i ]
  %.136.i2415 = icmp sgt i64 %.81.i2361.010067, 1
  br i1 %.136.i2415, label %B38.if.i, label %B2672

B38.if.i:                                         ; preds = %B2550, %B304.i
  %some.2.i.010068 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2550 ]
  %.81.i2361.010067 = phi i64 [ %.145.i2909, %B304.i ], [ %storemerge, %B2550 ]
  %.78.i2360.010066 = phi i64 [ %.149.i2912, %B304.i ], [ 0, %B2550 ]
  %.145.i2909 = add nsw i64 %.81.i2361.010067, -1
  %.149.i2912 = add nsw i64 %.78.i2360.010066, 1
  %.234.i2483 = getelementptr double, ptr %212, i64 %.78.i2360.010066
  store double 0.000000e+00, ptr %.234.i2483, align 8, !noalias !64
  %.289.i2530 = getelementptr i64, ptr %arg.lane.1.4, i64 %.78.i2360.010066
  %.290.i2531 = load i64, ptr %.289.i2530, align 8, !noalias !64
  %.291.i2532 = icmp sgt i64 %.290.i2531, -1
  br i1 %.291.i2532, label %B104.i2537, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i2371.0 = phi i64 [ %.48.i.i2319.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i2664 = icmp sgt i64 %.363.i2371.0, -1
  br i1 %.393.i2664, label %B190.i2665, label %B304.i

B2672:                                            ; preds = %B304.i, %B2550, %B2530
  %beyond.2.1 = phi i1 [ false, %B2530 ], [ false, %B2550 ], [ %some.3.i.1, %B304.i ]
  %brmerge9688 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge9688, label %B2682, label %B3204

B2682:                                            ; preds = %B2672
  br i1 %.539, label %B3098.critedge, label %B2730.if

B142.i3197:                                       ; preds = %B66.if.i
  %.407.i3245 = getelementptr double, ptr %218, i64 %.135.i3019.010073
  %.408.i3246 = load double, ptr %.407.i3245, align 8, !noalias !72
  %.409.i3247 = fcmp uge double %.408.i3246, 5.000000e-01
  %.422.i3255.not = icmp slt i64 %.344.i3192, %arg.times.5.0
  %or.cond9689 = select i1 %.409.i3247, i1 %.422.i3255.not, i1 false
  br i1 %or.cond9689, label %B218.i, label %B611.i

B218.i:                                           ; preds = %B142.i3197
  %.438.i3266 = icmp slt i64 %.344.i3192, 0
  %.439.i3267 = select i1 %.438.i3266, i64 %arg.times.5.0, i64 0
  %121 = getelementptr double, ptr %arg.times.4, i64 %.344.i3192
  %.453.i3281 = getelementptr double, ptr %121, i64 %.439.i3267
  %.454.i3282 = load double, ptr %.453.i3281, align 8, !noalias !72
  %.508.i3330 = getelementptr double, ptr %219, i64 %.135.i3019.010073
  %.509.i3331 = load double, ptr %.508.i3330, align 8, !noalias !72
  %.510.i3332 = fcmp ult double %.454.i3282, %.509.i3331
  br i1 %.510.i3332, label %B270.i, label %B611.i

B270.i:                                           ; preds = %B218.i
  %.572.i3379 = getelementptr double, ptr %220, i64 %.135.i3019.010073
  %.573.i3380 = load double, ptr %.572.i3379, align 8, !noalias !72
  %.574.i = fcmp ogt double %.573.i3380, 1.000000e+00
  br i1 %.574.i, label %B308.i, label %B611.i

B308.i:                                           ; preds = %B270.i
  store double 0.000000e+00, ptr %.407.i3245, align 8, !noalias !72
  %.690.i3474 = getelementptr double, ptr %221, i64 %.135.i3019.010073
  store double 0.000000e+00, ptr %.690.i3474, align 8, !noalias !72
  %.745.i3515 = getelementptr double, ptr %222, i64 %.135.i3019.010073
  store double 0.000000e+00, ptr %.745.i3515, align 8, !noalias !72
  %.800.i3558 = getelementptr double, ptr %223, i64 %.135.i3019.010073
  %.801.i3559 = load double, ptr %.800.i3558, align 8, !noalias !72
  %.832.i3583 = load double, ptr %.453.i3281, align 8, !noalias !72
  %.888.i3628 = getelementptr double, ptr %224, i64 %.135.i3019.010073
  store double %.801.i3559, ptr %.888.i3628, align 8, !noalias !72
  %.945.i3671 = getelementptr double, ptr %225, i64 %.135.i3019.010073
  store double %.832.i3583, ptr %.945.i3671, align 8, !noalias !72
  %.996.i3707 = mul i64 %.289.i3144, %arg.results.3.5.1
  %.1000.i = getelementptr i64, ptr %arg.results.3.4, i64 %.996.i3707
  %.1001.i = load i64, ptr %.1000.i, align 8, !noalias !72
  %.1002.i = add nsw i64 %.1001.i, -1
  store i64 %.1002.i, ptr %.1000.i, align 8, !noalias !72
  %.1108.i3773 = getelementptr i8, ptr %.1000.i, i64 24
  %.1109.i3774 = load i64, ptr %.1108.i3773, align 8, !noalias !72
  %.1110.i = add nsw i64 %.1109.i3774, 1
  store i64 %.1110.i, ptr %.1108.i3773, align 8, !noalias !72
  %.1218.i = getelementptr i8, ptr %.1000.i, i64 8
  %.1219.i = load i64, ptr %.1218.i, align 8, !noalias !72
  %.1220.i = add nsw i64 %.1219.i, 3
  store i64 %.1220.i, ptr %.1218.i, align 8, !noalias !72
  br label %B611.i

B611.i:                                           ; preds = %B270.i, %B308.i, %B66.if.i, %B142.i3197, %B218.i
  %.194.i3086 = icmp sgt i64 %.138.i3020.010074, 1
  br i1 %.194.i3086, label %B66.if.i, label %B3098

B66.if.i:                                         ; preds = %B2730.if, %B611.i
  %.138.i3020.010074 = phi i64 [ %.203.i3820, %B611.i ], [ %storemerge, %B2730.if ]
  %.135.i3019.010073 = phi i64 [ %.207.i3823, %B611.i ], [ 0, %B2730.if ]
  %.203.i3820 = add nsw i64 %.138.i3020.010074, -1
  %.207.i3823 = add nsw i64 %.135.i3019.010073, 1
  %.288.i3143 = getelementptr i64, ptr %arg.lane.1.4, i64 %.135.i3019.010073
  %.289.i3144 = load i64, ptr %.288.i3143, align 8, !noalias !72
  %.343.i3191 = getelementptr i64, ptr %217, i64 %.135.i3019.010073
  %.344.i3192 = load i64, ptr %.343.i3191, align 8, !noalias !72
  %.352.i3196 = icmp slt i64 %.289.i3144, 0
  br i1 %.352.i3196, label %B611.i, label %B142.i3197

B3098.critedge:                                   ; preds = %B2682
  %.4336.c = load i64, ptr %.4335.c, align 8
  %.4381.c = inttoptr i64 %.4336.c to ptr
  tail call void %.4381.c(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B3098

B3098:                                            ; preds = %B611.i, %B2730.if, %B3098.critedge
  br i1 %beyond.2.1, label %B106.if.i, label %B3142

B104.loopexit.i.critedge:                         ; preds = %B106.if.i
  %.693.i.c = load i64, ptr %.692.i, align 8, !noalias !76
  %.810.i.c = inttoptr i64 %.693.i.c to ptr
  tail call void %.810.i.c(ptr %.496, ptr %.784.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !76
  br label %B104.loopexit.i

B104.loopexit.i:                                  ; preds = %B1330.i, %B104.loopexit.i.critedge
  %.284.i = icmp ugt i64 %.228.01213.i, 1
  br i1 %.284.i, label %B106.if.i, label %B674.i

B140.loopexit.i:                                  ; preds = %B122.if.i.i, %B140.if.i
  %exitcond1218.not.i = icmp eq i64 %arg.shape.0, %.415.i9736
  br i1 %exitcond1218.not.i, label %B306.i, label %B140.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.01205.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.01205.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep10076 = getelementptr double, ptr %invariant.gep10075, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep10076, align 8, !noalias !79
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %share.3.2.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.01205.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep10078 = getelementptr double, ptr %invariant.gep10077, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep10078, align 8, !noalias !79
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.01205.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep10080 = getelementptr double, ptr %invariant.gep10079, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep10080, align 8, !noalias !79
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %share.3.2.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.01205.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep10082 = getelementptr double, ptr %invariant.gep10081, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep10082, align 8, !noalias !79
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.01205.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep10084 = getelementptr double, ptr %invariant.gep10083, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep10084, align 8, !noalias !79
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %share.3.2.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.01205.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep10086 = getelementptr double, ptr %invariant.gep10085, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep10086, align 8, !noalias !79
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.01205.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep10088 = getelementptr double, ptr %invariant.gep10087, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep10088, align 8, !noalias !79
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %share.3.2.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.01205.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.01205.i, %arg.shape.0
  %gep10090 = getelementptr double, ptr %invariant.gep10089, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep10090, align 8, !noalias !79
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.360.i.i = add nsw i64 %.229.i.01205.i, %.359.i.i
  %.362.i.i9739 = mul nsw i64 %.360.i.i, %arg.shape.0
  %gep10092 = getelementptr double, ptr %invariant.gep10091, i64 %.362.i.i9739
  store double %.313.i.i.i, ptr %gep10092, align 8, !noalias !86
  %exitcond.not.i9740 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i9740, label %B140.loopexit.i, label %B122.if.i.i

B306.i:                                           ; preds = %B140.loopexit.i
  %.693.i = load i64, ptr %.692.i, align 8, !noalias !76
  %.810.i = inttoptr i64 %.693.i to ptr
  tail call void %.810.i(ptr %.496, ptr %.784.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !76
  br label %B454.if.i

B506.i:                                           ; preds = %B454.if.i
  %.1043.i = getelementptr double, ptr %226, i64 %.836.01211.i
  %.1044.i9746 = load double, ptr %.1043.i, align 8, !noalias !76
  %.1098.i = getelementptr double, ptr %227, i64 %.836.01211.i
  %.1099.i = load double, ptr %.1098.i, align 8, !noalias !76
  %.1100.i = fadd double %.1044.i9746, %.1099.i
  %.1101.i = fmul double %.1100.i, 5.000000e-01
  br label %B34.i.i9747

B34.i.i9747:                                      ; preds = %B34.if.i.i9748, %B506.i
  %.48.i.0.i = phi i64 [ 0, %B506.i ], [ %.119.i88.i, %B34.if.i.i9748 ]
  %exitcond1219.not.i = icmp eq i64 %.48.i.0.i, %storemerge1193.i
  br i1 %exitcond1219.not.i, label %B644.i, label %B34.if.i.i9748

B80.i.i9750:                                      ; preds = %B34.if.i.i9748
  %122 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %122, label %B618.i, label %B644.i

B34.if.i.i9748:                                   ; preds = %B34.i.i9747
  %.119.i88.i = add i64 %.48.i.0.i, 1
  %.149.i53.i = add nsw i64 %.48.i.0.i, %arg.decided
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.836.01211.i
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.arrays.4.5.0, i64 0
  %123 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %123, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !87
  %.184.i.i9749 = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i9749, label %B80.i.i9750, label %B34.i.i9747

B618.i:                                           ; preds = %B80.i.i9750
  store double %.1101.i, ptr %.1098.i, align 8, !noalias !76
  br label %B1330.i

B644.i:                                           ; preds = %B34.i.i9747, %B80.i.i9750
  store double %.1101.i, ptr %.1043.i, align 8, !noalias !76
  br label %B1330.i

B674.i:                                           ; preds = %B104.loopexit.i
  br i1 %.276.i, label %B3142, label %B706.if.i

B810.i:                                           ; preds = %B706.if.i
  %.1689.i = load double, ptr %.1465.i, align 8, !noalias !76
  %.1690.i = tail call double @llvm.fabs.f64(double %.1689.i)
  %.1691.i = fmul double %.1690.i, 2.000000e-12
  %.1748.i = getelementptr double, ptr %226, i64 %.1314.01215.i
  %.1749.i = load double, ptr %.1748.i, align 8, !noalias !76
  %.1804.i = getelementptr double, ptr %229, i64 %.1314.01215.i
  %.1805.i = load double, ptr %.1804.i, align 8, !noalias !76
  %.1862.i = fmul double %.1805.i, 0x3D719799812DEA11
  %.10.i.i9743 = fcmp ogt double %.1691.i, %.1862.i
  %.11.i.i9744 = select i1 %.10.i.i9743, double %.1691.i, double %.1862.i
  %.1750.i = fsub double 1.000000e+00, %.1749.i
  %.1806.i = fmul double %.1750.i, %.1805.i
  %.1891.i = fcmp ugt double %.1806.i, %.11.i.i9744
  br i1 %.1891.i, label %B1100.i, label %B1064.i

B1064.i:                                          ; preds = %B810.i
  store double 2.000000e+00, ptr %.1575.i, align 8, !noalias !76
  br label %B1329.i

B1100.i:                                          ; preds = %B810.i
  %124 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1314.01215.i
  %.1633.i = load i64, ptr %124, align 8, !noalias !76
  %.2010.i = getelementptr double, ptr %231, i64 %.1314.01215.i
  store double 0.000000e+00, ptr %.2010.i, align 8, !noalias !76
  %.2065.i = getelementptr double, ptr %232, i64 %.1314.01215.i
  store double 0.000000e+00, ptr %.2065.i, align 8, !noalias !76
  %.2120.i = getelementptr double, ptr %227, i64 %.1314.01215.i
  %.2121.i = load double, ptr %.2120.i, align 8, !noalias !76
  %.2176.i = load double, ptr %.1804.i, align 8, !noalias !76
  %.2177.i = fmul double %.2121.i, %.2176.i
  %.2233.i = getelementptr double, ptr %233, i64 %.1314.01215.i
  store double %.2177.i, ptr %.2233.i, align 8, !noalias !76
  %.2262.i = icmp slt i64 %.1633.i, 0
  %.2263.i = select i1 %.2262.i, i64 %arg.results.3.5.0, i64 0
  %.2264.i = add i64 %.2263.i, %.1633.i
  %.2284.i9745 = mul i64 %.2264.i, %arg.results.3.5.1
  %.2288.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2284.i9745
  %.2289.i = load i64, ptr %.2288.i, align 8, !noalias !76
  %.2290.i = add nsw i64 %.2289.i, -1
  store i64 %.2290.i, ptr %.2288.i, align 8, !noalias !76
  %.2398.i = getelementptr i8, ptr %.2288.i, i64 24
  %.2399.i = load i64, ptr %.2398.i, align 8, !noalias !76
  %.2400.i = add nsw i64 %.2399.i, 1
  store i64 %.2400.i, ptr %.2398.i, align 8, !noalias !76
  br label %B1329.i

B1329.i:                                          ; preds = %B706.if.i, %B1100.i, %B1064.i
  %exitcond1221.not.i = icmp eq i64 %.1384.i, %arg.shape.0
  br i1 %exitcond1221.not.i, label %B3142, label %B706.if.i

B1330.i:                                          ; preds = %B454.if.i, %B644.i, %B618.i
  %exitcond1220.not.i = icmp eq i64 %arg.shape.0, %.905.i9741
  br i1 %exitcond1220.not.i, label %B104.loopexit.i, label %B454.if.i

B106.if.i:                                        ; preds = %B3098, %B104.loopexit.i
  %.228.01213.i = phi i64 [ %.293.i, %B104.loopexit.i ], [ 50, %B3098 ]
  %.293.i = add nsw i64 %.228.01213.i, -1
  br i1 %.276.i, label %B104.loopexit.i.critedge, label %B140.if.i

B140.if.i:                                        ; preds = %B106.if.i, %B140.loopexit.i
  %.346.01208.i = phi i64 [ %.415.i9736, %B140.loopexit.i ], [ 0, %B106.if.i ]
  %.415.i9736 = add nsw i64 %.346.01208.i, 1
  %.496.i = getelementptr double, ptr %226, i64 %.346.01208.i
  %.497.i = load double, ptr %.496.i, align 8, !noalias !76
  %.551.i = getelementptr double, ptr %227, i64 %.346.01208.i
  %.552.i = load double, ptr %.551.i, align 8, !noalias !76
  %.553.i = fadd double %.497.i, %.552.i
  %.554.i = fmul double %.553.i, 5.000000e-01
  %.611.i = getelementptr double, ptr %228, i64 %.346.01208.i
  %.612.i = load double, ptr %.611.i, align 8, !noalias !76
  %.613.i9737 = fcmp une double %.612.i, 1.000000e+00
  %share.3.2.i = select i1 %.613.i9737, double 1.000000e+00, double %.554.i
  %.92.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.346.01208.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !86
  %.146.i.i = getelementptr double, ptr %229, i64 %.346.01208.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !86
  %.149.i.i = fmul double %share.3.2.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i9738 = getelementptr double, ptr %.496, i64 %.346.01208.i
  store double %.150.i.i, ptr %.203.i.i9738, align 8, !noalias !86
  br i1 %.287.i1204.not.i, label %B140.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B140.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep10075 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10077 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10079 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10081 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10083 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10085 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10087 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10089 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  %invariant.gep10091 = getelementptr double, ptr %arg.arrays.0.4, i64 %.346.01208.i
  br label %B122.if.i.i

B454.if.i:                                        ; preds = %B306.i, %B1330.i
  %.836.01211.i = phi i64 [ %.905.i9741, %B1330.i ], [ 0, %B306.i ]
  %.905.i9741 = add nsw i64 %.836.01211.i, 1
  %.986.i = getelementptr double, ptr %228, i64 %.836.01211.i
  %.987.i = load double, ptr %.986.i, align 8, !noalias !76
  %.988.i = fcmp oeq double %.987.i, 1.000000e+00
  br i1 %.988.i, label %B506.i, label %B1330.i

B706.if.i:                                        ; preds = %B674.i, %B1329.i
  %.1314.01215.i = phi i64 [ %.1384.i, %B1329.i ], [ 0, %B674.i ]
  %.1384.i = add nsw i64 %.1314.01215.i, 1
  %.1465.i = getelementptr double, ptr %230, i64 %.1314.01215.i
  %.1466.i = load double, ptr %.1465.i, align 8, !noalias !76
  %.1520.i = getelementptr double, ptr %.496, i64 %.1314.01215.i
  store double %.1466.i, ptr %.1520.i, align 8, !noalias !76
  %.1575.i = getelementptr double, ptr %228, i64 %.1314.01215.i
  %.1576.i = load double, ptr %.1575.i, align 8, !noalias !76
  %.1577.i = fcmp oeq double %.1576.i, 1.000000e+00
  br i1 %.1577.i, label %B810.i, label %B1329.i

B3142:                                            ; preds = %B1329.i, %B674.i, %B3098
  br i1 %.4521.not, label %B3204, label %B102.if.i

B102.loopexit.i.critedge:                         ; preds = %B102.if.i
  %.523.i.c = load i64, ptr %.522.i, align 8, !noalias !91
  %.640.i.c = inttoptr i64 %.523.i.c to ptr
  tail call void %.640.i.c(ptr %.496, ptr %.614.i9752, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !91
  br label %B102.loopexit.i

B102.loopexit.i:                                  ; preds = %B484.i, %B102.loopexit.i.critedge
  %exitcond692.not.i = icmp eq i64 %.227.0688.i, %.9690
  br i1 %exitcond692.not.i, label %B3204, label %B102.if.i

B136.loopexit.i:                                  ; preds = %B122.if.i.i9764, %B136.if.i
  %exitcond690.not.i = icmp eq i64 %arg.shape.0, %.419.i
  br i1 %exitcond690.not.i, label %B188.i, label %B136.if.i

B188.i:                                           ; preds = %B136.loopexit.i
  %.523.i = load i64, ptr %.522.i, align 8, !noalias !91
  %.640.i = inttoptr i64 %.523.i to ptr
  tail call void %.640.i(ptr %.496, ptr %.614.i9752, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !91
  br label %B336.if.i

B378.i:                                           ; preds = %B336.if.i
  %125 = getelementptr double, ptr %arg.arrays.4.4, i64 %.666.0686.i
  %.850.i = load double, ptr %125, align 8, !noalias !91
  %.852.i = fcmp olt double %.850.i, -1.000000e-09
  br i1 %.852.i, label %B414.i9813, label %B484.i

B414.i9813:                                       ; preds = %B378.i
  %126 = getelementptr i64, ptr %arg.lane.1.4, i64 %.666.0686.i
  %.84.i51.i = load i64, ptr %126, align 8, !noalias !94
  %.89.i.i9814 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i9814, label %B46.i.i9815, label %B414.endif.i

B46.i.i9815:                                      ; preds = %B414.i9813
  %.120.i73.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !94
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i9816, label %B414.endif.i

B80.i.i9816:                                      ; preds = %B46.i.i9815
  store i64 4, ptr %.120.i73.i, align 8, !noalias !94
  br label %B414.endif.i

B484.i:                                           ; preds = %B414.endif.i, %B336.if.i, %B378.i
  %exitcond691.not.i = icmp eq i64 %arg.shape.0, %.735.i
  br i1 %exitcond691.not.i, label %B102.loopexit.i, label %B336.if.i

B102.if.i:                                        ; preds = %B3142, %B102.loopexit.i
  %.227.0688.i = phi i64 [ %.298.i, %B102.loopexit.i ], [ 1, %B3142 ]
  %.298.i = add nsw i64 %.227.0688.i, 1
  br i1 %.276.i, label %B102.loopexit.i.critedge, label %B136.if.lr.ph.i

B136.if.lr.ph.i:                                  ; preds = %B102.if.i
  %127 = uitofp i64 %.227.0688.i to double
  %.452.i = fdiv double %127, %.448.i
  %.247.i.i.i9755 = fsub double 1.000000e+00, %.452.i
  br label %B136.if.i

B136.if.i:                                        ; preds = %B136.if.lr.ph.i, %B136.loopexit.i
  %.350.0683.i = phi i64 [ 0, %B136.if.lr.ph.i ], [ %.419.i, %B136.loopexit.i ]
  %.419.i = add nsw i64 %.350.0683.i, 1
  %.92.i.i9756 = getelementptr double, ptr %arg.lane.0.4, i64 %.350.0683.i
  %.93.i.i9757 = load double, ptr %.92.i.i9756, align 8, !noalias !97
  %.146.i.i9758 = getelementptr double, ptr %234, i64 %.350.0683.i
  %.147.i.i9759 = load double, ptr %.146.i.i9758, align 8, !noalias !97
  %.149.i.i9760 = fmul double %.452.i, %.147.i.i9759
  %.150.i.i9761 = fadd double %.93.i.i9757, %.149.i.i9760
  %.203.i.i9762 = getelementptr double, ptr %.496, i64 %.350.0683.i
  store double %.150.i.i9761, ptr %.203.i.i9762, align 8, !noalias !97
  br i1 %.287.i679.not.i, label %B136.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B136.if.i
  %invariant.gep10093 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10095 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10097 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10099 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10101 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10103 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10105 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10107 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  %invariant.gep10109 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0683.i
  br label %B122.if.i.i9764

B122.if.i.i9764:                                  ; preds = %B122.if.i.i9764, %B122.if.i.preheader.i
  %.229.i.0680.i = phi i64 [ %.300.i.i9806, %B122.if.i.i9764 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i9765 = add nsw i64 %.229.i.0680.i, %.155.i.i.i9763
  %.159.i.i.i9766 = mul nsw i64 %.157.i.i.i9765, %arg.shape.0
  %gep10094 = getelementptr double, ptr %invariant.gep10093, i64 %.159.i.i.i9766
  %.191.i.i.i9767 = load double, ptr %gep10094, align 8, !noalias !101
  %.193.i.i.i9768 = fadd double %.191.i.i.i9767, 0.000000e+00
  %.253.i.i.i9769 = fmul double %.452.i, %.193.i.i.i9768
  %.157.i.i.1.i9771 = add nsw i64 %.229.i.0680.i, %.155.i.i.1.i9770
  %.159.i.i.1.i9772 = mul nsw i64 %.157.i.i.1.i9771, %arg.shape.0
  %gep10096 = getelementptr double, ptr %invariant.gep10095, i64 %.159.i.i.1.i9772
  %.191.i.i.1.i9773 = load double, ptr %gep10096, align 8, !noalias !101
  %.193.i.i.1.i9774 = fadd double %.191.i.i.1.i9773, %.253.i.i.i9769
  %.253.i.i.1.i9775 = fmul double %.247.i.i.i9755, %.193.i.i.1.i9774
  %.157.i.i.2.i9777 = add nsw i64 %.229.i.0680.i, %.155.i.i.2.i9776
  %.159.i.i.2.i9778 = mul nsw i64 %.157.i.i.2.i9777, %arg.shape.0
  %gep10098 = getelementptr double, ptr %invariant.gep10097, i64 %.159.i.i.2.i9778
  %.191.i.i.2.i9779 = load double, ptr %gep10098, align 8, !noalias !101
  %.193.i.i.2.i9780 = fadd double %.191.i.i.2.i9779, %.253.i.i.1.i9775
  %.253.i.i.2.i9781 = fmul double %.452.i, %.193.i.i.2.i9780
  %.157.i.i.3.i9783 = add nsw i64 %.229.i.0680.i, %.155.i.i.3.i9782
  %.159.i.i.3.i9784 = mul nsw i64 %.157.i.i.3.i9783, %arg.shape.0
  %gep10100 = getelementptr double, ptr %invariant.gep10099, i64 %.159.i.i.3.i9784
  %.191.i.i.3.i9785 = load double, ptr %gep10100, align 8, !noalias !101
  %.193.i.i.3.i9786 = fadd double %.191.i.i.3.i9785, %.253.i.i.2.i9781
  %.253.i.i.3.i9787 = fmul double %.247.i.i.i9755, %.193.i.i.3.i9786
  %.157.i.i.4.i9789 = add nsw i64 %.229.i.0680.i, %.155.i.i.4.i9788
  %.159.i.i.4.i9790 = mul nsw i64 %.157.i.i.4.i9789, %arg.shape.0
  %gep10102 = getelementptr double, ptr %invariant.gep10101, i64 %.159.i.i.4.i9790
  %.191.i.i.4.i9791 = load double, ptr %gep10102, align 8, !noalias !101
  %.193.i.i.4.i9792 = fadd double %.191.i.i.4.i9791, %.253.i.i.3.i9787
  %.253.i.i.4.i9793 = fmul double %.452.i, %.193.i.i.4.i9792
  %.157.i.i.5.i9795 = add nsw i64 %.229.i.0680.i, %.155.i.i.5.i9794
  %.159.i.i.5.i9796 = mul nsw i64 %.157.i.i.5.i9795, %arg.shape.0
  %gep10104 = getelementptr double, ptr %invariant.gep10103, i64 %.159.i.i.5.i9796
  %.191.i.i.5.i9797 = load double, ptr %gep10104, align 8, !noalias !101
  %.193.i.i.5.i9798 = fadd double %.191.i.i.5.i9797, %.253.i.i.4.i9793
  %.253.i.i.5.i9799 = fmul double %.247.i.i.i9755, %.193.i.i.5.i9798
  %.157.i.i.6.i9801 = add nsw i64 %.229.i.0680.i, %.155.i.i.6.i9800
  %.159.i.i.6.i9802 = mul nsw i64 %.157.i.i.6.i9801, %arg.shape.0
  %gep10106 = getelementptr double, ptr %invariant.gep10105, i64 %.159.i.i.6.i9802
  %.191.i.i.6.i9803 = load double, ptr %gep10106, align 8, !noalias !101
  %.193.i.i.6.i9804 = fadd double %.191.i.i.6.i9803, %.253.i.i.5.i9799
  %.253.i.i.6.i9805 = fmul double %.452.i, %.193.i.i.6.i9804
  %.300.i.i9806 = add nsw i64 %.229.i.0680.i, 1
  %.271.i.i.i9807 = mul nsw i64 %.229.i.0680.i, %arg.shape.0
  %gep10108 = getelementptr double, ptr %invariant.gep10107, i64 %.271.i.i.i9807
  %.309.i.i.i9808 = load double, ptr %gep10108, align 8, !noalias !101
  %.313.i.i.i9809 = fadd double %.309.i.i.i9808, %.253.i.i.6.i9805
  %.360.i.i9810 = add nsw i64 %.229.i.0680.i, %.359.i.i9753
  %.362.i.i9811 = mul nsw i64 %.360.i.i9810, %arg.shape.0
  %gep10110 = getelementptr double, ptr %invariant.gep10109, i64 %.362.i.i9811
  store double %.313.i.i.i9809, ptr %gep10110, align 8, !noalias !97
  %exitcond.not.i9812 = icmp eq i64 %arg.shape.1, %.300.i.i9806
  br i1 %exitcond.not.i9812, label %B136.loopexit.i, label %B122.if.i.i9764

B336.if.i:                                        ; preds = %B188.i, %B484.i
  %.666.0686.i = phi i64 [ %.735.i, %B484.i ], [ 0, %B188.i ]
  %.735.i = add nsw i64 %.666.0686.i, 1
  %128 = getelementptr double, ptr %235, i64 %.666.0686.i
  %.817.i = load double, ptr %128, align 8, !noalias !91
  %.818.i = fcmp ogt double %.817.i, 5.000000e-01
  br i1 %.818.i, label %B378.i, label %B484.i

B414.endif.i:                                     ; preds = %B80.i.i9816, %B46.i.i9815, %B414.i9813
  store double 0.000000e+00, ptr %128, align 8, !noalias !91
  br label %B484.i

B3204:                                            ; preds = %B102.loopexit.i, %B2672, %B3142
  br i1 %wanted.2.1, label %B3212, label %B3264

B3212:                                            ; preds = %B3204
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge9693 = select i1 %within.5.1.not, i1 true, i1 %.539
  %"$phi3248.7.2.2" = select i1 %brmerge9693, i64 0, i64 3
  br i1 %.276.i, label %B3356, label %B78.if.i

B154.i:                                           ; preds = %B78.if.i
  %.448.i9820 = getelementptr double, ptr %237, i64 %.176.0654.i
  %.449.i = load double, ptr %.448.i9820, align 8, !noalias !105
  %.450.i = fcmp olt double %.449.i, 5.000000e-01
  br i1 %.450.i, label %B772.i, label %B192.i

B192.i:                                           ; preds = %B154.i
  %.481.i = getelementptr i64, ptr %arg.results.1.4, i64 %.330.i
  %.482.i = load i64, ptr %.481.i, align 8, !noalias !105
  %.483.not.i = icmp eq i64 %.482.i, 0
  br i1 %.483.not.i, label %B228.i, label %B772.i

B228.i:                                           ; preds = %B192.i
  %.545.i = mul i64 %.330.i, %arg.results.3.5.1
  %129 = getelementptr i64, ptr %arg.results.3.4, i64 %.545.i
  %.549.i9821 = getelementptr i8, ptr %129, i64 8
  %.550.i = load i64, ptr %.549.i9821, align 8, !noalias !105
  %.552.i9822 = add nsw i64 %.550.i, %"$phi3248.7.2.2"
  store i64 %.552.i9822, ptr %.549.i9821, align 8, !noalias !105
  %.658.i = getelementptr double, ptr %arg.lane.0.4, i64 %.176.0654.i
  %.659.i = load double, ptr %.658.i, align 8, !noalias !105
  %.713.i = getelementptr double, ptr %238, i64 %.176.0654.i
  %.714.i = load double, ptr %.713.i, align 8, !noalias !105
  %.768.i = getelementptr double, ptr %239, i64 %.176.0654.i
  %.769.i = load double, ptr %.768.i, align 8, !noalias !105
  %.790.i = icmp slt i64 %.385.i, %arg.times.5.0
  br i1 %.790.i, label %B402.i, label %B742.i

B402.i:                                           ; preds = %B228.i
  %.813.i9823 = icmp slt i64 %.385.i, 0
  %.814.i9824 = select i1 %.813.i9823, i64 %arg.times.5.0, i64 0
  %130 = getelementptr double, ptr %arg.times.4, i64 %.385.i
  %.828.i = getelementptr double, ptr %130, i64 %.814.i9824
  %.829.i9825 = load double, ptr %.828.i, align 8, !noalias !105
  %.833.i = fcmp ugt double %.829.i9825, %.769.i
  br i1 %.833.i, label %B742.i, label %B426.preheader.i

B426.preheader.i:                                 ; preds = %B402.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.330.i
  %.1320.i = getelementptr double, ptr %240, i64 %.176.0654.i
  %131 = getelementptr double, ptr %arg.results.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep10111 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10113 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10115 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10117 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10119 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10121 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10123 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10125 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  %invariant.gep10127 = getelementptr double, ptr %arg.arrays.0.4, i64 %.176.0654.i
  br label %B426.i

B426.i:                                           ; preds = %B718.i, %B426.preheader.i
  %done.2.3.i = phi i64 [ %.1258.i, %B718.i ], [ %.385.i, %B426.preheader.i ]
  br i1 %.920649.not.i, label %B626.i, label %B456.if.lr.ph.i

B456.if.lr.ph.i:                                  ; preds = %B426.i
  %.975.i = icmp slt i64 %done.2.3.i, 0
  %.976.i9826 = select i1 %.975.i, i64 %arg.times.5.0, i64 0
  %132 = getelementptr double, ptr %arg.times.4, i64 %done.2.3.i
  %.990.i = getelementptr double, ptr %132, i64 %.976.i9826
  %.1216.i = select i1 %.975.i, i64 %arg.results.0.5.1, i64 0
  %.1217.i = add i64 %.1216.i, %done.2.3.i
  %.1246.i = mul i64 %.1217.i, %arg.results.0.5.2
  %133 = getelementptr double, ptr %131, i64 %.1246.i
  br label %B456.if.i

B484.i9834:                                       ; preds = %B456.if.i
  %.998.i = add nsw i64 %.864.0650.i, %.996.i
  %.1000.i9835 = mul nsw i64 %.998.i, %arg.shape.0
  %gep10128 = getelementptr double, ptr %invariant.gep10127, i64 %.1000.i9835
  %.1032.i = load double, ptr %gep10128, align 8, !noalias !105
  br label %B771.i

B626.i:                                           ; preds = %B771.i, %B426.i
  store double 0x7FF0000000000000, ptr %.1320.i, align 8, !noalias !105
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %241
  br i1 %exitcond656.not.i, label %B742.i, label %B718.i

B718.i:                                           ; preds = %B626.i
  %.1258.i = add i64 %done.2.3.i, 1
  %.1355.i = icmp slt i64 %done.2.3.i, -1
  %.1356.i = select i1 %.1355.i, i64 %arg.times.5.0, i64 0
  %134 = getelementptr double, ptr %arg.times.4, i64 %.1258.i
  %.1370.i = getelementptr double, ptr %134, i64 %.1356.i
  %.1371.i = load double, ptr %.1370.i, align 8, !noalias !105
  %.1375.i = fcmp ugt double %.1371.i, %.769.i
  br i1 %.1375.i, label %B742.i, label %B426.i

B742.i:                                           ; preds = %B718.i, %B626.i, %B402.i, %B228.i
  %done.3.2.i = phi i64 [ %.385.i, %B402.i ], [ %.385.i, %B228.i ], [ %arg.times.5.0, %B626.i ], [ %.1258.i, %B718.i ]
  store i64 %done.3.2.i, ptr %.384.i, align 8, !noalias !105
  br label %B772.i

B771.i:                                           ; preds = %B38.if.i.i, %B484.i9834
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1032.i, %B484.i9834 ]
  %135 = getelementptr double, ptr %133, i64 %.864.0650.i
  store double %.313.i.i.sink, ptr %135, align 8, !noalias !105
  %exitcond.not.i9833 = icmp eq i64 %arg.shape.1, %.933.i
  br i1 %exitcond.not.i9833, label %B626.i, label %B456.if.i

B772.i:                                           ; preds = %B78.if.i, %B742.i, %B192.i, %B154.i
  %exitcond657.not.i = icmp eq i64 %.248.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3264, label %B78.if.i

B78.if.i:                                         ; preds = %B3212, %B772.i
  %.176.0654.i = phi i64 [ %.248.i, %B772.i ], [ 0, %B3212 ]
  %.248.i = add nsw i64 %.176.0654.i, 1
  %.329.i9818 = getelementptr i64, ptr %arg.lane.1.4, i64 %.176.0654.i
  %.330.i = load i64, ptr %.329.i9818, align 8, !noalias !105
  %.384.i = getelementptr i64, ptr %236, i64 %.176.0654.i
  %.385.i = load i64, ptr %.384.i, align 8, !noalias !105
  %.393.i9819 = icmp slt i64 %.330.i, 0
  br i1 %.393.i9819, label %B772.i, label %B154.i

B456.if.i:                                        ; preds = %B771.i, %B456.if.lr.ph.i
  %.864.0650.i = phi i64 [ 0, %B456.if.lr.ph.i ], [ %.933.i, %B771.i ]
  %.933.i = add nsw i64 %.864.0650.i, 1
  %.991.i = load double, ptr %.990.i, align 8, !noalias !105
  %.993.i = fcmp oeq double %.991.i, %.769.i
  br i1 %.993.i, label %B484.i9834, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B456.if.i
  %.1141.i9830 = fsub double %.991.i, %.659.i
  %.1146.i = fdiv double %.1141.i9830, %.714.i
  %.247.i.i = fsub double 1.000000e+00, %.1146.i
  %.157.i.i = add nsw i64 %.864.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep10112 = getelementptr double, ptr %invariant.gep10111, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep10112, align 8, !noalias !108
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i9831 = fmul double %.1146.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.864.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep10114 = getelementptr double, ptr %invariant.gep10113, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep10114, align 8, !noalias !108
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i9831
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.864.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep10116 = getelementptr double, ptr %invariant.gep10115, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep10116, align 8, !noalias !108
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1146.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.864.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep10118 = getelementptr double, ptr %invariant.gep10117, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep10118, align 8, !noalias !108
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.864.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep10120 = getelementptr double, ptr %invariant.gep10119, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep10120, align 8, !noalias !108
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1146.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.864.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep10122 = getelementptr double, ptr %invariant.gep10121, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep10122, align 8, !noalias !108
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.864.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep10124 = getelementptr double, ptr %invariant.gep10123, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep10124, align 8, !noalias !108
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1146.i, %.193.i.6.i
  %.271.i.i9832 = mul nsw i64 %.864.0650.i, %arg.shape.0
  %gep10126 = getelementptr double, ptr %invariant.gep10125, i64 %.271.i.i9832
  %.309.i.i = load double, ptr %gep10126, align 8, !noalias !108
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B771.i

B3264:                                            ; preds = %B772.i, %B3204
  br i1 %.276.i, label %B3356, label %B3298.if

B3356:                                            ; preds = %B3298.if, %B3212, %B3264
  %taken.2.1.lcssa = phi i64 [ 0, %B3264 ], [ 0, %B3212 ], [ %.4942, %B3298.if ]
  %.4958 = icmp eq i64 %taken.2.1.lcssa, %arg.shape.0
  %or.cond9696 = select i1 %.537.not, i1 true, i1 %.4958
  br i1 %or.cond9696, label %B3372, label %B48.i3923.preheader

B48.i3923.preheader:                              ; preds = %B3356
  br i1 %.276.i, label %B3476, label %B48.if.i

B3372:                                            ; preds = %B3356
  %.4993 = load i64, ptr %.4992, align 8
  %.5038 = inttoptr i64 %.4993 to ptr
  tail call void %.5038(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B3476

B90.i:                                            ; preds = %B48.if.i
  %.281.i4048 = getelementptr double, ptr %244, i64 %.72.i3861.010139
  %.282.i4049 = load double, ptr %.281.i4048, align 8, !noalias !112
  %.336.i4096 = getelementptr double, ptr %arg.lane.0.4, i64 %.72.i3861.010139
  store double %.282.i4049, ptr %.336.i4096, align 8, !noalias !112
  br i1 %.418.i413310134.not, label %B244.i3997, label %B170.if.i.preheader

B170.if.i.preheader:                              ; preds = %B90.i
  %invariant.gep10205 = getelementptr double, ptr %arg.arrays.0.4, i64 %.72.i3861.010139
  %invariant.gep10207 = getelementptr double, ptr %arg.arrays.0.4, i64 %.72.i3861.010139
  br label %B170.if.i

B244.i3997:                                       ; preds = %B170.if.i, %B90.i, %B48.if.i
  %.130.i3928 = icmp sgt i64 %.75.i3862.010138, 1
  br i1 %.130.i3928, label %B48.if.i, label %B3476

B48.if.i:                                         ; preds = %B48.i3923.preheader, %B244.i3997
  %.72.i3861.010139 = phi i64 [ %.143.i4227, %B244.i3997 ], [ 0, %B48.i3923.preheader ]
  %.75.i3862.010138 = phi i64 [ %.139.i4224, %B244.i3997 ], [ %storemerge, %B48.i3923.preheader ]
  %.139.i4224 = add nsw i64 %.75.i3862.010138, -1
  %.143.i4227 = add nsw i64 %.72.i3861.010139, 1
  %.224.i3994 = getelementptr double, ptr %243, i64 %.72.i3861.010139
  %.225.i3995 = load double, ptr %.224.i3994, align 8, !noalias !112
  %.226.i3996 = fcmp ogt double %.225.i3995, 5.000000e-01
  br i1 %.226.i3996, label %B90.i, label %B244.i3997

B170.if.i:                                        ; preds = %B170.if.i.preheader, %B170.if.i
  %.362.i3875.010135 = phi i64 [ %.431.i4212, %B170.if.i ], [ 0, %B170.if.i.preheader ]
  %.431.i4212 = add nsw i64 %.362.i3875.010135, 1
  %.458.i4145 = add nsw i64 %.362.i3875.010135, %.457.i4144
  %.460.i4147 = mul nsw i64 %.458.i4145, %arg.shape.0
  %gep10206 = getelementptr double, ptr %invariant.gep10205, i64 %.460.i4147
  %.492.i4175 = load double, ptr %gep10206, align 8, !noalias !112
  %.494.i4177 = mul nsw i64 %.362.i3875.010135, %arg.shape.0
  %gep10208 = getelementptr double, ptr %invariant.gep10207, i64 %.494.i4177
  store double %.492.i4175, ptr %gep10208, align 8, !noalias !112
  %exitcond10187.not = icmp eq i64 %arg.shape.1, %.431.i4212
  br i1 %exitcond10187.not, label %B244.i3997, label %B170.if.i

B3476:                                            ; preds = %B244.i3997, %B48.i3923.preheader, %B3372
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge10171 = or i1 %.276.i, %beyond.2.1.not
  br i1 %brmerge10171, label %B3520, label %B62.if.i

B116.i4483:                                       ; preds = %B62.if.i
  %.347.i4531 = getelementptr double, ptr %246, i64 %.137.i4328.010147
  %.348.i4532 = load double, ptr %.347.i4531, align 8, !noalias !116
  %.349.i4533 = fcmp ogt double %.348.i4532, 5.000000e-01
  br i1 %.349.i4533, label %B156.i, label %B722.i

B156.i:                                           ; preds = %B116.i4483
  %.404.i4581 = getelementptr double, ptr %arg.lane.0.4, i64 %.137.i4328.010147
  %.405.i4582 = load double, ptr %.404.i4581, align 8, !noalias !116
  %.459.i4630 = getelementptr double, ptr %247, i64 %.137.i4328.010147
  %.460.i4631 = load double, ptr %.459.i4630, align 8, !noalias !116
  %.461.i4632 = fsub double %.405.i4582, %.460.i4631
  br i1 %.548.i467010140.not, label %B362.i, label %B252.if.i.preheader

B252.if.i.preheader:                              ; preds = %B156.i
  %invariant.gep10209 = getelementptr double, ptr %arg.arrays.0.4, i64 %.137.i4328.010147
  br label %B252.if.i

B362.i:                                           ; preds = %B252.if.i, %B156.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B156.i ], [ %.11.i.i, %B252.if.i ]
  %.662.i4682 = fmul double %.461.i4632, %fastest.2.i.2.lcssa
  %.694.i4708 = load double, ptr %.693.i4707, align 8, !noalias !116
  %.695.i4709 = fcmp ogt double %.662.i4682, %.694.i4708
  %.9697 = select i1 %.695.i4709, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.739.i4738 = load double, ptr %.738.i4737, align 8, !noalias !116
  %.769.i4760 = load double, ptr %arg.times.4, align 8, !noalias !116
  %.770.i4761 = fsub double %.739.i4738, %.769.i4760
  %.772.i4763 = fmul double %.9697, %.770.i4761
  %.776.i4766 = fcmp olt double %.461.i4632, %.772.i4763
  br i1 %.776.i4766, label %B472.i, label %B510.i

B472.i:                                           ; preds = %B362.i
  %136 = getelementptr i64, ptr %249, i64 %.137.i4328.010147
  %.834.i5201 = load i64, ptr %136, align 8, !noalias !116
  %.835.i5202 = add nsw i64 %.834.i5201, 1
  br label %B510.i

B510.i:                                           ; preds = %B362.i, %B472.i
  %"$phi510.1.2.i.2" = phi i64 [ %.835.i5202, %B472.i ], [ 0, %B362.i ]
  %137 = getelementptr i64, ptr %250, i64 %.137.i4328.010147
  store i64 %"$phi510.1.2.i.2", ptr %137, align 8, !noalias !116
  %.955.i4863 = load double, ptr %.404.i4581, align 8, !noalias !116
  store double %.955.i4863, ptr %.459.i4630, align 8, !noalias !116
  %.1064.i4946 = getelementptr double, ptr %251, i64 %.137.i4328.010147
  store double 1.000000e+00, ptr %.1064.i4946, align 8, !noalias !116
  store i64 1, ptr %.723, align 8, !noalias !116
  %.1150.i5012 = load i64, ptr %137, align 8, !noalias !116
  %.1151.i5013 = icmp sgt i64 %.1150.i5012, 1000
  br i1 %.1151.i5013, label %B676.i, label %B722.i

B676.i:                                           ; preds = %B510.i
  %138 = getelementptr i64, ptr %arg.lane.1.4, i64 %.137.i4328.010147
  %.84.i.i5092 = load i64, ptr %138, align 8, !noalias !120
  %.89.i.i5095 = icmp sgt i64 %.84.i.i5092, -1
  br i1 %.89.i.i5095, label %B46.i.i5102, label %B722.i

B46.i.i5102:                                      ; preds = %B676.i
  %.120.i.i5122 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i5092
  %.121.i.i5123 = load i64, ptr %.120.i.i5122, align 8, !noalias !120
  %.122.i.i5124 = icmp eq i64 %.121.i.i5123, 0
  br i1 %.122.i.i5124, label %B80.i.i5129, label %B722.i

B80.i.i5129:                                      ; preds = %B46.i.i5102
  store i64 6, ptr %.120.i.i5122, align 8, !noalias !120
  br label %B722.i

B722.i:                                           ; preds = %B80.i.i5129, %B676.i, %B46.i.i5102, %B510.i, %B116.i4483, %B62.if.i
  %.196.i4414 = icmp sgt i64 %.140.i4329.010146, 1
  br i1 %.196.i4414, label %B62.if.i, label %B3520

B62.if.i:                                         ; preds = %B3476, %B722.i
  %.137.i4328.010147 = phi i64 [ %.209.i5272, %B722.i ], [ 0, %B3476 ]
  %.140.i4329.010146 = phi i64 [ %.205.i5269, %B722.i ], [ %storemerge, %B3476 ]
  %.205.i5269 = add nsw i64 %.140.i4329.010146, -1
  %.209.i5272 = add nsw i64 %.137.i4328.010147, 1
  %.290.i4479 = getelementptr double, ptr %245, i64 %.137.i4328.010147
  %.291.i4480 = load double, ptr %.290.i4479, align 8, !noalias !116
  %.292.i4481 = fcmp oeq double %.291.i4480, 2.000000e+00
  br i1 %.292.i4481, label %B116.i4483, label %B722.i

B252.if.i:                                        ; preds = %B252.if.i.preheader, %B252.if.i
  %fastest.2.i.210143 = phi double [ %.11.i.i, %B252.if.i ], [ 0.000000e+00, %B252.if.i.preheader ]
  %.492.i4343.010142 = phi i64 [ %.561.i5257, %B252.if.i ], [ 0, %B252.if.i.preheader ]
  %.561.i5257 = add nsw i64 %.492.i4343.010142, 1
  %.588.i5209 = add nsw i64 %.492.i4343.010142, %arg.shape.1
  %.590.i5211 = mul nsw i64 %.588.i5209, %arg.shape.0
  %gep10210 = getelementptr double, ptr %invariant.gep10209, i64 %.590.i5211
  %.622.i5239 = load double, ptr %gep10210, align 8, !noalias !116
  %.623.i5240 = tail call double @llvm.fabs.f64(double %.622.i5239)
  %.10.i.i = fcmp ogt double %.623.i5240, %fastest.2.i.210143
  %.11.i.i = select i1 %.10.i.i, double %.623.i5240, double %fastest.2.i.210143
  %exitcond10188.not = icmp eq i64 %arg.shape.1, %.561.i5257
  br i1 %exitcond10188.not, label %B362.i, label %B252.if.i

B3520:                                            ; preds = %B722.i, %B3476
  %brmerge9698.not = and i1 %.5139.not, %looked.4.2.lcssa
  %brmerge9698.not.not = xor i1 %brmerge9698.not, true
  %brmerge10170 = or i1 %.276.i, %brmerge9698.not.not
  br i1 %brmerge10170, label %B3574, label %B96.if.i

B46.i.i9838:                                      ; preds = %B96.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !123
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i9848, label %B270.i9839

B80.i.i9848:                                      ; preds = %B46.i.i9838
  %.196.i.i = getelementptr double, ptr %252, i64 %.346.01939.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !123
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B270.i9839, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i9848
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.346.01939.i
  %.265.i.i9849 = load double, ptr %.264.i.i, align 8, !noalias !123
  %.321.i.i = getelementptr double, ptr %253, i64 %.346.01939.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !123
  %.325.i.i = fcmp une double %.265.i.i9849, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.190.i5541935.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01941.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01941.i
  br i1 %brmerge.i, label %B270.i9839, label %B76.if.i.lr.ph.i9850

B76.if.i.lr.ph.i9850:                             ; preds = %B122.i.i
  %.641.i = getelementptr i64, ptr %254, i64 %.346.01939.i
  %.642.i = load i64, ptr %.641.i, align 8, !noalias !128
  %.643.i = add nsw i64 %.642.i, 1
  %139 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.587.i = load i64, ptr %139, align 8, !noalias !128
  %.259.i.i = icmp slt i64 %.587.i, 0
  %.260.i581.i = select i1 %.259.i.i, i64 %arg.schedule.3.5.0, i64 0
  %.261.i.i = add i64 %.260.i581.i, %.587.i
  %.262.i.i = icmp slt i64 %.642.i, -1
  %.263.i582.i = select i1 %.262.i.i, i64 %arg.schedule.3.5.1, i64 0
  %.264.i583.i = add i64 %.643.i, %.263.i582.i
  %.291.i599.i = mul i64 %.289.i.i9836, %.261.i.i
  %.293.i601.i = mul i64 %.264.i583.i, %arg.schedule.3.5.2
  %140 = getelementptr double, ptr %arg.schedule.3.4, i64 %.291.i599.i
  %141 = getelementptr double, ptr %140, i64 %.293.i601.i
  br label %B76.if.i.i9851

B76.if.i.i9851:                                   ; preds = %B76.if.i.i9851, %B76.if.i.lr.ph.i9850
  %.132.i508.01936.i = phi i64 [ 0, %B76.if.i.lr.ph.i9850 ], [ %.203.i.i9852, %B76.if.i.i9851 ]
  %.203.i.i9852 = add nsw i64 %.132.i508.01936.i, 1
  %142 = getelementptr double, ptr %141, i64 %.132.i508.01936.i
  %.298.i606.i = load double, ptr %142, align 8, !noalias !129
  %143 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.132.i508.01936.i
  %.328.i.i9853 = load i64, ptr %143, align 8, !noalias !129
  %.330.i.i = mul nsw i64 %.328.i.i9853, %arg.shape.0
  %.332.i.i9854 = add nsw i64 %.330.i.i, %.346.01939.i
  %.346.i.i9855 = icmp slt i64 %.332.i.i9854, 0
  %.347.i.i = select i1 %.346.i.i9855, i64 %arg.arrays.1.5.0, i64 0
  %144 = getelementptr double, ptr %arg.arrays.1.4, i64 %.332.i.i9854
  %.361.i.i = getelementptr double, ptr %144, i64 %.347.i.i
  store double %.298.i606.i, ptr %.361.i.i, align 8, !noalias !129
  %exitcond.not.i9856 = icmp eq i64 %arg.schedule.2.5.0, %.203.i.i9852
  br i1 %exitcond.not.i9856, label %B270.i9839, label %B76.if.i.i9851

B270.i9839:                                       ; preds = %B76.if.i.i9851, %B96.if.i, %B122.i.i, %B80.i.i9848, %B46.i.i9838
  %some.3.1.i = phi i1 [ %some.2.01941.mux.i, %B122.i.i ], [ %some.2.01941.i, %B80.i.i9848 ], [ %some.2.01941.i, %B96.if.i ], [ %some.2.01941.i, %B46.i.i9838 ], [ true, %B76.if.i.i9851 ]
  %exitcond1953.not.i = icmp eq i64 %arg.shape.0, %.417.i9837
  br i1 %exitcond1953.not.i, label %B272.i, label %B96.if.i

B272.i:                                           ; preds = %B270.i9839
  br i1 %some.3.1.i, label %B280.i, label %B3574

B280.i:                                           ; preds = %B272.i
  %.775.i9840 = load i64, ptr %.774.i, align 8, !noalias !128
  %.887.i9841 = inttoptr i64 %.775.i9840 to ptr
  tail call void %.887.i9841(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !128
  %.918.i = load i64, ptr %.917.i, align 8, !noalias !128
  %.1034.i = inttoptr i64 %.918.i to ptr
  tail call void %.1034.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1033.i), !noalias !128
  br label %B512.if.i

B46.i82.i:                                        ; preds = %B512.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !133
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B892.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %252, i64 %.1060.01948.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !133
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B892.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1060.01948.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !133
  %.321.i223.i = getelementptr double, ptr %253, i64 %.1060.01948.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !133
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B892.i, label %B552.i

B552.i:                                           ; preds = %B122.i147.i
  %.1314.i = getelementptr i64, ptr %255, i64 %.1060.01948.i
  %.1315.i = load i64, ptr %.1314.i, align 8, !noalias !128
  %.1326.i = icmp sgt i64 %.1315.i, 0
  br i1 %.1326.i, label %B628.i, label %B682.i

B628.i:                                           ; preds = %B552.i
  %145 = getelementptr double, ptr %arg.times.4, i64 %.1315.i
  %.1361.i = getelementptr i8, ptr %145, i64 -8
  %.1362.i = load double, ptr %.1361.i, align 8, !noalias !128
  %.1418.i = fcmp oeq double %.1362.i, %.265.i185.i
  br label %B682.i

B682.i:                                           ; preds = %B628.i, %B552.i
  %"$phi682.1.2.1.i" = phi i1 [ %.1418.i, %B628.i ], [ false, %B552.i ]
  br i1 %.15141942.not.i, label %B892.i, label %B714.if.lr.ph.i

B714.if.lr.ph.i:                                  ; preds = %B682.i
  %.1644.i = add nsw i64 %.1315.i, -1
  %.1683.i = select i1 %.1326.i, i64 0, i64 %arg.results.0.5.1
  %.1684.i = add i64 %.1644.i, %.1683.i
  %.1711.i = mul i64 %.1709.i, %.99.i78.i
  %.1713.i = mul i64 %.1684.i, %arg.results.0.5.2
  %146 = getelementptr double, ptr %arg.results.0.4, i64 %.1711.i
  %147 = getelementptr double, ptr %146, i64 %.1713.i
  %invariant.gep10148 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1060.01948.i
  %invariant.gep10150 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1060.01948.i
  br label %B714.if.i

B810.i9847:                                       ; preds = %B714.if.i
  %148 = getelementptr double, ptr %147, i64 %.1458.01943.i
  store double %.1592.i, ptr %148, align 8, !noalias !128
  br label %B832.i

B832.i:                                           ; preds = %B714.if.i, %B810.i9847
  %exitcond1954.not.i = icmp eq i64 %arg.shape.1, %.1527.i
  br i1 %exitcond1954.not.i, label %B834.loopexit.i, label %B714.if.i

B834.loopexit.i:                                  ; preds = %B832.i
  %149 = fcmp une double %.1599.i, 0.000000e+00
  br i1 %149, label %B846.i, label %B892.i

B846.i:                                           ; preds = %B834.loopexit.i
  %.84.i687.i = load i64, ptr %152, align 8, !noalias !136
  %.89.i689.i = icmp sgt i64 %.84.i687.i, -1
  br i1 %.89.i689.i, label %B46.i693.i, label %B892.i

B46.i693.i:                                       ; preds = %B846.i
  %.120.i714.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i687.i
  %.121.i715.i = load i64, ptr %.120.i714.i, align 8, !noalias !136
  %.122.i716.i = icmp eq i64 %.121.i715.i, 0
  br i1 %.122.i716.i, label %B80.i720.i, label %B892.i

B80.i720.i:                                       ; preds = %B46.i693.i
  store i64 3, ptr %.120.i714.i, align 8, !noalias !136
  br label %B892.i

B892.i:                                           ; preds = %B512.if.i, %B80.i720.i, %B46.i693.i, %B846.i, %B834.loopexit.i, %B682.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1955.not.i = icmp eq i64 %arg.shape.0, %.1129.i
  br i1 %exitcond1955.not.i, label %B894.i, label %B512.if.i

B894.i:                                           ; preds = %B892.i
  br i1 %.1798.not.i, label %B3574, label %B898.i

B898.i:                                           ; preds = %B894.i
  %.1831.i9844 = load i64, ptr %.1830.i, align 8, !noalias !128
  %.1945.i = inttoptr i64 %.1831.i9844 to ptr
  tail call void %.1945.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !128
  br label %B1018.if.i

B46.i315.i:                                       ; preds = %B1018.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !139
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1140.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %252, i64 %.1981.01951.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !139
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1140.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1981.01951.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !139
  %.321.i456.i = getelementptr double, ptr %253, i64 %.1981.01951.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !139
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1140.i, label %B1058.i

B1058.i:                                          ; preds = %B122.i380.i
  %150 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1981.01951.i
  %.2157.i = load double, ptr %150, align 8, !noalias !128
  %.2159.i = fcmp olt double %.2157.i, -1.000000e-09
  br i1 %.2159.i, label %B80.i852.i, label %B1140.i

B80.i852.i:                                       ; preds = %B1058.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !142
  br label %B1140.i

B1140.i:                                          ; preds = %B1018.if.i, %B80.i852.i, %B1058.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond10189.not = icmp eq i64 %arg.shape.0, %.2050.i
  br i1 %exitcond10189.not, label %B3574, label %B1018.if.i

B96.if.i:                                         ; preds = %B3520, %B270.i9839
  %some.2.01941.i = phi i1 [ %some.3.1.i, %B270.i9839 ], [ false, %B3520 ]
  %.346.01939.i = phi i64 [ %.417.i9837, %B270.i9839 ], [ 0, %B3520 ]
  %.417.i9837 = add nsw i64 %.346.01939.i, 1
  %151 = getelementptr i64, ptr %arg.lane.1.4, i64 %.346.01939.i
  %.99.i.i = load i64, ptr %151, align 8, !noalias !123
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B270.i9839, label %B46.i.i9838

B512.if.i:                                        ; preds = %B892.i, %B280.i
  %.1060.01948.i = phi i64 [ 0, %B280.i ], [ %.1129.i, %B892.i ]
  %.1129.i = add nsw i64 %.1060.01948.i, 1
  %152 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1060.01948.i
  %.99.i78.i = load i64, ptr %152, align 8, !noalias !133
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B892.i, label %B46.i82.i

B714.if.i:                                        ; preds = %B832.i, %B714.if.lr.ph.i
  %trouble.2.11945.i = phi double [ 0.000000e+00, %B714.if.lr.ph.i ], [ %.1599.i, %B832.i ]
  %.1458.01943.i = phi i64 [ 0, %B714.if.lr.ph.i ], [ %.1527.i, %B832.i ]
  %.1527.i = add nsw i64 %.1458.01943.i, 1
  %.1558.i = add nsw i64 %.1458.01943.i, %.988.i9842
  %.1560.i = mul nsw i64 %.1558.i, %arg.shape.0
  %gep10149 = getelementptr double, ptr %invariant.gep10148, i64 %.1560.i
  %.1592.i = load double, ptr %gep10149, align 8, !noalias !128
  %.1597.i = fmul double %.1592.i, 0.000000e+00
  %.1599.i = fadd double %trouble.2.11945.i, %.1597.i
  %.1607.i9846 = mul nsw i64 %.1458.01943.i, %arg.shape.0
  %gep10151 = getelementptr double, ptr %invariant.gep10150, i64 %.1607.i9846
  store double %.1592.i, ptr %gep10151, align 8, !noalias !128
  br i1 %"$phi682.1.2.1.i", label %B810.i9847, label %B832.i

B1018.if.i:                                       ; preds = %B1140.i, %B898.i
  %.1981.01951.i = phi i64 [ 0, %B898.i ], [ %.2050.i, %B1140.i ]
  %.2050.i = add nsw i64 %.1981.01951.i, 1
  %153 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1981.01951.i
  %.99.i311.i = load i64, ptr %153, align 8, !noalias !139
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1140.i, label %B46.i315.i

B3574:                                            ; preds = %B1140.i, %B3520, %B272.i, %B894.i
  %looked.4.2.lcssa.not = xor i1 %looked.4.2.lcssa, true
  %brmerge10172 = or i1 %.276.i, %looked.4.2.lcssa.not
  br i1 %brmerge10172, label %B4376, label %B3612.if

B3658:                                            ; preds = %B3612.if
  br i1 %.166.i541010155.not, label %B104.i5419, label %B48.if.i5844.preheader

B48.if.i5844.preheader:                           ; preds = %B3658
  %invariant.gep10217 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5303.010159
  br label %B48.if.i5844

B104.i5419:                                       ; preds = %B48.if.i5844, %B3658
  %.363.i5472 = getelementptr double, ptr %arg.lane.0.4, i64 %.5303.010159
  store double 0.000000e+00, ptr %.363.i5472, align 8, !noalias !145
  %.418.i5520 = getelementptr double, ptr %290, i64 %.5303.010159
  store double 5.000000e-01, ptr %.418.i5520, align 8, !noalias !145
  %.473.i5568 = getelementptr double, ptr %291, i64 %.5303.010159
  store double 1.000000e+00, ptr %.473.i5568, align 8, !noalias !145
  %.534.i5616 = getelementptr double, ptr %292, i64 %.5303.010159
  store double 0.000000e+00, ptr %.534.i5616, align 8, !noalias !145
  %.589.i5664 = getelementptr double, ptr %293, i64 %.5303.010159
  store double 0.000000e+00, ptr %.589.i5664, align 8, !noalias !145
  %.644.i5712 = getelementptr double, ptr %294, i64 %.5303.010159
  store double 0.000000e+00, ptr %.644.i5712, align 8, !noalias !145
  %.701.i5761 = getelementptr double, ptr %295, i64 %.5303.010159
  store double 0x7FF0000000000000, ptr %.701.i5761, align 8, !noalias !145
  br label %B4403

B48.if.i5844:                                     ; preds = %B48.if.i5844.preheader, %B48.if.i5844
  %.108.i5349.010157 = phi i64 [ %.179.i5852, %B48.if.i5844 ], [ 0, %B48.if.i5844.preheader ]
  %.179.i5852 = add nsw i64 %.108.i5349.010157, 1
  %154 = getelementptr double, ptr %arg.runs.0.4, i64 %.108.i5349.010157
  %.258.i5814 = load double, ptr %154, align 8, !noalias !145
  %.260.i5816 = mul nsw i64 %.108.i5349.010157, %arg.shape.0
  %gep10218 = getelementptr double, ptr %invariant.gep10217, i64 %.260.i5816
  store double %.258.i5814, ptr %gep10218, align 8, !noalias !145
  %exitcond10191.not = icmp eq i64 %arg.shape.1, %.179.i5852
  br i1 %exitcond10191.not, label %B104.i5419, label %B48.if.i5844

B3698:                                            ; preds = %B3612.if
  %.5588 = mul i64 %.5465, %arg.results.3.5.1
  %.5592 = getelementptr i64, ptr %arg.results.3.4, i64 %.5588
  %.5593 = load i64, ptr %.5592, align 8
  %.5649 = getelementptr i8, ptr %.5592, i64 24
  %.5650 = load i64, ptr %.5649, align 8
  %155 = add i64 %.5593, %.5650
  %.5651 = sub i64 %arg.most, %155
  %.5656 = icmp slt i64 %.5651, 1
  br i1 %.5656, label %B3778, label %B3824

B3778:                                            ; preds = %B3698
  %156 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5303.010159
  %.84.i5935 = load i64, ptr %156, align 8, !noalias !149
  %.89.i5938 = icmp sgt i64 %.84.i5935, -1
  br i1 %.89.i5938, label %B46.i5943, label %B3824

B46.i5943:                                        ; preds = %B3778
  %.120.i5969 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i5935
  %.121.i5970 = load i64, ptr %.120.i5969, align 8, !noalias !149
  %.122.i5971 = icmp eq i64 %.121.i5970, 0
  br i1 %.122.i5971, label %B80.i5976, label %B3824

B80.i5976:                                        ; preds = %B46.i5943
  store i64 5, ptr %.120.i5969, align 8, !noalias !149
  br label %B3824

B3824:                                            ; preds = %B80.i5976, %B3778, %B46.i5943, %B3698
  %.5746 = getelementptr double, ptr %256, i64 %.5303.010159
  %.5747 = load double, ptr %.5746, align 8
  %.5748 = fcmp ogt double %.5747, 5.000000e-01
  br i1 %.5748, label %B3862, label %B3968

B3862:                                            ; preds = %B3824
  %.5803 = getelementptr double, ptr %arg.lane.0.4, i64 %.5303.010159
  %.5804 = load double, ptr %.5803, align 8
  %.5858 = getelementptr double, ptr %257, i64 %.5303.010159
  %.5859 = load double, ptr %.5858, align 8
  %.5860 = fcmp oeq double %.5804, %.5859
  br i1 %.5860, label %B3926, label %B3968

B3926:                                            ; preds = %B3862
  %.243.i6257 = load i64, ptr %.5464, align 8, !noalias !152
  %.261.i6269 = icmp slt i64 %.243.i6257, 0
  %.262.i6270 = select i1 %.261.i6269, i64 %arg.runs.2.5.0, i64 0
  %157 = getelementptr i64, ptr %arg.runs.2.4, i64 %.243.i6257
  %.276.i6284 = getelementptr i64, ptr %157, i64 %.262.i6270
  %.277.i6285 = load i64, ptr %.276.i6284, align 8, !noalias !152
  %.334.i6334 = getelementptr i64, ptr %258, i64 %.5303.010159
  %.335.i6335 = load i64, ptr %.334.i6334, align 8, !noalias !152
  %.336.i6336 = add nsw i64 %.335.i6335, 1
  store i64 %.336.i6336, ptr %.334.i6334, align 8, !noalias !152
  %.457.i6441 = icmp slt i64 %.277.i6285, 0
  %.458.i6442 = select i1 %.457.i6441, i64 %arg.schedule.1.5.0, i64 0
  %158 = getelementptr i64, ptr %arg.schedule.1.4, i64 %.277.i6285
  %.472.i6456 = getelementptr i64, ptr %158, i64 %.458.i6442
  %.473.i6457 = load i64, ptr %.472.i6456, align 8, !noalias !152
  %.474.i6458 = icmp eq i64 %.336.i6336, %.473.i6457
  br i1 %.474.i6458, label %B186.i, label %B244.i6459

B186.i:                                           ; preds = %B3926
  %.511.i7156 = select i1 %.261.i6269, i64 %arg.results.1.5.0, i64 0
  %159 = getelementptr i64, ptr %arg.results.1.4, i64 %.243.i6257
  %.525.i7170 = getelementptr i64, ptr %159, i64 %.511.i7156
  %.526.i7171 = load i64, ptr %.525.i7170, align 8, !noalias !152
  %.527.i7172 = icmp eq i64 %.526.i7171, 0
  br i1 %.527.i7172, label %B220.i, label %B3968

B220.i:                                           ; preds = %B186.i
  store i64 1, ptr %.525.i7170, align 8, !noalias !152
  br label %B3968

B244.i6459:                                       ; preds = %B3926
  %.654.i6531 = select i1 %.457.i6441, i64 %arg.schedule.0.5.0, i64 0
  %.655.i6532 = add i64 %.654.i6531, %.277.i6285
  %.656.i6533 = icmp slt i64 %.335.i6335, -1
  %.657.i6534 = select i1 %.656.i6533, i64 %arg.schedule.0.5.1, i64 0
  %.675.i6552 = mul i64 %.655.i6532, %arg.schedule.0.5.1
  %160 = getelementptr double, ptr %arg.schedule.0.4, i64 %.675.i6552
  %161 = getelementptr double, ptr %160, i64 %.336.i6336
  %.679.i6556 = getelementptr double, ptr %161, i64 %.657.i6534
  %.680.i6557 = load double, ptr %.679.i6556, align 8, !noalias !152
  store double %.680.i6557, ptr %.5858, align 8, !noalias !152
  %.792.i6654 = load i64, ptr %.334.i6334, align 8, !noalias !152
  %.817.i6675 = select i1 %.457.i6441, i64 %arg.schedule.4.5.0, i64 0
  %.818.i6676 = add i64 %.817.i6675, %.277.i6285
  %.819.i6677 = icmp slt i64 %.792.i6654, 0
  %.820.i6678 = select i1 %.819.i6677, i64 %arg.schedule.4.5.1, i64 0
  %.838.i6696 = mul i64 %.818.i6676, %arg.schedule.4.5.1
  %162 = getelementptr i64, ptr %arg.schedule.4.4, i64 %.838.i6696
  %163 = getelementptr i64, ptr %162, i64 %.792.i6654
  %.842.i6700 = getelementptr i64, ptr %163, i64 %.820.i6678
  %.843.i6701 = load i64, ptr %.842.i6700, align 8, !noalias !152
  %.846.i6703 = icmp eq i64 %.843.i6701, 0
  br i1 %.846.i6703, label %B364.i, label %B412.i6704

B364.i:                                           ; preds = %B244.i6459
  %.901.i7108 = getelementptr double, ptr %259, i64 %.5303.010159
  store double 1.000000e+00, ptr %.901.i7108, align 8, !noalias !152
  br label %B456.i.sink.split

B412.i6704:                                       ; preds = %B244.i6459
  %.969.i6729 = load i64, ptr %.723, align 8, !noalias !152
  %.970.i6730 = icmp eq i64 %.969.i6729, 0
  br i1 %.970.i6730, label %B456.i.sink.split, label %B456.i

B456.i.sink.split:                                ; preds = %B412.i6704, %B364.i
  %.sink = phi i64 [ 1, %B364.i ], [ 2, %B412.i6704 ]
  store i64 %.sink, ptr %.723, align 8, !noalias !152
  br label %B456.i

B456.i:                                           ; preds = %B456.i.sink.split, %B412.i6704
  br i1 %.190.i.i694310152.not, label %B3968, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B456.i
  %.1062.i6780 = load i64, ptr %.334.i6334, align 8, !noalias !152
  %.260.i.i = select i1 %.457.i6441, i64 %arg.schedule.3.5.0, i64 0
  %.261.i.i6985 = add i64 %.260.i.i, %.277.i6285
  %.262.i.i6986 = icmp slt i64 %.1062.i6780, 0
  %.263.i.i6987 = select i1 %.262.i.i6986, i64 %arg.schedule.3.5.1, i64 0
  %.264.i.i6988 = add i64 %.263.i.i6987, %.1062.i6780
  %.291.i.i6999 = mul i64 %.289.i.i, %.261.i.i6985
  %.293.i.i7000 = mul i64 %.264.i.i6988, %arg.schedule.3.5.2
  %164 = getelementptr double, ptr %arg.schedule.3.4, i64 %.291.i.i6999
  %165 = getelementptr double, ptr %164, i64 %.293.i.i7000
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.132.i.i6013.010154 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.203.i.i7031, %B76.if.i.i ]
  %.203.i.i7031 = add nsw i64 %.132.i.i6013.010154, 1
  %166 = getelementptr double, ptr %165, i64 %.132.i.i6013.010154
  %.298.i.i7003 = load double, ptr %166, align 8, !noalias !156
  %167 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.132.i.i6013.010154
  %.328.i.i7019 = load i64, ptr %167, align 8, !noalias !156
  %.330.i.i7021 = mul nsw i64 %.328.i.i7019, %arg.shape.0
  %.332.i.i = add nsw i64 %.330.i.i7021, %.5303.010159
  %.346.i.i = icmp slt i64 %.332.i.i, 0
  %.347.i.i7024 = select i1 %.346.i.i, i64 %arg.arrays.1.5.0, i64 0
  %168 = getelementptr double, ptr %arg.arrays.1.4, i64 %.332.i.i
  %.361.i.i7025 = getelementptr double, ptr %168, i64 %.347.i.i7024
  store double %.298.i.i7003, ptr %.361.i.i7025, align 8, !noalias !156
  %exitcond10190.not = icmp eq i64 %arg.schedule.2.5.0, %.203.i.i7031
  br i1 %exitcond10190.not, label %B3968, label %B76.if.i.i

B3968:                                            ; preds = %B76.if.i.i, %B456.i, %B220.i, %B186.i, %B3862, %B3824
  %.5966 = getelementptr i64, ptr %arg.results.1.4, i64 %.5465
  %.5967 = load i64, ptr %.5966, align 8
  %.5968.not = icmp eq i64 %.5967, 0
  br i1 %.5968.not, label %B4126, label %B4002

B4002:                                            ; preds = %B3968
  %.6029 = getelementptr i64, ptr %260, i64 %.5303.010159
  %.6030 = load i64, ptr %.6029, align 8
  %.6060 = getelementptr i64, ptr %arg.results.2.4, i64 %.5465
  store i64 %.6030, ptr %.6060, align 8
  store i64 -1, ptr %.5464, align 8
  %.305.i9857 = load i64, ptr %arg.lane.2.4, align 8, !noalias !160
  %.365.i9859 = load i64, ptr %.364.i9858, align 8, !noalias !160
  %.366.i9860 = icmp slt i64 %.305.i9857, %.365.i9859
  br i1 %.366.i9860, label %B116.i9992, label %B302.i9861

B116.i9992:                                       ; preds = %B4002
  %.376.i9993 = add nsw i64 %.305.i9857, 1
  store i64 %.376.i9993, ptr %arg.lane.2.4, align 8, !noalias !160
  store i64 1, ptr %.723, align 8, !noalias !160
  store i64 %.305.i9857, ptr %.5464, align 8, !noalias !160
  %.548.i9999 = getelementptr i64, ptr %261, i64 %.5303.010159
  store i64 0, ptr %.548.i9999, align 8, !noalias !160
  store i64 1, ptr %.6029, align 8, !noalias !160
  br i1 %.6871761.not.i10002, label %B302.i9861, label %B258.if.lr.ph.i10003

B258.if.lr.ph.i10003:                             ; preds = %B116.i9992
  %.748.i10004 = icmp slt i64 %.305.i9857, 0
  %.749.i10005 = select i1 %.748.i10004, i64 %arg.runs.0.5.0, i64 0
  %.750.i10006 = add i64 %.749.i10005, %.305.i9857
  %.770.i10007 = mul i64 %.750.i10006, %arg.runs.0.5.1
  %169 = getelementptr double, ptr %arg.runs.0.4, i64 %.770.i10007
  %.813.i10008 = select i1 %.748.i10004, i64 %arg.results.0.5.0, i64 0
  %.814.i10009 = add i64 %.813.i10008, %.305.i9857
  %.844.i10011 = mul i64 %.842.i10010, %.814.i10009
  %170 = getelementptr double, ptr %arg.results.0.4, i64 %.844.i10011
  br label %B258.if.i10012

B302.i9861:                                       ; preds = %B258.if.i10012, %B116.i9992, %B4002
  %m.2.0.i9862 = phi i64 [ 0, %B4002 ], [ %.305.i9857, %B116.i9992 ], [ %.305.i9857, %B258.if.i10012 ]
  br i1 %.9571764.not.i9863, label %B376.i9879, label %B332.if.lr.ph.i9864

B332.if.lr.ph.i9864:                              ; preds = %B302.i9861
  %.1018.i9865 = icmp slt i64 %m.2.0.i9862, 0
  %.1019.i9866 = select i1 %.1018.i9865, i64 %arg.runs.1.5.0, i64 0
  %.1020.i9867 = add i64 %.1019.i9866, %m.2.0.i9862
  %.1040.i9868 = mul i64 %.1020.i9867, %arg.runs.1.5.1
  %171 = getelementptr double, ptr %arg.runs.1.4, i64 %.1040.i9868
  %invariant.gep10211 = getelementptr double, ptr %arg.arrays.1.4, i64 %.5303.010159
  br label %B332.if.i9869

B376.i9879:                                       ; preds = %B332.if.i9869, %B302.i9861
  %.1102.i9880 = icmp slt i64 %m.2.0.i9862, 0
  %.1103.i9881 = select i1 %.1102.i9880, i64 %arg.runs.2.5.0, i64 0
  %172 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i9862
  %.1117.i9882 = getelementptr i64, ptr %172, i64 %.1103.i9881
  br i1 %.190.i1767.not.i9883, label %B376.endif.i9902, label %B76.if.i.lr.ph.i9884

B76.if.i.lr.ph.i9884:                             ; preds = %B376.i9879
  %.1118.i9885 = load i64, ptr %.1117.i9882, align 8, !noalias !160
  %.265.i.i9886 = icmp slt i64 %.1118.i9885, 0
  %.266.i.i9887 = select i1 %.265.i.i9886, i64 %arg.schedule.3.5.0, i64 0
  %.267.i.i9888 = add i64 %.266.i.i9887, %.1118.i9885
  %.297.i.i9890 = mul i64 %.295.i.i9889, %.267.i.i9888
  %173 = getelementptr double, ptr %arg.schedule.3.4, i64 %.297.i.i9890
  br label %B76.if.i.i9891

B76.if.i.i9891:                                   ; preds = %B76.if.i.i9891, %B76.if.i.lr.ph.i9884
  %.132.i.01768.i9892 = phi i64 [ 0, %B76.if.i.lr.ph.i9884 ], [ %.203.i.i9893, %B76.if.i.i9891 ]
  %.203.i.i9893 = add nsw i64 %.132.i.01768.i9892, 1
  %174 = getelementptr double, ptr %173, i64 %.132.i.01768.i9892
  %.304.i.i9894 = load double, ptr %174, align 8, !noalias !163
  %175 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.132.i.01768.i9892
  %.334.i.i9895 = load i64, ptr %175, align 8, !noalias !163
  %.336.i.i9896 = mul nsw i64 %.334.i.i9895, %arg.shape.0
  %.338.i.i9897 = add nsw i64 %.336.i.i9896, %.5303.010159
  %.352.i.i9898 = icmp slt i64 %.338.i.i9897, 0
  %.353.i.i9899 = select i1 %.352.i.i9898, i64 %arg.arrays.1.5.0, i64 0
  %176 = getelementptr double, ptr %arg.arrays.1.4, i64 %.338.i.i9897
  %.367.i.i9900 = getelementptr double, ptr %176, i64 %.353.i.i9899
  store double %.304.i.i9894, ptr %.367.i.i9900, align 8, !noalias !163
  %exitcond1777.not.i9901 = icmp eq i64 %.203.i.i9893, %arg.schedule.2.5.0
  br i1 %exitcond1777.not.i9901, label %B376.endif.i9902, label %B76.if.i.i9891

B432.i9903:                                       ; preds = %B376.endif.i9902
  br i1 %.1188.i9904, label %B444.i9906, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017

B444.i9906:                                       ; preds = %B432.i9903
  br i1 %.166.i801770.not.i9907, label %B104.i.i9918, label %B48.if.i.i9908.preheader

B48.if.i.i9908.preheader:                         ; preds = %B444.i9906
  %invariant.gep10213 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5303.010159
  br label %B48.if.i.i9908

B104.i.i9918:                                     ; preds = %B48.if.i.i9908, %B444.i9906
  %.363.i123.i9922 = getelementptr double, ptr %arg.lane.0.4, i64 %.5303.010159
  store double 0.000000e+00, ptr %.363.i123.i9922, align 8, !noalias !167
  %.418.i.i9923 = getelementptr double, ptr %262, i64 %.5303.010159
  store double 5.000000e-01, ptr %.418.i.i9923, align 8, !noalias !167
  %.473.i.i9925 = getelementptr double, ptr %263, i64 %.5303.010159
  store double 1.000000e+00, ptr %.473.i.i9925, align 8, !noalias !167
  %.534.i.i9927 = getelementptr double, ptr %264, i64 %.5303.010159
  store double 0.000000e+00, ptr %.534.i.i9927, align 8, !noalias !167
  %.589.i.i9929 = getelementptr double, ptr %265, i64 %.5303.010159
  store double 0.000000e+00, ptr %.589.i.i9929, align 8, !noalias !167
  %.644.i.i9931 = getelementptr double, ptr %266, i64 %.5303.010159
  store double 0.000000e+00, ptr %.644.i.i9931, align 8, !noalias !167
  %.701.i.i9933 = getelementptr double, ptr %267, i64 %.5303.010159
  store double 0x7FF0000000000000, ptr %.701.i.i9933, align 8, !noalias !167
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017

B48.if.i.i9908:                                   ; preds = %B48.if.i.i9908.preheader, %B48.if.i.i9908
  %.108.i.01771.i9909 = phi i64 [ %.179.i184.i9910, %B48.if.i.i9908 ], [ 0, %B48.if.i.i9908.preheader ]
  %.179.i184.i9910 = add nsw i64 %.108.i.01771.i9909, 1
  %177 = getelementptr double, ptr %arg.runs.0.4, i64 %.108.i.01771.i9909
  %.258.i.i9911 = load double, ptr %177, align 8, !noalias !167
  %.260.i161.i9912 = mul nsw i64 %.108.i.01771.i9909, %arg.shape.0
  %gep10214 = getelementptr double, ptr %invariant.gep10213, i64 %.260.i161.i9912
  store double %.258.i.i9911, ptr %gep10214, align 8, !noalias !167
  %exitcond1778.not.i9917 = icmp eq i64 %arg.shape.1, %.179.i184.i9910
  br i1 %exitcond1778.not.i9917, label %B104.i.i9918, label %B48.if.i.i9908

B486.i9934:                                       ; preds = %B376.endif.i9902
  br i1 %.13511773.not.i9935, label %B560.i9950, label %B516.if.lr.ph.i9936

B516.if.lr.ph.i9936:                              ; preds = %B486.i9934
  %.1413.i9937 = select i1 %.1102.i9880, i64 %arg.runs.0.5.0, i64 0
  %.1414.i9938 = add i64 %.1413.i9937, %m.2.0.i9862
  %.1434.i9939 = mul i64 %.1414.i9938, %arg.runs.0.5.1
  %178 = getelementptr double, ptr %arg.runs.0.4, i64 %.1434.i9939
  %invariant.gep10215 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5303.010159
  br label %B516.if.i9940

B560.i9950:                                       ; preds = %B516.if.i9940, %B486.i9934
  %.1514.i9951 = load double, ptr %arg.times.4, align 8, !noalias !160
  %.1551.i9952 = load i64, ptr %.1117.i9882, align 8, !noalias !160
  %.1581.i9953 = icmp slt i64 %.1551.i9952, 0
  %.1582.i9954 = select i1 %.1581.i9953, i64 %arg.schedule.0.5.0, i64 0
  %.1583.i9955 = add i64 %.1582.i9954, %.1551.i9952
  %.1603.i9956 = mul i64 %.1583.i9955, %arg.schedule.0.5.1
  %.1607.i9957 = getelementptr double, ptr %arg.schedule.0.4, i64 %.1603.i9956
  %.1608.i9958 = load double, ptr %.1607.i9957, align 8, !noalias !160
  %.1662.i9962 = getelementptr double, ptr %arg.lane.0.4, i64 %.5303.010159
  store double %.1514.i9951, ptr %.1662.i9962, align 8, !noalias !160
  %.1717.i9964 = getelementptr double, ptr %268, i64 %.5303.010159
  store double %.1608.i9958, ptr %.1717.i9964, align 8, !noalias !160
  %.1772.i9965 = getelementptr double, ptr %269, i64 %.5303.010159
  store double 0.000000e+00, ptr %.1772.i9965, align 8, !noalias !160
  %.1831.i9967 = getelementptr double, ptr %270, i64 %.5303.010159
  store double 1.000000e+00, ptr %.1831.i9967, align 8, !noalias !160
  %.1886.i9969 = getelementptr double, ptr %271, i64 %.5303.010159
  store double 0.000000e+00, ptr %.1886.i9969, align 8, !noalias !160
  %.1942.i9971 = getelementptr double, ptr %272, i64 %.5303.010159
  store double 0xFFF0000000000000, ptr %.1942.i9971, align 8, !noalias !160
  %179 = getelementptr i64, ptr %273, i64 %.5303.010159
  store i64 0, ptr %179, align 8, !noalias !160
  %.2054.i9976 = getelementptr double, ptr %274, i64 %.5303.010159
  store double 0x7FF0000000000000, ptr %.2054.i9976, align 8, !noalias !160
  %.2113.i9978 = getelementptr double, ptr %275, i64 %.5303.010159
  store double 0.000000e+00, ptr %.2113.i9978, align 8, !noalias !160
  %.2168.i9980 = getelementptr double, ptr %276, i64 %.5303.010159
  store double 0.000000e+00, ptr %.2168.i9980, align 8, !noalias !160
  %.2229.i9982 = getelementptr double, ptr %277, i64 %.5303.010159
  store double 0.000000e+00, ptr %.2229.i9982, align 8, !noalias !160
  %.2284.i9984 = getelementptr double, ptr %278, i64 %.5303.010159
  store double 0.000000e+00, ptr %.2284.i9984, align 8, !noalias !160
  %.2339.i9986 = getelementptr double, ptr %279, i64 %.5303.010159
  store double 0.000000e+00, ptr %.2339.i9986, align 8, !noalias !160
  %.2394.i9988 = getelementptr double, ptr %280, i64 %.5303.010159
  %.2395.i9989 = load double, ptr %.2394.i9988, align 8, !noalias !160
  %.2397.i9990 = fcmp ueq double %.2395.i9989, 0xFFF0000000000000
  br i1 %.2397.i9990, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017, label %B1034.i9991

B1034.i9991:                                      ; preds = %B560.i9950
  store double 0.000000e+00, ptr %.2394.i9988, align 8, !noalias !160
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017

B258.if.i10012:                                   ; preds = %B258.if.i10012, %B258.if.lr.ph.i10003
  %.629.01762.i10013 = phi i64 [ 0, %B258.if.lr.ph.i10003 ], [ %.700.i10014, %B258.if.i10012 ]
  %.700.i10014 = add nsw i64 %.629.01762.i10013, 1
  %180 = getelementptr double, ptr %169, i64 %.629.01762.i10013
  %.775.i10015 = load double, ptr %180, align 8, !noalias !160
  %181 = getelementptr double, ptr %170, i64 %.629.01762.i10013
  store double %.775.i10015, ptr %181, align 8, !noalias !160
  %exitcond.not.i10016 = icmp eq i64 %.700.i10014, %arg.shape.1
  br i1 %exitcond.not.i10016, label %B302.i9861, label %B258.if.i10012

B332.if.i9869:                                    ; preds = %B332.if.i9869, %B332.if.lr.ph.i9864
  %.901.01765.i9870 = phi i64 [ 0, %B332.if.lr.ph.i9864 ], [ %.970.i9871, %B332.if.i9869 ]
  %.970.i9871 = add nsw i64 %.901.01765.i9870, 1
  %182 = getelementptr double, ptr %171, i64 %.901.01765.i9870
  %.1045.i9872 = load double, ptr %182, align 8, !noalias !160
  %.1047.i9873 = mul nsw i64 %.901.01765.i9870, %arg.shape.0
  %gep10212 = getelementptr double, ptr %invariant.gep10211, i64 %.1047.i9873
  store double %.1045.i9872, ptr %gep10212, align 8, !noalias !160
  %exitcond1776.not.i9878 = icmp eq i64 %.970.i9871, %arg.shape.2
  br i1 %exitcond1776.not.i9878, label %B376.i9879, label %B332.if.i9869

B376.endif.i9902:                                 ; preds = %B76.if.i.i9891, %B376.i9879
  br i1 %.366.i9860, label %B486.i9934, label %B432.i9903

B516.if.i9940:                                    ; preds = %B516.if.i9940, %B516.if.lr.ph.i9936
  %.1295.01774.i9941 = phi i64 [ 0, %B516.if.lr.ph.i9936 ], [ %.1364.i9942, %B516.if.i9940 ]
  %.1364.i9942 = add nsw i64 %.1295.01774.i9941, 1
  %183 = getelementptr double, ptr %178, i64 %.1295.01774.i9941
  %.1439.i9943 = load double, ptr %183, align 8, !noalias !160
  %.1441.i9944 = mul nsw i64 %.1295.01774.i9941, %arg.shape.0
  %gep10216 = getelementptr double, ptr %invariant.gep10215, i64 %.1441.i9944
  store double %.1439.i9943, ptr %gep10216, align 8, !noalias !160
  %exitcond1779.not.i9949 = icmp eq i64 %.1364.i9942, %arg.shape.1
  br i1 %exitcond1779.not.i9949, label %B560.i9950, label %B516.if.i9940

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017: ; preds = %B432.i9903, %B104.i.i9918, %B560.i9950, %B1034.i9991
  %storemerge1747.i9905 = phi i64 [ 0, %B432.i9903 ], [ 0, %B104.i.i9918 ], [ 1, %B1034.i9991 ], [ 1, %B560.i9950 ]
  %.6120 = add nsw i64 %active.3.210162, -1
  %.6219 = add nsw i64 %.6120, %storemerge1747.i9905
  br label %B4334

B4126:                                            ; preds = %B3968
  %.6285 = getelementptr double, ptr %281, i64 %.5303.010159
  %.6286 = load double, ptr %.6285, align 8
  %.6288 = fcmp ult double %.6286, 1.500000e+01
  br i1 %.6288, label %B4334, label %B4174

B4174:                                            ; preds = %B4126
  %.6334 = load double, ptr %.6333, align 8
  %.6388 = getelementptr double, ptr %arg.lane.0.4, i64 %.5303.010159
  %.6389 = load double, ptr %.6388, align 8
  %.6390 = fsub double %.6334, %.6389
  %.6444 = getelementptr double, ptr %284, i64 %.5303.010159
  %.6445 = load double, ptr %.6444, align 8
  %.6447 = fmul double %.6445, 5.000000e+03
  %.6448 = fcmp ogt double %.6390, %.6447
  br i1 %.6448, label %B4334, label %B4310

B4310:                                            ; preds = %B4174
  store double 0.000000e+00, ptr %.6285, align 8
  br label %B4334

B4334:                                            ; preds = %B4174, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017, %B4310, %B4126
  %budget.7.3 = phi i64 [ %budget.5.210161, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017 ], [ %budget.5.210161, %B4126 ], [ %budget.5.210161, %B4310 ], [ 0, %B4174 ]
  %active.5.3 = phi i64 [ %.6219, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit10017 ], [ %active.3.210162, %B4126 ], [ %active.3.210162, %B4310 ], [ %active.3.210162, %B4174 ]
  %.133.i7342 = load i64, ptr %.5464, align 8, !noalias !171
  %.138.i7345 = icmp sgt i64 %.133.i7342, -1
  br i1 %.138.i7345, label %B58.i, label %B4403

B58.i:                                            ; preds = %B4334
  %.329.i7475 = getelementptr double, ptr %285, i64 %.5303.010159
  %.330.i7476 = load double, ptr %.329.i7475, align 8, !noalias !171
  %.332.i7477 = fcmp ogt double %.330.i7476, 0.000000e+00
  br i1 %.332.i7477, label %B192.i7483, label %B190.i7478

B190.i7478:                                       ; preds = %B58.i
  %.191.i7400 = mul i64 %.133.i7342, %arg.results.3.5.1
  %.195.i7404 = getelementptr i64, ptr %arg.results.3.4, i64 %.191.i7400
  %.196.i7405 = load i64, ptr %.195.i7404, align 8, !noalias !171
  %.209.i7282.0 = and i64 %.196.i7405, 127
  %.239.i7413 = sub nsw i64 128, %.209.i7282.0
  %.11.i.i7422 = tail call i64 @llvm.smin.i64(i64 %.239.i7413, i64 %.5651)
  %.343.i7481 = sitofp i64 %.11.i.i7422 to double
  br label %B192.i7483

B192.i7483:                                       ; preds = %B58.i, %B190.i7478
  %"$phi192.0.2.i.0" = phi double [ %.343.i7481, %B190.i7478 ], [ 1.000000e+00, %B58.i ]
  %.401.i7532 = getelementptr double, ptr %286, i64 %.5303.010159
  store double %"$phi192.0.2.i.0", ptr %.401.i7532, align 8, !noalias !171
  %.111.i.i7661 = getelementptr i64, ptr %287, i64 %.5303.010159
  %.112.i.i7662 = load i64, ptr %.111.i.i7661, align 8, !noalias !175
  %.169.i.i7700 = getelementptr double, ptr %288, i64 %.5303.010159
  %.170.i.i7701 = load double, ptr %.169.i.i7700, align 8, !noalias !175
  %.224.i.i7738 = getelementptr double, ptr %289, i64 %.5303.010159
  store double %.170.i.i7701, ptr %.224.i.i7738, align 8, !noalias !175
  %.237.i.i7744 = icmp slt i64 %.112.i.i7662, %arg.times.5.0
  br i1 %.237.i.i7744, label %B134.i.i7757, label %B4403

B134.i.i7757:                                     ; preds = %B192.i7483
  %.253.i.i7766 = icmp slt i64 %.112.i.i7662, 0
  %.254.i.i7767 = select i1 %.253.i.i7766, i64 %arg.times.5.0, i64 0
  %184 = getelementptr double, ptr %arg.times.4, i64 %.112.i.i7662
  %.268.i.i7777 = getelementptr double, ptr %184, i64 %.254.i.i7767
  %.269.i.i7778 = load double, ptr %.268.i.i7777, align 8, !noalias !175
  %.328.i.i7818 = load double, ptr %.169.i.i7700, align 8, !noalias !175
  %.10.i.i.i7823 = fcmp olt double %.328.i.i7818, %.269.i.i7778
  %.11.i.i.i7824 = select i1 %.10.i.i.i7823, double %.328.i.i7818, double %.269.i.i7778
  store double %.11.i.i.i7824, ptr %.224.i.i7738, align 8, !noalias !175
  br label %B4403

B4376:                                            ; preds = %B4403, %B3574
  %budget.4.2 = phi i64 [ %.689, %B3574 ], [ %budget.6.3, %B4403 ]
  %active.7.2 = phi i64 [ %active.6.0, %B3574 ], [ %active.4.3, %B4403 ]
  %.6607 = icmp sgt i64 %active.7.2, 0
  %.6626 = icmp sgt i64 %budget.4.2, 0
  %or.cond9699 = select i1 %.6607, i1 %.6626, i1 false
  br i1 %or.cond9699, label %B266, label %B4402

B4402:                                            ; preds = %B4376, %B0.endif
  %active.8.1 = phi i64 [ %active.3.i.0.lcssa, %B0.endif ], [ %active.7.2, %B4376 ]
  br i1 %.276.i, label %B4402.endif, label %B46.if.i2178.lr.ph

B46.if.i2178.lr.ph:                               ; preds = %B4402
  %.idx9620 = mul i64 %arg.lane.0.5.1, 192
  %185 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9620
  %.idx9621 = mul i64 %arg.lane.0.5.1, 200
  %186 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9621
  %.682.i1949 = add nsw i64 %arg.shape.3, -1
  %.idx9622 = mul i64 %arg.lane.0.5.1, 176
  %187 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9622
  br label %B46.if.i2178

B92.i1599:                                        ; preds = %B46.if.i2178
  %.303.i1647 = getelementptr double, ptr %185, i64 %.90.i1457.010167
  %.304.i1648 = load double, ptr %.303.i1647, align 8, !noalias !179
  %.5.i.i1649 = fptosi double %.304.i1648 to i64
  %.382.i1699 = getelementptr double, ptr %186, i64 %.90.i1457.010167
  %.383.i1700 = load double, ptr %.382.i1699, align 8, !noalias !179
  %.5.i1.i1701 = fptosi double %.383.i1700 to i64
  %.457.i1749 = mul i64 %.243.i1592, %arg.results.3.5.1
  %.461.i1753 = getelementptr i64, ptr %arg.results.3.4, i64 %.457.i1749
  %.462.i1754 = load i64, ptr %.461.i1753, align 8, !noalias !179
  %.463.i1755 = add nsw i64 %.462.i1754, %.5.i.i1649
  store i64 %.463.i1755, ptr %.461.i1753, align 8, !noalias !179
  %.569.i1850 = getelementptr i8, ptr %.461.i1753, i64 24
  %.570.i1851 = load i64, ptr %.569.i1850, align 8, !noalias !179
  %.571.i1852 = add nsw i64 %.570.i1851, %.5.i1.i1701
  store i64 %.571.i1852, ptr %.569.i1850, align 8, !noalias !179
  %.679.i1946 = getelementptr i8, ptr %.461.i1753, i64 8
  %.680.i1947 = load i64, ptr %.679.i1946, align 8, !noalias !179
  %.683.i1950 = add nsw i64 %.5.i1.i1701, %.5.i.i1649
  %.684.i1951 = mul nsw i64 %.683.i1950, %.682.i1949
  %.685.i1952 = add nsw i64 %.684.i1951, %.5.i.i1649
  %.686.i1953 = add nsw i64 %.685.i1952, %.680.i1947
  store i64 %.686.i1953, ptr %.679.i1946, align 8, !noalias !179
  store double 0.000000e+00, ptr %.303.i1647, align 8, !noalias !179
  store double 0.000000e+00, ptr %.382.i1699, align 8, !noalias !179
  %.908.i2133 = getelementptr double, ptr %187, i64 %.90.i1457.010167
  %.909.i2134 = load double, ptr %.908.i2133, align 8, !noalias !179
  %.911.i2136 = sitofp i64 %.683.i1950 to double
  %.912.i2137 = fsub double %.909.i2134, %.911.i2136
  store double %.912.i2137, ptr %.908.i2133, align 8, !noalias !179
  br label %B468.i1596

B468.i1596:                                       ; preds = %B92.i1599, %B46.if.i2178
  %.148.i1525 = icmp sgt i64 %.93.i1458.010168, 1
  br i1 %.148.i1525, label %B46.if.i2178, label %B4402.endif

B46.if.i2178:                                     ; preds = %B46.if.i2178.lr.ph, %B468.i1596
  %.93.i1458.010168 = phi i64 [ %storemerge, %B46.if.i2178.lr.ph ], [ %.157.i2183, %B468.i1596 ]
  %.90.i1457.010167 = phi i64 [ 0, %B46.if.i2178.lr.ph ], [ %.161.i2186, %B468.i1596 ]
  %.157.i2183 = add nsw i64 %.93.i1458.010168, -1
  %.161.i2186 = add nsw i64 %.90.i1457.010167, 1
  %188 = getelementptr i64, ptr %arg.lane.1.4, i64 %.90.i1457.010167
  %.243.i1592 = load i64, ptr %188, align 8, !noalias !179
  %.248.i1595 = icmp sgt i64 %.243.i1592, -1
  br i1 %.248.i1595, label %B92.i1599, label %B468.i1596

B4403:                                            ; preds = %B4334, %B134.i.i7757, %B192.i7483, %B104.i5419
  %budget.6.3 = phi i64 [ %budget.5.210161, %B104.i5419 ], [ %budget.7.3, %B192.i7483 ], [ %budget.7.3, %B134.i.i7757 ], [ %budget.7.3, %B4334 ]
  %active.4.3 = phi i64 [ %active.3.210162, %B104.i5419 ], [ %active.5.3, %B192.i7483 ], [ %active.5.3, %B134.i.i7757 ], [ %active.5.3, %B4334 ]
  %.5366 = icmp sgt i64 %.5306.010160, 1
  br i1 %.5366, label %B3612.if, label %B4376

B0.endif:                                         ; preds = %B171.i, %entry
  %active.3.i.0.lcssa = phi i64 [ 0, %entry ], [ %active.4.i.1, %B171.i ]
  %.657 = icmp sgt i64 %active.3.i.0.lcssa, 0
  %.679 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.657, i1 %.679, i1 false
  br i1 %or.cond, label %B266.preheader, label %B4402

B266.preheader:                                   ; preds = %B0.endif
  %.723 = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul10165 = mul i64 %arg.shape.0, %arg.shape.1
  %.819 = getelementptr i8, ptr %arg.code.4, i64 8
  %.871 = icmp sgt i64 %arg.decided, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx9680 = mul i64 %arg.lane.0.5.1, 24
  %189 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9680
  %.457.i17910026 = icmp slt i64 %arg.decided, 1
  %.613.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.930.not = icmp eq i64 %arg.guarded, 0
  %.960 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1087.idx = shl i64 %.388, 4
  %.1087 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1087.idx
  %.1118 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1194 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1295.idx = mul i64 %.388, 136
  %.1295 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1295.idx
  %.1320.idx = mul i64 %.388, 24
  %.1320 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1320.idx
  %.1351 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx9672 = mul i64 %arg.lane.0.5.1, 24
  %190 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9672
  %.idx9673 = shl i64 %arg.lane.0.5.1, 5
  %191 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9673
  %.idx9674 = mul i64 %arg.lane.0.5.1, 136
  %192 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9674
  %. = select i1 %.537.not, i64 2, i64 0
  %.idx9675 = mul i64 %arg.lane.0.5.1, 88
  %193 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9675
  %.idx9676 = shl i64 %arg.lane.0.5.1, 4
  %194 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9676
  %.idx9677 = shl i64 %arg.lane.1.5.1, 4
  %195 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9677
  %.idx9678 = shl i64 %arg.lane.0.5.1, 4
  %196 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9678
  %.idx9679 = mul i64 %arg.lane.0.5.1, 168
  %197 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9679
  %.1496 = getelementptr i8, ptr %arg.code.4, i64 56
  %.1622 = getelementptr double, ptr %arg.arrays.0.4, i64 %.388
  %.127.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.174.not.i = icmp slt i64 %.127.i, %arg.linear.0.5.0
  %.344.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.524.idx.i = shl i64 %arg.lane.0.5.1, 5
  %.524.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.524.idx.i
  %.123.i.i = shl nsw i64 %arg.shape.1, 1
  %.124.i.i = add nsw i64 %.123.i.i, 5
  %.153.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 24
  %.183.i.i9711 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i9713 = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i9713, i64 %arg.linear.1.5.0, i64 0
  %.226.i.i = add i64 %.225.i.i, %.124.i.i
  %.229.i.i = icmp slt i64 %.226.i.i, 0
  %.234.i.i = icmp sge i64 %.226.i.i, %arg.linear.1.5.0
  %198 = or i1 %.229.i.i, %.234.i.i
  %.241.i.i = icmp slt i64 %.186.i.i, -1
  %.242.i.i = select i1 %.241.i.i, i64 %arg.linear.1.5.0, i64 0
  %.243.i.i = add i64 %.242.i.i, %.187.i.i
  %.246.i.i = icmp slt i64 %.243.i.i, 0
  %.251.i.not.i = icmp slt i64 %.243.i.i, %arg.linear.1.5.0
  %.409.i.i = icmp sge i64 %.243.i.i, %arg.linear.1.5.0
  %199 = or i1 %.246.i.i, %.409.i.i
  %.538.i.i = add nsw i64 %arg.shape.1, 1
  %.539.i.i = add i64 %.124.i.i, %.538.i.i
  %.1162.i2379.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2421.i = mul i64 %arg.shape.1, 136
  %.idx2422.i = mul i64 %arg.shape.1, 88
  %.1461.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 16
  %storemerge2359.i = tail call i64 @llvm.smax.i64(i64 %.538.i.i, i64 0)
  %.1556.i2382.not.i = icmp slt i64 %arg.shape.1, 0
  %.1716.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.1789.i.i = mul nsw i64 %arg.shape.1, 12
  %.1807.i.idx.i = mul i64 %arg.shape.1, 136
  %.1807.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1807.i.idx.i
  %.1832.i.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1789.i.i
  %.153.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.499.i.i.idx.i = mul i64 %arg.lane.0.5.1, 48
  %.499.i.i.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.499.i.i.idx.i
  %.503.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.520.i.i.i = select i1 %.1556.i2382.not.i, i64 %arg.arrays.0.5.0, i64 0
  %.idx.i9716 = mul i64 %arg.shape.1, 152
  %200 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i9716
  %.534.i.i.i = getelementptr double, ptr %200, i64 %.520.i.i.i
  %.897.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1279.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1279.i.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1279.i.i.idx.i
  %.2636.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2423.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx2423.i
  %.idx2424.i = mul i64 %arg.shape.1, 144
  %invariant.gep10035 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %invariant.gep10037 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %.663.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.711.i = icmp sgt i64 %arg.shape.1, 0
  %.743.sroa.0.02358.i = add i64 %arg.shape.1, 1
  %.1140.idx.i = mul i64 %arg.lane.0.5.1, 160
  %.1140.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.1140.idx.i
  %.1724 = add i64 %arg.shape.3, -1
  %storemerge9607 = tail call i64 @llvm.smax.i64(i64 %.1724, i64 0)
  %.176710043.not = icmp slt i64 %.1724, 1
  %.1940.idx = mul i64 %.388, 136
  %.1940 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1940.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i9719 = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i, i64 %arg.linear.1.5.0, i64 0
  %.274.i = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i, 0
  %.282.not.i = icmp slt i64 %.274.i, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i9722 = mul i64 %arg.shape.1, 80
  %invariant.gep10039 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i9722
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep10041 = getelementptr double, ptr %arg.arrays.0.4, i64 %.887.i
  %.2043 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2125 = icmp sgt i64 %arg.guarded, 0
  %.2130 = icmp sgt i64 %arg.decided, 0
  %.idx9670 = mul i64 %arg.lane.0.5.1, 40
  %201 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9670
  %.idx9671 = mul i64 %arg.lane.0.5.1, 184
  %202 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9671
  %.idx9667 = mul i64 %arg.lane.0.5.1, 192
  %203 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9667
  %.idx9668 = mul i64 %arg.lane.0.5.1, 200
  %204 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9668
  %.idx9669 = mul i64 %arg.lane.0.5.1, 176
  %205 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9669
  %.idx9661 = shl i64 %arg.lane.1.5.1, 4
  %206 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9661
  %.idx9662 = mul i64 %arg.lane.0.5.1, 208
  %207 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9662
  %.idx9663 = mul i64 %arg.lane.0.5.1, 72
  %208 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9663
  %.idx9664 = mul i64 %arg.lane.0.5.1, 40
  %209 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9664
  %.idx9665 = mul i64 %arg.lane.0.5.1, 144
  %210 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9665
  %.idx9666 = mul i64 %arg.lane.0.5.1, 56
  %211 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9666
  %.3673.idx = mul i64 %.388, 136
  %.3673 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3673.idx
  %.3698.idx = mul i64 %.388, 104
  %.3698 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3698.idx
  %.3736 = getelementptr i8, ptr %arg.code.4, i64 232
  %.3832 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3854.idx = mul i64 %.388, 136
  %.3854 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3854.idx
  %.idx9656 = mul i64 %arg.lane.0.5.1, 96
  %212 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9656
  %.idx9657 = mul i64 %arg.lane.0.5.1, 40
  %213 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9657
  %.idx9658 = mul i64 %arg.lane.0.5.1, 104
  %214 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9658
  %.idx9659 = mul i64 %arg.lane.0.5.1, 112
  %215 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9659
  %.idx9660 = shl i64 %arg.lane.1.5.1, 5
  %216 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9660
  %.4195.idx = mul i64 %.388, 136
  %.4195 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4195.idx
  %.4258 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4335 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx9648 = shl i64 %arg.lane.1.5.1, 4
  %217 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9648
  %.idx9649 = mul i64 %arg.lane.0.5.1, 40
  %218 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9649
  %.idx9650 = mul i64 %arg.lane.0.5.1, 56
  %219 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9650
  %.idx9651 = mul i64 %arg.lane.0.5.1, 240
  %220 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9651
  %.idx9652 = shl i64 %arg.lane.0.5.1, 5
  %221 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9652
  %.idx9653 = mul i64 %arg.lane.0.5.1, 96
  %222 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9653
  %.idx9654 = mul i64 %arg.lane.0.5.1, 48
  %223 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9654
  %224 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx9655 = mul i64 %arg.lane.0.5.1, 248
  %225 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9655
  %.4335.c = getelementptr i8, ptr %arg.code.4, i64 104
  %.692.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.784.i.idx = shl i64 %factor.op.mul, 4
  %.784.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.784.i.idx
  %.idx1194.i = mul i64 %arg.lane.0.5.1, 104
  %226 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1194.i
  %.idx1195.i = mul i64 %arg.lane.0.5.1, 112
  %227 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1195.i
  %.idx1196.i = mul i64 %arg.lane.0.5.1, 96
  %228 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1196.i
  %.idx1197.i = mul i64 %arg.lane.0.5.1, 48
  %229 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1197.i
  %.287.i1204.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i = shl nsw i64 %arg.shape.1, 1
  %storemerge1193.i = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i9742 = mul i64 %arg.lane.0.5.1, 56
  %230 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i9742
  %.idx1185.i = mul i64 %arg.lane.0.5.1, 40
  %231 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1185.i
  %.idx1186.i = shl i64 %arg.lane.0.5.1, 5
  %232 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1186.i
  %233 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.4521.not = icmp eq i64 %arg.guarded, 0
  %.9690 = select i1 %.537.not, i64 16, i64 1
  %.522.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.614.i9752.idx = shl i64 %factor.op.mul10165, 4
  %.614.i9752 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.614.i9752.idx
  %.448.i = uitofp i64 %.9690 to double
  %.idx673.i = mul i64 %arg.lane.0.5.1, 48
  %234 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx673.i
  %.287.i679.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i9753 = shl nsw i64 %arg.shape.1, 1
  %.idx.i9754 = mul i64 %arg.lane.0.5.1, 40
  %235 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i9754
  %.155.i.i.i9763 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i9770 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i9776 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i9782 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i9788 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i9794 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i9800 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.idx.i9817 = shl i64 %arg.lane.1.5.1, 4
  %236 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i9817
  %.idx640.i = mul i64 %arg.lane.0.5.1, 40
  %237 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.lane.0.5.1, 48
  %238 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.lane.0.5.1, 56
  %239 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx642.i
  %.920649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.lane.0.5.1, 248
  %240 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx644.i
  %.996.i = mul nsw i64 %arg.shape.1, 17
  %241 = add i64 %arg.times.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx9647 = mul i64 %arg.lane.0.5.1, 40
  %242 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9647
  %.idx = mul i64 %arg.lane.0.5.1, 40
  %243 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx9615 = mul i64 %arg.lane.0.5.1, 56
  %244 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9615
  %.418.i413310134.not = icmp slt i64 %arg.shape.1, 1
  %.457.i4144 = mul nsw i64 %arg.shape.1, 17
  %.4992 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx9640 = mul i64 %arg.lane.0.5.1, 96
  %245 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9640
  %.idx9641 = mul i64 %arg.lane.0.5.1, 40
  %246 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9641
  %.idx9642 = mul i64 %arg.lane.0.5.1, 120
  %247 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9642
  %.548.i467010140.not = icmp slt i64 %arg.shape.1, 1
  %.693.i4707 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %248 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.738.i4737 = getelementptr i8, ptr %248, i64 -8
  %.idx9644 = mul i64 %arg.lane.1.5.1, 24
  %249 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9644
  %.idx9645 = mul i64 %arg.lane.1.5.1, 24
  %250 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9645
  %.idx9646 = mul i64 %arg.lane.0.5.1, 24
  %251 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9646
  %.5139.not = icmp ne i64 %arg.jumping, 0
  %.idx1932.i = mul i64 %arg.lane.0.5.1, 40
  %252 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1932.i
  %.idx1933.i = shl i64 %arg.lane.0.5.1, 4
  %253 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1933.i
  %254 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.190.i5541935.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.289.i.i9836 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.774.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.917.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.988.i9842 = mul nsw i64 %arg.shape.1, 17
  %.990.i9843 = mul nsw i64 %.988.i9842, %arg.shape.0
  %.1033.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.990.i9843
  %.idx1930.i = shl i64 %arg.lane.1.5.1, 4
  %255 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1930.i
  %.15141942.not.i = icmp slt i64 %arg.shape.1, 1
  %.1709.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.1798.not.i = icmp eq i64 %arg.guarded, 0
  %.1830.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx9623 = mul i64 %arg.lane.0.5.1, 40
  %256 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9623
  %.idx9624 = shl i64 %arg.lane.0.5.1, 4
  %257 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9624
  %258 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx9625 = mul i64 %arg.lane.0.5.1, 24
  %259 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9625
  %.190.i.i694310152.not = icmp slt i64 %arg.schedule.2.5.0, 1
  %.289.i.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.idx9628 = shl i64 %arg.lane.1.5.1, 4
  %260 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9628
  %.364.i9858 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %261 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.6871761.not.i10002 = icmp slt i64 %arg.shape.1, 1
  %.842.i10010 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9571764.not.i9863 = icmp slt i64 %arg.shape.2, 1
  %.190.i1767.not.i9883 = icmp slt i64 %arg.schedule.2.5.0, 1
  %.295.i.i9889 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1188.i9904 = icmp sgt i64 %arg.shape.0, 1
  %.166.i801770.not.i9907 = icmp slt i64 %arg.shape.1, 1
  %262 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1742.i9924 = shl i64 %arg.lane.0.5.1, 4
  %263 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1742.i9924
  %.idx1743.i9926 = mul i64 %arg.lane.0.5.1, 24
  %264 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1743.i9926
  %.idx1744.i9928 = shl i64 %arg.lane.0.5.1, 5
  %265 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1744.i9928
  %.idx1745.i9930 = mul i64 %arg.lane.0.5.1, 168
  %266 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1745.i9930
  %.idx1746.i9932 = mul i64 %arg.lane.0.5.1, 248
  %267 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1746.i9932
  %.13511773.not.i9935 = icmp slt i64 %arg.shape.1, 1
  %.idx1749.i9963 = shl i64 %arg.lane.0.5.1, 4
  %268 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1749.i9963
  %269 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1750.i9966 = mul i64 %arg.lane.0.5.1, 24
  %270 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1750.i9966
  %.idx1751.i9968 = shl i64 %arg.lane.0.5.1, 5
  %271 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1751.i9968
  %.idx1752.i9970 = mul i64 %arg.lane.0.5.1, 120
  %272 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1752.i9970
  %.idx1753.i9973 = mul i64 %arg.lane.1.5.1, 24
  %273 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1753.i9973
  %.idx1754.i9975 = mul i64 %arg.lane.0.5.1, 248
  %274 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1754.i9975
  %.idx1755.i9977 = mul i64 %arg.lane.0.5.1, 224
  %275 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1755.i9977
  %.idx1756.i9979 = mul i64 %arg.lane.0.5.1, 232
  %276 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1756.i9979
  %.idx1757.i9981 = mul i64 %arg.lane.0.5.1, 192
  %277 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1757.i9981
  %.idx1758.i9983 = mul i64 %arg.lane.0.5.1, 200
  %278 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1758.i9983
  %.idx1759.i9985 = mul i64 %arg.lane.0.5.1, 152
  %279 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1759.i9985
  %.idx1760.i9987 = mul i64 %arg.lane.0.5.1, 144
  %280 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1760.i9987
  %.idx9627 = mul i64 %arg.lane.0.5.1, 144
  %281 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9627
  %.6319 = tail call i64 @llvm.smin.i64(i64 %arg.times.5.0, i64 0)
  %282 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %283 = getelementptr i8, ptr %282, i64 -8
  %.6333 = getelementptr double, ptr %283, i64 %.6319
  %284 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx9629 = mul i64 %arg.lane.0.5.1, 144
  %285 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9629
  %.idx9630 = mul i64 %arg.lane.0.5.1, 176
  %286 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9630
  %.idx9631 = shl i64 %arg.lane.1.5.1, 4
  %287 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx9631
  %.idx9632 = shl i64 %arg.lane.0.5.1, 4
  %288 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9632
  %.idx9633 = mul i64 %arg.lane.0.5.1, 168
  %289 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9633
  %.166.i541010155.not = icmp slt i64 %arg.shape.1, 1
  %290 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx9635 = shl i64 %arg.lane.0.5.1, 4
  %291 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9635
  %.idx9636 = mul i64 %arg.lane.0.5.1, 24
  %292 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9636
  %.idx9637 = shl i64 %arg.lane.0.5.1, 5
  %293 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9637
  %.idx9638 = mul i64 %arg.lane.0.5.1, 168
  %294 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9638
  %.idx9639 = mul i64 %arg.lane.0.5.1, 248
  %295 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx9639
  %296 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4220.idx = mul i64 %.388, 112
  %.4220 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4220.idx
  %297 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4220.1.idx = mul i64 %.388, 120
  %.4220.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4220.1.idx
  %298 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4220.2.idx = shl i64 %.388, 7
  %.4220.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4220.2.idx
  br label %B266

B1232.if:                                         ; preds = %B1200, %B1456
  %.1711.010044 = phi i64 [ %.1780, %B1456 ], [ 1, %B1200 ]
  %.1780 = add i64 %.1711.010044, 1
  %299 = getelementptr i64, ptr %arg.code.4, i64 %.1711.010044
  %300 = getelementptr i8, ptr %299, i64 104
  %.1839 = load i64, ptr %300, align 8
  %.1884 = inttoptr i64 %.1839 to ptr
  tail call void %.1884(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1915 = load i64, ptr %arg.code.4, align 8
  %.1921 = mul nsw i64 %.1780, %.388
  %.1965 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1921
  %.1966 = inttoptr i64 %.1915 to ptr
  tail call void %.1966(ptr %.496, ptr %.1940, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1965)
  br i1 %.535, label %B1420, label %B1456

B1602.if:                                         ; preds = %B1458, %B1688
  %looked.4.210050 = phi i1 [ %"$phi1688.1.2.2", %B1688 ], [ %spec.select9700, %B1458 ]
  %good.2.110049 = phi i1 [ %"$phi1646.1.2.2", %B1688 ], [ false, %B1458 ]
  %.2173.010048 = phi i64 [ %.2235, %B1688 ], [ %storemerge, %B1458 ]
  %.2170.010047 = phi i64 [ %.2239, %B1688 ], [ 0, %B1458 ]
  %.2235 = add nsw i64 %.2173.010048, -1
  %.2239 = add nsw i64 %.2170.010047, 1
  br i1 %good.2.110049, label %B1646, label %B1610

B1766.if:                                         ; preds = %B1764.preheader, %B2326
  %doubted.3.210061 = phi i1 [ %doubted.4.3, %B2326 ], [ false, %B1764.preheader ]
  %within.3.210060 = phi i1 [ %within.4.3, %B2326 ], [ false, %B1764.preheader ]
  %wanted.3.210059 = phi i1 [ %wanted.4.3, %B2326 ], [ false, %B1764.preheader ]
  %.2534.010058 = phi i64 [ %.2606, %B2326 ], [ %storemerge, %B1764.preheader ]
  %.2531.010057 = phi i64 [ %.2610, %B2326 ], [ 0, %B1764.preheader ]
  %.2606 = add nsw i64 %.2534.010058, -1
  %.2610 = add nsw i64 %.2531.010057, 1
  %.2697 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2531.010057
  %.2698 = load i64, ptr %.2697, align 8
  %.2752 = getelementptr i64, ptr %206, i64 %.2531.010057
  %.2753 = load i64, ptr %.2752, align 8
  %.2813 = getelementptr double, ptr %207, i64 %.2531.010057
  store double 0.000000e+00, ptr %.2813, align 8
  %.2816 = icmp sgt i64 %.2698, -1
  br i1 %.2816, label %B1866, label %B2326

B46.i2255:                                        ; preds = %B1904
  %.120.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i2248
  %.121.i2281 = load i64, ptr %.120.i, align 8, !noalias !61
  %.122.i2282 = icmp eq i64 %.121.i2281, 0
  br i1 %.122.i2282, label %B80.i, label %B2004

B80.i:                                            ; preds = %B46.i2255
  store i64 %.5.i, ptr %.120.i, align 8, !noalias !61
  br label %B2004

B2730.if:                                         ; preds = %B2682
  %.4095 = load i64, ptr %296, align 8
  %.4140 = inttoptr i64 %.4095 to ptr
  tail call void %.4140(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4171 = load i64, ptr %arg.code.4, align 8
  %.4221 = inttoptr i64 %.4171 to ptr
  tail call void %.4221(ptr %.496, ptr %.4195, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4220)
  %.4095.1 = load i64, ptr %297, align 8
  %.4140.1 = inttoptr i64 %.4095.1 to ptr
  tail call void %.4140.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4171.1 = load i64, ptr %arg.code.4, align 8
  %.4221.1 = inttoptr i64 %.4171.1 to ptr
  tail call void %.4221.1(ptr %.496, ptr %.4195, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4220.1)
  %.4095.2 = load i64, ptr %298, align 8
  %.4140.2 = inttoptr i64 %.4095.2 to ptr
  tail call void %.4140.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4171.2 = load i64, ptr %arg.code.4, align 8
  %.4221.2 = inttoptr i64 %.4171.2 to ptr
  tail call void %.4221.2(ptr %.496, ptr %.4195, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4220.2)
  %.4259 = load i64, ptr %.4258, align 8
  %.4304 = inttoptr i64 %.4259 to ptr
  tail call void %.4304(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4336 = load i64, ptr %.4335, align 8
  %.4381 = inttoptr i64 %.4336 to ptr
  tail call void %.4381(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.276.i, label %B3098, label %B66.if.i

B3298.if:                                         ; preds = %B3264, %B3298.if
  %taken.2.110132 = phi i64 [ %.4942, %B3298.if ], [ 0, %B3264 ]
  %.4780.010131 = phi i64 [ %.4842, %B3298.if ], [ %storemerge, %B3264 ]
  %.4777.010130 = phi i64 [ %.4846, %B3298.if ], [ 0, %B3264 ]
  %.4842 = add nsw i64 %.4780.010131, -1
  %.4846 = add nsw i64 %.4777.010130, 1
  %301 = getelementptr double, ptr %242, i64 %.4777.010130
  %.4924 = load double, ptr %301, align 8
  %.4925 = fcmp ogt double %.4924, 5.000000e-01
  %.9694 = zext i1 %.4925 to i64
  %.4942 = add nsw i64 %taken.2.110132, %.9694
  %.4833 = icmp sgt i64 %.4780.010131, 1
  br i1 %.4833, label %B3298.if, label %B3356

B3612.if:                                         ; preds = %B3574, %B4403
  %active.3.210162 = phi i64 [ %active.4.3, %B4403 ], [ %active.6.0, %B3574 ]
  %budget.5.210161 = phi i64 [ %budget.6.3, %B4403 ], [ %.689, %B3574 ]
  %.5306.010160 = phi i64 [ %.5375, %B4403 ], [ %storemerge, %B3574 ]
  %.5303.010159 = phi i64 [ %.5379, %B4403 ], [ 0, %B3574 ]
  %.5375 = add nsw i64 %.5306.010160, -1
  %.5379 = add nsw i64 %.5303.010159, 1
  %.5464 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5303.010159
  %.5465 = load i64, ptr %.5464, align 8
  %.5470 = icmp slt i64 %.5465, 0
  br i1 %.5470, label %B3658, label %B3698

B4402.endif:                                      ; preds = %B468.i1596, %B4402
  store i64 %active.8.1, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

define dso_local noundef i32 @ask(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.role, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.states.0, ptr readnone %arg.states.1, i64 %arg.states.2, i64 %arg.states.3, ptr %arg.states.4, i64 %arg.states.5.0, i64 %arg.states.6.0, i64 %arg.n, ptr readnone %arg.pieces.0, ptr readnone %arg.pieces.1, i64 %arg.pieces.2, i64 %arg.pieces.3, ptr readonly %arg.pieces.4, i64 %arg.pieces.5.0, i64 %arg.pieces.6.0, ptr readnone %arg.places.0, ptr readnone %arg.places.1, i64 %arg.places.2, i64 %arg.places.3, ptr readonly %arg.places.4, i64 %arg.places.5.0, i64 %arg.places.6.0, ptr readnone %arg.values.0, ptr readnone %arg.values.1, i64 %arg.values.2, i64 %arg.values.3, ptr readonly %arg.values.4, i64 %arg.values.5.0, i64 %arg.values.5.1, i64 %arg.values.6.0, i64 %arg.values.6.1, ptr readnone %arg.t.0, ptr readnone %arg.t.1, i64 %arg.t.2, i64 %arg.t.3, ptr %arg.t.4, i64 %arg.t.5.0, i64 %arg.t.6.0, ptr readnone %arg.P.0, ptr readnone %arg.P.1, i64 %arg.P.2, i64 %arg.P.3, ptr %arg.P.4, i64 %arg.P.5.0, i64 %arg.P.6.0, ptr readnone %arg.T.0, ptr readnone %arg.T.1, i64 %arg.T.2, i64 %arg.T.3, ptr %arg.T.4, i64 %arg.T.5.0, i64 %arg.T.6.0, ptr readnone %arg.W.0, ptr readnone %arg.W.1, i64 %arg.W.2, i64 %arg.W.3, ptr %arg.W.4, i64 %arg.W.5.0, i64 %arg.W.6.0, ptr readnone %arg.D.0, ptr readnone %arg.D.1, i64 %arg.D.2, i64 %arg.D.3, ptr %arg.D.4, i64 %arg.D.5.0, i64 %arg.D.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.244546.not = icmp slt i64 %arg.times.5.0, 1
  br i1 %.244546.not, label %B466, label %B64.if.lr.ph

B64.if.lr.ph:                                     ; preds = %entry
  %.511540.not = icmp slt i64 %arg.places.5.0, 1
  %.698 = getelementptr i8, ptr %arg.code.4, i64 8
  %.764 = icmp slt i64 %arg.role, 0
  %.765 = select i1 %.764, i64 %arg.code.5.0, i64 0
  %0 = getelementptr i64, ptr %arg.code.4, i64 %arg.role
  %.779 = getelementptr i64, ptr %0, i64 %.765
  %.926543.not = icmp slt i64 %arg.out.5.1, 1
  br label %B64.if

B64.loopexit:                                     ; preds = %B432.if, %B304
  %exitcond551.not = icmp eq i64 %.257, %arg.times.5.0
  br i1 %exitcond551.not, label %B466, label %B64.if

B114:                                             ; preds = %B64.if
  br i1 %.511540.not, label %B230, label %B186.if.lr.ph

B186.if.lr.ph:                                    ; preds = %B114
  %.572 = icmp slt i64 %.380, 0
  %.573 = select i1 %.572, i64 %arg.values.5.0, i64 0
  %.574 = add i64 %.573, %.380
  %.594 = mul i64 %.574, %arg.values.5.1
  %1 = getelementptr double, ptr %arg.values.4, i64 %.594
  br label %B186.if

B230:                                             ; preds = %B186.if, %B114
  %.699 = load i64, ptr %.698, align 8
  %.702 = mul nsw i64 %.186.0547, %arg.n
  %.721 = getelementptr double, ptr %arg.states.4, i64 %.702
  %.747 = inttoptr i64 %.699 to ptr
  tail call void %.747(ptr nonnull %arg.t.4, ptr %.721, ptr %arg.P.4, ptr %arg.T.4, ptr %arg.W.4, ptr %arg.W.4)
  br label %B304

B304:                                             ; preds = %B230, %B64.if
  %piece.3.1 = phi i64 [ %.380, %B230 ], [ %piece.2.0549, %B64.if ]
  %.780 = load i64, ptr %.779, align 8
  %.783 = mul nsw i64 %.186.0547, %arg.n
  %.787 = mul nsw i64 %.257, %arg.n
  %.806 = getelementptr double, ptr %arg.states.4, i64 %.783
  %.831 = getelementptr double, ptr %arg.D.4, i64 %.787
  %.832 = inttoptr i64 %.780 to ptr
  tail call void %.832(ptr nonnull %arg.t.4, ptr %.806, ptr %arg.P.4, ptr %arg.T.4, ptr %arg.W.4, ptr %.831)
  br i1 %.926543.not, label %B64.loopexit, label %B432.if.lr.ph

B432.if.lr.ph:                                    ; preds = %B304
  %.1039 = mul i64 %.186.0547, %arg.out.5.1
  %2 = getelementptr double, ptr %arg.out.4, i64 %.1039
  br label %B432.if

B466:                                             ; preds = %B64.loopexit, %entry
  store ptr null, ptr %retptr, align 8
  ret i32 0

B64.if:                                           ; preds = %B64.if.lr.ph, %B64.loopexit
  %piece.2.0549 = phi i64 [ -1, %B64.if.lr.ph ], [ %piece.3.1, %B64.loopexit ]
  %.186.0547 = phi i64 [ 0, %B64.if.lr.ph ], [ %.257, %B64.loopexit ]
  %.257 = add nsw i64 %.186.0547, 1
  %3 = getelementptr double, ptr %arg.times.4, i64 %.186.0547
  %.319 = load double, ptr %3, align 8
  store double %.319, ptr %arg.t.4, align 8
  %4 = getelementptr i64, ptr %arg.pieces.4, i64 %.186.0547
  %.380 = load i64, ptr %4, align 8
  %.382.not = icmp eq i64 %.380, %piece.2.0549
  br i1 %.382.not, label %B304, label %B114

B186.if:                                          ; preds = %B186.if.lr.ph, %B186.if
  %.455.0541 = phi i64 [ 0, %B186.if.lr.ph ], [ %.524, %B186.if ]
  %.524 = add nsw i64 %.455.0541, 1
  %5 = getelementptr double, ptr %1, i64 %.455.0541
  %.599 = load double, ptr %5, align 8
  %6 = getelementptr i64, ptr %arg.places.4, i64 %.455.0541
  %.629 = load i64, ptr %6, align 8
  %.643 = icmp slt i64 %.629, 0
  %.644 = select i1 %.643, i64 %arg.P.5.0, i64 0
  %7 = getelementptr double, ptr %arg.P.4, i64 %.629
  %.658 = getelementptr double, ptr %7, i64 %.644
  store double %.599, ptr %.658, align 8
  %exitcond.not = icmp eq i64 %arg.places.5.0, %.524
  br i1 %exitcond.not, label %B230, label %B186.if

B432.if:                                          ; preds = %B432.if.lr.ph, %B432.if
  %.870.0544 = phi i64 [ 0, %B432.if.lr.ph ], [ %.939, %B432.if ]
  %.939 = add nsw i64 %.870.0544, 1
  %8 = getelementptr double, ptr %arg.W.4, i64 %.870.0544
  %.993 = load double, ptr %8, align 8
  %9 = getelementptr double, ptr %2, i64 %.870.0544
  store double %.993, ptr %9, align 8
  %exitcond550.not = icmp eq i64 %arg.out.5.1, %.939
  br i1 %exitcond550.not, label %B64.loopexit, label %B432.if
}


!0 = !{!1, !3, !5}
!1 = distinct !{!1, !2, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = distinct !{!3, !4, !"_ZN12clpt_control6native9for_numba5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!4 = distinct !{!4, !"_ZN12clpt_control6native9for_numba5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!5 = distinct !{!5, !4, !"_ZN12clpt_control6native9for_numba5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!6 = !{!7, !9, !1, !3, !5}
!7 = distinct !{!7, !8, !"_ZN12clpt_control6native9for_numba9set_pieceB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEEx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN12clpt_control6native9for_numba9set_pieceB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEEx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!9 = distinct !{!9, !8, !"_ZN12clpt_control6native9for_numba9set_pieceB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEEx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!10 = !{!11, !13, !1, !3, !5}
!11 = distinct !{!11, !12, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!12 = distinct !{!12, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!13 = distinct !{!13, !12, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!14 = !{!3, !5}
!15 = !{!16, !18}
!16 = distinct !{!16, !17, !"_ZN12clpt_control6native9for_numba6decideB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!17 = distinct !{!17, !"_ZN12clpt_control6native9for_numba6decideB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!18 = distinct !{!18, !17, !"_ZN12clpt_control6native9for_numba6decideB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!19 = !{!20, !22}
!20 = distinct !{!20, !21, !"_ZN12clpt_control6native9for_numba5beginB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExb5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!21 = distinct !{!21, !"_ZN12clpt_control6native9for_numba5beginB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExb5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!22 = distinct !{!22, !21, !"_ZN12clpt_control6native9for_numba5beginB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExb5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!23 = !{!24, !20, !22}
!24 = distinct !{!24, !25, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!25 = distinct !{!25, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!26 = !{!27, !20, !22}
!27 = distinct !{!27, !28, !"_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!28 = distinct !{!28, !"_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!29 = !{!30, !32, !20, !22}
!30 = distinct !{!30, !31, !"_ZN12clpt_control6native9for_numba10look_aheadB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!31 = distinct !{!31, !"_ZN12clpt_control6native9for_numba10look_aheadB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!32 = distinct !{!32, !31, !"_ZN12clpt_control6native9for_numba10look_aheadB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!33 = !{!"branch_weights", i32 99, i32 1}
!34 = !{!35, !37, !38}
!35 = distinct !{!35, !36, !"_ZN12clpt_control6native9for_numba13differentiateB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!36 = distinct !{!36, !"_ZN12clpt_control6native9for_numba13differentiateB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!37 = distinct !{!37, !36, !"_ZN12clpt_control6native9for_numba13differentiateB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!38 = distinct !{!38, !39, !"_ZN12clpt_control6native9for_numba9lineariseB3v12B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!39 = distinct !{!39, !"_ZN12clpt_control6native9for_numba9lineariseB3v12B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!40 = !{!"branch_weights", i32 1, i32 99}
!41 = !{!42, !44, !35, !37, !38}
!42 = distinct !{!42, !43, !"_ZN12clpt_control6native9for_numba14by_differencesB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!43 = distinct !{!43, !"_ZN12clpt_control6native9for_numba14by_differencesB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!44 = distinct !{!44, !43, !"_ZN12clpt_control6native9for_numba14by_differencesB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!45 = !{!"branch_weights", i32 199, i32 9801}
!46 = !{!38}
!47 = !{!48, !38}
!48 = distinct !{!48, !49, !"_ZN12clpt_control6native16linear_equations6factorB3v18B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN12clpt_control6native16linear_equations6factorB3v18B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN12clpt_control6native9for_numba11solve_stageB3v19B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN12clpt_control6native9for_numba11solve_stageB3v19B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!53 = !{!54, !56, !51}
!54 = distinct !{!54, !55, !"_ZN12clpt_control6native16linear_equations5solveB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!55 = distinct !{!55, !"_ZN12clpt_control6native16linear_equations5solveB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!56 = distinct !{!56, !55, !"_ZN12clpt_control6native16linear_equations5solveB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!57 = !{!58, !60}
!58 = distinct !{!58, !59, !"_ZN12clpt_control6native9for_numba5countB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!59 = distinct !{!59, !"_ZN12clpt_control6native9for_numba5countB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!60 = distinct !{!60, !59, !"_ZN12clpt_control6native9for_numba5countB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!61 = !{!62}
!62 = distinct !{!62, !63, !"_ZN12clpt_control6native9for_numba4failB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!63 = distinct !{!63, !"_ZN12clpt_control6native9for_numba4failB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!64 = !{!65, !67}
!65 = distinct !{!65, !66, !"_ZN12clpt_control6native9for_numba6passesB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!66 = distinct !{!66, !"_ZN12clpt_control6native9for_numba6passesB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!67 = distinct !{!67, !66, !"_ZN12clpt_control6native9for_numba6passesB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!68 = !{!69, !71, !65, !67}
!69 = distinct !{!69, !70, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!71 = distinct !{!71, !70, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!72 = !{!73, !75}
!73 = distinct !{!73, !74, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!74 = distinct !{!74, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!75 = distinct !{!75, !74, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!76 = !{!77}
!77 = distinct !{!77, !78, !"_ZN12clpt_control6native9for_numba5crossB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi4EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!78 = distinct !{!78, !"_ZN12clpt_control6native9for_numba5crossB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi4EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!79 = !{!80, !82, !83, !85, !77}
!80 = distinct !{!80, !81, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!81 = distinct !{!81, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!82 = distinct !{!82, !81, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!83 = distinct !{!83, !84, !"_ZN12clpt_control6native9for_numba11look_withinB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!84 = distinct !{!84, !"_ZN12clpt_control6native9for_numba11look_withinB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!85 = distinct !{!85, !84, !"_ZN12clpt_control6native9for_numba11look_withinB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!86 = !{!83, !85, !77}
!87 = !{!88, !90, !77}
!88 = distinct !{!88, !89, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!89 = distinct !{!89, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!90 = distinct !{!90, !89, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!91 = !{!92}
!92 = distinct !{!92, !93, !"_ZN12clpt_control6native9for_numba5watchB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi4EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!93 = distinct !{!93, !"_ZN12clpt_control6native9for_numba5watchB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi4EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!94 = !{!95, !92}
!95 = distinct !{!95, !96, !"_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!96 = distinct !{!96, !"_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!97 = !{!98, !100, !92}
!98 = distinct !{!98, !99, !"_ZN12clpt_control6native9for_numba11look_withinB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!99 = distinct !{!99, !"_ZN12clpt_control6native9for_numba11look_withinB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!100 = distinct !{!100, !99, !"_ZN12clpt_control6native9for_numba11look_withinB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!101 = !{!102, !104, !98, !100, !92}
!102 = distinct !{!102, !103, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!103 = distinct !{!103, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!104 = distinct !{!104, !103, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!105 = !{!106}
!106 = distinct !{!106, !107, !"_ZN12clpt_control6native9for_numba6sampleB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi4EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!107 = distinct !{!107, !"_ZN12clpt_control6native9for_numba6sampleB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi4EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!108 = !{!109, !111, !106}
!109 = distinct !{!109, !110, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!110 = distinct !{!110, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!111 = distinct !{!111, !110, !"_ZN12clpt_control6native9for_numba7betweenB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!112 = !{!113, !115}
!113 = distinct !{!113, !114, !"_ZN12clpt_control6native9for_numba6acceptB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!114 = distinct !{!114, !"_ZN12clpt_control6native9for_numba6acceptB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!115 = distinct !{!115, !114, !"_ZN12clpt_control6native9for_numba6acceptB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!116 = !{!117, !119}
!117 = distinct !{!117, !118, !"_ZN12clpt_control6native9for_numba11decide_anewB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!118 = distinct !{!118, !"_ZN12clpt_control6native9for_numba11decide_anewB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!119 = distinct !{!119, !118, !"_ZN12clpt_control6native9for_numba11decide_anewB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!120 = !{!121, !117, !119}
!121 = distinct !{!121, !122, !"_ZN12clpt_control6native9for_numba4failB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!122 = distinct !{!122, !"_ZN12clpt_control6native9for_numba4failB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!123 = !{!124, !126}
!124 = distinct !{!124, !125, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!125 = distinct !{!125, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!126 = distinct !{!126, !127, !"_ZN12clpt_control6native9for_numba4leapB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!127 = distinct !{!127, !"_ZN12clpt_control6native9for_numba4leapB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!128 = !{!126}
!129 = !{!130, !132, !126}
!130 = distinct !{!130, !131, !"_ZN12clpt_control6native9for_numba9set_pieceB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!131 = distinct !{!131, !"_ZN12clpt_control6native9for_numba9set_pieceB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEExx5ArrayIdLi1E1C7mutable7alignedE"}
!132 = distinct !{!132, !131, !"_ZN12clpt_control6native9for_numba9set_pieceB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!133 = !{!134, !126}
!134 = distinct !{!134, !135, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!135 = distinct !{!135, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!136 = !{!137, !126}
!137 = distinct !{!137, !138, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!138 = distinct !{!138, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!139 = !{!140, !126}
!140 = distinct !{!140, !141, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!141 = distinct !{!141, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!142 = !{!143, !126}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba4failB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!145 = !{!146, !148}
!146 = distinct !{!146, !147, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!147 = distinct !{!147, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!148 = distinct !{!148, !147, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!149 = !{!150}
!150 = distinct !{!150, !151, !"_ZN12clpt_control6native9for_numba4failB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!151 = distinct !{!151, !"_ZN12clpt_control6native9for_numba4failB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!152 = !{!153, !155}
!153 = distinct !{!153, !154, !"_ZN12clpt_control6native9for_numba5enterB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!154 = distinct !{!154, !"_ZN12clpt_control6native9for_numba5enterB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!155 = distinct !{!155, !154, !"_ZN12clpt_control6native9for_numba5enterB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!156 = !{!157, !159, !153, !155}
!157 = distinct !{!157, !158, !"_ZN12clpt_control6native9for_numba9set_pieceB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!158 = distinct !{!158, !"_ZN12clpt_control6native9for_numba9set_pieceB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEExx5ArrayIdLi1E1C7mutable7alignedE"}
!159 = distinct !{!159, !158, !"_ZN12clpt_control6native9for_numba9set_pieceB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEExx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!160 = !{!161}
!161 = distinct !{!161, !162, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!162 = distinct !{!162, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!163 = !{!164, !166, !161}
!164 = distinct !{!164, !165, !"_ZN12clpt_control6native9for_numba9set_pieceB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEEx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!165 = distinct !{!165, !"_ZN12clpt_control6native9for_numba9set_pieceB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEEx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE"}
!166 = distinct !{!166, !165, !"_ZN12clpt_control6native9for_numba9set_pieceB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEEx23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!167 = !{!168, !170, !161}
!168 = distinct !{!168, !169, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!169 = distinct !{!169, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!170 = distinct !{!170, !169, !"_ZN12clpt_control6native9for_numba4restB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi4EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!171 = !{!172, !174}
!172 = distinct !{!172, !173, !"_ZN12clpt_control6native9for_numba10look_againB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!173 = distinct !{!173, !"_ZN12clpt_control6native9for_numba10look_againB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!174 = distinct !{!174, !173, !"_ZN12clpt_control6native9for_numba10look_againB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!175 = !{!176, !178, !172, !174}
!176 = distinct !{!176, !177, !"_ZN12clpt_control6native9for_numba10look_aheadB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!177 = distinct !{!177, !"_ZN12clpt_control6native9for_numba10look_aheadB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!178 = distinct !{!178, !177, !"_ZN12clpt_control6native9for_numba10look_aheadB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!179 = !{!180, !182}
!180 = distinct !{!180, !181, !"_ZN12clpt_control6native9for_numba5countB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!181 = distinct !{!181, !"_ZN12clpt_control6native9for_numba5countB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!182 = distinct !{!182, !181, !"_ZN12clpt_control6native9for_numba5countB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
