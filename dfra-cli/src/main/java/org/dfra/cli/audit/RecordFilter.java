package org.dfra.cli.audit;

import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditKind;
import org.dfra.core.audit.AuditLine;

/**
 * Which records are shown.
 *
 * @param who name, text or address of the caller
 * @param isDeniedOnly whether permitted calls are left out
 * @param since the earliest time
 * @param robot of the called object
 */
record RecordFilter(
    Optional<String> who, boolean isDeniedOnly, Optional<Instant> since, Optional<String> robot) {

  private static final Set<String> REFUSALS =
      Set.of(AuditKind.LOGIN_FAILED.text(), AuditKind.CODE_REFUSED.text());

  /** Whether a line is shown. First lines of files never are. */
  boolean shows(AuditLine line) {
    return !line.is(AuditKind.FILE_OPENED)
        && since.map(begin -> !line.time().isBefore(begin)).orElse(true)
        && robot.map(name -> name.equals(line.robot())).orElse(true)
        && who.map(name -> isCaller(name, line)).orElse(true)
        && (!isDeniedOnly || isRefused(line));
  }

  private static boolean isCaller(String name, AuditLine line) {
    return name.equals(line.address())
        || isMember(name, line.member())
        || isMember(name, line.behalf());
  }

  /** A member's text is its role, its name and its team. */
  private static boolean isMember(String name, String text) {
    String[] words = text.split(" ", -1);
    return name.equals(text) || (words.length > 1 && name.equals(words[1]));
  }

  private static boolean isRefused(AuditLine line) {
    return line.decision().equals(AuditEvent.DENY)
        || line.decision().equals(AuditEvent.ERROR)
        || REFUSALS.contains(line.kind());
  }
}
