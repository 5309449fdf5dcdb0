package org.dfra.recruit.agent;

import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.persona.RecruitmentAttributes;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Detects robots of the team whose personas give another replacement timeout than this robot's: a
 * call may then temporarily have two helpers. It warns once for each.
 */
final class TimeoutConsistencyMonitor
    implements DirectoryListener<RecruitmentAgent>, AutoCloseable {

  private final ModuleContext context;
  private final RecruitmentAttributes mine;
  private final Logger log;
  private final Map<String, String> warned = new ConcurrentHashMap<>(); // by robot
  private @Nullable DirectoryRegistration watch; // only by the agent's own start and end

  TimeoutConsistencyMonitor(ModuleContext context, RecruitmentAttributes mine, Logger log) {
    this.context = context;
    this.mine = mine;
    this.log = log;
  }

  void start() {
    watch = context.directory().listen(ModuleQuery.of(RecruitmentAgent.class), this);
  }

  @Override
  public void matched(ModuleListing<RecruitmentAgent> listing) {
    if (!listing.robot().equals(context.robot())) {
      listing
          .attributes(RecruitmentAttributes.class)
          .ifPresent(each -> hold(listing.robot(), each));
    }
  }

  @Override
  public void changed(ModuleListing<RecruitmentAgent> before, ModuleListing<RecruitmentAgent> now) {
    matched(now);
  }

  /** Ignores a robot that has left, or that does not publish its timeouts any more. */
  @Override
  public void unmatched(ModuleListing<RecruitmentAgent> last) {
    warned.remove(last.robot());
  }

  private void hold(String robot, RecruitmentAttributes theirs) {
    if (theirs.replaceAfter() == mine.replaceAfter() && theirs.margin() == mine.margin()) {
      warned.remove(robot);
      return;
    }
    String what =
        String.format(
            Locale.ROOT,
            "%s has replace_after %s s and margin %s s, this agent %s s and %s s; set the same"
                + " values in the whole team, or a call may have two helpers",
            robot,
            theirs.replaceAfter(),
            theirs.margin(),
            mine.replaceAfter(),
            mine.margin());
    if (!what.equals(warned.put(robot, what))) {
      log.warn("{}: {}", context.path(), what);
    }
  }

  /** The inconsistent robots, with a sentence each. */
  Map<String, String> disagreements() {
    return Map.copyOf(warned);
  }

  @Override
  public void close() {
    DirectoryRegistration open = watch;
    if (open != null) {
      open.close();
    }
  }
}
