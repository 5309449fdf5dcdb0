package org.dfra.examples.security;

import static org.dfra.examples.security.FieldTeam.ANNA;
import static org.dfra.examples.security.FieldTeam.MALLORY;
import static org.dfra.examples.security.FieldTeam.OTTO;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.server.RMIClassLoader;
import java.text.NumberFormat;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.module.Module;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.loading.CodeRefusedException;
import org.dfra.security.AccessRefusedException;
import org.jspecify.annotations.Nullable;

/** What happens while the robots search: who may do what, and who is never believed. */
final class SecurityScenes {

  private static final Duration LEASE = Duration.ofSeconds(10);
  private static final int POSITIONS = 3;
  private static final String FIRST = "atrv1";
  private static final String SECOND = "atrv2";
  private static final String RECEIVER = "gps_front";
  private static final int DIGITS = 8; // of a digest that are shown

  private final ProgressReporter progress;
  private final MemberCommands commands;
  private final FieldTeam team;

  SecurityScenes(ProgressReporter progress, MemberCommands commands, FieldTeam team) {
    this.progress = progress;
    this.commands = commands;
    this.team = team;
  }

  /** A call that must be refused. */
  @FunctionalInterface
  private interface Attempt {
    @Nullable Object make() throws Exception;
  }

  /** Makes a call that must be refused by the policy, and returns the refusal. */
  private static String refused(Attempt attempt) throws IOException {
    try {
      Object unused = attempt.make();
    } catch (AccessRefusedException e) {
      return String.valueOf(e.getMessage());
    } catch (Exception e) { // any other failure is no refusal
      throw new IOException("it was not refused by the policy, but failed: " + e, e);
    }
    throw new IOException("it was not refused");
  }

  /** An observer sees and listens, and moves nothing. */
  void observer() throws Exception {
    progress.section("watching as an observer", "Otto may watch");
    GPSSensor receiver = team.as(OTTO, () -> team.find(GPSSensor.class, FIRST + "/" + RECEIVER));
    CountDownLatch positions = new CountDownLatch(POSITIONS);
    try (Subscription unused =
        team.as(OTTO, () -> receiver.subscribe(event -> count(event, positions), keepLast()))) {
      DemoAssertions.require(
          positions.await(DemoEnvironment.PATIENCE.toSeconds(), TimeUnit.SECONDS),
          "otto received no positions of " + FIRST);
    }
    progress.say(
        "Otto, an observer, sees %d services of %s and has received %d positions of %s.",
        team.as(OTTO, () -> team.services(FIRST)).size(), FIRST, POSITIONS, RECEIVER);
    DriveEffector drive = team.as(OTTO, () -> team.find(DriveEffector.class, FIRST + "/drive"));
    CommandKey key = new CommandKey(UUID.randomUUID());
    progress.say("Otto drives: %s.", refused(() -> execute(drive, key, new Velocity(0.3, 0))));
    progress.say(
        "The same with an argument that no robot can read: %s.",
        refused(() -> execute(drive, key, new UnreadableCommand())));
    DriveEffector annas = team.find(DriveEffector.class, FIRST + "/drive");
    String failure = "nothing";
    try {
      Object unused = execute(annas, key, new UnreadableCommand());
    } catch (RemoteException | RuntimeException e) {
      failure = rootCause(e);
    }
    DemoAssertions.require(
        !failure.equals("nothing"), "an argument that cannot be read was accepted");
    progress.say(
        "So Otto's argument was not even looked at. When Anna, an operator, sends it, the robot tries"
            + " to read it: %s.",
        failure);
  }

  private static DeliveryPolicy keepLast() {
    return DeliveryPolicy.keepLast(8);
  }

  private static void count(Delivery delivery, CountDownLatch positions) {
    if (delivery.event() instanceof ModuleEvent.NewReading) {
      positions.countDown();
    }
  }

  @SuppressWarnings("unchecked") // as a program that was not written in Java may
  private static @Nullable Object execute(DriveEffector drive, CommandKey key, Command command)
      throws RemoteException {
    ((Effector<Command>) (Effector<?>) drive).execute(key, command);
    return null;
  }

  private static String rootCause(Throwable thrown) {
    Throwable root = thrown;
    for (Throwable next = root.getCause(); next != null; next = root.getCause()) {
      root = next;
    }
    return root.toString();
  }

  /** Robots filter the classes of arguments: this one has a part that they refuse. */
  private static final class UnreadableCommand implements Command {
    private static final long serialVersionUID = 1L;

    @SuppressWarnings({"unused", "FieldCanBeLocal"}) // it is sent
    private final NumberFormat refusedByFilters = NumberFormat.getInstance(Locale.ROOT);
  }

