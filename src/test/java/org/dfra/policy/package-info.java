/** Policies, against the remote interfaces of all modules. */
package org.dfra.policy;
