"""Verner's most efficient pair of orders 7 and 6, as text for the compiler.

Ten stages, an error estimate from the embedded method of order 6 (J. H. Verner,
"Numerically optimal Runge-Kutta pairs with interpolants", Numerical Algorithms
53, 2010).  It is the cheaper method for errors of 1e-5 to 1e-9, where samples
are few: steps end at every sample, for the interpolant would take six stages
more.
"""

from fractions import Fraction

import numpy as np

from .dormand_prince import weighted_sum

C = "0 1/200 49/450 49/300 911/2000 3480084980/5709648941 221/250 37/40 1 1"
A = {
    1: "1/200",
    2: "-4361/4050 2401/2025",
    3: "49/1200 0 49/400",
    4: "2454451729/3841600000 0 -9433712007/3841600000 4364554539/1920800000",
    5: "-6187101755456742839167388910402379177523537620/"
    "2324599620333464857202963610201679332423082271 0 "
    "27569888999279458303270493567994248533230000/2551701010245296220859455115479340650299761 "
    "-37368161901278864592027018689858091583238040000/"
    "4473131870960004275166624817435284159975481033 "
    "1392547243220807196190880383038194667840000000/"
    "1697219131380493083996999253929006193143549863",
    6: "11272026205260557297236918526339/1857697188743815510261537500000 0 "
    "-48265918242888069/1953194276993750 "
    "26726983360888651136155661781228/1308381343805114800955157615625 "
    "-2090453318815827627666994432/1096684189897834170412307919 "
    "1148577938985388929671582486744843844943428041509/"
    "1141532118233823914568777901158338927629837500000",
    7: "1304457204588839386329181466225966641/108211771565488329642169667802016000 0 "
    "-1990261989751005/40001418792832 "
    "2392691599894847687194643439066780106875/58155654089143548047476915856270826016 "
    "-1870932273351008733802814881998561250/419326053051486744762255151208232123 "
    "1043329047173803328972823866240311074041739158858792987034783181/"
    "510851127745017966999893975119259285040213723744255237522144000 "
    "-311918858557595100410788125/3171569057622789618800376448",
    8: "17579784273699839132265404100877911157/1734023495717116205617154737841023480 0 "
    "-18539365951217471064750/434776548575709731377 "
    "447448655912568142291911830292656995992000/12511202807447096607487664209063950964109 "
    "-65907597316483030274308429593905808000000/15158061430635748897861852383197382130691 "
    "273847823027445129865693702689010278588244606493753883568739168819449761/"
    "136252034448398939768371761610231099586032870552034688235302796640584360 "
    "694664732797172504668206847646718750/1991875650119463976442052358853258111 "
    "-19705319055289176355560129234220800/72595753317320295604316217197876507",
    9: "-511858190895337044664743508805671/11367030248263048398341724647960 0 "
    "2822037469238841750/15064746656776439 "
    "-23523744880286194122061074624512868000/152723005449262599342117017051789699 "
    "10685036369693854448650967542704000000/575558095977344459903303055137999707 "
    "-6259648732772142303029374363607629515525848829303541906422993/"
    "876479353814142962817551241844706205620792843316435566420120 "
    "17380896627486168667542032602031250/13279937889697320236613879977356033",
}
B = (
    "96762636172307789/2051985304794103980 0 0 312188947591288252500000/1212357694274963646019729 "
    "13550580884964304000000000000/51686919683339547115937980629 "
    "72367769693133178898676076432831566019684378142853445230956642801/"
    "475600216991873963561768100160364792981629064220601844848928537580 "
    "1619421054120605468750/3278200730370057108183 -66898316144057728000/227310933007074849597 "
    "181081444637946577/2226845467039736466 0"
)
B6 = (
    "117807213929927/2640907728177740 0 0 4758744518816629500000/17812069906509312711137 "
    "1730775233574080000000000/7863520414322158392809673 "
    "2682653613028767167314032381891560552585218935572349997/"
    "12258338284789875762081637252125169126464880985167722660 "
    "40977117022675781250/178949401077111131341 0 0 2152106665253777/106040260335225546"
)


