package org.dfra.app.bench;

import java.time.Duration;
import java.util.List;
import org.dfra.app.bench.attack.ProcessSample;
import org.dfra.app.figure.Figure;

/**
 * What was measured beside a load.
 *
 * @param p99 of honest calls, milliseconds
 * @param failed honest calls
 * @param cpu seconds of the robot's CPU time while the operator listened
 * @param threads more than before the load
 * @param heap bytes more than before the load
 * @param slower seconds from the operator's last command until the wheels became slower
 * @param silent seconds from the operator's last command until they stopped
 * @param stopped seconds from the emergency stop until they stopped
 * @param recovered seconds until the robot uses what it used before
 * @param calls of the attacker
 * @param refused how many of them were refused
 * @param own what the attack was measured by besides
 */
record AttackResult(
    double p99,
    int failed,
    double cpu,
    int threads,
    long heap,
    double slower,
    double silent,
    double stopped,
    double recovered,
    long calls,
    long refused,
    List<Figure> own) {

  /** How long a robot may take to use again what it used before. */
  static final Duration RECOVERY = Duration.ofSeconds(10);

  private static final double MOST_SLOWER = 0.35; // s: 0.3, and 10 % of the speed to be lost
  private static final double MOST_STOPPED = 0.5; // s
  private static final double MOST_RATIO = 3;
  private static final int MOST_THREADS = 64;
  private static final double MEGABYTE = 1 << 20;
  private static final double MOST_MEGABYTES = 8;
  private static final double MOST_CPU = 1; // s for each refused call

  /** Whether threads and heap are within the limits again. */
  static boolean isNormal(ProcessSample now, ProcessSample before) {
    return now.threads() - before.threads() <= MOST_THREADS
        && now.heapBytes() - before.heapBytes() <= MOST_MEGABYTES * MEGABYTE;
  }

  /** Reports what attacks are compared with. */
  void report(Report report, AttackCase load) {
    report.figure("p99 of honest calls beside " + load.name(), p99, "ms");
    wheels(report, load);
  }

  /** Reports an attack, and whether it did harm. */
  void report(Report report, AttackCase attack, AttackResult neutral) {
    String beside = " beside " + attack.name();
    report.say(
        "  %d calls of the attacker, %d refused; %d honest calls failed"
            .formatted(calls, refused, failed));
    wheels(report, attack);
    report.figure(
        "p99 of honest calls" + beside + ", times that beside " + AttackCase.NEUTRAL.name(),
        p99 / neutral.p99,
        MOST_RATIO,
        "");
    report.figure("threads added" + beside, threads, MOST_THREADS, "");
    report.figure("heap added" + beside, heap / MEGABYTE, MOST_MEGABYTES, "MB");
    if (refused > 0) {
      double more = Math.max(0, cpu - neutral.cpu);
      report.figure("CPU for each refused call" + beside, more / refused, MOST_CPU, "s");
    }
    report.figure("back to normal after " + attack.name(), recovered, RECOVERY.toSeconds(), "s");
    for (Figure each : own) {
      report.figure(each.what() + beside, each.measured(), each.most(), each.unit());
    }
  }

  private void wheels(Report report, AttackCase attack) {
    String beside = " beside " + attack.name();
    report.figure("wheels slower after the last command" + beside, slower, MOST_SLOWER, "s");
    report.figure("wheels stopped after the last command" + beside, silent, MOST_STOPPED, "s");
    report.figure("wheels stopped after the emergency stop" + beside, stopped, MOST_STOPPED, "s");
  }
}
