package org.dfra.drivers.uav.mavlink;

/**
 * What became of a command.
 *
 * @param end how it ended
 * @param code {@code MAV_RESULT} where it was answered, else 0
 */
record CommandResult(End end, int code) {

  /** How a command may end. */
  enum End {
    /** It is, or will be, done. */
    ACCEPTED,
    /** The vehicle will not do it. */
    REFUSED,
    /** Nothing came back, though it was sent several times; it may be done or not. */
    UNANSWERED,
    /** The link was lost before an answer came; it may be done or not. */
    LOST
  }

  static final CommandResult UNANSWERED = new CommandResult(End.UNANSWERED, 0);
  static final CommandResult LOST = new CommandResult(End.LOST, 0);

  /** {@code MAV_RESULT_IN_PROGRESS}: no end yet. */
  static final int IN_PROGRESS = 5;

  static CommandResult answered(int code) {
    return new CommandResult(code == 0 ? End.ACCEPTED : End.REFUSED, code);
  }

  boolean isAccepted() {
    return end == End.ACCEPTED;
  }

  /** Whether it is refused only as things are now. */
  boolean isForNow() {
    return end == End.REFUSED && code == 1;
  }

  /** As the rest of a sentence that begins with the command's name. */
  @Override
  public String toString() {
    return switch (end) {
      case ACCEPTED -> "is accepted";
      case REFUSED -> "is " + word();
      case UNANSWERED -> "was sent " + CommandProtocol.MOST + " times and is not answered";
      case LOST -> "was sent, and the link was lost before an answer came";
    };
  }

  private String word() {
    return switch (code) {
      case 1 -> "rejected for now";
      case 2 -> "denied";
      case 3 -> "not supported";
      case 4 -> "failed";
      case 6 -> "cancelled";
      case 7 -> "only taken as COMMAND_LONG";
      case 8 -> "only taken as COMMAND_INT";
      case 9 -> "not supported in this frame";
      default -> "refused with result " + code;
    };
  }
}
