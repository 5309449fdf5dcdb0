package org.dfra.app.raster.embedded;

import java.time.Instant;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.app.figure.Figure;
import org.dfra.app.raster.live.Scene;
import org.dfra.app.raster.live.Searching;
import org.dfra.app.raster.live.Trouble;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.jspecify.annotations.Nullable;

/**
 * A robot's registrar is ended: whoever knows no other finds the robot no more. It drives on. Later
 * a registrar is started at the same port, which knows nobody, and all modules register again by
 * themselves.
 *
 * <pre>
 *   THERE --share done--&gt; ENDING --it has ended--&gt; GONE --more done--&gt; RETURNING --all listed--&gt; OVER
 *                                                   '--for good, the search has ended------------^
 * </pre>
 */
final class LostRegistrar implements Trouble<EmbeddedRobot> {

  /** It is not started again. */
  static final double FOR_GOOD = Double.POSITIVE_INFINITY;

  /** In which the modules are to be listed again, real seconds. */
  private static final double MOST = 5;

  private enum State {
    /** Waits until the robot has done a share of its search. */
    THERE,
    /** Waits until the registrar has ended. */
    ENDING,
    /** Waits until the robot has done more. */
    GONE,
    /** Waits until the registrar lists all modules again. */
    RETURNING,
    /** It has happened, or never will. */
    OVER
  }

  private final int robot;
  private final double from;
  private final double to;
  private final ExecutorService operator =
      Executors.newSingleThreadExecutor(task -> new Thread(task, "registrar operator"));
  private State state = State.THERE;

  // known once it is lost
  private Set<String> listed = Set.of();
  private double done;
  private Instant lost = Instant.MIN;
  private Instant returned = Instant.MIN;
  private @Nullable Future<?> work; // the operator's

  /**
   * @param robot which one, counted from 0
   * @param from share of its search after which its registrar is ended
   * @param to share after which it is started again; {@link #FOR_GOOD} if it is not
   */
  LostRegistrar(int robot, double from, double to) {
    this.robot = robot;
    this.from = from;
    this.to = to;
  }

  @Override
  public void look(Scene<EmbeddedRobot> now) throws Exception {
    Searching<EmbeddedRobot> victim = now.robots().get(robot);
    double share = victim.hearing().newest().done();
    boolean hasEnded = victim.hasEnded();
    switch (state) {
      case THERE -> {
        if (hasEnded) {
          state = State.OVER;
        } else if (share >= from) {
          lose(now, victim);
        }
      }
      case ENDING -> {
        if (isWorkDone()) {
          state = State.GONE;
        }
      }
      case GONE -> {
        if (hasEnded && to == FOR_GOOD) {
          tellTheEnd(now, victim);
        } else if (hasEnded || share >= to) {
          returned = now.clock().instant();
          work = operator.submit(() -> victim.robot().registrar().start());
          state = State.RETURNING;
        }
      }
      case RETURNING -> {
        if (isWorkDone()) {
          seeWhetherAllAreListed(now, victim);
        }
      }
      default -> {}
    }
  }

  private void lose(Scene<EmbeddedRobot> now, Searching<EmbeddedRobot> victim) throws Exception {
    listed = Listed.of(victim.robot()).keySet();
    done = victim.hearing().newest().done();
    lost = now.clock().instant();
    work =
        operator.submit(
            () -> {
              victim.robot().registrar().close();
              return null;
            });
    now.mark(
        lost,
        victim,
        "its registrar is ended, which listed its %d modules; it drives on",
        listed.size());
    state = State.ENDING;
  }

  /** Whether the operator has done what it was told; throws what it threw. */
  private boolean isWorkDone() throws Exception {
    Future<?> known = work;
    if (known == null || !known.isDone()) {
      return false;
    }
    Object unused = known.get();
    return true;
  }

  private void tellTheEnd(Scene<EmbeddedRobot> now, Searching<EmbeddedRobot> victim) {
    Instant end = now.clock().instant();
    now.mark(
        end,
        victim,
        "its search is over; the last %.0f s of it were without its registrar",
        Scene.seconds(lost, end));
    state = State.OVER;
  }

  private void seeWhetherAllAreListed(Scene<EmbeddedRobot> now, Searching<EmbeddedRobot> victim)
      throws Exception {
    Set<String> again = Listed.of(victim.robot()).keySet();
    if (again.size() < listed.size()) {
      return; // some are on their way
    }
    Instant back = now.clock().instant();
    now.mark(
        back,
        victim,
        "its registrar is back and lists its %d modules again; it was gone for %.0f s, in which the"
            + " robot searched %.0f %% of its region",
        again.size(),
        Scene.seconds(lost, returned),
        100 * (victim.hearing().newest().done() - done));
    now.figure(
        "registrar back to all modules listed again",
        Scene.seconds(returned, back) / now.speed(),
        MOST);
    now.figures()
        .add(
            new Figure(
                "registrar back: modules that are listed under another service ID",
                again.stream().filter(each -> !listed.contains(each)).count(),
                0,
                ""));
    state = State.OVER;
  }

  @Override
  public boolean hasBegun() {
    return state != State.THERE;
  }

  @Override
  public boolean isOver() {
    return state == State.OVER;
  }

  @Override
  public void close() {
    operator.shutdownNow();
  }
}
