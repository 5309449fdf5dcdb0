package org.dfra.security;

/** Nothing is hidden. */
final class CompleteVisibility implements Visibility, Visibility.OfService {

  @Override
  public boolean isComplete() {
    return true;
  }

  @Override
  public OfService of(ListedService service) {
    return this;
  }

  @Override
  public boolean isShown() {
    return true;
  }

  @Override
  public boolean isShown(String type, String component) {
    return true;
  }

  @Override
  public boolean isShown(String type) {
    return true;
  }
}
