package org.dfra.behaviors.waypoint;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * Drives home in a straight line, using its robot's {@link GoToWaypoint}. Home is the first
 * accurate position of the robot; it is stored persistently.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code home}: latitude and longitude in degrees, such as {@code 48.0001 11.0002}, or {@code
 *       here}; can be set while it runs
 *   <li>{@code position}: name of the estimator to use; default the first
 *   <li>{@code go_to_waypoint}, {@code drive}: as for {@link FollowWaypointsImpl}
 * </ul>
 */
public final class ReturnHomeImpl extends BehaviorImpl<HomeGoal> implements ReturnHome {

  private static final String DOCUMENT = "home";
  private static final double GOOD_ENOUGH = 2; // metres, sigma
  private static final String EXPECTED =
      "latitude and longitude in degrees, such as 48.0001 11.0002, or here";

  private final ModuleDependency<GoToWaypoint> goTo;
  private final Object place = new Object();

  @GuardedBy("place")
  private @Nullable GeoPosition home;

  @GuardedBy("place")
  private @Nullable GeoPosition here;

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public ReturnHomeImpl(ModuleContext context) {
    super(context, "drives back to the robot's home", "DFRA", "1", HomeGoal.class, 5);
    this.goTo = ModuleDependency.of(context, GoToWaypoint.class, "go_to_waypoint");
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
    parameterTable().declareText("home", "the position of home", this::homeText, this::setHome);
    declareInput(PositionEstimator.class, "position", PoseEstimate.class, this::take);
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

  private String homeText() {
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
        storeHome(here);
      } else {
        storeHome(parse(text));
      }
    }
  }

  private void take(ModuleListing<?> source, PoseEstimate pose) {
    synchronized (place) {
      here = pose.position();
      if (home == null && pose.positionSigma() <= GOOD_ENOUGH) {
        storeHome(pose.position());
      }
    }
  }

  @GuardedBy("place")
  private void storeHome(GeoPosition wanted) {
    home = wanted;
    try {
      context().state().write(DOCUMENT, homeText().getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      log.warn(
          "{}: home cannot be stored, so it is lost when this process ends: {}",
          path(),
          e.toString());
      recordException(e);
    }
  }

  @Override
  protected void onStart() {
    synchronized (place) {
      if (home == null) {
        loadHome();
      }
    }
    super.onStart();
  }

  @GuardedBy("place")
  private void loadHome() {
    try {
      context()
          .state()
          .read(DOCUMENT)
          .ifPresent(bytes -> home = parse(new String(bytes, StandardCharsets.UTF_8)));
    } catch (IOException | IllegalArgumentException e) {
      log.warn(
          "{}: the stored home cannot be read, so the next accurate position becomes home: {}",
          path(),
          e.toString());
      recordException(e);
    }
  }

  @Override
  protected boolean movesWheels() {
    return true;
  }

  @Override
  protected GoalExecution startGoal(HomeGoal goal) {
    GoToWaypoint unused = goTo.resolve();
    synchronized (place) {
      if (home == null) {
        throw new GoalRefusedException(
            path() + " has no home yet; wait for the robot's position, or set home");
      }
      return new PathExecution(
          path(),
          goTo,
          new PathGoal(null, List.of(home), goal.tolerance()),
          interlock(),
          taskExecutor(),
          log);
    }
  }
}
