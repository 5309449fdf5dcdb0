package org.dfra.examples.security;

import static java.util.Locale.ROOT;
import static org.dfra.examples.security.FieldTeam.ANNA;
import static org.dfra.examples.security.FieldTeam.MALLORY;
import static org.dfra.examples.security.FieldTeam.OSCAR;
import static org.dfra.examples.security.FieldTeam.OTTO;
import static org.dfra.examples.security.FieldTeam.ROBOTS;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.host.FreePorts;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRunner;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.examples.harness.SimulationProcess;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.monitor.AnnouncedTime;
import org.dfra.examples.raster.LiveProgress;
import org.dfra.examples.raster.RasterSetup;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.river.security.SecureProcess;
import org.jspecify.annotations.Nullable;

/**
 * A team whose members know each other: two robots search a field, while an observer, a stranger, a
 * rogue robot and a revoked operator try what they may not. All commands are real processes, with a
 * state folder for each member as if it had a computer of its own.
 */
public final class SecurityDemo implements Demo {

  private static final Duration TO_A_TEAM = Duration.ofSeconds(60);

  /** Seconds of the robots' time per second: commands run beside the robots. */
  private static final double SPEED = 1.25;

  private static final String SCHEME = "jini://";

  /** Lines of a long output that are shown. */
  private static final int LINES = 3;

  private final ProgressReporter progress;

  /** Starts nothing. */
  public SecurityDemo(ProgressReporter progress) {
    this.progress = progress;
  }

  @Override
  public boolean run() {
    return DemoRunner.run(progress, this::play);
  }

  private void play(DemoEnvironment environment) throws Exception {
    RasterSetup setup = RasterSetup.inProcesses(SPEED);
    try (AnnouncedTime time = new AnnouncedTime()) {
      SimulationProcess field =
          SimulationProcess.start(
              environment,
              setup.world(),
              List.of("--seed=" + setup.scenario().world().seed(), "--speed=" + SPEED));
      time.set(field.startMessage().dfraTime());
      Process rogue =
          environment.startJvm(
              "rogue", List.of(RogueRegistrarMain.class.getName(), "atrv1", "gps_front"));
      BufferedReader rogueOutput = rogue.inputReader(StandardCharsets.UTF_8);
      String rogueLocator =
          Optional.ofNullable(rogueOutput.readLine())
              .orElseThrow(() -> new IOException("the rogue lookup service did not start"));

      Ports ports = Ports.allocate();
      MemberCommands commands = new MemberCommands(environment, progress, ports.variables(field));
      String withRogue = ports.locators() + "," + rogueLocator.replace(SCHEME, "");
      FieldTeam team =
          new FieldTeam(environment, commands, ports.registrars(), ports.phoenixes(), withRogue);
      try {
        make(commands, team);
        search(setup, field, commands, team, ports, rogueLocator);
        believed(rogue, rogueOutput);
        audit(commands);
      } finally {
        team.takeDown();
      }
    }
  }

  /** Ports of this demonstration, all free. */
  private record Ports(
      Map<String, Integer> registrars,
      Map<String, Integer> phoenixes,
      Map<String, Integer> classServers) {

    static Ports allocate() throws IOException {
      Map<String, Integer> registrars = new HashMap<>();
      Map<String, Integer> phoenixes = new HashMap<>();
      Map<String, Integer> classServers = new HashMap<>();
      for (String robot : ROBOTS) {
        registrars.put(robot, FreePorts.allocate());
        phoenixes.put(robot, FreePorts.allocate());
        classServers.put(robot, FreePorts.allocate());
      }
      return new Ports(registrars, phoenixes, classServers);
    }

    /** Those of the robots' lookup services, separated by commas. */
    String locators() {
      return ROBOTS.stream()
          .map(robot -> DemoEnvironment.ADDRESS + ":" + registrars.get(robot))
          .collect(Collectors.joining(","));
    }

    /** The environment of all commands: the robots' descriptions read them. */
    Map<String, String> variables(SimulationProcess field) {
      Map<String, String> all = new HashMap<>();
      all.put("DFRA_HOST", DemoEnvironment.ADDRESS);
      all.put("DFRA_TEAM", "security-demo-" + ProcessHandle.current().pid());
      all.put(FieldTeam.LOCATORS, locators());
      all.put("DFRA_WAIT", "4"); // a computer with two cores has twenty processes here
      registrars.forEach((robot, port) -> put(all, robot, "REGISTRAR_PORT", port));
      classServers.forEach((robot, port) -> put(all, robot, "CLASS_PORT", port));
      for (String robot : ROBOTS) {
        field
            .links(robot)
            .forEach((device, link) -> put(all, robot, device.toUpperCase(ROOT) + "_LINK", link));
      }
      return all;
    }

    private static void put(Map<String, String> all, String robot, String name, Object value) {
      all.put("DFRA_" + robot.toUpperCase(ROOT) + "_" + name, value.toString());
    }
  }

