# gnuplot -e "data='folder'; out='file.svg'" plot.gnuplot
set terminal svg size 1000,380 font "DejaVu Sans,13" background "white"
set output out
set multiplot layout 1,3 title "Prefiltered radiance of a sunset: error against the number of samples"
set logscale xy
set xrange [16:16384]
set yrange [1e-3:2]
set format y "10^{%L}"
set xtics (16, 128, 1024, 8192)
set grid ytics lc rgb "#dddddd"
set xlabel "samples"
set ylabel "relative rms error"
set key bottom left
do for [r in "3 5 8"] {
    set label 1 "roughness 0.".r at graph 0.5,0.94 center
    plot data."/".r.".dat" using 1:3 with linespoints lw 2 pt 7 ps 0.5 lc rgb "#cc3311" title "unfiltered", \
         data."/".r.".dat" using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb "#0072b2" title "filtered"
    unset key
    unset ylabel
}
unset multiplot
