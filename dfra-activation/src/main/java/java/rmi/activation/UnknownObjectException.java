package java.rmi.activation;

/**
 * The receiver of a call does not know an {@link ActivationID}: it was never registered there, or
 * was unregistered.
 */
public class UnknownObjectException extends ActivationException {

  private static final long serialVersionUID = 3425547551622251430L;

  /**
   * An exception without a cause.
   *
   * @param message which object is unknown, and to which receiver
   */
  public UnknownObjectException(String message) {
    super(message);
  }
}
