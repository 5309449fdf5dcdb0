package org.dfra.examples.mission.process;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.mission.monitor.FaultInjectionContext;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.RobotSubscriptions.ReceivedPosition;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.jspecify.annotations.Nullable;

/**
 * The process of one of a robot's receivers is killed. The other receiver continues; the dead one
 * is restarted, and its listeners receive readings again.
 */
final class ReceiverProcessKill implements InjectedFault<DemoRobot> {

  /** Target until a subscription to it has recovered, real seconds. */
  private static final double MOST = 5;

  private final int robot;
  private final String receiver;
  private final double share;
  private boolean over;

  // known once it is killed
  private @Nullable Instant killed;
  private @Nullable ReceivedPosition last;
  private @Nullable RecoverySteps steps;
  private long lost;

  /**
   * @param robot its index, from 0
   * @param receiver the module, alone in a group of its name
   * @param share of its search after which it is killed
   */
  ReceiverProcessKill(int robot, String receiver, double share) {
    this.robot = robot;
    this.receiver = receiver;
    this.share = share;
  }

  @Override
  public void update(FaultInjectionContext<DemoRobot> now) throws Exception {
    SearchingRobot<DemoRobot> victim = now.robots().get(robot);
    @Nullable Instant since = killed;
    if (since != null) {
      checkRecovered(now, victim, since);
    } else if (victim.hasEnded()) {
      over = true;
    } else if (victim.subscriptions().latestStatus().completion() >= share) {
      kill(now, victim);
    }
  }

  private void kill(FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim)
      throws Exception {
    last = last(victim.subscriptions().positions());
    if (last == null) {
      return; // it is checked again
    }
    long process = victim.robot().process(receiver);
    lost = victim.subscriptions().lost(receiver);
    killed = now.clock().instant();
    steps =
        RecoverySteps.of(victim.robot(), receiver, process)
            .step("subscription interrupted", () -> victim.subscriptions().isInterrupted(receiver))
            .watch();
    victim.robot().host().kill(process);
    now.recordEvent(killed, victim, "%s is killed (process %d)", receiver, process);
  }

  private void checkRecovered(
      FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim, Instant since)
      throws Exception {
    List<ReceivedPosition> all = victim.subscriptions().positions();
    ReceivedPosition before = Objects.requireNonNull(last);
    @Nullable ReceivedPosition newest = last(all);
    if (newest == null || newest.epoch() <= before.epoch()) {
      return;
    }
    ReceivedPosition back =
        all.stream()
            .filter(each -> each.receiver().equals(receiver) && each.epoch() > before.epoch())
            .findFirst()
            .orElse(newest);
    long others =
        all.stream()
            .filter(each -> !each.receiver().equals(receiver))
            .filter(each -> each.measured().isAfter(before.measured()))
            .filter(each -> each.measured().isBefore(back.measured()))
            .count();
    now.recordEvent(
        back.measured(),
        victim,
        "%s is back (process %d): it was missing for %.1f s, in which %d positions of others were"
            + " received; %d of its events are missing",
        receiver,
        victim.robot().process(receiver),
        FaultInjectionContext.seconds(before.measured(), back.measured()),
        others,
        victim.subscriptions().lost(receiver) - lost);
    RecoverySteps recovery = Objects.requireNonNull(steps);
    recovery.close();
    double took = FaultInjectionContext.seconds(since, back.measured()) / now.speed();
    if (took > MOST) { // so that a user sees which part took long
      now.recordEvent(
          now.clock().instant(), victim, "%s took %.1f s: %s", receiver, took, recovery);
    }
    now.figure(receiver + " killed to readings received again", took, MOST);
    over = true;
  }

  private @Nullable ReceivedPosition last(List<ReceivedPosition> all) {
    return all.stream()
        .filter(each -> each.receiver().equals(receiver))
        .reduce((one, next) -> next)
        .orElse(null);
  }

  @Override
  public boolean hasStarted() {
    return killed != null;
  }

  @Override
  public boolean isOver() {
    return over;
  }
}
