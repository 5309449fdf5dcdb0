package org.dfra.app.team;

import static java.util.stream.Collectors.joining;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.CommandOutput;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.NearestName;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.lookup.UnreadableModule;

/**
 * The team's robots, as one command sees them. The command waits for lookup services and modules
 * until its own time is over, which begins here: a robot that is starting is found as soon as it is
 * there. Closing it ends the search.
 */
public final class TeamDirectory implements AutoCloseable {

  /** Registrars that multicast reaches answer at once; this is for a busy one. */
  private static final Duration NAMESAKES = Duration.ofMillis(500);

  private final JiniModuleDirectory directory;
  private final long end; // of the command's waiting time, by System.nanoTime
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
   * The directory, once everybody at hand was asked. People are told of locators where nobody
   * answered.
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
                        + "; bring its robot up, or mend the locator"));
    return directory;
  }

  /** What is left of the command's waiting time; never negative. */
  private Duration remainingTime() {
    return Duration.ofNanos(Math.max(0, end - System.nanoTime()));
  }

  /**
   * The modules that match, once one of them is meant or the command's waiting time is over.
   *
   * @param isMeant which of those that match are waited for
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
        + "); bring a robot up, name one with --locator, or ask ./dfra doctor";
  }

  /**
   * The module of that name, which is waited for until the command's waiting time is over. Other
   * robots may have the same name, so one that is found at once is not taken before others had a
   * moment to be found too.
   *
   * @param text {@code robot/module}, {@code robot@host/module} where several robots have that
   *     name, or the module alone where only one robot has it
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
        "; ./dfra module list shows what there is");
  }

  /** Says on the side which of the robots that are found share a name. */
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

  /** Says on the side which modules are listed differently by several lookup services. */
  public void noteConflicts() {
    directory.conflicts().forEach(each -> answer.note(each.describe()));
  }

  private void refuseUnreadableUnlessFound(ModuleName name) {
    if (name.at(directory.find(name.query())).isEmpty()) {
      refuseUnreadable(name);
    }
  }

  /** Says why a module that is there cannot be used here. */
  private void refuseUnreadable(ModuleName name) {
    for (UnreadableModule each : directory.unreadableModules()) {
      if (name.isOf(each.robot(), each.name())) {
        throw new CommandFailure(
            ExitCode.FAILED, each.path() + " cannot be used here: " + each.reason());
      }
    }
  }

  /** Without their robots, as they may be written too. */
  private static List<String> withoutRobots(List<String> paths) {
    return paths.stream().map(path -> path.substring(path.indexOf('/') + 1)).distinct().toList();
  }

  @Override
  public void close() {
    directory.close();
  }
}
