package org.dfra.examples.harness;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import org.dfra.cli.Main;
import org.dfra.examples.sim.SimulationStart;
import org.dfra.examples.sim.SimulationState;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.world.GroundTruth.Collision;

/** A simulated world in a separate process: {@code ./dfra sim run}. */
public final class SimulationProcess {

  private static final int TRUTH_RATE = 100;

  private final SimulationStart beginning;
  private final Path truth;
  private final ProcessHandle process;
  private final List<String> states; // in the order they were reported

  private SimulationProcess(
      SimulationStart beginning, Path truth, ProcessHandle process, List<String> states) {
    this.beginning = beginning;
    this.truth = truth;
    this.process = process;
    this.states = states;
  }

  /**
   * Starts it and waits until its devices answer.
   *
   * @param world a file in {@code config/worlds}
   */
  public static SimulationProcess start(DemoEnvironment environment, String world)
      throws IOException, InterruptedException {
    return start(
        environment,
        Path.of(System.getProperty("dfra.root", ""), "config", "worlds", world),
        List.of());
  }

  /**
   * Starts it and waits until its devices answer.
   *
   * @param world its description file
   * @param options further ones of {@code ./dfra sim run}
   */
  public static SimulationProcess start(
      DemoEnvironment environment, Path world, List<String> options)
      throws IOException, InterruptedException {
    Path truth = environment.folder().resolve("truth.csv");
    List<String> command =
        new ArrayList<>(List.of(Main.class.getName(), "sim", "run", world.toString()));
    command.addAll(
        List.of("--any-ports", "--json", "--truth=" + truth, "--truth-rate=" + TRUTH_RATE));
    command.addAll(options);
    Process process = environment.startJvm("simulation", command);
    List<String> states = new CopyOnWriteArrayList<>();
    CompletableFuture<String> first = new CompletableFuture<>();
    Thread drain = new Thread(() -> drain(process, first, states), "simulation output");
    drain.setDaemon(true);
    drain.start();
    try {
      String line = first.get(DemoEnvironment.PATIENCE.toSeconds(), TimeUnit.SECONDS);
      SimulationStart beginning =
          (SimulationStart) CommandOutput.parseValue(line, SimulationStart.class);
      return new SimulationProcess(beginning, truth, process.toHandle(), states);
    } catch (ExecutionException | TimeoutException | IllegalArgumentException e) {
      throw new IOException(
          "the simulated world did not start; see simulation.log in " + environment.folder(), e);
    }
  }

  /** Reads its output, so that the process never blocks. */
  private static void drain(Process process, CompletableFuture<String> first, List<String> states) {
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      String line = out.readLine();
      if (line == null) {
        first.completeExceptionally(new IOException("it ended immediately"));
        return;
      }
      first.complete(line);
      for (line = out.readLine(); line != null; line = out.readLine()) { // one every second
        states.add(line);
      }
    } catch (IOException e) {
      first.completeExceptionally(e);
    }
  }

  /** Whether its process runs. */
  public boolean isAlive() {
    return process.isAlive();
  }

  /** Collisions of robots in order of time, except those of the last second. */
  public List<Collision> collisions() {
    return states.stream()
        .flatMap(
            line ->
                ((SimulationState) CommandOutput.parseValue(line, SimulationState.class))
                    .newCollisions().stream())
        .toList();
  }

  /** The message that it printed at its start. */
  public SimulationStart startMessage() {
    return beginning;
  }

  /** Links to the devices of a robot, by the device's name. */
  public Map<String, String> links(String robot) {
    return beginning.endpoints().stream()
        .filter(each -> each.robot().equals(robot))
        .collect(Collectors.toMap(DeviceEndpoint::device, DeviceEndpoint::link));
  }

  /**
   * The file to which it writes the true pose of every robot, {@value #TRUTH_RATE} times a second.
   */
  public Path truth() {
    return truth;
  }
}
