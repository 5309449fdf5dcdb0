package org.dfra.core.audit;

import java.util.List;
import java.util.Optional;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * What happened, without its time. Two equal events of an interval share a record. Texts are made
 * {@linkplain PrintableText printable} and are cut to the lengths that are named here.
 *
 * @param kind what it is about
 * @param caller who called; empty if the process itself is the subject
 * @param robot the robot that the called object belongs to; empty if none; 64 code units
 * @param object the called object; empty if none; 200 code units
 * @param method the called method, such as {@code Effector.execute}; empty if none; 200 code units
 * @param decision {@code permit}, {@code deny} or {@code error}; the mode of a started process;
 *     empty for other kinds
 * @param rule name of the rule that decided; empty if none; 200 code units
 * @param reason one sentence; may be empty; 1000 code units
 * @param obligations what the decision obliged the guard to do; at most 16, 100 code units each
 */
public record AuditEvent(
    AuditKind kind,
    Optional<Caller> caller,
    String robot,
    String object,
    String method,
    String decision,
    String rule,
    String reason,
    List<String> obligations) {

  /** The decision about a call that may run. */
  public static final String PERMIT = "permit";

  /** The decision about a call that may not run. */
  public static final String DENY = "deny";

  /** The guard threw an exception, so the call did not run. */
  public static final String ERROR = "error";

  private static final int ROBOT = 64;
  private static final int NAME = 200;
  private static final int REASON = 1_000;
  private static final int OBLIGATION = 100;
  private static final int MOST_OBLIGATIONS = 16;

  /** Makes the texts printable, and cuts them. */
  public AuditEvent {
    robot = PrintableText.line(robot, ROBOT);
    object = PrintableText.line(object, NAME);
    method = PrintableText.line(method, NAME);
    decision = PrintableText.line(decision, NAME);
    rule = PrintableText.line(rule, NAME);
    reason = PrintableText.line(reason, REASON);
    obligations =
        obligations.isEmpty()
            ? List.of()
            : obligations.stream()
                .limit(MOST_OBLIGATIONS)
                .map(each -> PrintableText.line(each, OBLIGATION))
                .toList();
  }

  /** A call, and what the guard decided. */
  public static AuditEvent call(
      AccessRequest request, Decision decision, List<String> obligations) {
    return call(
        request,
        decision.isPermitted() ? PERMIT : DENY,
        decision.rule(),
        decision.reason(),
        obligations);
  }

  /** A call about which the guard could not decide. */
  static AuditEvent undecided(AccessRequest request, Throwable thrown) {
    return call(request, ERROR, "", "the guard failed: " + thrown, List.of());
  }

  private static AuditEvent call(
      AccessRequest request,
      String decision,
      String rule,
      String reason,
      List<String> obligations) {
    return new AuditEvent(
        AuditKind.CALL,
        Optional.of(request.caller()),
        request.robot(),
        request.object(),
        request.methodName(),
        decision,
        rule,
        reason,
        obligations);
  }

  /**
   * The process has begun to apply another policy.
   *
   * @param number of the policy
   * @param source where it came from, such as a file or a member
   */
  public static AuditEvent policyReplaced(long number, String source) {
    return ofProcess(AuditKind.POLICY_REPLACED, "", "policy " + number + " from " + source);
  }

  /**
   * The process has received a list of revoked certificates.
   *
   * @param number of the list
   * @param source where it came from
   * @param revoked who is on it and was not on the list before, in words
   */
  public static AuditEvent revocationReceived(long number, String source, String revoked) {
    return ofProcess(
        AuditKind.REVOCATION_RECEIVED, "", "list " + number + " from " + source + ": " + revoked);
  }

  /**
   * The process has started.
   *
   * @param reason why it has this mode, in a sentence
   */
  public static AuditEvent processStarted(SecurityMode mode, String reason) {
    return ofProcess(AuditKind.PROCESS_STARTED, mode.text(), reason);
  }

  /**
   * A caller could not prove who it is.
   *
   * @param caller what is known of it
   * @param reason what was wrong, in a sentence
   */
  public static AuditEvent loginFailed(Caller caller, String reason) {
    return ofCaller(AuditKind.LOGIN_FAILED, Optional.of(caller), "", reason);
  }

  /**
   * This process could not prove who it is.
   *
   * @param reason what was wrong, in a sentence
   */
  public static AuditEvent ownLoginFailed(String reason) {
    return ofProcess(AuditKind.LOGIN_FAILED, "", reason);
  }

  /**
   * Code that is not trusted was not loaded.
   *
   * @param reason which code, where it came from, and why it was refused
   */
  public static AuditEvent codeRefused(String reason) {
    return ofProcess(AuditKind.CODE_REFUSED, "", reason);
  }

  /** An event of the process itself. */
  static AuditEvent ofProcess(AuditKind kind, String decision, String reason) {
    return ofCaller(kind, Optional.empty(), decision, reason);
  }

  private static AuditEvent ofCaller(
      AuditKind kind, Optional<Caller> caller, String decision, String reason) {
    return new AuditEvent(kind, caller, "", "", "", decision, "", reason, List.of());
  }

  /** Of what differs most: this is computed for each command. */
  @Override
  public int hashCode() {
    int hash = caller.isEmpty() ? kind.ordinal() : caller.get().address().hashCode();
    hash = 31 * hash + object.hashCode();
    hash = 31 * hash + method.hashCode();
    return 31 * hash + reason.hashCode();
  }

  /** As the record's own, but faster; see {@link CallerEquality}. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof AuditEvent event
        && kind == event.kind
        && method.equals(event.method)
        && object.equals(event.object)
        && robot.equals(event.robot)
        && decision.equals(event.decision)
        && rule.equals(event.rule)
        && reason.equals(event.reason)
        && obligations.equals(event.obligations)
        && isSameCaller(event);
  }

  private boolean isSameCaller(AuditEvent event) {
    return caller.isEmpty() || event.caller.isEmpty()
        ? caller.isEmpty() && event.caller.isEmpty()
        : CallerEquality.areEqual(caller.get(), event.caller.get());
  }
}
