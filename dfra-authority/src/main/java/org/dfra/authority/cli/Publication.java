package org.dfra.authority.cli;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.time.BoundedThreads;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.news.NewsExchange;
import org.dfra.river.security.news.TeamNews.Numbers;
import org.jspecify.annotations.Nullable;

/**
 * Gives every robot that this computer finds what the authority has signed, and says what is in
 * force there. The search begins when it is made, so that it costs no time later.
 */
final class Publication implements AutoCloseable {

  /** The longest wait for a robot, from the first call to its confirmation. */
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  private static final int MOST_AT_ONCE = 32;
  private static final int IDLE_SECONDS = 1;
  private static final long ASK_AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

  private final @Nullable TeamDirectory search;

  private Publication(@Nullable TeamDirectory search) {
    this.search = search;
  }

  /**
   * What has become of it at one robot.
   *
   * @param robot name of the robot
   * @param revocations number of the list in force there; 0 if it did not say
   * @param policy version of the policy in force there; 0 if it did not say, or if it is the one
   *     that comes with DFRA
   * @param isInForce whether it has everything that this computer has
   * @param seconds from the first call to it until it confirmed that
   * @param fault why it has not; empty if it has
   */
  record RobotView(
      String robot,
      long revocations,
      long policy,
      boolean isInForce,
      double seconds,
      String fault) {

    String sentence() {
      return isInForce
          ? String.format(
              Locale.ROOT,
              "Robot %s has list %d and policy %d in force after %.2f s.",
              robot,
              revocations,
              policy,
              seconds)
          : "Robot " + robot + " does NOT have them in force: " + fault;
    }
  }

  /** Begins to search for robots, if this process has the identity of a member. */
  static Publication begin(TeamOptions team) throws IOException {
    return new Publication(SecureProcess.news().isPresent() ? team.open() : null);
  }

  /** Whether this process has the identity of a member. */
  boolean isPossible() {
    return search != null;
  }

  /**
   * Gives the robots what is in the folder of this computer's identity, each as soon as it is
   * found: a lookup service that does not answer delays no other robot.
   *
   * @return a result for each robot that was found; none if there is no lookup service
   */
  List<RobotView> run() throws IOException, InterruptedException {
    TeamDirectory found = search;
    if (found == null) {
      return List.of();
    }
    SecureProcess.readAgain();
    NewsExchange news = SecureProcess.news().orElseThrow();
    ExecutorService threads = BoundedThreads.create("dfra-publish-", MOST_AT_ONCE, IDLE_SECONDS);
    try {
      Deliveries deliveries = new Deliveries(news, threads);
      try (DirectoryRegistration unused = found.listen(ModuleQuery.of(Module.class), deliveries)) {
        var unusedToo = found.awaitDirectory();
      } catch (CommandFailure e) { // no lookup service answers
        return List.of();
      }
      return deliveries.results();
    } finally {
      threads.shutdownNow();
    }
  }

  /** Begins with one process of each robot on each of its computers, since these share a folder. */
  private static final class Deliveries implements DirectoryListener<Module> {

    private final NewsExchange news;
    private final ExecutorService threads;

    @GuardedBy("this")
    private final Map<String, Future<RobotView>> begun = new TreeMap<>();

    Deliveries(NewsExchange news, ExecutorService threads) {
      this.news = news;
      this.threads = threads;
    }

    @Override
    public synchronized void matched(ModuleListing<Module> listing) {
      if (listing.module() instanceof ModuleProxy<?> proxy) {
        @Nullable PeerAddress address = PeerAddress.of(proxy.server());
        String robot = proxy.identification().robot();
        if (address != null) {
          begun.computeIfAbsent(
              robot + " " + address.host(),
              name -> threads.submit(() -> publish(robot, address, news)));
        }
      }
    }

    @Override
    public void changed(ModuleListing<Module> before, ModuleListing<Module> now) {
      matched(now);
    }

    List<RobotView> results() throws IOException, InterruptedException {
      Map<String, Future<RobotView>> all;
      synchronized (this) {
        all = new TreeMap<>(begun);
      }
      List<RobotView> results = new ArrayList<>();
      for (Future<RobotView> each : all.values()) { // each ends by itself
        try {
          results.add(each.get());
        } catch (ExecutionException e) {
          throw new IOException("a robot could not be asked: " + e.getCause(), e);
        }
      }
      return results;
    }
  }

  private static RobotView publish(String robot, PeerAddress process, NewsExchange news) {
    long begin = System.nanoTime();
    Numbers wanted = news.own();
    Numbers theirs = new Numbers(0, 0);
    String fault = "it does not confirm them in time; look at its log";
    while (System.nanoTime() - begin < PATIENCE.toNanos()) {
      try {
        theirs = news.exchangeNow(process);
      } catch (IOException | RuntimeException e) { // another robot's fault is no fault here
        fault = Objects.toString(e.getMessage(), e.toString());
        break;
      }
      if (theirs.revocations() >= wanted.revocations() && theirs.policy() >= wanted.policy()) {
        double seconds = (System.nanoTime() - begin) / 1e9;
        return new RobotView(robot, theirs.revocations(), theirs.policy(), true, seconds, "");
      }
      LockSupport.parkNanos(ASK_AGAIN_NANOS); // its processes look at their folder themselves
    }
    return new RobotView(robot, theirs.revocations(), theirs.policy(), false, 0, fault);
  }

  /** Sentences for the operator. */
  static List<String> sentences(boolean isPossible, List<RobotView> robots) {
    List<String> lines = new ArrayList<>();
    if (!isPossible) {
      lines.add(
          "No robot was asked: this computer has no usable identity of the team. Each robot gets"
              + " it from the next member that has it.");
    } else if (robots.isEmpty()) {
      lines.add(
          "No robot was found. Each gets it when this computer, or a member that has it, finds it.");
    }
    robots.forEach(each -> lines.add(each.sentence()));
    return lines;
  }

  @Override
  public void close() {
    if (search != null) {
      search.close();
    }
  }
}
