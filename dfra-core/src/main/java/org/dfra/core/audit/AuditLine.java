package org.dfra.core.audit;

import java.time.Instant;
import java.util.List;
import java.util.Optional;

/**
 * A line of the audit trail, as it was read. Texts that the line does not have are empty.
 *
 * @param number of the line in its stream, from 1
 * @param time when it happened, by the clock of the process
 * @param kind text of an {@link AuditKind}, or a later version's
 * @param standing what was proved of the caller: {@code stranger}, {@code expired}, {@code member}
 *     or {@code own}
 * @param member whom the caller's certificate named
 * @param behalf on whose behalf the caller called
 * @param address the caller's address
 * @param robot the robot that the called object belongs to
 * @param object the called object
 * @param method the called method
 * @param decision {@code permit}, {@code deny}, {@code error}, or the mode of a started process
 * @param rule the rule that decided
 * @param reason one sentence
 * @param obligations what the decision obliged the guard to do
 * @param count how many equal events the line stands for
 * @param since of a sum, when its interval began
 * @param header what the first line of a file says about it; empty for other lines
 * @param previous hash of the line before, 64 hexadecimal digits
 */
public record AuditLine(
    long number,
    Instant time,
    String kind,
    String standing,
    String member,
    String behalf,
    String address,
    String robot,
    String object,
    String method,
    String decision,
    String rule,
    String reason,
    List<String> obligations,
    long count,
    Optional<Instant> since,
    Optional<Header> header,
    String previous) {

  /**
   * What the first line of a file says about it.
   *
   * @param stream name of the stream
   * @param file number of the file
   * @param files how many files the stream keeps
   * @param owner whose trail it is
   */
  public record Header(String stream, long file, int files, String owner) {}

  /** Copies the list. */
  public AuditLine {
    obligations = List.copyOf(obligations);
  }

  /** Whether it is of a kind. */
  public boolean is(AuditKind wanted) {
    return kind.equals(wanted.text());
  }
}
