package org.dfra.benchmarks.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.host.PrivateFiles;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.phoenix.host.ClassArchive;
import org.jspecify.annotations.Nullable;

/**
 * The two robots of {@code ./dfra demo persona}, brought up once.
 *
 * @param coldStartSeconds from the command to start both until a client's directory shows all four
 *     modules at work
 * @param coldStartCpuSeconds CPU time of both phoenixes and all six groups until then, which
 *     depends less on what else the computer does
 * @param recoverySeconds from {@code kill -9} of a receiver's group until the next call is
 *     answered, which needs no position of the receiver
 * @param receiverMegabytes memory of a receiver's group, its share of shared pages included (PSS),
 *     while one of the robots runs
 * @param registrarMegabytes the same of the registrar's group
 * @param phoenixMegabytes the same of phoenix
 */
public record RobotStart(
    double coldStartSeconds,
    double coldStartCpuSeconds,
    double recoverySeconds,
    double receiverMegabytes,
    double registrarMegabytes,
    double phoenixMegabytes) {

  private static final List<String> ROBOTS = List.of("atrv1", "atrv2");
  private static final List<String> RECEIVERS = List.of("gps_front", "gps_rear");
  private static final double NANOS = 1e9;
  private static final double KILOBYTES = 1024;
  private static final Pattern PSS = Pattern.compile("(?m)^Pss:\\s+(\\d+) kB$");

  /**
   * Brings the robots up and down again.
   *
   * @param links to four receivers that send a position each second
   * @throws IOException if a robot does not come up, or this is not Linux
   */
  public static RobotStart measure(StartCondition condition, List<String> links) throws Exception {
    @Nullable String archive = System.getProperty(ClassArchive.COMMANDS);
    if (!condition.hasArchive()) {
      System.clearProperty(ClassArchive.COMMANDS);
    }
    try (DemoEnvironment environment = new DemoEnvironment()) {
      RobotStart measured = measure(environment, condition, links);
      environment.shutDown();
      return measured;
    } finally {
      if (archive != null) {
        System.setProperty(ClassArchive.COMMANDS, archive);
      }
    }
  }

  private static RobotStart measure(
      DemoEnvironment environment, StartCondition condition, List<String> links) throws Exception {
    List<DemoRobot> robots = new ArrayList<>();
    for (int i = 0; i < ROBOTS.size(); i++) {
      robots.add(
          robot(
              environment,
              ROBOTS.get(i),
              Map.of(RECEIVERS.get(0), links.get(2 * i), RECEIVERS.get(1), links.get(2 * i + 1)),
              condition));
    }
    long began = System.nanoTime();
    try (ModuleDirectory directory =
        new JiniModuleDirectory(
            DemoEnvironment.ADDRESS, List.of(), robots.stream().map(DemoRobot::locator).toList())) {
      bringUp(robots);
      DemoAssertions.await(
          "that all robots show their modules at work",
          DemoEnvironment.PATIENCE,
          () -> isComplete(directory));
      double coldStart = (System.nanoTime() - began) / NANOS;
      double cpu = cpuSeconds(robots);
      DemoRobot robot = robots.get(0);
      GPSSensor gps =
          directory
              .find(ModuleQuery.of(GPSSensor.class).robot(robot.name()).name(RECEIVERS.get(0)))
              .get(0)
              .module();
      Object unused = gps.readiness(); // it connects
      robots.get(1).host().shutDown();
      double receiver = megabytes(robot.process(RECEIVERS.get(0)));
      double registrar = megabytes(robot.process("lookup"));
      double phoenix = megabytes(robot.host().phoenix().pid().orElseThrow());
      return new RobotStart(
          coldStart, cpu, recover(environment, robot, gps), receiver, registrar, phoenix);
    }
  }

  private static DemoRobot robot(
      DemoEnvironment environment, String name, Map<String, String> links, StartCondition condition)
      throws IOException {
    Path xml =
        Path.of(System.getProperty("dfra.root", ""), "config", "teams", "field", name + ".xml");
    DemoRobot robot =
        DemoRobot.of(environment, xml, name, links, each -> withOptions(each, condition.options()));
    Path permitted = robot.host().phoenix().state().resolve("permitted.options");
    PrivateFiles.makeFile(permitted);
    Files.write(permitted, condition.options());
    return robot;
  }

  private static RobotDescription withOptions(RobotDescription robot, List<String> options) {
    List<GroupDescription> groups = new ArrayList<>();
    for (GroupDescription each : robot.groups()) {
      List<String> all = new ArrayList<>(each.jvmOptions());
      all.addAll(options);
      groups.add(
          new GroupDescription(each.name(), all, each.registrar(), each.modules(), each.place()));
    }
    return robot.withGroups(groups);
  }

  /** Both in parallel, as on two computers. */
  private static void bringUp(List<DemoRobot> robots) throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(robots.size());
    try {
      List<Future<List<RobotBootstrap.ServiceReference>>> begun = new ArrayList<>();
      for (DemoRobot each : robots) {
        begun.add(threads.submit(each::bringUp));
      }
      for (Future<List<RobotBootstrap.ServiceReference>> each : begun) {
        List<RobotBootstrap.ServiceReference> unused = each.get();
      }
    } finally {
      threads.shutdownNow();
    }
  }

  private static boolean isComplete(ModuleDirectory directory) {
    return directory.personas().size() == ROBOTS.size()
        && directory.personas().stream()
            .allMatch(
                each ->
                    each.modules().size() == RECEIVERS.size()
                        && each.modules().stream()
                            .allMatch(
                                module ->
                                    module
                                        .attributes(ModuleAttributes.class)
                                        .filter(attributes -> attributes.state().serves())
                                        .isPresent()));
  }

  private static double cpuSeconds(List<DemoRobot> robots) throws IOException {
    double sum = 0;
    for (DemoRobot robot : robots) {
      List<Long> processes = new ArrayList<>();
      processes.add(robot.host().phoenix().pid().orElseThrow());
      robot.host().groups().forEach(group -> processes.add(group.pid()));
      for (long pid : processes) {
        sum +=
            ProcessHandle.of(pid)
                .flatMap(process -> process.info().totalCpuDuration())
                .orElseThrow(() -> new IOException("process " + pid + " has ended"))
                .toNanos();
      }
    }
    return sum / NANOS;
  }

  private static double recover(DemoEnvironment environment, DemoRobot robot, GPSSensor gps)
      throws Exception {
    long process = robot.process(RECEIVERS.get(0));
    long began = System.nanoTime();
    environment.signal("KILL", process);
    Object answer = gps.readiness();
    double seconds = (System.nanoTime() - began) / NANOS;
    if (robot.process(RECEIVERS.get(0)) == process) {
      throw new IOException("process " + process + " still runs, and answered: " + answer);
    }
    return seconds;
  }

  /**
   * Memory of a process: its own pages, and its share of those that it shares with others.
   *
   * @return 10⁶ · 1.048576 bytes
   * @throws IOException if it has ended, is of another user, or this is not Linux
   */
  static double megabytes(long pid) throws IOException {
    Path file = Path.of("/proc", Long.toString(pid), "smaps_rollup");
    Matcher pss = PSS.matcher(Files.readString(file));
    if (!pss.find()) {
      throw new IOException(file + " has no line \"Pss\"; use a Linux kernel 4.14 or newer");
    }
    return Long.parseLong(pss.group(1)) / KILOBYTES;
  }
}
