package org.dfra.cli.team;

import static java.util.stream.Collectors.joining;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.dfra.core.config.NearestName;
import org.dfra.core.host.CommandName;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;

/**
 * The team's robots, as one command discovers them. The command waits for lookup services and
 * modules until its timeout, which starts here: a starting robot is found as soon as it registers.
 * Closing it ends the discovery.
 */
public final class TeamDirectory implements AutoCloseable {

  /** Registrars answer multicast immediately; this allows for a loaded one. */
  private static final Duration NAMESAKES = Duration.ofMillis(500);

  private final JiniModuleDirectory directory;
  private final long end; // the command's deadline, by System.nanoTime
  private final CommandOutput answer;
  private final String asked;
  private final Set<String> remarked = new HashSet<>();

  TeamDirectory(JiniModuleDirectory directory, Duration wait, CommandOutput answer, String asked) {
    this.directory = directory;
    this.end = System.nanoTime() + wait.toNanos();
    this.answer = answer;
    this.asked = asked;
  }

  /**
   * The directory, after all known registrars were queried. Prints a note about named locators that
   * do not answer.
   *
   * @throws CommandFailure if no lookup service was found at all
   */
  public JiniModuleDirectory awaitDirectory() throws InterruptedException {
    List<String> silent = directory.awaitFirstRead(remainingTime());
    if (directory.registrarCount() == 0) {
      throw new CommandFailure(ExitCode.NOT_FOUND, noLookupService());
    }
    silent.stream()
        .filter(remarked::add)
        .forEach(
            locator ->
                answer.note(
                    "no lookup service answers at "
                        + locator
                        + "; bring its robot up, or correct the locator"));
    return directory;
  }

  /**
   * Notifies a listener of modules that match, also of those that were found before.
   *
   * @return ends it when it is closed
   */
  public <M extends Module> DirectoryRegistration listen(
      ModuleQuery<M> query, DirectoryListener<M> listener) {
    return directory.listen(query, listener);
  }

  /** The remaining time until the command's deadline; never negative. */
  private Duration remainingTime() {
    return Duration.ofNanos(Math.max(0, end - System.nanoTime()));
  }

  /**
   * The modules that match, after one of them is selected or at the command's deadline.
   *
   * @param isMeant which matching modules end the wait
   */
  public <M extends Module> List<ModuleListing<M>> await(
      ModuleQuery<M> query, Predicate<ModuleListing<M>> isMeant) throws InterruptedException {
    CountDownLatch found = new CountDownLatch(1);
    DirectoryListener<M> finder =
        new DirectoryListener<M>() {
          @Override
          public void matched(ModuleListing<M> listing) {
            if (isMeant.test(listing)) {
              found.countDown();
            }
          }

          @Override
          public void changed(ModuleListing<M> before, ModuleListing<M> now) {
            matched(now);
          }
        };
    if (directory.find(query).stream().noneMatch(isMeant)) {
      try (DirectoryRegistration unused = directory.listen(query, finder)) {
        boolean unusedToo = found.await(remainingTime().toNanos(), TimeUnit.NANOSECONDS);
      }
    }
    return directory.find(query);
  }

  private String noLookupService() {
    return "no lookup service answers (asked: "
        + asked
        + "); bring a robot up, name one with --locator, or ask "
        + CommandName.current()
        + " doctor";
  }

  /**
   * The module of that name; waits for it until the command's deadline. Since other robots may have
   * the same name, it allows a moment to discover them after the first match.
   *
   * @param text {@code robot/module}, {@code robot@host/module} if several robots have that name,
   *     or the module alone if only one robot has it
   * @throws CommandFailure if there is none, or more than one
   */
  public ModuleListing<Module> module(String text) throws InterruptedException {
    ModuleName name = ModuleName.of(text);
    if (name.robot() == null) {
      awaitDirectory(); // another robot may have such a module too
      refuseUnreadableUnlessFound(name);
    }
    List<ModuleListing<Module>> found =
        await(name.query(), each -> !name.at(List.of(each)).isEmpty());
    if (!name.at(found).isEmpty()) {
      Duration left = remainingTime();
      List<String> unused =
          directory.awaitFirstRead(left.compareTo(NAMESAKES) < 0 ? left : NAMESAKES);
      List<ModuleListing<Module>> now = directory.find(name.query());
      return name.choose(name.at(now).isEmpty() ? found : now);
    }
    awaitDirectory();
    refuseUnreadable(name);
    throw new CommandFailure(ExitCode.NOT_FOUND, "there is no module " + text + hint(name, found));
  }

  private String hint(ModuleName name, List<ModuleListing<Module>> elsewhere) {
    if (!elsewhere.isEmpty()) {
      return " there; it is on "
          + elsewhere.stream().map(ModuleListing::host).distinct().sorted().collect(joining(", "));
    }
    List<String> names =
        directory.find(ModuleQuery.of(Module.class)).stream()
            .map(ModuleListing::path)
            .distinct()
            .sorted()
            .toList();
    return NearestName.hint(
        name.text(),
        name.robot() != null ? names : withoutRobots(names),
        "; " + CommandName.current() + " module list shows what there is");
  }

  /** Prints a note about discovered robots that share a name. */
  public void noteDuplicateNames() {
    DuplicateRobotNames.of(directory.find(ModuleQuery.of(Module.class)))
        .forEach(
            (robot, hosts) ->
                answer.note(
                    DuplicateRobotNames.inWords(robot, hosts)
                        + "; rename one of them, and until then name a module as "
                        + robot
                        + "@HOST/MODULE"));
  }

  /** Prints a note about modules that several lookup services list differently. */
  public void noteConflicts() {
    directory.conflicts().forEach(each -> answer.note(each.describe()));
  }

  private void refuseUnreadableUnlessFound(ModuleName name) {
    if (name.at(directory.find(name.query())).isEmpty()) {
      refuseUnreadable(name);
    }
  }

  /** Fails with the reason why a discovered module cannot be used here. */
  private void refuseUnreadable(ModuleName name) {
    for (UnreadableModule each : directory.unreadableModules()) {
      if (name.isOf(each.robot(), each.name())) {
        throw new CommandFailure(
            ExitCode.FAILED, each.path() + " cannot be used here: " + each.reason());
      }
    }
  }

  /** Without their robots, as the user may enter them too. */
  private static List<String> withoutRobots(List<String> paths) {
    return paths.stream().map(path -> path.substring(path.indexOf('/') + 1)).distinct().toList();
  }

  @Override
  public void close() {
    directory.close();
  }
}
