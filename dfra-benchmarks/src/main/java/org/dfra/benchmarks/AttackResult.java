package org.dfra.benchmarks;

import java.time.Duration;
import java.util.List;
import org.dfra.benchmarks.attack.AttackCase;
import org.dfra.benchmarks.attack.ProcessSample;
import org.dfra.report.measurement.MeasuredValue;

/**
 * Measurements taken during a load.
 *
 * @param p99 latency of honest calls, milliseconds
 * @param failed number of failed honest calls
 * @param cpu CPU time of the robot while the operator measured, seconds
 * @param threads maximum during the load, minus the number before it
 * @param heap increase over the value before the load, bytes
 * @param commandTimeout seconds from the operator's last command until the wheels' controller
 *     received a stop command
 * @param slowdownTime seconds from the operator's last command until the wheels slowed down
 * @param stopTimeAfterSilence seconds from the operator's last command until they stopped
 * @param stopTimeAfterEmergencyStop seconds from the emergency stop until they stopped
 * @param recoveryTime seconds until the robot's resource use is back to normal
 * @param calls number of the attacker's calls
 * @param refused number of refused calls
 * @param attackMeasurements further measurements of the attack itself
 */
record AttackResult(
    double p99,
    int failed,
    double cpu,
    int threads,
    long heap,
    double commandTimeout,
    double slowdownTime,
    double stopTimeAfterSilence,
    double stopTimeAfterEmergencyStop,
    double recoveryTime,
    long calls,
    long refused,
    List<MeasuredValue> attackMeasurements) {

  /** Maximum time until the robot's resource use is back to normal. */
  static final Duration RECOVERY = Duration.ofSeconds(10);

  private static final double COMMAND_TIMEOUT = 0.35; // s: 0.3, rest for the call and the link
  private static final double MOST_SLOWER = 0.35; // s: 0.3 timeout, rest to lose 10 % speed
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

  /** Reports the values of the baseline. */
  void report(Report report, AttackCase load) {
    report.figure("p99 of honest calls beside " + load.name(), p99, "ms");
    wheels(report, load);
  }

  /** Reports an attack's values and checks them against the limits. */
  void report(Report report, AttackCase attack, AttackResult neutral) {
    String beside = " beside " + attack.name();
    report.say(
        "  %d calls of the attacker, %d refused; %d honest calls failed"
            .formatted(calls, refused, failed));
    wheels(report, attack);
    report.figure(
        "p99 of honest calls" + beside + ", times that beside " + AttackCase.BASELINE.name(),
        p99 / neutral.p99,
        MOST_RATIO,
        "");
    report.figure("threads added" + beside, threads, MOST_THREADS, "");
    report.figure("heap added" + beside, heap / MEGABYTE, MOST_MEGABYTES, "MB");
    if (refused > 0) {
      double more = Math.max(0, cpu - neutral.cpu);
      report.figure("CPU for each refused call" + beside, more / refused, MOST_CPU, "s");
    }
    report.figure("back to normal after " + attack.name(), recoveryTime, RECOVERY.toSeconds(), "s");
    for (MeasuredValue each : attackMeasurements) {
      report.figure(each.name() + beside, each.value(), each.target(), each.unit());
    }
  }

  private void wheels(Report report, AttackCase attack) {
    String beside = " beside " + attack.name();
    report.figure(
        "stop command at the wheels after the last command" + beside,
        commandTimeout,
        COMMAND_TIMEOUT,
        "s");
    report.figure("wheels slower after the last command" + beside, slowdownTime, MOST_SLOWER, "s");
    report.figure(
        "wheels stopped after the last command" + beside, stopTimeAfterSilence, MOST_STOPPED, "s");
    report.figure(
        "wheels stopped after the emergency stop" + beside,
        stopTimeAfterEmergencyStop,
        MOST_STOPPED,
        "s");
  }
}
