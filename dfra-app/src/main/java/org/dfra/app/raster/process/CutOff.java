package org.dfra.app.raster.process;

import java.time.Instant;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.app.demo.stage.FieldRobot;
import org.dfra.app.figure.Figure;
import org.dfra.app.raster.live.Scene;
import org.dfra.app.raster.live.Searching;
import org.dfra.app.raster.live.Trouble;
import org.dfra.river.phoenix.GroupStatus;
import org.jspecify.annotations.Nullable;

/**
 * A robot's registrar and its phoenix are killed: it is found through another robot's only, and
 * nobody would bring back what dies. It drives on. Later phoenix is started again and takes back
 * what lives.
 *
 * <pre>
 *   WHOLE --share done--&gt; CUT_OFF --more done--&gt; RETURNING --phoenix and registrar answer--&gt; OVER
 *                             '--for good, its search has ended-------------------------------^
 * </pre>
 */
final class CutOff implements Trouble<FieldRobot> {

  /** Phoenix is not started again. */
  static final double FOR_GOOD = Double.POSITIVE_INFINITY;

  private static final String LOOKUP = "lookup";

  private enum State {
    /** Waits until the robot has done a share of its search. */
    WHOLE,
    /** Waits until it has done more. */
    CUT_OFF,
    /** Waits until phoenix has started. */
    RETURNING,
    /** It has happened, or never will. */
    OVER
  }

  private final int robot;
  private final double from;
  private final double to;
  private final Trouble<FieldRobot> before;
  private final ExecutorService starter =
      Executors.newSingleThreadExecutor(task -> new Thread(task, "phoenix starter"));
  private State state = State.WHOLE;

  // known once it is cut off
  private Map<String, Long> groups = Map.of();
  private double done;
  private Instant cut = Instant.MIN;
  private @Nullable Future<ProcessHandle> phoenix;

  /**
   * @param robot which one, counted from 0
   * @param from share of its search after which it is cut off
   * @param to share after which its phoenix is started again; {@link #FOR_GOOD} if it is not
   * @param before comes first
   */
  CutOff(int robot, double from, double to, Trouble<FieldRobot> before) {
    this.robot = robot;
    this.before = before;
    this.from = from;
    this.to = to;
  }

  @Override
  public void look(Scene<FieldRobot> now) throws Exception {
    Searching<FieldRobot> victim = now.robots().get(robot);
    double share = victim.hearing().newest().done();
    boolean hasEnded = victim.hasEnded();
    switch (state) {
      case WHOLE -> {
        if (hasEnded) {
          state = State.OVER;
        } else if (share >= from && before.isOver()) {
          cut(now, victim);
        }
      }
      case CUT_OFF -> {
        if (hasEnded && to == FOR_GOOD) {
          state = State.OVER;
        } else if (hasEnded || share >= to) {
          phoenix = starter.submit(() -> victim.robot().host().startPhoenix());
          state = State.RETURNING;
        }
      }
      case RETURNING -> {
        if (phoenix != null && phoenix.isDone()) {
          back(now, victim, phoenix.get());
        }
      }
      default -> {}
    }
  }

  private void cut(Scene<FieldRobot> now, Searching<FieldRobot> victim) throws Exception {
    groups = processes(victim);
    long registrar = victim.robot().process(LOOKUP);
    cut = now.clock().instant();
    done = victim.hearing().newest().done();
    victim.robot().host().killPhoenix();
    victim.robot().host().kill(registrar);
    now.mark(
        cut,
        victim,
        "its phoenix and its registrar are killed (process %d); it drives on",
        registrar);
    state = State.CUT_OFF;
  }

  private void back(Scene<FieldRobot> now, Searching<FieldRobot> victim, ProcessHandle process)
      throws Exception {
    if (victim.robot().process(LOOKUP) <= 0) {
      return; // its registrar is being brought back
    }
    Map<String, Long> living = processes(victim);
    long others =
        groups.entrySet().stream()
            .filter(each -> !each.getKey().endsWith("." + LOOKUP))
            .filter(each -> !each.getValue().equals(living.get(each.getKey())))
            .count();
    now.mark(
        now.clock().instant(),
        victim,
        "phoenix is back (process %d) and has taken back its %d living groups; it was gone for %.0f"
            + " s, in which the robot searched %.0f %% of its region",
        process.pid(),
        groups.size() - 1,
        Scene.seconds(cut, now.clock().instant()),
        100 * (victim.hearing().newest().done() - done));
    now.figures()
        .add(new Figure("phoenix back: living groups that have another process", others, 0, ""));
    state = State.OVER;
  }

  private static Map<String, Long> processes(Searching<FieldRobot> victim) throws Exception {
    Map<String, Long> processes = new TreeMap<>();
    for (GroupStatus each : victim.robot().host().groups()) {
      processes.put(each.name(), each.pid());
    }
    return processes;
  }

  @Override
  public boolean hasBegun() {
    return state != State.WHOLE;
  }

  @Override
  public boolean isOver() {
    return state == State.OVER;
  }

  @Override
  public void close() {
    starter.shutdownNow();
  }
}
