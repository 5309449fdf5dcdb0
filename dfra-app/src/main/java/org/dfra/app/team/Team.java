package org.dfra.app.team;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.app.terminal.Answer;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.NearestName;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.lookup.UnreadableModule;

/** The team's robots, as one command sees them. Closing it ends the search. */
public final class Team implements AutoCloseable {

  private final JiniModuleDirectory directory;
  private final Duration wait;
  private final Answer answer;
  private final String asked;

  Team(JiniModuleDirectory directory, Duration wait, Answer answer, String asked) {
    this.directory = directory;
    this.wait = wait;
    this.answer = answer;
    this.asked = asked;
  }

  /**
   * The directory, once everybody at hand was asked. People are told of locators where nobody
   * answered.
   *
   * @throws CommandFailure if no lookup service was found at all
   */
  public JiniModuleDirectory surveyed() throws InterruptedException {
    List<String> silent = directory.awaitFirstLook(wait);
    if (directory.registrars() == 0) {
      throw new CommandFailure(ExitCode.NOT_FOUND, noLookupService());
    }
    silent.forEach(
        locator ->
            answer.remark(
                "no lookup service answers at "
                    + locator
                    + "; bring its robot up, or mend the locator"));
    return directory;
  }

  private String noLookupService() {
    return "no lookup service answers (asked: "
        + asked
        + "); bring a robot up, name one with --locator, or ask ./dfra doctor";
  }

  /**
   * The module of that name.
   *
   * @param name {@code robot/module}, or the module alone where only one robot has it
   * @throws CommandFailure if there is none, or more than one
   */
  public ModuleListing<Module> module(String name) throws InterruptedException {
    ModuleQuery<Module> query = query(name);
    boolean isFullName = name.indexOf('/') >= 0;
    if (isFullName) {
      Optional<ModuleListing<Module>> found = directory.findFirst(query, wait);
      if (found.isPresent()) {
        return found.get();
      }
    }
    surveyed();
    List<ModuleListing<Module>> found = directory.find(query);
    if (found.size() == 1) {
      return found.get(0);
    }
    List<String> names =
        (found.isEmpty() ? directory.find(ModuleQuery.of(Module.class)) : found)
            .stream().map(ModuleListing::path).distinct().sorted().toList();
    if (found.isEmpty()) {
      refuseUnreadable(name);
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        found.isEmpty()
            ? "there is no module "
                + name
                + NearestName.hint(
                    name,
                    isFullName ? names : withoutRobots(names),
                    "; ./dfra module list shows what there is")
            : "there are several modules " + name + "; name one of " + String.join(", ", names));
  }

  /** Says why a module that is there cannot be used here. */
  private void refuseUnreadable(String name) {
    for (UnreadableModule each : directory.unreadable()) {
      if (each.path().equals(name) || each.name().equals(name)) {
        throw new CommandFailure(
            ExitCode.FAILED, each.path() + " cannot be used here: " + each.reason());
      }
    }
  }

  /** Without their robots, as they may be written too. */
  private static List<String> withoutRobots(List<String> paths) {
    return paths.stream().map(path -> path.substring(path.indexOf('/') + 1)).distinct().toList();
  }

  private static ModuleQuery<Module> query(String name) {
    int slash = name.indexOf('/');
    ModuleQuery<Module> any = ModuleQuery.of(Module.class);
    return slash < 0
        ? any.name(name)
        : any.robot(name.substring(0, slash)).name(name.substring(slash + 1));
  }

  @Override
  public void close() {
    directory.close();
  }
}
