package org.dfra.app.raster.process;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.dfra.app.demo.stage.FieldRobot;
import org.dfra.app.demo.stage.RecoverySteps;
import org.dfra.app.raster.live.Hearing.Position;
import org.dfra.app.raster.live.Scene;
import org.dfra.app.raster.live.Searching;
import org.dfra.app.raster.live.Trouble;
import org.jspecify.annotations.Nullable;

/**
 * The process of one of a robot's receivers is killed. The other goes on; the dead one comes back
 * and is heard again by whoever listened to it.
 */
final class KilledReceiver implements Trouble<FieldRobot> {

  /** In which a subscription to it is to be back, real seconds. */
  private static final double MOST = 5;

  private final int robot;
  private final String receiver;
  private final double share;
  private boolean over;

  // known once it is killed
  private @Nullable Instant killed;
  private @Nullable Position last;
  private @Nullable RecoverySteps steps;
  private long lost;

  /**
   * @param robot which one, counted from 0
   * @param receiver the module, alone in a group of its name
   * @param share of its search after which it is killed
   */
  KilledReceiver(int robot, String receiver, double share) {
    this.robot = robot;
    this.receiver = receiver;
    this.share = share;
  }

  @Override
  public void look(Scene<FieldRobot> now) throws Exception {
    Searching<FieldRobot> victim = now.robots().get(robot);
    @Nullable Instant since = killed;
    if (since != null) {
      seeWhetherItIsBack(now, victim, since);
    } else if (victim.hasEnded()) {
      over = true;
    } else if (victim.hearing().newest().done() >= share) {
      kill(now, victim);
    }
  }

  private void kill(Scene<FieldRobot> now, Searching<FieldRobot> victim) throws Exception {
    last = last(victim.hearing().positions());
    if (last == null) {
      return; // it is looked at again
    }
    long process = victim.robot().process(receiver);
    lost = victim.hearing().lost(receiver);
    killed = now.clock().instant();
    steps =
        RecoverySteps.of(victim.robot(), receiver, process)
            .step("subscription interrupted", () -> victim.hearing().isInterrupted(receiver))
            .watch();
    victim.robot().host().kill(process);
    now.mark(killed, victim, "%s is killed (process %d)", receiver, process);
  }

  private void seeWhetherItIsBack(
      Scene<FieldRobot> now, Searching<FieldRobot> victim, Instant since) throws Exception {
    List<Position> all = victim.hearing().positions();
    Position before = Objects.requireNonNull(last);
    @Nullable Position newest = last(all);
    if (newest == null || newest.epoch() <= before.epoch()) {
      return;
    }
    Position back =
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
    now.mark(
        back.measured(),
        victim,
        "%s is back (process %d): %.1f s without it, in which %d positions came of others; %d of its"
            + " events are missing",
        receiver,
        victim.robot().process(receiver),
        Scene.seconds(before.measured(), back.measured()),
        others,
        victim.hearing().lost(receiver) - lost);
    RecoverySteps recovery = Objects.requireNonNull(steps);
    recovery.close();
    double took = Scene.seconds(since, back.measured()) / now.speed();
    if (took > MOST) { // so a user sees which part took long
      now.mark(now.clock().instant(), victim, "%s took %.1f s: %s", receiver, took, recovery);
    }
    now.figure(receiver + " killed to heard again", took, MOST);
    over = true;
  }

  private @Nullable Position last(List<Position> all) {
    return all.stream()
        .filter(each -> each.receiver().equals(receiver))
        .reduce((one, next) -> next)
        .orElse(null);
  }

  @Override
  public boolean hasBegun() {
    return killed != null;
  }

  @Override
  public boolean isOver() {
    return over;
  }
}
