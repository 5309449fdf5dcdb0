package java.rmi.activation;

import java.rmi.RemoteException;

/**
 * A remote call could not be made because its object could not be activated.
 *
 * <p>The call was not executed, so it may be repeated.
 */
public class ActivateFailedException extends RemoteException {

  private static final long serialVersionUID = 4863550261346652506L;

  /**
   * A failure without a cause.
   *
   * @param message what could not be activated
   */
  public ActivateFailedException(String message) {
    super(message);
  }

  /**
   * A failure with its cause.
   *
   * @param message what could not be activated
   * @param cause why
   */
  public ActivateFailedException(String message, Exception cause) {
    super(message, cause);
  }
}
