package java.rmi.activation;

/**
 * The receiver of a call does not know an {@link ActivationGroupID}: it was never registered there,
 * was unregistered, or has another incarnation.
 */
public class UnknownGroupException extends ActivationException {

  private static final long serialVersionUID = 7056094974750002460L;

  /**
   * An exception without a cause.
   *
   * @param message which group is unknown, and to which receiver
   */
  public UnknownGroupException(String message) {
    super(message);
  }
}