  private void make(MemberCommands commands, FieldTeam team) throws Exception {
    progress.section("making the team", "A team whose members know each other");
    progress.say(
        "Every member has a computer of its own; here, that is a state folder. Anna's has the"
            + " authority of the team. What is typed on a computer stands behind its name.");
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    commands.type(ANNA, "security", "init", "field", "--no-passphrase", "--operator=" + ANNA);
    for (String robot : ROBOTS) {
      admit(commands, "robot", robot);
    }
    progress.step("bringing the robots up");
    bringUp(commands, team);
    SecureProcess.Installed own = SecureProcess.install(commands.security(ANNA), false);
    DemoAssertions.require(
        own.mode() == SecurityMode.SECURE, "anna's identity cannot be used: " + own.fault());
    for (String robot : ROBOTS) {
      int services = team.services(robot).size();
      DemoAssertions.require(services > 0, robot + " has no services");
    }
    Duration took = watch.elapsed();
    progress.say(
        "From an empty folder to two robots that authenticate each other: %s.",
        QuantityText.seconds(took));
    progress.figure("from nothing to a team of two robots", took, TO_A_TEAM);
    admit(commands, "operator", OSCAR);
    admit(commands, "observer", OTTO);
    admit(commands, "robot", MALLORY);
    commands.type(OTTO, "whoami");
  }

  private static void admit(MemberCommands commands, String role, String name)
      throws IOException, InterruptedException {
    String passphrase = "--passphrase-file=" + name + ".pass";
    commands.typeBriefly(ANNA, 1, "security", "issue", role, name, passphrase);
    commands.typeBriefly(name, 1, "security", "join", name + ".bundle", passphrase);
  }

  /** Both in parallel, as on two computers. */
  private static void bringUp(MemberCommands commands, FieldTeam team) throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(ROBOTS.size());
    try {
      List<Callable<List<String>>> tasks = new ArrayList<>();
      ROBOTS.forEach(robot -> tasks.add(() -> team.bringUp(robot)));
      List<Future<List<String>>> all = threads.invokeAll(tasks);
      for (int i = 0; i < all.size(); i++) {
        commands.show(
            ROBOTS.get(i),
            MemberCommands.first(LINES, all.get(i).get()),
            team.upWords(ROBOTS.get(i)));
      }
    } catch (ExecutionException e) {
      @Nullable Throwable why = e.getCause();
      throw new IOException("a robot did not start: " + (why == null ? e : why).getMessage(), why);
    } finally {
      threads.shutdownNow();
    }
  }

  private void search(
      RasterSetup setup,
      SimulationProcess field,
      MemberCommands commands,
      FieldTeam team,
      Ports ports,
      String rogueLocator)
      throws Exception {
    progress.section("searching", "Two robots search: one for Anna, one for Oscar");
    SecurityScenes scenes = new SecurityScenes(progress, commands, team);
    RevocationScene revocation = new RevocationScene(progress, commands, team, "atrv2");
    List<String> locators = new ArrayList<>();
    for (String each : ports.locators().split(",")) {
      locators.add(SCHEME + each);
    }
    locators.add(rogueLocator);
    MissionResult result =
        new SecureSearch(setup, field, team, locators)
            .run(
                new LiveProgress(progress, System::nanoTime, setup.scenario()),
                () -> {
                  scenes.observer();
                  scenes.stranger();
                  scenes.rogueReceiver();
                  scenes.alteredCode();
                  revocation.play();
                  scenes.policy();
                });
    progress.section("judging", "The search is over");
    for (RobotMissionResult each : result.robots()) {
      progress.say("%s: %s.", each.robot(), each.ending());
    }
    progress.figure("collisions", result.collisions().size(), 0, "");
  }

  /** Asks the stranger's lookup service, whose locator all had, who has believed it. */
  private void believed(Process rogue, BufferedReader output) throws IOException {
    progress.section("asking the rogue", "A rogue lookup service is never used");
    rogue.getOutputStream().close();
    String[] counts =
        Optional.ofNullable(output.readLine())
            .orElseThrow(() -> new IOException("the rogue lookup service has ended"))
            .split(" ");
    progress.say(
        "All the time, both robots and Anna's program also asked a stranger's lookup service, which"
            + " lists a receiver that says that it is atrv1/gps_front. The receiver was called %s"
            + " times; %s modules were registered there.",
        counts[0], counts[1]);
    progress.figure("calls of a stranger's receiver", Integer.parseInt(counts[0]), 0, "");
    progress.figure("modules with a stranger", Integer.parseInt(counts[1]), 0, "");
  }

  private void audit(MemberCommands commands) throws Exception {
    progress.section("reading the audit trail", "Who did what");
    commands.type("atrv1", "audit", "--who=" + OTTO, "--last=8");
    commands.type("atrv2", "audit", "--who=" + OSCAR, "--last=4");
    for (String robot : ROBOTS) {
      commands.type(robot, "audit", "verify");
    }
  }
}
