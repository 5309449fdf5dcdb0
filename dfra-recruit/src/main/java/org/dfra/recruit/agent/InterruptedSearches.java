package org.dfra.recruit.agent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.rmi.RemoteException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterSearch;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.NotReadyException;
import org.slf4j.Logger;

/**
 * The searches that a robot has interrupted to help, and resumes afterwards, even after a crash of
 * its process. Confined to one thread.
 */
final class InterruptedSearches {

  private static final String DOCUMENT = "left-work";

  private final ModuleContext context;
  private final Logger log;
  private final Set<String> left = new TreeSet<>(); // modules, by path

  InterruptedSearches(ModuleContext context, Logger log) {
    this.context = context;
    this.log = log;
  }

  /** Loads the searches interrupted by an earlier process. */
  void load() {
    try {
      Optional<byte[]> kept = context.state().read(DOCUMENT);
      kept.ifPresent(text -> new String(text, StandardCharsets.UTF_8).lines().forEach(left::add));
    } catch (IOException e) {
      log.warn(
          "{}: the stored list of interrupted searches cannot be read: {}",
          context.path(),
          e.toString());
    }
  }

  /** Whether there are any that it resumes itself. */
  boolean hasLeft() {
    return !left.isEmpty();
  }

  private void keep() {
    try {
      context.state().write(DOCUMENT, String.join("\n", left).getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      log.warn(
          "{}: the list of interrupted searches cannot be stored, so they are not resumed after a restart: {}",
          context.path(),
          e.toString());
    }
  }

  /** Pauses the running ones. */
  void pauseSearches() {
    for (ModuleListing<RasterSearch> search : searches()) {
      try {
        if (search.module().status().phase() == Phase.RUNNING) {
          if (left.add(search.path())) {
            keep(); // before it pauses: one only listed as interrupted continues unchanged
          }
          search.module().pauseUnattended();
        }
      } catch (RemoteException | NotReadyException e) {
        log.warn("{}: {} cannot be paused: {}", context.path(), search.path(), e.toString());
      }
    }
  }

  /**
   * Resumes those that it paused, unless an operator has paused them since; returns whether all
   * run.
   */
  boolean resumeSearches() {
    for (ModuleListing<RasterSearch> search : searches()) {
      if (left.contains(search.path())) {
        try {
          search.module().resumeUnattended(); // a brake set since then stays set
          left.remove(search.path());
          keep();
        } catch (RemoteException | NotReadyException e) {
          log.warn("{}: {} cannot be resumed yet: {}", context.path(), search.path(), e.toString());
        }
      }
    }
    return left.isEmpty();
  }

  /** Resumes none of them automatically: an operator has stopped the robot, and resumes them. */
  void handOverToOperator() {
    if (!left.isEmpty()) {
      log.info(
          "{}: these searches are paused until an operator resumes them: {}", context.path(), left);
      left.clear();
      keep();
    }
  }

  private List<ModuleListing<RasterSearch>> searches() {
    return context.directory().find(ModuleQuery.of(RasterSearch.class).robot(context.robot()));
  }
}
