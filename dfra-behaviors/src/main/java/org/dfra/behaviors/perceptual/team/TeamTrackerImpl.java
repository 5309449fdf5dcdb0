package org.dfra.behaviors.perceptual.team;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.perceptual.TeamPositions;
import org.dfra.flow.perceptual.TeamTracker;
import org.dfra.flow.perceptual.Teammate;
import org.dfra.lifecycle.Incident;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Subscribes to the position estimators of all robots of the team, including its own. Poses are
 * compared at the same instant, using the offset of both clocks to UTC from satellites; without a
 * satellite fix a robot's distance is unknown. A robot's loss of contact and its return are
 * recorded in the history and the log, with the number of missed poses.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code estimator}: name of the position estimator, the same on all robots; default {@code
 *       position}
 *   <li>{@code rate}: rate of its reports, hertz, 0.1 to 10; default 5
 *   <li>{@code peer_timeout}: seconds without a pose after which a robot is out of reach, 0.5 to
 *       600; default 3
 *   <li>{@code max_age}: as for every perceptual schema; default 1
 * </ul>
 */
public final class TeamTrackerImpl extends PerceptualSchemaImpl<TeamPositions>
    implements TeamTracker {

  private final String robot;
  private final Scheduler time;
  private final long peerTimeoutNanos; // nanoseconds
  private final Duration interval;
  private final OwnPoseBuffer own = new OwnPoseBuffer(); // guarded by itself, as the following
  private final Map<String, TeammateTracker> teammates = new TreeMap<>();
  private @Nullable Instant lastPublished;

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public TeamTrackerImpl(ModuleContext context) {
    super(
        context,
        "positions of the other robots, and for how long no message came from each",
        "DFRA",
        "1",
        TeamPositions.class,
        "TeamPositions",
        1);
    this.robot = context.robot();
    this.time = context.robotTime();
    this.peerTimeoutNanos = Math.round(settings().number("peer_timeout", 3, 0.5, 600) * 1e9);
    this.interval = Duration.ofNanos(Math.round(1e9 / settings().number("rate", 5, 0.1, 10)));
    declareInputFromTeam(
        ModuleQuery.of(PositionEstimator.class)
            .name(settings().find("estimator").orElse("position")),
        PoseEstimate.class,
        this::take);
  }

  private void take(ModuleListing<?> source, long sequence, PoseEstimate pose) {
    if (source.robot().equals(robot)) {
      takeOwn(pose);
      return;
    }
    Optional<String> news;
    synchronized (own) {
      news =
          teammates
              .computeIfAbsent(source.robot(), TeammateTracker::new)
              .receive(pose, sequence, clock().instant(), time.nanos(), peerTimeoutNanos);
    }
    news.ifPresent(this::report);
  }

  private void takeOwn(PoseEstimate pose) {
    List<String> news = new ArrayList<>();
    TeamPositions fresh;
    boolean isDue;
    synchronized (own) {
      own.add(pose);
      List<Teammate> all = new ArrayList<>();
      for (TeammateTracker each : teammates.values()) {
        each.checkSilence(time.nanos(), peerTimeoutNanos).ifPresent(news::add);
        all.add(each.relativeTo(own));
      }
      fresh = new TeamPositions(pose.measured(), pose.frame(), all);
      isDue =
          lastPublished == null
              || Duration.between(lastPublished, pose.measured()).abs().compareTo(interval) >= 0;
      if (isDue) {
        lastPublished = pose.measured();
      }
    }
    news.forEach(this::report);
    if (isDue) {
      publishPercept(fresh);
    } else {
      setPercept(fresh);
    }
  }

  private void report(String news) {
    log.warn("{}: {}", path(), news);
    recordIncident(Incident.Kind.GAP, news);
  }

  @Override
  protected PerceptualSchemaAttributes schemaAttributes() {
    return new PerceptualSchemaAttributes(
        "TeamPositions", "standard deviation", "same instant", null, null);
  }

  @Override
  public TeamPositions team() {
    return percept();
  }
}
