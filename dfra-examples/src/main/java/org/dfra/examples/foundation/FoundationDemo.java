package org.dfra.examples.foundation;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoHost;
import org.dfra.examples.harness.DemoRunner;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.phoenix.GroupStatus;

/**
 * The foundation: a client finds a receiver by capability, and keeps using it after the process of
 * the receiver, or of phoenix, was killed.
 */
public final class FoundationDemo implements Demo {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;
  private static final int MANY = 1000;
  private static final GeoPosition ANTENNA = new GeoPosition(27.9506, -82.4572, 14.5);

  private final ProgressReporter progress;

  /** {@code tell} reports the progress. */
  public FoundationDemo(ProgressReporter progress) {
    this.progress = progress;
  }

  @Override
  public boolean run() {
    return DemoRunner.run(progress, this::play);
  }

  private void play(DemoEnvironment environment) throws Exception {
    progress.section("switching on the receiver", "A robot starts");
    String link = environment.startReceivers(List.of(ANTENNA)).get(0);
    progress.say(
        "An M12+ receiver is switched on at %s: an emulator that sends the receiver's real bytes.",
        link);

    ProgressReporter.Stopwatch coldStart = progress.stopwatch();
    DemoHost host = environment.host("atrv1");
    String locator = bringUp(host, link);

    progress.section("finding the receiver", "A client finds a receiver");
    ProgressReporter.Stopwatch search = progress.stopwatch();
    try (PositionClient client = PositionClient.find(locator, PATIENCE)) {
      progress.say(
          "A client that knows only the interface GPSSensor found %s through discovery and lookup"
              + " in %s.",
          client.gps(), QuantityText.seconds(search.elapsed()));
      GpsFix fix = client.position(PATIENCE);
      Duration cold = coldStart.elapsed();
      progress.say("By a remote call it read %s.", describe(fix));
      progress.figure("cold start of everything to position read", cold, Duration.ofSeconds(8));

      killTheReceiversGroup(environment, host, client.gps());
      silence(environment, host, client.gps());
      activateInALivingGroup(host);
      killPhoenix(environment, host, client.gps());
      callLocally(environment, client);
    }
  }

  private String bringUp(DemoHost host, String link) throws Exception {
    progress.step("starting phoenix");
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    ProcessHandle phoenix = host.startPhoenix();
    progress.say(
        "Phoenix, the activation daemon, is process %d after %s.",
        phoenix.pid(), QuantityText.seconds(watch.elapsed()));

    progress.step("bringing up the robot");
    int port = FreePorts.allocate();
    Map<String, String> settings =
        Map.of(
            "DFRA_HOST",
            DemoEnvironment.ADDRESS,
            "DFRA_ATRV1_REGISTRAR_PORT",
            Integer.toString(port),
            "DFRA_ATRV1_GPS_FRONT_LINK",
            link);
    Path xml = Path.of(System.getProperty("dfra.root", ""), "config", "robots", "atrv1.xml");
    RobotDescription robot = RobotXml.read(xml, settings::get);
    watch = progress.stopwatch();
    List<RobotBootstrap.ServiceReference> services = new RobotBootstrap(host.phoenix(), robot).up();
    progress.say(
        "Robot %s is up after another %s: %s.",
        robot.name(),
        QuantityText.seconds(watch.elapsed()),
        services.stream()
            .map(service -> service.name() + " in group " + service.group())
            .collect(Collectors.joining(", ")));
    for (GroupStatus group : host.groups()) {
      progress.say("Group %s is process %d.", group.name(), group.pid());
    }
    return "jini://" + DemoEnvironment.ADDRESS + ":" + port;
  }

  private void killTheReceiversGroup(DemoEnvironment environment, DemoHost host, GPSSensor gps)
      throws Exception {
    progress.section("killing the receiver's group", "kill -9 of the receiver's virtual machine");
    long old = host.group("gps").pid();
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    environment.signal("KILL", old);
    GpsFix fix = fixFrom(gps);
    Duration healed = watch.elapsed();
    long now = host.group("gps").pid();
    DemoAssertions.require(now != old && now > 0, "the group was not restarted");
    progress.say(
        "Process %d was killed. The same proxy answered again after %s, from process %d: %s.",
        old, QuantityText.seconds(healed), now, describe(fix));
    progress.figure("GPS group killed to same proxy answering", healed, Duration.ofSeconds(3));
  }

  /** The last fix; a receiver that has just restarted has none for a moment. */
  private static GpsFix fixFrom(GPSSensor gps) throws RemoteException {
    gps.awaitReadiness(PATIENCE);
    return gps.fix();
  }

  private void silence(DemoEnvironment environment, DemoHost host, GPSSensor gps) throws Exception {
    progress.section(
        "stopping the receiver's group",
        "kill -STOP: a process that does not answer, as out of radio range");
    long pid = host.group("gps").pid();
    environment.signal("STOP", pid);
    ProgressReporter.Stopwatch sinceSignal = progress.stopwatch();
    try {
      while (true) {
        ProgressReporter.Stopwatch watch = progress.stopwatch();
        try {
          gps.fix(); // on a loaded machine the signal takes effect a moment later
        } catch (DeadlineExceededException e) {
          progress.say(
              "Process %d was suspended. The call ended after %s: %s.",
              pid, QuantityText.seconds(watch.elapsed()), String.valueOf(e.getMessage()));
          progress.figure("silent server reported", watch.elapsed(), Duration.ofSeconds(3));
          break;
        }
        DemoAssertions.require(
            sinceSignal.elapsed().compareTo(PATIENCE) < 0, "a suspended process still answers");
      }
    } finally {
      environment.signal("CONT", pid);
    }
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    gps.fix();
    progress.say(
        "It was resumed, and the same proxy answered after %s.",
        QuantityText.seconds(watch.elapsed()));
  }