def row(numbers: str) -> list[Fraction]:
    """Read a row of the table.

    Examples
    --------
    >>> row("1/2 -3")
    [Fraction(1, 2), Fraction(-3, 1)]
    """
    return [Fraction(number) for number in numbers.split()]


ADVANCE = """
C = np.array({times})


@njit({options})
def advance(S, Z, P, T, W, F, edges, places, values, times, states, rtol, atol, budget, counts):
    # S: time, step, edge number, samples done, 1 where a new piece begins
    t, h_abs, edge, done, fresh = S[0], S[1], int(S[2]), int(S[3]), S[4] == 1.0
    status = 0
    steps = 0
    while status == 0 and steps < budget:
        end = edges[edge]
        if fresh:
            for j in range(len(places)):
                P[places[j]] = values[edge, j]
            prepare(P, T)
            counts[2] += 1
        far_derivative(t, Z[0:NX], P, T, W, Z[NX : 2 * NX])
        counts[1] += 1
        bad = 0.0
        for i in range(NX):
            bad += 0.0 * Z[NX + i] + 0.0 * Z[i]
        if bad != 0.0:
            status = 3
            break
        if fresh:
            h_abs = first_step(t, end - t, Z, P, T, W, rtol, atol)
            counts[1] += 1
            fresh = False
        smallest = 10.0 * abs(np.nextafter(t, np.inf) - t)
        h_abs = max(h_abs, smallest)
        stop = min(end, times[done]) if done < len(times) else end
        rejected = False
        while True:
            if not h_abs >= smallest:
                status = 2
                break
            t_new = min(t + h_abs, stop)
            h = t_new - t
            for s in range(1, 10):
{stages}
                derivative(t + C[s] * h, Z[Y : Y + NX], P, T, W, Z[(s + 1) * NX : (s + 2) * NX])
            counts[1] += 9
            total = 0.0
            for i in range(NX):
                Z[Y + i] = Z[i] + h * ({new_state})
                off = {error}
                scale = atol + max(abs(Z[i]), abs(Z[Y + i])) * rtol
                total += (off / scale) ** 2
            error = h * math.sqrt(total / NX)
            if error < 1.0:
                factor = 10.0 if error == 0.0 else min(10.0, 0.9 * error ** (-1.0 / 7.0))
                if rejected:
                    factor = min(1.0, factor)
                h_abs = max(h_abs, h * factor) if t_new == stop and not rejected else h * factor
                break
            h_abs = h * max(0.2, 0.9 * error ** (-1.0 / 7.0)) if error == error else 0.2 * h
            rejected = True
            counts[3] += 1
        if status != 0:
            break
        for i in range(NX):
            Z[i] = Z[Y + i]
        t = t_new
        steps += 1
        counts[0] += 1
        if done < len(times) and t == times[done]:
            for i in range(NX):
                states[done, i] = Z[i]
            done += 1
        if t == end:
            edge += 1
            fresh = True
            if edge == len(edges):
                status = 1
    S[0], S[1], S[2], S[3], S[4] = t, h_abs, edge, done, 1.0 if fresh else 0.0
    return status
"""


def advance_text(options: str) -> str:
    """Give the text of `advance` for Verner's method.

    Parameters
    ----------
    options : str
        What the compiler is told.

    Returns
    -------
    str
        Takes the place of DOP853's `advance`.
    """
    lines = []
    for s in range(1, 10):
        total = weighted_sum(np.array(row(A[s]), dtype=float))
        lines += [f"{'if' if s == 1 else 'elif'} s == {s}:", "    for i in range(NX):",
                  f"        Z[Y + i] = Z[i] + h * ({total})"]  # fmt: skip
    error = [b - b6 for b, b6 in zip(row(B), row(B6), strict=True)]
    return ADVANCE.format(
        options=options,
        times=[float(c) for c in row(C)],
        stages="\n".join(" " * 16 + line for line in lines),
        new_state=weighted_sum(np.array(row(B), dtype=float)),
        error=weighted_sum(np.array(error, dtype=float)),
    )
