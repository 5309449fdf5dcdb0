package org.dfra.examples.raster;

import org.dfra.examples.mission.LockStepMission;
import org.dfra.examples.mission.Mission;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.embedded.EmbeddedMission;
import org.dfra.examples.mission.process.ProcessMission;
import org.dfra.report.measurement.RunMeasurements;

/** The modes in which a search can be run. The only class that knows all of them. */
final class MissionModes {

  private MissionModes() {}

  /** The mode of a search, explained in sentences. */
  static String meaning(Mission mission) {
    return switch (mission.mode()) {
      case "local" ->
          "Mode local: drivers, schemas and behaviours of all robots run in one virtual machine and"
              + " find each other in its memory, without a network. The drivers read the bytes of"
              + " emulated devices. Time advances in lock-step, so the same seed gives exactly the"
              + " same search.";
      case "processes" ->
          "Mode processes: each robot has its phoenix, its registrar and a process for each service"
              + " group; modules find each other through lookup, and drivers read the bytes of"
              + " emulated devices over TCP. The seed determines the world and its noise, not the order"
              + " in which processes run.";
      case "embedded" ->
          "Mode embedded: all robots run in one virtual machine, each with its own lookup service."
              + " Their modules are exported, register and find each other through lookup, and"
              + " drivers read the bytes of emulated devices over TCP; a proxy calls a module of its"
              + " own virtual machine directly. No process is killed, but lookup services are ended"
              + " during the search. The seed determines the world and its noise, not the order of threads.";
      default -> "Mode " + mission.mode() + ".";
    };
  }

  /**
   * The mission of the selected mode. In processes some are killed during the search, if there are
   * two robots.
   *
   * @param figures receive the mission's own measurements
   */
  static Mission of(RasterSetup setup, RunMeasurements figures) {
    Scenario scenario = setup.scenario();
    return switch (setup.mode()) {
      case LOCAL -> new LockStepMission(scenario, setup.longest(), robot -> robot, false);
      case EMBEDDED ->
          new EmbeddedMission(
              scenario, setup.simulationSpeed().speed(), setup.longest(), robot -> robot, figures);
      case PROCESSES ->
          new ProcessMission(
              scenario,
              setup.world(),
              setup.simulationSpeed().speed(),
              setup.longest(),
              robot -> robot,
              scenario.robots().size() > 1,
              figures);
    };
  }
}