  private void activateInALivingGroup(DemoHost host) throws Exception {
    progress.section("activating an object in a living group", "Activation of an object");
    ActivationSystem system = host.phoenix().system();
    ActivationGroupID group = gpsGroup(host);
    beacon(system, group).pid(); // loads the classes of the PID service
    ActivationID id = register(system, group);
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    long pid = ((ProcessIdService) id.activate(false)).pid();
    Duration took = watch.elapsed();
    DemoAssertions.require(
        pid == host.group("gps").pid(), "the object was created in another process");
    progress.say(
        "An object that needs no device was created in the running group in %s.",
        QuantityText.seconds(took));
    progress.figure("activation of an object in a live group", took, Duration.ofMillis(100));
  }

  private static ProcessIdService beacon(ActivationSystem system, ActivationGroupID group)
      throws ActivationException, RemoteException {
    return (ProcessIdService) register(system, group).activate(false);
  }

  private static ActivationID register(ActivationSystem system, ActivationGroupID group)
      throws ActivationException, RemoteException {
    return system.registerObject(
        new ActivationDesc(
            group, ProcessIdService.Server.class.getName(), null, (MarshalledObject<?>) null));
  }

  private static ActivationGroupID gpsGroup(DemoHost host) throws IOException {
    @SuppressWarnings("unchecked") // as phoenix declares it
    Map<ActivationGroupID, ActivationGroupDesc> groups =
        host.phoenix().admin().getActivationGroups();
    return groups.entrySet().stream()
        .filter(
            each -> String.valueOf(each.getValue().getPropertyOverrides()).contains("atrv1.gps"))
        .map(Map.Entry::getKey)
        .findFirst()
        .orElseThrow(() -> new IOException("the GPS group is not registered"));
  }

  private void killPhoenix(DemoEnvironment environment, DemoHost host, GPSSensor gps)
      throws Exception {
    progress.section("registering many objects", "kill -9 of phoenix");
    ActivationSystem system = host.phoenix().system();
    ActivationGroupID group = gpsGroup(host);
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    for (int i = 0; i < MANY; i++) {
      register(system, group);
    }
    progress.say(
        "%d more objects were registered in %s, each one on disk before phoenix acknowledged it.",
        MANY, QuantityText.seconds(watch.elapsed()));

    progress.step("killing phoenix");
    List<GroupStatus> before = host.groups();
    host.killPhoenix();
    watch = progress.stopwatch();
    gps.fix();
    progress.say(
        "Phoenix was killed. The receiver still answered, after %s: a call needs no phoenix while"
            + " its server runs.",
        QuantityText.seconds(watch.elapsed()));

    progress.step("restarting phoenix");
    watch = progress.stopwatch();
    ProcessHandle restarted = host.startPhoenix();
    Duration ready = watch.elapsed();
    List<GroupStatus> after = host.groups();
    progress.say(
        "A new phoenix, process %d, answered after %s.",
        restarted.pid(), QuantityText.seconds(ready));
    progress.figure("phoenix restart to ready, " + MANY + " objects", ready, Duration.ofSeconds(2));
    DemoAssertions.require(
        count(before) == count(after), count(before) + " registrations became " + count(after));
    for (int i = 0; i < before.size(); i++) {
      DemoAssertions.require(
          before.get(i).pid() == after.get(i).pid(), "a running group was restarted");
      DemoAssertions.require(after.get(i).adopted(), "a running group was not adopted");
    }
    progress.say(
        "All %d registrations are present, and the running groups were adopted, not started twice: %s.",
        count(after),
        after.stream()
            .map(each -> each.name() + " is still process " + each.pid())
            .collect(Collectors.joining(", ")));

    progress.step("killing the receiver's group under the new phoenix");
    long old = host.group("gps").pid();
    watch = progress.stopwatch();
    environment.signal("KILL", old);
    fixFrom(gps);
    progress.say(
        "The adopted group was killed too: the same proxy answered after %s, from process %d.",
        QuantityText.seconds(watch.elapsed()), host.group("gps").pid());
  }

  private static int count(List<GroupStatus> groups) {
    return groups.stream().mapToInt(GroupStatus::objects).sum();
  }

  private void callLocally(DemoEnvironment environment, PositionClient client) throws Exception {
    progress.section(
        "calling in the same virtual machine", "The proxy in the module's own virtual machine");
    SameVmCall.Result result =
        SameVmCall.measure(client.gps(), environment.startReceivers(List.of(ANTENNA)).get(0));
    progress.say(
        "There a proxy passes the call directly to the implementation: %.1f ns instead of %.1f ns;"
            + " over the network a call takes %.0f µs.",
        result.proxyNanos(), result.directNanos(), result.remoteNanos() / 1000);
    progress.figure(
        "same-VM proxy call over the direct call",
        result.proxyNanos() - result.directNanos(),
        100,
        "ns");
  }

  private static String describe(GpsFix fix) {
    GeoPosition at = Objects.requireNonNull(fix.position());
    return String.format(
        Locale.ROOT,
        "%s, %.1f m (%s, %d satellites, %s)",
        QuantityText.place(at),
        at.height(),
        fix.mode(),
        fix.satellitesTracked(),
        fix.utc().truncatedTo(ChronoUnit.MILLIS));
  }
}
