package org.dfra.examples.persona;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;

/** A receiver's process is killed: under a subscription and a lease, and during a call. */
final class ReceiverKillStep {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;
  private static final Duration LEASE = Duration.ofSeconds(10);

  /** The subscription and the lease. */
  private static final int CLIENTS = 2;

  /** A call that lasts this much longer than usual has not been answered by a living server. */
  private static final Duration UNANSWERED = Duration.ofMillis(300);

  private final ProgressReporter progress;
  private final DemoEnvironment environment;
  private final DemoRobot robot;
  private final ModuleDirectory directory;

  ReceiverKillStep(
      ProgressReporter progress,
      DemoEnvironment environment,
      DemoRobot robot,
      ModuleDirectory directory) {
    this.progress = progress;
    this.environment = environment;
    this.robot = robot;
    this.directory = directory;
  }

  /** Kills the process of a receiver that has a listener and a lease. */
  void underASubscription(FixLog log) throws Exception {
    progress.section("killing a receiver", "kill -9 of a receiver's process with a subscriber");
    try (ModuleLease lease = log.gps().acquireLease(LEASE)) {
      DemoAssertions.require(lease.isLive(), "the lease on " + log.path() + " is not live");
      awaitClients(log, Instant.MIN);
      progress.say(
          "The client subscribes to the readings of %s and holds a lease on it, so the receiver stays"
              + " active.",
          log.path());
      FixLog.Arrival last = log.next(PATIENCE);
      long lost = log.subscription().lost();
      long process = robot.process(log.module());

      Instant killed = Instant.now();
      ProgressReporter.Stopwatch watch = progress.stopwatch();
      environment.signal("KILL", process);
      FixLog.Arrival again = log.firstAfterLife(last.life(), PATIENCE);
      Duration listening = watch.elapsed();
      awaitClients(log, killed);
      Duration leased = watch.elapsed();

      long missed = again.number() - last.number() - 1;
      long counted = log.subscription().lost() - lost;
      progress.say(
          "Process %d was killed after reading no. %d. Reading no. %d came %s after the kill, from"
              + " process %d, and the lease is valid again after %s. The client took no action for"
              + " either.",
          process,
          last.number(),
          again.number(),
          QuantityText.seconds(listening),
          robot.process(log.module()),
          QuantityText.seconds(leased));
      progress.say(
          "Events are numbered across a module's restarts, so a gap is detected and counted. In this"
              + " gap of %s the client missed %s, %s.",
          QuantityText.seconds(Duration.ofNanos(again.nanos() - last.nanos())),
          QuantityText.count(counted, "event"),
          missed == 0 ? "but no reading" : QuantityText.count(missed, "reading") + " among them");
      progress.figure(
          "receiver killed to its readings coming again", listening, Duration.ofSeconds(5));
      progress.figure(
          "receiver killed to the client's lease counted", leased, Duration.ofSeconds(5));
      progress.figure(
          "readings missed in the gap but not counted", Math.max(0, missed - counted), 0, "");
    }
  }

  /** Waits until the receiver that restarted after a moment reports both clients. */
  private void awaitClients(FixLog log, Instant after) throws Exception {
    ModuleQuery<GPSSensor> query =
        ModuleQuery.of(GPSSensor.class).robot(robot.name()).name(log.module());
    DemoAssertions.await(
        "that " + log.path() + " has " + CLIENTS + " clients",
        PATIENCE,
        () ->
            directory.find(query).stream()
                .flatMap(each -> each.attributes(ModuleAttributes.class).stream())
                .anyMatch(
                    each ->
                        each.clients() == CLIENTS
                            && each.activated() != null
                            && each.activated().isAfter(after)));
  }

  /** Kills the receiver's process during a call that it has not answered. */
  void underACall() throws Exception {
    progress.section("killing a receiver under a call", "kill -9 under a call");
    awaitAllReady();
    LocationSensor any = directory.proxyFor(DiscoveryStep.CAPABLE_SENSORS.robot(robot.name()));
    String asked = any.location().frame();
    progress.say(
        "This client can use any location sensor of %s, so it calls one object that represents all"
            + " of them. %s answered first.",
        robot.name(), asked);
    long process = robot.process(asked.substring(asked.indexOf('/') + 1));
    ExecutorService caller = Executors.newSingleThreadExecutor();
    try {
      environment.signal("STOP", process);
      Future<LocationReading> call = inFlight(caller, any);
      ProgressReporter.Stopwatch watch = progress.stopwatch();
      environment.signal("KILL", process);
      String answered = call.get(PATIENCE.toSeconds(), TimeUnit.SECONDS).frame();
      Duration took = watch.elapsed();
      progress.say(
          "The next call had reached it and waited for its answer (the process was suspended for"
              + " that) when process %d was killed. %s after the kill the call was answered by %s;"
              + " the caller received no exception.",
          process, QuantityText.seconds(took), answered);
      if (answered.equals(asked)) {
        progress.say("It had restarted in a new process before the other receiver was called.");
      }
      progress.figure("call to a killed receiver answered", took, Duration.ofSeconds(3));
    } finally {
      caller.shutdownNow();
    }
    awaitAllReady();
  }

  /** A call that a suspended process has not answered. */
  private static Future<LocationReading> inFlight(ExecutorService caller, LocationSensor any)
      throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (System.nanoTime() - end < 0) {
      Future<LocationReading> call = caller.submit(any::location);
      try {
        // On a loaded machine the signal takes effect a moment later.
        LocationReading unused = call.get(UNANSWERED.toMillis(), TimeUnit.MILLISECONDS);
      } catch (TimeoutException e) {
        return call;
      } catch (ExecutionException e) {
        throw new RemoteException("the call ended too early", e.getCause());
      }
    }
    throw new RemoteException("a suspended process still answers");
  }

  private void awaitAllReady() throws Exception {
    List<GPSSensor> all =
        directory.find(ModuleQuery.of(GPSSensor.class).robot(robot.name())).stream()
            .map(each -> each.module())
            .toList();
    for (GPSSensor each : all) {
      Readiness readiness = each.awaitReadiness(PATIENCE);
      DemoAssertions.require(readiness.serves(), each.identification().path() + " is " + readiness);
    }
  }
}
