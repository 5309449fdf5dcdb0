/**
 * The slice from a device to a client, in one virtual machine: the five classes of a module, its
 * six activation steps, its lookup services and its leases.
 *
 * <p>Enter at {@link org.dfra.slice.FiveClassesTest}.
 */
package org.dfra.slice;
