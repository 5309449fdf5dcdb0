package org.dfra.examples.security;

import static org.dfra.examples.security.FieldTeam.OSCAR;
import static org.dfra.examples.security.FieldTeam.ROBOTS;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dfra.behavior.RasterSearch;
import org.dfra.core.config.RobotXml;
import org.dfra.core.time.RobotTime;
import org.dfra.directory.ModuleDirectory;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.SimulationProcess;
import org.dfra.examples.mission.MissionProgressListener;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.monitor.MissionMonitor;
import org.dfra.examples.mission.monitor.RobotStartup;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.examples.mission.process.TruthFile;
import org.dfra.examples.raster.RasterSetup;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;

/**
 * The search of a team's robots: the first one's goal is anna's, the second one's oscar's. Scenes
 * run beside it.
 */
final class SecureSearch {

  private final RasterSetup setup;
  private final SimulationProcess field;
  private final FieldTeam team;
  private final List<String> locators;

  /**
   * @param locators of the lookup services that this process asks
   */
  SecureSearch(RasterSetup setup, SimulationProcess field, FieldTeam team, List<String> locators) {
    this.setup = setup;
    this.field = field;
    this.team = team;
    this.locators = List.copyOf(locators);
  }

  /** What happens during the search. */
  @FunctionalInterface
  interface Scenes {
    void play() throws Exception;
  }

  /**
   * Runs both to their end. If a scene fails, the search is cancelled.
   *
   * @param scenes begin when the robots do, on a thread of their own
   */
  MissionResult run(MissionProgressListener listener, Scenes scenes) throws Exception {
    Scenario scenario = setup.scenario();
    try (ModuleDirectory directory =
            new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), locators);
        TruthFile truth = new TruthFile(field)) {
      List<SearchingRobot<String>> robots = new ArrayList<>();
      for (int i = 0; i < ROBOTS.size(); i++) {
        RobotStartup.awaitReady(directory, RobotXml.read(scenario.robots().get(i)));
        robots.add(
            SearchingRobot.connect(ROBOTS.get(i), ROBOTS.get(i), scenario.plan(i), directory));
      }
      SearchingRobot<String> second = robots.get(1);
      RasterSearch oscars =
          team.as(OSCAR, () -> team.find(RasterSearch.class, path(second.search())));
      robots.set(
          1,
          new SearchingRobot<>(
              second.name(),
              second.robot(),
              oscars,
              second.waypointDriver(),
              second.plan(),
              second.recorder(),
              second.subscriptions()));
      List<RasterSearch> annas = List.of(robots.get(0).search(), second.search());
      CompletableFuture<Void> ended = new CompletableFuture<>();
      AtomicBoolean hasBegun = new AtomicBoolean();
      MissionProgressListener both =
          progress -> {
            if (hasBegun.compareAndSet(false, true)) {
              start(scenes, annas, ended);
            }
            listener.onProgress(progress);
          };
      MissionResult result =
          new MissionMonitor<>(
                  scenario,
                  truth,
                  RobotTime.clock(),
                  setup.simulationSpeed().speed(),
                  robots,
                  new RunMeasurements(),
                  both)
              .run(List.of(), setup.longest());
      await(ended);
      return result;
    }
  }

  private static String path(RasterSearch search) throws RemoteException {
    return search.identification().path();
  }

  private static void start(
      Scenes scenes, List<RasterSearch> searches, CompletableFuture<Void> ended) {
    Thread thread =
        new Thread(
            () -> {
              try {
                scenes.play();
                ended.complete(null);
              } catch (Exception | Error e) { // the mission's thread reports it
                searches.forEach(each -> cancel(each, e));
                ended.completeExceptionally(e);
              }
            },
            "demo-scenes");
    thread.setDaemon(true);
    thread.start();
  }

  private static void cancel(RasterSearch search, Throwable reason) {
    try {
      search.cancel();
    } catch (RemoteException e) {
      reason.addSuppressed(e);
    }
  }

  private static void await(CompletableFuture<Void> ended) throws Exception {
    try {
      Object unused = ended.get();
    } catch (ExecutionException e) {
      @Nullable Throwable why = e.getCause();
      throw why instanceof Exception exception
          ? exception
          : new IOException(Optional.ofNullable(why).map(Throwable::toString).orElse("?"), e);
    }
  }
}
