package java.rmi.activation;

/**
 * A failure of activation, with its nested cause if there is one.
 *
 * <p>The nested failure is the public field {@link #detail}; {@link #getCause} returns the same
 * object, however it was set.
 */
public class ActivationException extends Exception {

  private static final long serialVersionUID = -4320118837291406071L;

  /**
   * The nested failure, or null.
   *
   * @serial the nested failure, or null
   */
  public Throwable detail;

  /** An exception without message or cause. Its cause can no longer be set. */
  public ActivationException() {
    this(null, null);
  }

  /**
   * An exception without a cause. Its cause can no longer be set.
   *
   * @param message what went wrong
   */
  public ActivationException(String message) {
    this(message, null);
  }

  /**
   * An exception with the failure that led to it. {@code initCause} is illegal afterwards.
   *
   * @param message what went wrong
   * @param cause the nested failure, kept in {@link #detail}; may be null
   */
  public ActivationException(String message, Throwable cause) {
    // A null cause given here locks initCause; the cause itself lives in the public field.
    super(message, null);
    detail = cause;
  }

  /**
   * The message, and after it the nested failure's own description if there is one.
   *
   * @return both, in the layout {@link java.rmi.RemoteException} uses
   */
  @Override
  public String getMessage() {
    String own = super.getMessage();
    return detail == null ? own : own + "; nested exception is: \n\t" + detail;
  }

  /**
   * The nested failure.
   *
   * @return the value of {@link #detail}, may be null
   */
  @Override
  public Throwable getCause() {
    return detail;
  }
}
