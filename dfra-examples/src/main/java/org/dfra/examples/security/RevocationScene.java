package org.dfra.examples.security;

import static org.dfra.examples.security.FieldTeam.ANNA;
import static org.dfra.examples.security.FieldTeam.OSCAR;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterSearch;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.security.AccessRefusedException;

/**
 * The operator whose goal a robot pursues is revoked: the operator's next call fails, the robot
 * halts, and another operator has it go on.
 */
final class RevocationScene {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;
  private static final Duration NEXT_CALL = Duration.ofSeconds(1);
  private static final Duration STANDING = Duration.ofMillis(1500);
  private static final long LOOK_MILLIS = 10;

  private final ProgressReporter progress;
  private final MemberCommands commands;
  private final FieldTeam team;
  private final String robot;

  /**
   * @param robot pursues a goal of oscar's
   */
  RevocationScene(
      ProgressReporter progress, MemberCommands commands, FieldTeam team, String robot) {
    this.progress = progress;
    this.commands = commands;
    this.team = team;
    this.robot = robot;
  }

  /** What happens within moments of the revocation, each measured from the authority's list on. */
  private record Moments(Duration refused, Duration standing, String refusal) {}

  void play() throws Exception {
    progress.section("revoking an operator", "An operator is revoked in mid-mission");
    RasterSearch search =
        team.as(OSCAR, () -> team.find(RasterSearch.class, robot + "/raster_search"));
    RasterSearch annas = team.find(RasterSearch.class, robot + "/raster_search");
    DriveEffector wheels = team.find(DriveEffector.class, robot + "/drive");
    BehaviorStatus before = search.status();
    DemoAssertions.require(
        before.phase() == Phase.RUNNING,
        robot + " was to search for oscar now, but its search is " + before.phase());
    progress.say(
        "%s searches for Oscar, an operator: %s. Oscar's laptop is lost.",
        robot, before.activity());
    CompletableFuture<Moments> moments = new CompletableFuture<>();
    Thread watching = new Thread(() -> complete(moments, search, annas, wheels), "demo-revocation");
    watching.setDaemon(true);
    watching.start();
    commands.type(ANNA, "security", "revoke", OSCAR, "--reason=lost");
    Moments seen = moments(moments);
    progress.say(
        "Oscar's next call fails %s after the authority has signed the list: %s.",
        QuantityText.seconds(seen.refused()), seen.refusal());
    BehaviorStatus halted = annas.status();
    progress.say(
        "%s stands %s after it: its search is %s (%s).",
        robot,
        QuantityText.seconds(seen.standing()),
        halted.phase().name().toLowerCase(Locale.ROOT),
        halted.activity());
    progress.figure("revoked to next call refused", seen.refused(), NEXT_CALL);
    progress.figure("revoked to wheels that stand", seen.standing(), STANDING);
    progress.say("Anna has looked at the robot, and takes over:");
    commands.type(ANNA, "task", "resume", "--robot=" + robot);
    DemoAssertions.await(
        "that " + robot + " goes on", PATIENCE, () -> annas.status().phase() != Phase.PAUSED);
  }

  private static Moments moments(CompletableFuture<Moments> moments)
      throws IOException, InterruptedException {
    try {
      return moments.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    } catch (ExecutionException e) {
      throw new IOException("the revocation could not be watched: " + e.getCause(), e);
    } catch (TimeoutException e) {
      throw new IOException("the revocation has had no effect within " + PATIENCE, e);
    }
  }

  private void complete(
      CompletableFuture<Moments> moments,
      RasterSearch search,
      RasterSearch annas,
      DriveEffector wheels) {
    try {
      moments.complete(watch(search, annas, wheels));
    } catch (Exception e) { // the scene reports it
      moments.completeExceptionally(e);
    }
  }

  private Moments watch(RasterSearch search, RasterSearch annas, DriveEffector wheels)
      throws Exception {
    Path list = commands.state(ANNA).resolve("authority").resolve("revoked.crl");
    FileTime before = Files.getLastModifiedTime(list);
    while (Files.getLastModifiedTime(list).equals(before)) {
      TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS); // another process writes it
    }
    ProgressReporter.Stopwatch since = progress.stopwatch();
    Duration refused = Duration.ZERO;
    String refusal = "";
    while (refusal.isEmpty()) {
      try {
        Object unused = search.status();
        TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
      } catch (AccessRefusedException | RemoteException e) {
        refused = since.elapsed();
        refusal = sentence(e);
      }
    }
    while (annas.status().phase() == Phase.RUNNING || isMoving(wheels)) {
      TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
    }
    return new Moments(refused, since.elapsed(), refusal);
  }

  private static boolean isMoving(DriveEffector wheels) throws RemoteException {
    var velocity = wheels.driveState().velocity();
    return velocity.speed() != 0 || velocity.yawRate() != 0;
  }

  private static String sentence(Exception refusal) {
    Throwable root = refusal;
    for (Throwable next = root.getCause(); next != null; next = root.getCause()) {
      root = next;
    }
    return String.valueOf(root.getMessage());
  }
}
