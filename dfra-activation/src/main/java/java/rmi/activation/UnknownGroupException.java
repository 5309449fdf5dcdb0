package java.rmi.activation;

/**
 * An {@link ActivationGroupID} means nothing to the one asked: never registered there,
 * unregistered, or of another incarnation.
 */
public class UnknownGroupException extends ActivationException {

  private static final long serialVersionUID = 7056094974750002460L;

  /**
   * An exception without a cause.
   *
   * @param message which one is unknown, and to whom
   */
  public UnknownGroupException(String message) {
    super(message);
  }
}