  /** A program of nobody sees what is public. */
  void stranger() throws Exception {
    progress.section("looking as a stranger", "A stranger sees the public part of the persona");
    int services = CurrentIdentity.callAsStranger(() -> team.services(FIRST)).size();
    Module receiver =
        CurrentIdentity.callAsStranger(() -> team.find(GPSSensor.class, FIRST + "/" + RECEIVER));
    progress.say(
        "A program that has joined no team sees %d services of %s, and that %s is %s.",
        services, FIRST, RECEIVER, receiver.readiness());
    progress.say("It reads a position: %s.", refused(((GPSSensor) receiver)::fix));
    progress.say("It asks for a lease: %s.", refused(() -> receiver.acquireLease(LEASE)));
    DriveEffector drive =
        CurrentIdentity.callAsStranger(() -> team.find(DriveEffector.class, FIRST + "/drive"));
    progress.say("It stops the robot: %s.", refused(() -> drive.emergencyStop("nobody")));
  }

  /** A robot of the team that was taken over pretends to be another one's receiver. */
  void rogueReceiver() throws Exception {
    progress.section("pretending to be a receiver", "A rogue receiver is never used");
    progress.say(
        "Robot %s was taken over. It has a valid certificate, and now runs a receiver that says that"
            + " it is %s/%s.",
        MALLORY, FIRST, RECEIVER);
    PretendedGps rogue = team.as(MALLORY, () -> new PretendedGps(FIRST, RECEIVER));
    try (rogue) {
      String why = "nothing";
      try {
        team.as(MALLORY, () -> registered(rogue, team.registrar(FIRST)));
      } catch (RegistrationRefusedException e) {
        why = String.valueOf(e.getMessage());
      }
      DemoAssertions.require(!why.equals("nothing"), "a rogue receiver was registered");
      progress.say("It registers as that with %s: %s.", FIRST, why);
      team.as(
          MALLORY,
          () -> {
            rogue.register(team.registrar(SECOND), new Entry[0]);
            return true;
          });
      progress.say(
          "It registers with %s without saying whose it is, and is accepted: robots may offer each"
              + " other services.",
          SECOND);
      GPSSensor found =
          (GPSSensor)
              team.registrar(SECOND).lookup(new ServiceTemplate(rogue.serviceId(), null, null));
      String failure = "nothing";
      try {
        Object unused = found.fix();
      } catch (RemoteException e) {
        failure = rootCause(e);
      }
      DemoAssertions.require(!failure.equals("nothing"), "a rogue receiver was believed");
      progress.say("Anna calls it: %s.", failure);
      progress.say("The rogue receiver was called %d times.", rogue.calls());
      progress.figure("calls that a rogue receiver has received", rogue.calls(), 0, "");
    }
  }

  private static boolean registered(PretendedGps rogue, ServiceRegistrar registrar)
      throws IOException {
    rogue.register(registrar);
    return true;
  }

  /** Somebody changes code on its way. */
  void alteredCode() throws Exception {
    progress.section("altering code", "Altered code is refused");
    try (JarOnTheWay jar = new JarOnTheWay()) {
      progress.say(
          "A robot's jar for programs that lack its classes has the SHA-256 %s…; somebody on the way"
              + " changes one bit. Anna loads it: %s.",
          jar.digest().substring(0, DIGITS), codeRefusal(jar.alteredCodebase(), jar.digest()));
      progress.say(
          "Unchanged it is refused too, since no key of the team has signed it: %s.",
          codeRefusal(jar.codebase(), jar.digest()));
    }
  }

  private static String codeRefusal(String codebase, String digest) throws IOException {
    try {
      ClassLoader unused = RMIClassLoader.getClassLoader(codebase);
    } catch (CodeRefusedException e) {
      return String.valueOf(e.getMessage()).replace(digest, digest.substring(0, DIGITS) + "…");
    }
    throw new IOException("code was loaded that nobody has signed: " + codebase);
  }

  private static String place(GPSSensor receiver) throws RemoteException {
    return Optional.ofNullable(receiver.fix().position())
        .map(QuantityText::place)
        .orElse("no position now");
  }

  /** The authority changes the policy. */
  void policy() throws Exception {
    progress.section("changing the policy", "The policy changes while the robots search");
    GPSSensor first = team.as(OTTO, () -> team.find(GPSSensor.class, FIRST + "/" + RECEIVER));
    GPSSensor second = team.as(OTTO, () -> team.find(GPSSensor.class, SECOND + "/" + RECEIVER));
    progress.say("Otto reads the positions of both robots: %s, %s.", place(first), place(second));
    Path policy = commands.state(ANNA).resolve("authority").resolve("policy.xml");
    MemberCommands.edit(policy, "version=\"1\"", "version=\"2\"");
    String rule = "<deny name=\"no-positions\" member=\"otto\" interface=\"GPSSensor\"/>";
    MemberCommands.edit(
        policy, "<permit name=\"observers\"", rule + "\n\n  <permit name=\"observers\"");
    progress.say("Anna raises the version of the policy to 2, and adds a rule: %s", rule);
    commands.type(ANNA, "security", "publish");
    progress.say("Otto reads them again: %s.", refused(first::fix));
    progress.say("%s: %s.", SECOND, refused(second::fix));
  }
}
