package org.dfra.examples.sim;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.core.host.CommandName;
import org.dfra.core.time.RobotTime;
import org.dfra.core.time.ScaledTime;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.dfra.sim.run.GroundTruthLog;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.run.Simulation.PortPolicy;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra sim run}. */
@Command(
    name = "run",
    description =
        "Runs a world until Ctrl-C: every device answers on a TCP port, in its own protocol.",
    footer = {
      "",
      "Start the robots' software in another terminal with "
          + CommandName.IN_HELP
          + " up. If the speed is not 1,",
      "the simulation prints the DFRA_TIME to set there, so that drivers use the same time.",
      "With --json, one JSON object per line: first the start with all endpoints, then a",
      "state every second."
    })
final class RunCommand implements Callable<Integer> {

  private static final Duration STATE_EVERY = Duration.ofSeconds(1);

  @Parameters(paramLabel = "WORLD", description = "File that describes the world, in XML.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private Path file;

  @Option(
      names = "--speed",
      paramLabel = "N",
      description = "Simulated seconds per second, 0.01 to 1000 (default 1).")
  private double speed = 1;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "Random seed, instead of the world's own seed.")
  private @Nullable Long seed;

  @Option(
      names = "--any-ports",
      description = "Use free ports instead of those in the world's file.")
  private boolean anyPorts;

  @Option(
      names = "--for",
      paramLabel = "SECONDS",
      description = "End after this simulated time (default: run until Ctrl-C).")
  private @Nullable Double seconds;

  @Option(
      names = "--truth",
      paramLabel = "FILE",
      description = "Write the ground truth of every robot to this CSV file.")
  private @Nullable Path truth;

  @Option(
      names = "--truth-rate",
      paramLabel = "HZ",
      description = "Lines in that file per robot and simulated second (default ${DEFAULT-VALUE}).")
  private double truthRate = 20;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  private final CountDownLatch ended = new CountDownLatch(1);

  @Override
  public Integer call() throws Exception {
    checkOptions();
    WorldDescription read = WorldXml.read(file);
    WorldDescription world = seed == null ? read : read.withSeed(seed);
    InstantSource clock = clock();
    try (Simulation simulation =
        Simulation.overTcp(world, clock, anyPorts ? PortPolicy.EPHEMERAL : PortPolicy.CONFIGURED)) {
      simulation.start();
      Runtime.getRuntime().addShutdownHook(new Thread(ended::countDown, "simulation end"));
      begin(simulation, clock);
      run(simulation, clock);
    }
    return ExitCode.SUCCESS;
  }

  private void checkOptions() {
    if (!(speed >= ScaledTime.MIN_SPEED && speed <= ScaledTime.MAX_SPEED)) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR,
          "--speed "
              + speed
              + " is outside "
              + ScaledTime.MIN_SPEED
              + " to "
              + (int) ScaledTime.MAX_SPEED);
    }
    if (!(truthRate > 0 && truthRate <= 100)) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR, "--truth-rate " + truthRate + " Hz is outside above 0 to 100");
    }
    @Nullable Path folder = truth == null ? null : truth.toAbsolutePath().getParent();
    if (folder != null && !Files.isDirectory(folder)) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "--truth " + truth + ": there is no folder " + folder + "; create it first");
    }
    if (seconds != null && !(seconds > 0)) {
      throw new CommandFailure(ExitCode.USAGE_ERROR, "--for " + seconds + " s is not above 0");
    }
  }

  /** Real time, the time that the parent process passed, or a clock of its own speed. */
  private InstantSource clock() {
    return speed == 1
        ? RobotTime.clock()
        : new ScaledTime(speed, Instant.now().truncatedTo(ChronoUnit.MILLIS));
  }

  private void begin(Simulation simulation, InstantSource clock) {
    SimulationStart beginning = SimulationStart.of(simulation, clock);
    if (answer.isJson()) {
      answer.line(beginning, "");
      return;
    }
    Table table = new Table("ROBOT", "DEVICE", "PROTOCOL", "LINK", "SERVES");
    for (DeviceEndpoint each : beginning.endpoints()) {
      table.row(
          each.robot(),
          each.device(),
          each.protocol(),
          each.link(),
          String.join(", ", each.servedDevices()));
    }
    answer.table(
        beginning.endpoints(), table, "the world has no device with an endpoint of its own");
    answer.note(
        "the world "
            + beginning.world()
            + " runs with seed "
            + beginning.seed()
            + (speed == 1
                ? "; end it with Ctrl-C"
                : ", "
                    + speed
                    + " times as fast as real time; start the robots with "
                    + RobotTime.VARIABLE
                    + "='"
                    + beginning.dfraTime()
                    + "' "
                    + CommandName.current()
                    + " up ..., and end this with Ctrl-C"));
  }

  private void run(Simulation simulation, InstantSource clock) throws Exception {
    Instant begin = clock.instant();
    @Nullable Instant end = seconds == null ? null : begin.plusNanos((long) (seconds * 1e9));
    Duration period = Duration.ofNanos((long) (1e9 / truthRate));
    Instant nextTruth = begin;
    Instant nextState = begin.plus(scaled(STATE_EVERY));
    int known = 0; // collisions
    try (GroundTruthLog log =
        truth == null ? null : new GroundTruthLog(simulation.world(), truth)) {
      while (end == null || clock.instant().isBefore(end)) {
        Instant now = clock.instant();
        simulation.world().advanceTo(now);
        for (; log != null && !nextTruth.isAfter(now); nextTruth = nextTruth.plus(period)) {
          log.write(nextTruth);
        }
        if (!now.isBefore(nextState)) {
          SimulationState state = SimulationState.of(simulation.world(), begin, now, known);
          known = state.collisions();
          answerState(state);
          nextState = now.plus(scaled(STATE_EVERY));
        }
        Duration pause = log == null ? STATE_EVERY : period;
        if (ended.await((long) (pause.toNanos() / speed), TimeUnit.NANOSECONDS)) {
          break;
        }
      }
      last(SimulationState.of(simulation.world(), begin, clock.instant(), known));
    } catch (IOException e) {
      throw new IOException(truth + " cannot be written: " + e.getMessage(), e);
    }
  }

  private Duration scaled(Duration real) {
    return Duration.ofNanos((long) (real.toNanos() * speed));
  }

  /** Updates the last line of a terminal; without a terminal there is no text output. */
  private void answerState(SimulationState state) {
    if (answer.isJson()) {
      answer.line(state, "");
    } else if (System.console() != null) {
      System.err.print("\r\u001b[K" + PrintableText.line(state.inWords()));
      System.err.flush();
    }
  }

  private void last(SimulationState state) {
    if (answer.isJson()) {
      answer.line(state, "");
    } else {
      if (System.console() != null) {
        System.err.println();
      }
      answer.note(state.inWords());
    }
  }
}
