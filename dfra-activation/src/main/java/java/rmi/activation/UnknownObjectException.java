package java.rmi.activation;

/**
 * An {@link ActivationID} means nothing to the one asked: never registered there, or unregistered.
 */
public class UnknownObjectException extends ActivationException {

  private static final long serialVersionUID = 3425547551622251430L;

  /**
   * An exception without a cause.
   *
   * @param message which one is unknown, and to whom
   */
  public UnknownObjectException(String message) {
    super(message);
  }
}
