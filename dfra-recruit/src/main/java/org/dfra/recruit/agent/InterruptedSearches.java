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
 * The searches that a robot has left to help, and goes on with afterwards, also where its process
 * has died meanwhile. Confined to one thread.
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

  /** Knows again what it has left in an earlier process. */
  void load() {
    try {
      Optional<byte[]> kept = context.state().read(DOCUMENT);
      kept.ifPresent(text -> new String(text, StandardCharsets.UTF_8).lines().forEach(left::add));
    } catch (IOException e) {
      log.warn("{}: it does not know what it has left: {}", context.path(), e.toString());
    }
  }

  /** Whether there are some, which it does not leave to people. */
  boolean hasLeft() {
    return !left.isEmpty();
  }

  private void keep() {
    try {
      context.state().write(DOCUMENT, String.join("\n", left).getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      log.warn("{}: its next process would not go on: {}", context.path(), e.toString());
    }
  }

  /** Pauses those that run. */
  void pauseSearches() {
    for (ModuleListing<RasterSearch> search : searches()) {
      try {
        if (search.module().status().phase() == Phase.RUNNING) {
          if (left.add(search.path())) {
            keep(); // before it pauses: one that is only listed as left goes on as it did
          }
          search.module().pauseUnattended();
        }
      } catch (RemoteException | NotReadyException e) {
        log.warn("{}: {} cannot be paused: {}", context.path(), search.path(), e.toString());
      }
    }
  }

  /**
   * Has those go on that it paused, unless a person has paused them since; tells whether all do.
   */
  boolean resumeSearches() {
    for (ModuleListing<RasterSearch> search : searches()) {
      if (left.contains(search.path())) {
        try {
          search.module().resumeUnattended(); // a brake that was set since stays set
          left.remove(search.path());
          keep();
        } catch (RemoteException | NotReadyException e) {
          log.warn("{}: {} cannot go on yet: {}", context.path(), search.path(), e.toString());
        }
      }
    }
    return left.isEmpty();
  }

  /** Has none of them go on by itself: somebody has stopped the robot, and has them go on. */
  void handOverToOperator() {
    if (!left.isEmpty()) {
      log.info("{}: these wait until somebody resumes them: {}", context.path(), left);
      left.clear();
      keep();
    }
  }

  private List<ModuleListing<RasterSearch>> searches() {
    return context.directory().find(ModuleQuery.of(RasterSearch.class).robot(context.robot()));
  }
}
