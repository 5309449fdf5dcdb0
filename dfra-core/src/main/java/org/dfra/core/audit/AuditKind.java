package org.dfra.core.audit;

/** What a record of the audit trail is about. */
public enum AuditKind {
  /** A call, and what the guard decided about it. */
  CALL("call"),
  /** How often a caller made a permitted call that only reads, in an interval. */
  READS("reads"),
  /** The process has begun to apply another policy. */
  POLICY_REPLACED("policy"),
  /** The process has received a list of revoked certificates. */
  REVOCATION_RECEIVED("revocation"),
  /** The process has started, with its {@link SecurityMode}. */
  PROCESS_STARTED("start"),
  /** The process has ended by itself. A process that was killed has no such record. */
  PROCESS_ENDED("end"),
  /** Somebody, or this process itself, could not prove who it is. */
  LOGIN_FAILED("login-failed"),
  /** Code that is not trusted was not loaded. */
  CODE_REFUSED("code-refused"),
  /** Events that have no record: how many, and why. */
  RECORDS_DROPPED("dropped"),
  /** A file of the trail begins. */
  FILE_OPENED("file"),
  /** The last line was incomplete after a crash, and is now in a file beside the trail. */
  TORN_LINE("torn");

  /** How a process protects its objects. */
  public enum SecurityMode {
    /** Everybody may call. */
    OPEN("open"),
    /** The policy decides. */
    SECURE("secure"),
    /** Only the robot's own processes may call, since its credentials are unusable. */
    CLOSED("closed");

    private final String text;

    SecurityMode(String text) {
      this.text = text;
    }

    /** The mode in the trail. */
    public String text() {
      return text;
    }
  }

  private final String text;

  AuditKind(String text) {
    this.text = text;
  }

  /** The kind in the trail. */
  public String text() {
    return text;
  }
}
