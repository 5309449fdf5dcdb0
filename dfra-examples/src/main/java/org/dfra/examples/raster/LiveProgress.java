package org.dfra.examples.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.examples.mission.CrossTrackError;
import org.dfra.examples.mission.GroundTruthClearance;
import org.dfra.examples.mission.MissionProgressListener;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.examples.mission.Scenario;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.terminal.Table;

/**
 * Reports the progress of a search: on a terminal as a block that is redrawn every second,
 * elsewhere as a sentence every ten seconds. Confined to the thread that runs the search.
 */
public final class LiveProgress implements MissionProgressListener {

  private static final long REDRAW = TimeUnit.SECONDS.toNanos(1);
  private static final long SENTENCE = TimeUnit.SECONDS.toNanos(10);

  private final ProgressReporter progress;
  private final LongSupplier nanos;
  private final Scenario scenario;
  private final GroundTruthClearance bodies;
  private final List<RasterPlan> plans = new ArrayList<>();
  private final List<List<LocalPosition>> driven = new ArrayList<>();
  private double clearance = Double.POSITIVE_INFINITY;
  private long reported;

  /**
   * @param nanos a monotonic real-time clock with any origin
   */
  public LiveProgress(ProgressReporter progress, LongSupplier nanos, Scenario scenario) {
    this.progress = progress;
    this.nanos = nanos;
    this.scenario = scenario;
    this.bodies = new GroundTruthClearance(scenario.world());
    this.reported = nanos.getAsLong();
  }

  @Override
  public void onProgress(List<RobotProgress> robots) {
    for (int i = 0; i < robots.size(); i++) {
      if (plans.size() <= i) {
        plans.add(scenario.plan(i));
        driven.add(new ArrayList<>());
      }
      Sample sample = robots.get(i).sample();
      driven.get(i).add(new LocalPosition(sample.east(), sample.north(), 0));
      clearance = Math.min(clearance, sample.clearance());
    }
    long now = nanos.getAsLong();
    if (now - reported >= (progress.isTerminal() ? REDRAW : SENTENCE)) {
      reported = now;
      show(robots);
    }
  }

  @Override
  public void onEvent(MissionEvent mark) {
    progress.say("After %.0f s, %s: %s.", mark.time(), mark.robot(), mark.what());
  }

  private void show(List<RobotProgress> robots) {
    if (progress.isTerminal()) {
      List<String> lines = new ArrayList<>(table(robots));
      lines.add(summary(robots));
      progress.redraw(lines);
      return;
    }
    List<String> clauses = new ArrayList<>();
    for (int i = 0; i < robots.size(); i++) {
      clauses.add(
          robots.get(i).robot()
              + " has seen "
              + seen(i)
              + " ("
              + robots.get(i).status().activity()
              + off(i, robots.get(i), ", %.2f m off it")
              + ")");
    }
    progress.say("%s: %s.", summary(robots), String.join("; ", clauses));
  }

  private List<String> table(List<RobotProgress> robots) {
    Table table = new Table("ROBOT", "STATE", "COVERED", "CROSS-TRACK", "ACTIVITY");
    for (int i = 0; i < robots.size(); i++) {
      RobotProgress at = robots.get(i);
      table.row(
          at.robot(),
          at.status().phase().name().toLowerCase(Locale.ROOT),
          seen(i),
          off(i, at, "%.2f m"),
          at.status().activity());
    }
    return table.lines(progress.columns() - 1);
  }

  private String seen(int robot) {
    RasterPlan plan = plans.get(robot);
    return Math.round(100 * plan.coverageMap(driven.get(robot), plan.swath()).share()) + " %";
  }

  private String off(int robot, RobotProgress at, String format) {
    return CrossTrackError.of(at.sample(), plans.get(robot))
        .map(off -> String.format(Locale.ROOT, format, Math.abs(off.estimated())))
        .orElse("");
  }

  private String summary(List<RobotProgress> robots) {
    StringBuilder text = new StringBuilder();
    text.append(String.format(Locale.ROOT, "After %.0f s", robots.get(0).sample().time()));
    if (robots.size() > 1) {
      text.append(
          String.format(
              Locale.ROOT,
              ", %.1f m apart",
              bodies.distance(
                  robots.get(0).robot(),
                  robots.get(0).sample(),
                  robots.get(1).robot(),
                  robots.get(1).sample())));
    }
    if (Double.isFinite(clearance)) {
      text.append(String.format(Locale.ROOT, ", minimum clearance so far %.2f m", clearance));
    }
    return text.toString();
  }
}
