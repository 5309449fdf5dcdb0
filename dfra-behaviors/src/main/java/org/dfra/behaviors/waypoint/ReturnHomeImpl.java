package org.dfra.behaviors.waypoint;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behavior.ReturnHome;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.Pursuit;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.Needed;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * Drives home, straight, by way of its robot's {@link GoToWaypoint}. Home is where the robot first
 * knew its position well; it is remembered when the robot is switched off.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code home}: latitude and longitude in degrees, such as {@code 48.0001 11.0002}, or {@code
 *       here}; can be set while it runs
 *   <li>{@code position}: name of the estimator it listens to; where it is not set, the first
 *   <li>{@code go_to_waypoint}, {@code drive}: as of {@link FollowWaypointsImpl}
 * </ul>
 */
public final class ReturnHomeImpl extends BehaviorImpl<HomeGoal> implements ReturnHome {

  private static final String DOCUMENT = "home";
  private static final double GOOD_ENOUGH = 2; // metres, sigma
  private static final String EXPECTED =
      "latitude and longitude in degrees, such as 48.0001 11.0002, or here";

  private final Needed<GoToWaypoint> goTo;
  private final Object place = new Object();
  private @Nullable GeoPosition home; // guarded by place
  private @Nullable GeoPosition here; // guarded by place

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public ReturnHomeImpl(ModuleContext context) {
    super(context, "drives back to where the robot began", "DFRA", "1", HomeGoal.class, 5);
    this.goTo = Needed.of(context, GoToWaypoint.class, "go_to_waypoint");
    settings()
        .find("home")
        .ifPresent(
            text -> {
              try {
                home = parse(text);
              } catch (IllegalArgumentException e) {
                throw settings().fault("home", EXPECTED, e);
              }
            });
    declared().text("home", "where home is", this::told, this::setHome);
    takes(PositionEstimator.class, "position", PoseEstimate.class, this::take);
  }

  private static GeoPosition parse(String text) {
    String[] parts = text.strip().split("[\\s,]+");
    if (parts.length != 2) {
      throw new IllegalArgumentException(EXPECTED);
    }
    try {
      return new GeoPosition(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), 0);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(EXPECTED, e);
    }
  }

  private String told() {
    synchronized (place) {
      @Nullable GeoPosition now = home;
      return now == null
          ? "not known yet"
          : String.format(Locale.ROOT, "%.8f %.8f", now.latitude(), now.longitude());
    }
  }

  private void setHome(String text) {
    synchronized (place) {
      if (text.strip().equals("here")) {
        if (here == null) {
          throw new IllegalArgumentException("known yet; wait for the robot's position");
        }
        remember(here);
      } else {
        remember(parse(text));
      }
    }
  }

  private void take(ModuleListing<?> source, PoseEstimate pose) {
    synchronized (place) {
      here = pose.position();
      if (home == null && pose.positionSigma() <= GOOD_ENOUGH) {
        remember(pose.position());
      }
    }
  }

  /** Holds the lock. */
  private void remember(GeoPosition wanted) {
    home = wanted;
    try {
      context().state().write(DOCUMENT, told().getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      log.warn("{}: home is forgotten when this process ends: {}", path(), e.toString());
      survived(e);
    }
  }

  @Override
  protected void onStart() {
    synchronized (place) {
      if (home == null) {
        recall();
      }
    }
    super.onStart();
  }

  private void recall() {
    try {
      context()
          .state()
          .read(DOCUMENT)
          .ifPresent(bytes -> home = parse(new String(bytes, StandardCharsets.UTF_8)));
    } catch (IOException | IllegalArgumentException e) {
      log.warn("{}: where home was cannot be read and is found anew: {}", path(), e.toString());
      survived(e);
    }
  }

  @Override
  protected boolean movesWheels() {
    return true;
  }

  @Override
  protected Pursuit begin(HomeGoal goal) {
    GoToWaypoint unused = goTo.now();
    synchronized (place) {
      if (home == null) {
        throw new GoalRefusedException(
            path() + " does not know yet where home is; wait for a position, or set home");
      }
      return new PathPursuit(
          path(),
          goTo,
          new PathGoal(null, List.of(home), goal.tolerance()),
          interlock(),
          errands(),
          log);
    }
  }
}
